// Random force programs, and the track that they require by another method than the program's: in long double, with the
// whole frame turned by rotations (Rodrigues) about axes in the middle of steps a hundred times finer, and with all
// values found by regula falsi and iteration instead of closed forms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "sim/plan/force_path.h"

namespace coaster::test {

using Long = long double;
using Vector = std::array<Long, 3>;

class ForceOracle {
 public:
  explicit ForceOracle(const sim::ForceTask& task) : task_(task) {
    const auto of = [](glm::dvec3 v) { return Vector{v.x, v.y, v.z}; };
    position = of(task.end.position), forward = of(task.end.forward), up = of(task.end.up);
    square = Long{task.program.speed} * task.program.speed;
  }
  Vector position, forward, up;
  Long square, length = 0, time = 0, at = 0;

  // Returns the value that a channel's keys ask for, with what is added to them; without the ramp at the start.
  Long asked(world::ForceChannel channel, Long x) const {
    const bool forces = task_.program.of == world::ForceQuantity::forces;
    const Long usual = forces && channel == world::ForceChannel::vertical ? 1 : 0;
    const auto& keys = task_.program.keys(channel);
    const Long beyond = forces || channel != world::ForceChannel::roll || keys.empty() || x <= keys.back().at
                            ? Long{0}
                            : keys.back().slope * (x - keys.back().at);  // rolls on if it is held farther away
    return of_keys(keys, usual, x) + beyond +
           (task_.added && (forces || channel != world::ForceChannel::roll) ? of_keys(task_.added->keys(channel), 0, x)
                                                                            : Long{0});
  }

  static Long of_keys(const std::vector<world::ForceKey>& keys, Long usual, Long x) {
    if (keys.empty()) return usual;
    if (x <= keys.front().at) return keys.front().value;
    for (std::size_t i = 1; i < keys.size(); ++i)
      if (x < keys[i].at) return on_curve(keys[i - 1], keys[i], x);
    return keys.back().value;
  }

  // Goes on to that place of the axis.
  void go_to(Long x, Long finest = 0.0025L) {
    const bool by_time = task_.program.over == world::ForceDomain::time;
    while (at < x) {
      const Long step = std::min(x - at, by_time ? finest / std::sqrt(square) : finest);
      const State before = state(), middle = moved(before, rates(before), step / 2);
      put(moved(before, rates(middle), step));
    }
  }

 private:
  struct State {
    Vector position, forward, up;
    Long square, length, time, at;
  };
  struct Rates {  // by the axis
    Vector turn, move;
    Long square, length, time;
  };
  State state() const { return {position, forward, up, square, length, time, at}; }
  void put(const State& s) {
    position = s.position, forward = s.forward, up = s.up, square = s.square, length = s.length, time = s.time,
    at = s.at;
  }

  static Long dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Vector sum(const Vector& a, Long f, const Vector& b) {
    return {a[0] + f * b[0], a[1] + f * b[1], a[2] + f * b[2]};
  }

  static Long on_curve(const world::ForceKey& a, const world::ForceKey& b, Long x) {
    const Long third = (Long{b.at} - a.at) / 3;
    const auto bezier = [](Long p, Long q, Long r, Long s, Long u) {
      const auto mix = [&](Long m, Long n) { return m + u * (n - m); };
      return mix(mix(mix(p, q), mix(q, r)), mix(mix(q, r), mix(r, s)));
    };
    const Long after = a.after > 0 ? Long{a.after} : third, before = b.before > 0 ? Long{b.before} : third;
    // Regula falsi that halves the value of an end that stays (Illinois), until neither end moves by more than
    // rounding.
    const auto miss = [&](Long u) { return bezier(a.at, a.at + after, b.at - before, b.at, u) - x; };
    Long low = 0, high = 1, at_low = a.at - x, at_high = b.at - x, u = 0;
    for (int i = 0, stays = 0; i < 100 && high - low > 1e-18L; ++i) {
      u = high - at_high * (high - low) / (at_high - at_low);
      const Long at = miss(u);
      if (std::abs(at) < 1e-17L * (1 + std::abs(x))) break;
      if (at < 0) {
        low = u, at_low = at, at_high *= stays < 0 ? 0.5L : 1.0L, stays = -1;
      } else {
        high = u, at_high = at, at_low *= stays > 0 ? 0.5L : 1.0L, stays = 1;
      }
    }
    return bezier(a.value, a.value + after * a.slope, b.value - before * b.slope, b.value, u);
  }

