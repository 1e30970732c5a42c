#include "sim/plan/force_keys_from_track.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numerics.h"
#include "base/parallel.h"
#include "base/portable_math.h"
#include "curve/continuity.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;
using world::ForceKey;

// The size of a residual of 1.
constexpr double kWayUnit = 0.002, kRollUnit = 0.002;  // m, rad
// Units for the end: m; rad, 1/m and rad/m. At first as coarse as along the way, because the steps are far from linear
// then.
struct EndUnits {
  double place, angle;
};
constexpr EndUnits kEndUnits[] = {{2e-3, 2e-3}, {1e-4, 2e-5}, {3e-6, 3e-7}};
constexpr double kChangeUnit_g = 0.5, kChangeUnit_deg = 5;  // of a key
constexpr std::size_t kEachPoint = 4;                       // every fourth point of the trace is used

// Returns the unknowns: each channel's keys except the first.
std::vector<double*> unknowns_of(ForceTask& task) {
  std::vector<double*> unknowns;
  for (auto& keys : task.program.channels)
    for (std::size_t i = 1; i < keys.size(); ++i) unknowns.push_back(&keys[i].value);
  return unknowns;
}

class KeySolver {
 public:
  KeySolver(const ForceTask& task, const ForceGoal& goal) : task_(task), goal_(goal) {
    with_slopes(task_);
    first_ = values();
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 1; i < task_.program.channels[c].size(); ++i)
        units_.push_back(c == 2 ? kChangeUnit_deg : kChangeUnit_g);
    for (const double at : trace_force(task_).at) way_.push_back(goal.way(at));
  }

  std::optional<ForceTask> run(double& way_error) {
    std::optional<std::vector<double>> off = residuals(task_);
    if (!off) return std::nullopt;
    for (const EndUnits& units : kEndUnits) {
      end_ = units;
      off = residuals(task_);
      improve(*off);
    }
    way_error = 0;
    const std::vector<ForceState> states = trace_force(task_).states;
    for (std::size_t i = 0; i < states.size(); ++i)
      way_error = std::max(way_error, glm::distance(states[i].position, way_[i].position));
    return task_;
  }

 private:
  void improve(std::vector<double> off) {
    double damping = 1;
    for (int step = 0; step < 20; ++step) {
      const double before = square(off);
      make_normal(off);
      bool better = false;
      for (; damping < 1e12 && !better; damping *= 8) {
        const ForceTask tried = moved(solved(damping));
        auto there = residuals(tried);
        if (!there || !(square(*there) < before)) continue;
        task_ = tried, off = std::move(*there), better = true;
        damping /= 80;
      }
      if (!better || before - square(off) < 1e-4 * before) break;
    }
  }

  std::vector<double> values() {
    std::vector<double> all;
    for (const double* const value : unknowns_of(task_)) all.push_back(*value);
    return all;
  }
  static double square(const std::vector<double>& off) {
    double sum = 0;
    for (const double value : off) sum += value * value;
    return sum;
  }
  ForceTask moved(const std::vector<double>& by) const {
    ForceTask task = task_;
    const std::vector<double*> unknowns = unknowns_of(task);
    for (std::size_t i = 0; i < by.size(); ++i) *unknowns[i] += by[i];
    with_slopes(task);
    return task;
  }

  std::optional<std::vector<double>> residuals(const ForceTask& task) const {
    const ForceTrace trace = trace_force(task);
    if (!trace.complete || trace.at.size() != way_.size()) return std::nullopt;
    std::vector<double> off;
    for (std::size_t i = kEachPoint; i < way_.size(); i += kEachPoint) {
      const ElementPoint& to = way_[i];
      const dvec3 by = trace.states[i].position - to.position, left = glm::cross(to.up, to.tangent);
      off.push_back(glm::dot(by, to.up) / kWayUnit), off.push_back(glm::dot(by, left) / kWayUnit);
      off.push_back(glm::dot(trace.states[i].up, left) / kRollUnit);
    }
    const ElementPoint& end = goal_.end;
    const ForceState& last = trace.states.back();
    const dvec3 by = last.position - end.position, left = glm::cross(end.up, end.tangent),
                bend = trace.last.curvature - end.curvature;
    for (int axis = 0; axis < 3; ++axis) off.push_back(by[axis] / end_.place);
    for (const dvec3 axis : {end.up, left}) {
      off.push_back(glm::dot(last.tangent, axis) / end_.angle);
      off.push_back(glm::dot(bend, axis) / end_.angle);
    }
    off.push_back(glm::dot(last.up, left) / end_.angle), off.push_back((trace.last.spin - end.spin) / end_.angle);
    ForceTask own = task;
    const std::vector<double*> now = unknowns_of(own);
    for (std::size_t i = 0; i < now.size(); ++i) off.push_back((*now[i] - first_[i]) / units_[i]);
    return off;
  }

  // Sets J^T J and J^T r, in units of the unknowns.
  void make_normal(const std::vector<double>& off) {
    const std::size_t n = units_.size(), rows = off.size();
    std::vector<std::vector<double>> slopes(n);
    base::in_parts(n, 1, base::cores(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        constexpr double kStep = 1e-6;  // of its unit
        std::vector<double> by(n, 0.0);
        by[k] = kStep * units_[k];
        const auto beside = residuals(moved(by));
        slopes[k].assign(rows, 0.0);
        if (beside)
          for (std::size_t r = 0; r < rows; ++r) slopes[k][r] = ((*beside)[r] - off[r]) / kStep;
      }
    });
    normal_.assign(n * n, 0.0), right_.assign(n, 0.0);
    base::in_parts(n, 4, base::cores(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = 0; j <= i; ++j)
          for (std::size_t r = 0; r < rows; ++r) normal_[i * n + j] += slopes[i][r] * slopes[j][r];
        for (std::size_t r = 0; r < rows; ++r) right_[i] -= slopes[i][r] * off[r];
      }
    });
  }

  // Returns the change of the unknowns with that damping, by a Cholesky factorisation.
  std::vector<double> solved(double damping) const {
    const std::size_t n = units_.size();
    std::vector<double> a = normal_;
    for (std::size_t i = 0; i < n; ++i) a[i * n + i] += damping * (1 + 1e-9 * a[i * n + i]);
    std::vector<double> x = base::solve_positive(std::move(a), right_);
    for (std::size_t i = 0; i < n; ++i) x[i] *= units_[i];
    return x;
  }

  ForceTask task_;
  EndUnits end_ = kEndUnits[0];
  const ForceGoal& goal_;
  std::vector<double> first_, units_;
  std::vector<ElementPoint> way_;
  std::vector<double> normal_, right_;
};

}  // namespace

