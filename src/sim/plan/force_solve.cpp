#include "sim/plan/force_solve.h"

#include <algorithm>
#include <cmath>

#include "base/numerics.h"
#include "base/parallel.h"
#include "base/portable_math.h"

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

class LeastSquares {
 public:
  LeastSquares(const ForceTask& task, const ForceGoal& goal) : task_(task), goal_(goal) {
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
  return LeastSquares(task, goal).run(way_error);
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

}  // namespace coaster::sim
