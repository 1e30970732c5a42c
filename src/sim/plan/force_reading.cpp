#include "sim/plan/force_reading.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "curve/continuity.h"
#include "sim/plan/force_solve.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using world::ForceKey;

constexpr double kReadStep = 0.5;  // m between readings

// The values felt along the run, by channel.
struct Readings {
  std::array<std::vector<double>, 3> values;
  double step = 0;      // m
  std::string refusal;  // why keys cannot describe the run
};

Readings readings_of(const TrackRun& run, const ForceTask& start) {
  const auto steps = static_cast<std::size_t>(std::ceil(run.length() / kReadStep));
  Readings readings;
  readings.step = run.length() / static_cast<double>(steps);
  const ForceLaw law(start);
  ForceState state = law.start();
  for (std::size_t i = 0; i <= steps; ++i) {
    const double s = readings.step * static_cast<double>(i);
    const ElementPoint here = run.at(s);
    state.position = here.position, state.tangent = here.tangent, state.up = here.up;
    constexpr double kBeside = 0.05;  // m
    const double before = std::max(s - kBeside, 0.0), after = std::min(s + kBeside, run.length());
    ForceRates track{here.curvature, here.spin, (run.at(after).spin - run.at(before).spin) / (after - before)};
    track.along = law.along(state);
    const FeltG felt = felt_on(state, track, start.riders);
    const std::array<double, 3> values{felt.up, felt.side, base::degrees(here.spin)};
    for (std::size_t c = 0; c < 3; ++c) {
      readings.values[c].push_back(values[c]);
      const world::ForceChannelRow& row = world::kForceChannels[c];
      if (!(std::abs(values[c]) <= row.limit))
        readings.refusal =
            fmt::format("{} would be {:.1f} {} at {:.1f} m, and keys allow {}", row.name, values[c],
                        world::unit_of(start.program, static_cast<world::ForceChannel>(c)), s, row.limit);
    }
    const ForceState former = state;
    state.square += 2 * readings.step * track.along, state.length += readings.step;
    law.settle(former, state);
    if (i < steps && law.too_slow(state))
      readings.refusal = fmt::format("the train falls below {} m/s at {:.1f} m", world::kSlowestForce, s);
    if (!readings.refusal.empty()) break;
  }
  return readings;
}

// Returns lateral keys at the positions of the roll's keys: riders above the curve feel the roll's change sideways, and
// its slope changes its formula there.
std::vector<ForceKey> beside_roll(const Readings& readings, const ForceTask& task) {
  std::vector<ForceKey> keys = task.program.keys(world::ForceChannel::roll);
  for (ForceKey& key : keys) {
    const auto index = static_cast<std::size_t>(key.at / readings.step + 0.5);
    key.value = readings.values[1][std::min(index, readings.values[1].size() - 1)];
  }
  return keys;
}

// Returns keys with values of the readings, between which their curves differ from the readings by at most `unit` g, or
// 10 times as many degrees per metre. Each key is added at the largest error.
void put_keys(const Readings& readings, double unit, ForceTask& task) {
  for (std::size_t c = 0; c < 3; ++c)
    task.program.channels[c] = {{0, readings.values[c].front()}, {task.program.length, readings.values[c].back()}};
  for (const std::size_t c : {2, 0, 1}) {  // riders feel the roll's slope sideways
    const auto channel = static_cast<world::ForceChannel>(c);
    const std::vector<double>& values = readings.values[c];
    std::vector<ForceKey>& keys = task.program.channels[c];
    const auto place = [&](std::size_t i) {
      return i + 1 == values.size() ? task.program.length : readings.step * static_cast<double>(i);
    };
    if (c == 1 && task.riders != 0) keys = beside_roll(readings, task);
    while (keys.size() < world::kMostForceKeys) {
      with_slopes(task);
      const ForceCurve curve(task.program, channel);
      double most = c == 2 ? 10 * unit : unit;
      std::size_t worst = 0;
      for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const double off = std::abs(curve.at(place(i)).value - values[i]);
        const bool room = std::none_of(keys.begin(), keys.end(), [&](const ForceKey& key) {
          return std::abs(key.at - place(i)) < world::kKeyGap_m;
        });
        if (room && off > most) most = off, worst = i;
      }
      if (worst == 0) break;
      const ForceKey key{place(worst), values[worst]};
      keys.insert(std::upper_bound(keys.begin(), keys.end(), key.at,
                                   [](double at, const ForceKey& other) { return at < other.at; }),
                  key);
    }
  }
}

}  // namespace

