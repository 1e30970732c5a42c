// The ride report as JSON: the numbers of sim::report_text() and of what ride_report() adds to it.
#include "edit/session/ride_report.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "exchange/own/json_values.h"
#include "sim/plan/force_plan.h"
#include "sim/shape/folds.h"
#include "sim/study/ratings.h"
#include "world/sections.h"

namespace coaster::edit {
namespace {

using exchange::JsonValue;

// Returns "most_jerk_g_s" of "most jerk" and "g/s".
std::string key(std::string name, std::string_view unit) {
  name += unit.empty() ? "" : "_";
  for (const char c : unit)
    if (c != '^') name += c;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '-' || c == '/'; }, '_');
  return name;
}

exchange::JsonMembers overload(const sim::RedSpan& span) {
  return {{"car", std::int64_t{span.car + 1}},
          {"axis", std::string(base::name_of(span.axis))},
          {"worst_g", base::limited_figure(sim::signed_g(span.axis, span.worst), "g")},
          {"limit_g", sim::signed_g(span.axis, span.allowed)},
          {"from_s", span.from},
          {"to_s", span.to},
          {"from_m", span.from_distance},
          {"to_m", span.to_distance}};
}

}  // namespace

std::optional<std::string> ride_report_json(const Finder& find) {
  if (find.ride() == nullptr) return std::nullopt;
  const sim::Ghost& ghost = *find.ride();
  const sim::Ratings& r = find.ratings();
  const std::vector<sim::Rider> riders = find.riders()->all();
  const bool failed = ghost.end != world::FailureKind::none;
  exchange::JsonMembers all{{"name", find.session().document.name},
                            {"length_m", r.length},
                            {"lap_s", ghost.lap ? JsonValue(r.seconds) : nullptr},
                            {"time_s", r.seconds},
                            {"end", failed ? JsonValue(std::string(base::name_of(ghost.end))) : nullptr},
                            {"end_m", failed ? JsonValue(ghost.distance(ghost.samples.size() - 1)) : nullptr},
                            {"cars", std::int64_t{ghost.start.cars}},
                            {"spacing_m", double{ghost.start.spacing}},
                            {"mean_speed_m_s", r.mean_speed},
                            {"cutoff_Hz", riders.empty() ? nullptr : JsonValue(riders.front().cutoff)}};
  exchange::JsonList over;  // figures at their limit
  for (const auto& [name, unit, at] : sim::report_figures(r, riders)) {
    all.emplace_back(key(name, unit), base::limited_figure(at.value, unit));
    if (std::abs(at.value) >= base::figure_limit(unit)) over.push_back({{"figure", key(name, unit)}});
    all.emplace_back(key(name, "at_m"), at.distance), all.emplace_back(key(name, "at_s"), at.seconds);
    all.emplace_back(key(name, "car"), std::int64_t{at.car + 1});
  }
  const exchange::JsonMembers ratings{{"airtime_s", r.airtime},
                                      {"drops", std::int64_t{r.drops}},
                                      {"highest_drop_m", r.highest_drop},
                                      {"inversions", std::int64_t{r.inversions}},
                                      {"excitement", r.excitement},
                                      {"intensity", r.intensity},
                                      {"nausea", r.nausea}};
  all.insert(all.end(), ratings.begin(), ratings.end());
  all.emplace_back("over_limit", std::move(over));
  exchange::JsonList overloads, missed, bends;
  for (const sim::RedSpan& span : find.overloads()) overloads.push_back(overload(span));
  for (const sim::TightBend& bend : find.tight_bends()) bends.push_back({{"at_m", bend.at}, {"radius_m", bend.radius}});
  all.emplace_back("tight_bends", std::move(bends));
  const std::string blocks = sim::deadlock_text(find.session().document, find.session().derived);
  all.emplace_back("deadlock", blocks.empty() ? nullptr : JsonValue(blocks));
  all.emplace_back("overloads", std::move(overloads));
  const auto forces = forces_missed(find);
  for (const MissedForces& one : forces.value_or(std::vector<MissedForces>{}))
    missed.push_back({{"section", one.section}, {"missed", one.text}, {"tolerance_g", one.tolerance}});
  all.emplace_back("missed_forces", forces ? JsonValue(std::move(missed)) : nullptr);
  const auto& import = find.session().file.import;
  const auto deviation = [&](const char* name, double value) {
    all.emplace_back(name, import ? JsonValue(value) : nullptr);
  };
  using Import = std::remove_cvref_t<decltype(*import)>;
  const Import none{}, &rows = import ? *import : none;
  deviation("largest_deviation_mm", 1e3 * rows.max_error), deviation("largest_deviation_deg", rows.frame_error);
  deviation("jump_deviation_deg", rows.jump_error);
  deviation("rms_deviation_mm", 1e3 * rows.rms_error), deviation("rms_deviation_deg", rows.rms_frame_error);
  return exchange::json_members(all);
}

}  // namespace coaster::edit
