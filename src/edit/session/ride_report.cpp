// The ride report as text and as JSON, and the ride by time as CSV.
#include "edit/session/ride_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "base/units.h"
#include "edit/session/session.h"
#include "exchange/own/json_output.h"
#include "sim/plan/force_plan.h"
#include "sim/shape/folds.h"
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

exchange::JsonMembers overload(const sim::Overload& span) {
  return {{"car", std::int64_t{span.car + 1}},
          {"axis", std::string(base::name_of(span.axis))},
          {"worst_g", base::limited_figure(sim::signed_g(span.axis, span.worst), "g")},
          {"limit_g", sim::signed_g(span.axis, span.allowed)},
          {"from_s", span.from},
          {"to_s", span.to},
          {"from_m", span.from_distance},
          {"to_m", span.to_distance}};
}

// Returns a line for each force section whose spans miss its tolerance, below a line with their number; empty without
// force sections.
std::string missed_forces(const SessionFindings& find) {
  std::string lines;
  const std::optional<std::vector<MissedForces>> missed = forces_missed(find);
  if (!missed) return {};
  for (const MissedForces& one : *missed)
    lines += fmt::format("    section {}: {}; tolerance {} g\n", one.section, one.text, base::to_text(one.tolerance));
  return fmt::format("  {:<22} {:8} (force sections over their tolerance)\n", "missed forces", missed->size()) + lines;
}

}  // namespace

std::optional<std::vector<MissedForces>> forces_missed(const SessionFindings& find) {
  const world::Document& document = find.session().document;
  std::vector<MissedForces> all;
  bool any = false;
  for (const world::SectionRun& run : world::sections_of(document)) {
    const sim::ForcePlan* const plan = find.force(run.section);
    if (plan == nullptr) continue;
    any = true;
    std::string text = sim::missed_text(*plan);
    if (!plan->refusal.empty() || text.empty()) continue;
    all.push_back({world::label_of(document, run.section), std::move(text), plan->task.program.tolerance});
  }
  return any ? std::optional(std::move(all)) : std::nullopt;
}

std::optional<std::string> ride_report(const SessionFindings& find) {
  const sim::SimulatedRide* const ride = find.ride();
  if (ride == nullptr) return std::nullopt;
  std::string text =
      sim::report_text(*ride, find.ratings(), find.riders()->all(), find.overloads(), find.session().document.name);
  if (const auto bends = find.tight_bends(); !bends.empty()) text += fmt::format("  {}\n", sim::tight_text(bends));
  if (const std::string blocks = sim::deadlock_text(find.session().document, find.session().derived); !blocks.empty())
    text += fmt::format("  {}\n", blocks);
  text += missed_forces(find);
  if (const auto& import = find.session().file.import) {
    text += fmt::format("  {:<22} {:8.2f} mm, {:.3f} deg, of the file's rows; at their jumps {:.3f} deg\n",
                        "largest deviation", 1e3 * import->max_error, import->frame_error, import->jump_error);
    text += fmt::format("  {:<22} {:8.2f} mm, {:.3f} deg\n", "RMS deviation", 1e3 * import->rms_error,
                        import->rms_frame_error);
  }
  return text;
}
std::optional<std::string> ride_csv(const SessionFindings& find) {
  const sim::SimulatedRide* const ride = find.ride();
  return ride ? std::optional(sim::report_csv(*ride, find.riders()->all())) : std::nullopt;
}

std::optional<std::string> ride_report_json(const SessionFindings& find) {
  if (find.ride() == nullptr) return std::nullopt;
  const sim::SimulatedRide& simulated = *find.ride();
  const sim::Ratings& r = find.ratings();
  const std::vector<sim::Rider> riders = find.riders()->all();
  const bool failed = simulated.end != world::FailureKind::none;
  exchange::JsonMembers all{{"name", find.session().document.name},
                            {"length_m", r.length},
                            {"lap_s", simulated.lap ? JsonValue(r.seconds) : nullptr},
                            {"time_s", r.seconds},
                            {"end", failed ? JsonValue(std::string(base::name_of(simulated.end))) : nullptr},
                            {"end_m", failed ? JsonValue(simulated.distance(simulated.samples.size() - 1)) : nullptr},
                            {"cars", std::int64_t{simulated.start.cars}},
                            {"spacing_m", double{simulated.start.spacing}},
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
  for (const sim::Overload& span : find.overloads()) overloads.push_back(overload(span));
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