void with_slopes(ForceTask& task) {
  auto& channels = task.program.channels;
  const auto shape = [](std::vector<ForceKey>& keys) {
    const auto rise = [&](std::size_t i) {
      return (keys[i + 1].value - keys[i].value) / (keys[i + 1].at - keys[i].at);
    };
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
      const double before = keys[i].at - keys[i - 1].at, after = keys[i + 1].at - keys[i].at;
      keys[i].slope = (after * rise(i - 1) + before * rise(i)) / (before + after);
    }
    if (keys.size() < 3) {
      for (ForceKey& key : keys) key.slope = keys.size() == 2 ? rise(0) : 0;
      return;
    }
    keys.front().slope = 2 * rise(0) - keys[1].slope;
    keys.back().slope = 2 * rise(keys.size() - 2) - keys[keys.size() - 2].slope;
  };
  for (const std::size_t c : {2, 1, 0}) {  // riders feel the roll's slope sideways
    channels[c].front().value = ForceLaw(task).found_at_start()[c];
    shape(channels[c]);
  }
}

std::optional<ForceTask> solve_forces(const ForceTask& task, const ForceGoal& goal, double& way_error) {
  return KeySolver(task, goal).run(way_error);
}

ForceTrace trace_force(const ForceTask& task) {
  constexpr double kStep = 0.25;  // m, as force_path.cpp's
  const ForceLaw law(task);
  ForceTrace trace{{0}, {law.start()}, {}, false};
  trace.complete = follow_law(law, kStep, 0, law.start(), [&](double x, const ForceState& state) {
    if (law.too_slow(state)) return false;
    trace.at.push_back(x), trace.states.push_back(state);
    return true;
  });
  if (trace.complete) trace.last = law.rates(trace.at.back(), trace.states.back());
  return trace;
}

namespace {

constexpr double kReadStep = 0.5;  // m between readings

// The values felt along the run, by channel.
struct FeltAlongRun {
  std::array<std::vector<double>, 3> values;
  double step = 0;      // m
  std::string refusal;  // why keys cannot describe the run
};

FeltAlongRun readings_of(const TrackRun& run, const ForceTask& start) {
  const auto steps = static_cast<std::size_t>(std::ceil(run.length() / kReadStep));
  FeltAlongRun readings;
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
std::vector<ForceKey> beside_roll(const FeltAlongRun& readings, const ForceTask& task) {
  std::vector<ForceKey> keys = task.program.keys(world::ForceChannel::roll);
  for (ForceKey& key : keys) {
    const auto index = static_cast<std::size_t>(key.at / readings.step + 0.5);
    key.value = readings.values[1][std::min(index, readings.values[1].size() - 1)];
  }
  return keys;
}

// Returns keys with values of the readings, between which their curves differ from the readings by at most `unit` g, or
// 10 times as many degrees per metre. Each key is added at the largest error.
void put_keys(const FeltAlongRun& readings, double unit, ForceTask& task) {
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
        const bool room = std::ranges::none_of(
            keys, [&](const ForceKey& key) { return std::abs(key.at - place(i)) < world::kKeyGap_m; });
        if (room && off > most) most = off, worst = i;
      }
      if (worst == 0) break;
      const ForceKey key{place(worst), values[worst]};
      keys.insert(std::ranges::upper_bound(keys, key.at, {}, &ForceKey::at), key);
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

RunDeviation off_run(const TrackRun& run, const std::vector<world::Knot>& knots) {
  constexpr int kPlaces = 16;
  RunDeviation off;
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

RunForcePlan read_forces(const TrackRun& run, const ForceTask& start) {
  RunForcePlan best;
  ForceTask task = start;
  task.program.over = world::ForceDomain::distance, task.program.length = run.length();
  for (auto& keys : task.program.channels) keys.clear();
  if (const auto wrong = world::broken(task.program)) best.refusal = *wrong;
  const FeltAlongRun readings = best.refusal.empty() ? readings_of(run, task) : FeltAlongRun{};
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
      const RunDeviation off = off_run(run, plan.fit.spans.knots);
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
