#include "sim/plan/closing_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using world::kGravity;

constexpr double kStraights[] = {0, 10, 25, 50, 100};  // m before the first turn and after the second
constexpr double kSideG[] = {0.5, 0.8, 1.4, 2.2};      // g that a turn adds, before banking
constexpr double kLeastRadii[] = {25, 18, 12, 8};      // m
constexpr double kLeadG = 2.2, kLeadCrestG = 0.9;      // g that a lead's bend adds or removes
constexpr double kShortestTurn = 1;                    // s at the open end's speed: shorter ones roll too quickly
constexpr int kSteps = 48;
constexpr double kFarthestHome = 3000;  // m, straight distance from the open end to the first knot

// Returns the radius at which a bend adds that many g, m.
double radius_for(double square, double g, double least) { return std::max(least, square / (g * kGravity)); }

HeightLimits limits_for(double square, bool tight) {
  constexpr double kShortest = 12;  // m
  return {radius_for(square, tight ? 1.1 : 0.7, kShortest), radius_for(square, tight ? 2.2 : 1.2, kShortest),
          kSteepestHome};
}

double lead_radius(const TrackEnd& end, double square) {
  constexpr double kShortest = 10;  // m
  return radius_for(square, end.forward.y > 0 ? kLeadCrestG : kLeadG, kShortest);
}

std::string metres(double value) { return base::to_text(std::round(value * 10) / 10) + " m"; }

// Returns why no closing section is possible; empty if one may be.
std::string hopeless(const CircuitTask& task) {
  for (const auto& [end, name] : {std::pair{&task.from, "the open end"}, std::pair{&task.home, "the first knot"}})
    if (const double k = glm::length(end->curvature); k > kSharpestEnd)
      return fmt::format("{} is too sharp: its radius is {}", name, metres(1.0 / k));
  const double rise = task.home.position.y - task.from.position.y,
               gap = glm::distance(task.home.position, task.from.position);
  if (gap > kFarthestHome)
    return fmt::format("the first knot is too far away: {}, where the limit is {}", metres(gap), metres(kFarthestHome));
  if (task.coasts && square_speed(task, rise, gap) < slowest(task) * slowest(task))
    return fmt::format(
        "the train would reach the first knot, {} higher, at less than {} m/s: climb by a lift, or add a launch",
        metres(rise), base::to_text(slowest(task)));
  return {};
}

// Returns levels between the ends worth trying: over and under other track, and at the heights of both ends.
std::vector<double> levels_between(const CircuitCandidates& c, double floor) {
  const double low = std::min(c.in.height, c.out.height), high = std::max(c.in.height, c.out.height);
  std::vector<double> levels{low, high, 0.5 * (low + high), low - 4, high + 4, high + 8, high + 14};
  std::erase_if(levels, [&](double level) { return level < floor; });
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

double floor_of(const CircuitTask& task) {
  const double ends = std::min(task.from.position.y, task.home.position.y);
  return std::min(bottom(task) + kLowestRails - task.rails, ends) - 0.01;
}

HeightEnds ends_of(const CircuitCandidates& c, const TurnsInPlan& turns) {
  return {turns.length(), c.in.height, c.out.height, c.in.slope, c.out.slope};
}

double fastest_square(const CircuitTask& task, double lowest) {
  return std::max(1.0, square_speed(task, std::min(0.0, lowest - task.from.position.y), 0));
}

std::optional<HeightProfile> heights_of(const CircuitCandidates& c, const CircuitCandidate& candidate,
                                        const TurnsInPlan& turns) {
  const HeightEnds ends = ends_of(c, turns);
  const double level =
      candidate.level < 0 ? std::min(ends.from, ends.to) : c.levels[static_cast<std::size_t>(candidate.level)];
  const HeightLimits limits =
      limits_for(fastest_square(c.task, std::min({level, ends.from, ends.to})), candidate.tight);
  return candidate.level < 0 ? steady_heights(ends, limits) : heights_by_way_of(level, ends, limits);
}

// Adds a candidate, or counts the reason for leaving it out. Returns true if there was space for the heights.
bool consider(CircuitCandidate candidate, double floor, ClosingCurve& closing, CircuitCandidates& c) {
  const std::optional<HeightProfile> heights = heights_of(c, candidate, closing.turns);
  if (!heights) return false;
  closing.heights = *heights;
  if (lowest_of(*heights) < floor) {
    ++c.losses.buried;
    return true;
  }
  const std::optional<FeltRange> felt = estimate(c.task, closing, kSteps);
  if (!felt) {
    ++c.losses.slow;
  } else if (!felt->within()) {
    ++c.losses.forced, c.losses.least_g = std::min(c.losses.least_g, felt->most);
  } else {
    candidate.cost = cost_of(closing.turns.length(), *felt);
    c.list.push_back(candidate);
  }
  return true;
}

double shortest_turn(const CircuitTask& task) { return std::max(Bend::kShortest, kShortestTurn * task.speed); }

// Returns the ends and levels between which ways are searched for, or why none is possible.
CircuitCandidates prepared(const CircuitTask& task) {
  CircuitCandidates c;
  c.task = task;
  c.refusal = hopeless(task);
  if (!c.refusal.empty()) return c;
  const double rise = task.home.position.y - task.from.position.y, start = task.speed * task.speed,
               end = std::max(1.0, square_speed(task, rise, glm::distance(task.home.position, task.from.position)));
  c.arrival = std::sqrt(end);
  c.in = lead_from(task.from, lead_radius(task.from, start));
  TrackEnd back = task.home;
  back.forward = -back.forward;
  c.out = lead_to(task.home, lead_radius(back, end));
  const double floor = floor_of(task);
  if (std::min(c.in.height, c.out.height) < floor)
    c.refusal =
        fmt::format("the {} is in the way: the track is too steep there to be levelled above it", bottom_name(task));
  else c.levels = levels_between(c, floor);
  return c;
}

// Adds the candidates that turns and levels give, in their order.
void consider_all(CircuitCandidates& c) {
  const double floor = floor_of(c.task);
  ClosingCurve closing{c.in, c.out, {}, {}};
  for (std::size_t i = 0; i < c.turns.size(); ++i) {
    closing.turns = c.turns[i].rough;
    for (int level = -1; level < static_cast<int>(c.levels.size()); ++level) {
      const bool room = consider({i, level, false}, floor, closing, c) || consider({i, level, true}, floor, closing, c);
      if (!room) ++c.losses.steep;
    }
  }
}

void sort_by_cost(CircuitCandidates& c) { std::ranges::stable_sort(c.list, {}, &CircuitCandidate::cost); }

// Returns by how much the two turns differ from a former closing section's, rad.
double turned_from(const world::ClosingPlan& former, const TurnChoice& choice) {
  const auto differs = [](double was_deg, const Bend& is) {
    return std::abs(is.to - is.from - base::radians(was_deg));
  };
  return differs(former.first, choice.rough.first) + differs(former.second, choice.rough.second);
}

// Returns how much the shape changes from the former one to a candidate, approximately in metres.
double unlikeness(const world::ClosingPlan& former, const CircuitCandidates& c, const CircuitCandidate& candidate) {
  constexpr double kTurn = 40, kOtherSlopes = 15, kOtherBends = 5;  // m per rad, m, m
  const TurnChoice& choice = c.turns[candidate.turns];
  double sum = kTurn * turned_from(former, choice) + std::abs(choice.before - former.before) +
               std::abs(choice.after - former.after) + 2.0 * std::abs(choice.radius - former.radius);
  if (former.level != (candidate.level >= 0)) sum += kOtherSlopes;
  else if (former.level) sum += std::abs(c.levels[static_cast<std::size_t>(candidate.level)] - former.height);
  return sum + (candidate.tight != former.tight ? kOtherBends : 0.0);
}

}  // namespace