  // From felt g of riders d above the curve, with the rates of turn about left and up found by iteration.
  Rates rates(const State& s) const {
    const bool by_time = task_.program.over == world::ForceDomain::time;
    // Curvature goes on where the train stops.
    const bool bends = task_.program.of == world::ForceQuantity::curvature;
    const Long g = 9.81L, d = task_.riders, speed = std::sqrt(bends ? std::max(s.square, Long{1}) : s.square),
               radian = std::acos(-1.0L) / 180;
    const Vector left = cross(s.up, s.forward);
    const Long along = -g * s.forward[1] - (g * task_.losses.rolling + task_.losses.drag * s.square);
    const Long small = by_time ? 1e-5L : 1e-4L;
    const auto roll_at = [&](Long x) {
      if (!bends) return radian * asked(world::ForceChannel::roll, x);
      const Long rate =
          (asked(world::ForceChannel::roll, x + small) - asked(world::ForceChannel::roll, x - small)) / (2 * small);
      return radian * (rate + (task_.added ? of_keys(task_.added->keys(world::ForceChannel::roll), 0, x) : Long{0}));
    };
    const Long roll = roll_at(s.at), change = (roll_at(s.at + small) - roll_at(s.at - small)) / (2 * small);
    // Angular velocity and acceleration of the roll by time.
    const Long omega = by_time ? roll : roll * speed, alpha = by_time ? change : change * s.square + roll * along;
    const Long up_wanted = asked(world::ForceChannel::vertical, s.at) * g - g * s.up[1],
               left_wanted = asked(world::ForceChannel::lateral, s.at) * g - g * left[1];
    // The heart's acceleration: that of the curve, centripetal and tangential parts of a body that turns with pitch and
    // yaw p, y (rad/s) and rolls with omega; d above the curve along up.
    Long pitch = 0, yaw = 0;
    Long moved = bends ? 0 : 1;
    if (bends)
      pitch = speed * asked(world::ForceChannel::vertical, s.at),
      yaw = speed * asked(world::ForceChannel::lateral, s.at);
    for (int i = 0; i < 60 && moved > 1e-17L; ++i) {
      const Long pitched = (up_wanted + d * (pitch * pitch + omega * omega)) / speed;
      const Long yawed = (left_wanted + d * alpha + d * pitch * yaw) / speed;
      moved = std::abs(pitched - pitch) + std::abs(yawed - yaw), pitch = pitched, yaw = yawed;
    }
    const Long per = by_time ? 1 : 1 / speed;  // s per unit of the axis
    Rates r;
    // Turning up is towards `up` about -left; turning left is about `up`; rolling right is about `forward`.
    for (std::size_t i = 0; i < 3; ++i) {
      r.turn[i] = per * (omega * s.forward[i] - pitch * left[i] + yaw * s.up[i]);
      r.move[i] = per * speed * s.forward[i];
    }
    r.square = 2 * along * speed * per, r.length = speed * per, r.time = per;
    return r;
  }

  static Vector turned(const Vector& v, const Vector& turn, Long by) {
    const Long size = std::sqrt(dot(turn, turn));
    if (size == 0) return v;
    const Long angle = size * by, c = std::cos(angle), s = std::sin(angle);
    const Vector axis{turn[0] / size, turn[1] / size, turn[2] / size}, across = cross(axis, v);
    const Long along = dot(axis, v);
    Vector result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = c * v[i] + s * across[i] + (1 - c) * along * axis[i];
    return result;
  }
  static State moved(const State& s, const Rates& r, Long by) {
    return {sum(s.position, by, r.move),
            turned(s.forward, r.turn, by),
            turned(s.up, r.turn, by),
            s.square + by * r.square,
            s.length + by * r.length,
            s.time + by * r.time,
            s.at + by};
  }

