#include "sim/fit/track_samples.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "base/portable_math.h"
#include "world/motion.h"

namespace coaster::sim {

using glm::dvec3;

double frame_angle_deg(const curve::Frame& a, const curve::Frame& b) {
  // The squared distances of the three axes add up to 8 sin^2(angle / 2).
  const dvec3 f = a.forward - b.forward, u = a.up - b.up, l = a.left() - b.left();
  const double sine = std::sqrt(std::min(1.0, (glm::dot(f, f) + glm::dot(u, u) + glm::dot(l, l)) / 8));
  return base::degrees(2 * base::arc_tangent(sine, std::sqrt(1 - sine * sine)));
}

std::vector<double> row_jumps(std::span<const FitRow> rows, bool closed) {
  const std::size_t count = rows.size(), steps = closed ? count : count - 1;
  std::vector<double> angles, rates, jumps(steps, 0);
  for (std::size_t i = 0; i < steps; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    angles.push_back(frame_angle_deg({a.forward, a.up}, {b.forward, b.up}));
    rates.push_back(angles[i] / std::max(glm::distance(a.position, b.position), 1e-9));
  }
  for (std::size_t i = 0; i < steps; ++i) {
    const double before = closed || i > 0 ? rates[(i + steps - 1) % steps] : 0,
                 after = closed || i + 1 < steps ? rates[(i + 1) % steps] : 0;
    if (angles[i] > kJumpAngle && rates[i] > std::max(kJumpRate, kJumpTimes * std::max(before, after)))
      jumps[i] = angles[i];
  }
  return jumps;
}

double off_deg(const FitRow& a, const FitRow& b) {
  const auto angle = [](dvec3 u, dvec3 v) {
    return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
  };
  // The chord of an arc has the mean of the directions at its ends.
  const double off = angle(b.position - a.position, a.forward + b.forward);
  return off > kOffForward + angle(a.forward, b.forward) / 2 ? off : 0;
}

namespace {

// Returns the larger curvature at the ends of a step times its length, if it changes linearly in between.
double end_turn(const FitRow& a, const FitRow& b) {
  const dvec3 chord = glm::normalize(b.position - a.position);
  return std::max(glm::length(curve::across(6.0 * chord - 2.0 * b.forward, a.forward)),
                  glm::length(curve::across(6.0 * chord - 2.0 * a.forward, b.forward)));
}

}  // namespace

std::vector<double> bend_limits(std::span<const FitRow> rows, bool closed) {
  const auto count = static_cast<std::ptrdiff_t>(rows.size()), steps = closed ? count : count - 1;
  std::vector<double> starts{0}, bends, limits;
  for (std::ptrdiff_t i = 0; i < steps; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    const double length = std::max(glm::distance(a.position, b.position), 1e-9);
    starts.push_back(starts.back() + length);
    const double turn =
        base::arc_tangent(glm::length(glm::cross(a.forward, b.forward)), glm::dot(a.forward, b.forward));
    bends.push_back(std::max(turn, length < kLongStep ? 0 : end_turn(a, b)) / length);
  }
  const double whole = starts.back();
  // Distances of steps before the first and after the last, on a closed track.
  const auto lap = [&](std::ptrdiff_t i) { return i < 0 ? -1 : i >= steps ? 1 : 0; };
  const auto start = [&](std::ptrdiff_t i) { return starts[i - lap(i) * steps] + lap(i) * whole; };
  const auto bend = [&](std::ptrdiff_t i) { return bends[i - lap(i) * steps]; };
  const std::ptrdiff_t least = closed ? -steps : 0, most = closed ? 2 * steps : steps;
  // The steps near step i with falling curvatures: the first has the largest.
  std::deque<std::ptrdiff_t> near;
  std::ptrdiff_t next = 0;
  while (next > least && start(next) >= starts[1] - kBendReach) --next;
  for (std::ptrdiff_t i = 0; i < steps; ++i) {
    for (; next < most && start(next) <= start(i) + kBendReach; ++next) {
      while (!near.empty() && bend(near.back()) <= bend(next)) near.pop_back();
      near.push_back(next);
    }
    while (near.front() < i && start(near.front() + 1) < start(i + 1) - kBendReach) near.pop_front();
    limits.push_back(kBendShare * bend(near.front()) + kBendSpare);
  }
  return limits;
}

std::vector<double> row_speeds(std::span<const FitRow> rows) {
  double top = rows[0].position.y;
  for (const FitRow& row : rows) top = std::max(top, row.position.y);
  std::vector<double> speeds;
  for (const FitRow& row : rows) speeds.push_back(kTopSpeed * kTopSpeed / world::kGravity + 2 * (top - row.position.y));
  return speeds;
}

std::vector<char> near_jumps(std::span<const FitRow> rows, bool closed, double reach) {
  const std::size_t count = rows.size();
  std::vector<char> near(count, 0);
  std::vector<double> steps(count, 0), jumps = row_jumps(rows, closed);
  jumps.resize(count);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
    steps[i] = glm::distance(rows[i].position, rows[(i + 1) % count].position);
  // Computes the distance to the last jump in a forward pass, then to the next in a backward pass, from the middle of
  // the jump's step. A closed track needs two rounds, because the second knows the jumps of the first.
  const std::size_t laps = closed ? 2 * count : count;
  double gone = 2 * reach + 1;
  for (std::size_t n = 1; n < laps; ++n) {
    const std::size_t k = n % count, before = (n - 1) % count;
    gone = jumps[before] > 0 ? 0.5 * steps[before] : gone + steps[before];
    if (gone <= reach) near[k] = 1;
  }
  gone = 2 * reach + 1;
  for (std::size_t n = laps - (closed ? 0 : 1); n-- > 0;) {
    const std::size_t k = n % count;
    gone = jumps[k] > 0 ? 0.5 * steps[k] : gone + steps[k];
    if (gone <= reach) near[k] = 1;
  }
  return near;
}

bool rows_close(std::span<const FitRow> rows, double rounding) {
  if (rows.size() < 4) return false;
  const FitRow &first = rows.front(), &last = rows.back();
  double longest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    longest = std::max(longest, glm::distance(rows[i - 1].position, rows[i].position));
  const dvec3 gap = first.position - last.position;
  constexpr double kSameWay = 0.5;  // cosine
  return glm::length(gap) <= 1.01 * longest + rounding && glm::dot(gap, last.forward) >= -rounding &&
         glm::dot(first.forward, last.forward) > kSameWay;
}

double float_spacing(std::span<const FitRow> rows, int axis) {
  float most = 0;
  for (const FitRow& row : rows) most = std::max(most, std::abs(static_cast<float>(row.position[axis])));
  return std::nextafter(most, std::numeric_limits<float>::infinity()) - most;
}

}  // namespace coaster::sim
