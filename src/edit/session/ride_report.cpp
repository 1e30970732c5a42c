// The ride report as text and as JSON, and the ride by time as CSV.
#include "edit/session/ride_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/text.h"
#include "base/units.h"
#include "exchange/own/json_output.h"
#include "sim/plan/force_plan.h"
#include "sim/shape/folds.h"
#include "sim/study/ratings.h"
#include "world/sections.h"

namespace coaster::edit {
namespace {

using exchange::JsonValue;
using world::FailureKind;
using world::RideState;

// --- The end of a ride

// Returns the mean height of a train's cars (m) whose first car has moved `travelled` metres from its start.
double mean_height(const sim::SimulatedRide& simulated, const sim::RailTables& tables, double travelled,
                   std::size_t& hint) {
  double sum = 0;
  for (int car = 0; car < simulated.start.cars; ++car) {
    const double s = tables.locate(simulated.place(travelled, car), hint);
    sum += sim::rail_at(tables.segment(hint), s).height;
  }
  return sum / simulated.start.cars;
}

// The next top after the train's furthest point: how much higher it is, and where its first car would be; nothing if
// the rails do not rise from there.
struct Shortfall {
  double height = 0, distance = 0, furthest = 0;  // m; m along the track, both
};
std::optional<Shortfall> shortfall(const sim::SimulatedRide& simulated, const sim::RailTables& tables) {
  if (simulated.samples.empty() || tables.size() == 0) return std::nullopt;
  const double furthest = simulated.furthest();
  constexpr double kSearchStep = 0.25, kRise = 0.02;  // m
  std::size_t hint = 0;
  const double from = mean_height(simulated, tables, furthest, hint);
  double top = from, top_at = furthest;
  for (double at = furthest; at < furthest + simulated.track_length; at += kSearchStep) {
    const double height = mean_height(simulated, tables, at, hint);
    if (height < top - kRise) break;
    if (height > top) top = height, top_at = at;
  }
  if (top - from < kRise) return std::nullopt;
  const auto along = [&](double travelled) {
    const double at = simulated.place(travelled);
    return simulated.closed ? at : std::min(at, simulated.track_length);
  };
  return Shortfall{top - from, along(top_at), along(furthest)};
}

// Sets the reason and the place of a failure. `simulated`: the ride, if it was whole.
void explain(Session& session, const sim::SimulatedRide* simulated, RideResult& result) {
  const world::RideFailure& failure = session.motion.failure;
  const std::string_view what = base::name_of(failure.kind);
  const bool climbed = failure.kind == FailureKind::stall || failure.kind == FailureKind::rollback;
  const auto missing = simulated && climbed ? shortfall(*simulated, SessionFindings(session).tables()) : std::nullopt;
  result.place = missing ? missing->furthest : failure.distance;
  result.below_top = missing.has_value();
  if (missing)
    result.reason = fmt::format(
        "{} at {:.1f} m, {:.1f} m below the top at {:.1f} m: {:.1f} m/s more or a lift would take it over", what,
        missing->furthest, missing->height, missing->distance, std::sqrt(2 * world::kGravity * missing->height));
  else result.reason = fmt::format("{} at {:.1f} m, {:.1f} m/s", what, failure.distance, std::abs(failure.speed));
}

void judge(Session& session, RideResult* result) {
  if (!session.game.challenge || !session.game.referee.judge) return;
  ActiveChallenge& challenge = *session.game.challenge;
  const int before = challenge.medal;
  challenge.last = session.game.referee.judge(session, result);
  challenge.medal = std::max(challenge.medal, challenge.last.medal);
  ++challenge.judged;
  if (challenge.last.medal > 0)
    exchange::merge(session.game.earned, {std::filesystem::path(challenge.path).stem().string(), challenge.last.medal,
                                          challenge.last.values});
  if (result) result->verdict = challenge.last;
  constexpr const char* kMedals[] = {"", "bronze", "silver", "gold"};
  if (challenge.medal > before)
    notify(session, NoticeKind::info, fmt::format("Passed {} with {}.", challenge.file.name, kMedals[challenge.medal]));
}

// Ends the ride and reports it once.
void end_ride(Session& session, RideEnd end) {
  RideInProgress& run = session.game.run;
  run.under_way = false;
  RideResult result;
  result.end = end;
  result.serial = session.game.result ? session.game.result->serial + 1 : 1;
  result.whole = run.whole && run.document == world::hash(session.document);
  result.seconds = static_cast<double>(run.ticks) * world::kTick;
  const SessionFindings find(session);
  result.ratings = find.ratings();
  if (end == RideEnd::failed || end == RideEnd::open_end)
    explain(session, result.whole ? find.ride() : nullptr, result);
  judge(session, &result);
  session.game.result = std::move(result);
  session.game.show_result = true;
}

bool came_round(const Session& session) {
  const world::TrainMotion* const cart = session.motion.carts.find(chosen_cart(session));
  return cart != nullptr && cart->laps != 0;
}

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

void watch_start(Session& session, bool from_start) {
  session.game.show_result = false;
  if (from_start) session.game.run = {true, true, world::hash(session.document), 0};
}

void watch_disturbed(Session& session) {
  session.game.run.whole = false;
  session.game.run.under_way = session.game.run.under_way && session.motion.state != RideState::failed &&
                               session.motion.state != RideState::ended;
}

void watch_reset(Session& session) {
  session.game.run = {};
  session.game.show_result = false;
}

void watch_ticks(Session& session, int ticks) {
  RideInProgress& run = session.game.run;
  if (!run.under_way) return;
  run.ticks += static_cast<std::uint64_t>(ticks);
  const bool timed = session.game.challenge && session.game.challenge->file.judged == exchange::JudgedWhen::time;
  if (session.motion.state == RideState::failed) return end_ride(session, RideEnd::failed);
  if (timed && static_cast<double>(run.ticks) * world::kTick >= session.game.challenge->file.seconds)
    return end_ride(session, RideEnd::time);
  if (session.motion.state == RideState::ended) return end_ride(session, RideEnd::open_end);
  if (!timed && came_round(session)) end_ride(session, RideEnd::lap);
}

void watch_built(Session& session) {
  if (!session.game.challenge || session.game.challenge->file.judged != exchange::JudgedWhen::build ||
      session.history.in_gesture)
    return;
  judge(session, nullptr);
}

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