  const sim::ForceTask& task_;
};

// Smooth programs of curvature at random, over distance, that reach their end. They begin straight.
class RandomCurvature {
 public:
  explicit RandomCurvature(unsigned seed) : random_(seed) {}

  sim::ForceTask next(double metres) {
    for (;;) {
      sim::ForceTask task;
      task.end.position = {3, 120, -7};
      task.losses = {0.02f, 2e-5f}, task.riders = 1.1;
      world::ForceProgram& program = task.program;
      program.of = world::ForceQuantity::curvature, program.speed = uniform(12, 30), program.length = metres;
      for (std::size_t c = 0; c < 3; ++c) {
        program.channels[c] = {{0, 0}};
        for (double at = 0; at < metres;) {
          at = std::min(at + uniform(8, 20), metres);
          if (metres - at < 8) at = metres;
          const double most = c == 2 ? 90 : 0.03;
          program.channels[c].push_back({at, uniform(-most, most), c == 2 ? uniform(-2, 2) : uniform(-1e-3, 1e-3)});
        }
      }
      if (sim::force_path(task).stopped.empty()) return task;
    }
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::mt19937 random_;
};

// Smooth programs at random for trains of at most 35 m/s, up to 5 g, that reach their end: each key is one of some that
// let the train go on, neither below 9 m/s nor near the ground.
class RandomForces {
 public:
  explicit RandomForces(unsigned seed) : random_(seed) {}

  sim::ForceTask next(double metres) {
    for (;;)
      if (auto task = attempt(metres)) return *task;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  static bool rideable(const sim::ForcePath& path) {
    return path.stopped.empty() && std::ranges::all_of(path.points, [](const sim::ForcePoint& p) {
             return p.square >= 9 * 9 && p.square <= 34.9 * 34.9;
           });
  }

  std::optional<sim::ForceTask> attempt(double metres) {
    sim::ForceTask task;
    task.end.position = {0, 50, 0};
    task.losses = {0.02f, 2e-5f};
    task.riders = uniform(0, 1) < 0.5 ? 1.1 : 0;
    world::ForceProgram& program = task.program;
    program.over = uniform(0, 1) < 0.5 ? world::ForceDomain::time : world::ForceDomain::distance;
    program.speed = uniform(20, 30);
    const bool by_time = program.over == world::ForceDomain::time;
    for (std::size_t c = 0; c < 3; ++c) program.channels[c] = {{0, c == 0 ? 1.0 : 0.0}};
    sim::ElementPoint end{0, task.end.position};
    double at = 0, speed = program.speed;
    while (end.s < metres) {
      const double next = at + uniform(0.5, 1.3) * (by_time ? 1 : speed);
      std::optional<sim::ForcePath> found;
      for (int i = 0; i < 12 && !found; ++i) {
        sim::ForceTask tried = task;
        const double steer = -2.5 * (end.tangent.y - 0.02 * (50 - end.position.y)),
                     bank = glm::cross(end.up, end.tangent).y;
        const double g = uniform(0, 1) < 0.3 ? 4.9 : end.up.y + uniform(-1.5, 1.5) + steer;
        tried.program.channels[0].push_back({next, std::clamp(g, -1.0, 4.95)});
        tried.program.channels[1].push_back({next, uniform(-0.5, 0.5)});
        tried.program.channels[2].push_back({next, (uniform(-30, 30) - 50 * bank) / (by_time ? 1 : speed)});
        tried.program.length = next;
        sim::ForcePath path = sim::force_path(tried);
        if (rideable(path)) task = tried, found = std::move(path);
      }
      if (!found) return std::nullopt;
      end = found->curve.points.back(), speed = std::sqrt(found->points.back().square), at = next;
    }
    return task;
  }

  std::mt19937 random_;
};

}  // namespace coaster::test