ClosingCurve CircuitCandidates::rough(const CircuitCandidate& candidate) const {
  ClosingCurve closing{in, out, turns[candidate.turns].rough, {}};
  if (const std::optional<HeightProfile> heights = heights_of(*this, candidate, closing.turns))
    closing.heights = *heights;
  return closing;
}

std::optional<ClosingCurve> CircuitCandidates::exact(const CircuitCandidate& candidate) const {
  const std::optional<TurnsInPlan> found = exact_turns(in.pose, out.pose, turns[candidate.turns]);
  if (!found) return std::nullopt;
  const std::optional<HeightProfile> heights = heights_of(*this, candidate, *found);
  if (!heights) return std::nullopt;
  return ClosingCurve{in, out, *found, *heights};
}

world::ClosingPlan CircuitCandidates::described(const CircuitCandidate& candidate, const ClosingCurve& exact) const {
  const TurnChoice& choice = turns[candidate.turns];
  const auto turned = [](const Bend& bend) {
    return std::clamp(base::degrees(bend.to - bend.from), -world::kMostTurned_deg, world::kMostTurned_deg);
  };
  world::ClosingPlan closing{turned(exact.turns.first), turned(exact.turns.second), choice.radius, choice.before,
                             choice.after};
  closing.level = candidate.level >= 0;
  if (closing.level) closing.height = levels[static_cast<std::size_t>(candidate.level)];
  closing.tight = candidate.tight;
  closing.speed = std::min(task.speed, world::kFastestPlanned), closing.coasts = task.coasts;
  return closing;
}

CircuitCandidates circuit_candidates(const CircuitTask& task) {
  CircuitCandidates c = prepared(task);
  if (!c.refusal.empty()) return c;
  const double start = task.speed * task.speed, end = c.arrival * c.arrival;
  std::array<double, std::size(kSideG)> radii{};
  for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = radius_for(std::max(start, end), kSideG[i], kLeastRadii[i]);
  c.turns = turn_choices(c.in.pose, c.out.pose, radii, kStraights, shortest_turn(task));
  consider_all(c);
  sort_by_cost(c);
  return c;
}

CircuitCandidates candidates_like(const world::ClosingPlan& former, const CircuitTask& task) {
  constexpr double kMostTurned = 1;  // rad, of both turns together, from the former ones
  constexpr double kWider = 1.2;     // a larger radius to try
  CircuitCandidates c = prepared(task);
  if (!c.refusal.empty()) return c;
  if (former.level) c.levels.insert(c.levels.begin(), former.height);
  std::vector<double> straights{former.before, former.after, 0.0};
  std::sort(straights.begin(), straights.end());
  straights.erase(std::unique(straights.begin(), straights.end()), straights.end());
  const double radii[] = {former.radius, std::min(kWider * former.radius, world::kWidestTurn)};
  c.turns = turn_choices(c.in.pose, c.out.pose, radii, straights, shortest_turn(task));
  std::erase_if(c.turns, [&](const TurnChoice& choice) { return turned_from(former, choice) > kMostTurned; });
  consider_all(c);
  for (CircuitCandidate& candidate : c.list) candidate.cost = unlikeness(former, c, candidate);
  sort_by_cost(c);
  return c;
}

}  // namespace coaster::sim
