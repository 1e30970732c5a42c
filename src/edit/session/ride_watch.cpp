// The ends of rides, as values and in words.
#include "edit/session/ride_watch.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "sim/shape/folds.h"
#include "sim/study/ratings.h"
#include "world/sections.h"

namespace coaster::edit {
namespace {

using world::FailureKind;
using world::RideState;

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

}  // namespace coaster::edit