ElementPoint TrackRun::at(double s) const {
  const double place = derived.starts[first] + std::clamp(s, 0.0, length());
  const auto begin = derived.starts.begin() + static_cast<std::ptrdiff_t>(first);
  const auto above = std::upper_bound(begin, begin + static_cast<std::ptrdiff_t>(count), place);
  const std::size_t index = std::max<std::ptrdiff_t>(above - derived.starts.begin(), 1) - 1;
  const SegmentShape& shape = derived.shape_at(index);
  const double local = place - derived.starts[index], t = shape.arc.parameter(local);
  const curve::Frame frame = frame_at(shape, local, t);
  return {s,
          curve::point(shape.key.cubic, t),
          frame.forward,
          curve::across(curve::curvature_vector(shape.key.cubic, t), frame.forward),
          frame.up,
          shape.roll.spin(local)};
}

OffRun off_run(const TrackRun& run, const std::vector<world::Knot>& knots) {
  constexpr int kPlaces = 16;
  OffRun off;
  double way = 0;
  std::size_t index = run.first;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const curve::Cubic cubic = curve::Cubic{knots[k - 1].position, world::out_handle(knots[k - 1]),
                                            world::in_handle(knots[k]), knots[k].position};
    const double length = curve::arc_length(cubic);
    for (int i = 1; i <= kPlaces; ++i) {
      const double t = static_cast<double>(i) / kPlaces;
      const glm::dvec3 here = curve::point(cubic, t);
      // Returns the distance from the segment of the last position and from the following ones, as long as they are
      // nearer.
      const auto distance = [&](std::size_t segment) {
        return curve::nearest_point(run.derived.shape_at(segment).key.cubic, here).distance;
      };
      double least = distance(index);
      for (std::size_t next = index + 1; next < run.first + run.count && next <= index + 3; ++next)
        if (const double there = distance(next); there < least) least = there, index = next;
      if (least > off.error) off = {least, way + t * length};
    }
    way += length;
  }
  return off;
}

namespace {

// True if the plan ends where the run does, so that the following track fits without moving.
bool ends_there(const ForcePlan& plan, const ElementPoint& end) {
  constexpr double kPlace = 1e-4, kAngle = 1e-5, kBend = 1e-4;  // m, rad, 1/m and rad/m
  const ElementPoint& last = plan.path.curve.points.back();
  return glm::distance(last.position, end.position) <= kPlace && glm::distance(last.tangent, end.tangent) <= kAngle &&
         glm::distance(last.up, end.up) <= kAngle && glm::distance(last.curvature, end.curvature) <= kBend &&
         std::abs(last.spin - end.spin) <= kBend;
}

}  // namespace

ForceReading read_forces(const TrackRun& run, const ForceTask& start) {
  ForceReading best;
  ForceTask task = start;
  task.program.over = world::ForceOver::distance, task.program.length = run.length();
  for (auto& keys : task.program.channels) keys.clear();
  if (const auto wrong = world::broken(task.program)) best.refusal = *wrong;
  const Readings readings = best.refusal.empty() ? readings_of(run, task) : Readings{};
  if (!readings.refusal.empty()) best.refusal = readings.refusal;
  if (!best.refusal.empty()) return best;
  const ForceGoal goal{[&](double s) { return run.at(s); }, run.at(run.length())};
  best.error = 1e9;
  for (const double unit : {0.4, 0.2, 0.1, 0.05, 0.02, 0.007, 0.003}) {
    put_keys(readings, unit, task);
    double way_error = 0;
    const auto solved = solve_forces(task, goal, way_error);
    if (!solved || (unit > 0.01 && way_error > 0.6 * kKeptShape)) continue;
    for (double tolerance = start.program.tolerance;; tolerance = std::max(tolerance / 2, world::kLeastTolerance)) {
      ForceTask planned = *solved;
      planned.program.tolerance = tolerance;
      ForcePlan plan = plan_force(planned);
      if (!plan.refusal.empty() || !plan.path.stopped.empty()) {
        best.refusal = plan.refusal.empty() ? stop_text(plan) : plan.refusal;
        break;
      }
      if (!ends_there(plan, goal.end)) break;
      const OffRun off = off_run(run, plan.fit.spans.knots);
      if (off.error < best.error) best = {std::move(plan), off.error, off.at, {}};
      if (best.error <= kKeptShape) return best;
      if (tolerance <= world::kLeastTolerance) break;
    }
  }
  if (best.error < 1e9)
    best.refusal = fmt::format("keys would keep its shape within {:.1f} mm, not within 10 mm, at {:.1f} m",
                               1000 * best.error, best.error_at);
  else if (best.refusal.empty()) best.refusal = "no keys lead along it at the train's speed";
  return best;
}

}  // namespace coaster::sim
