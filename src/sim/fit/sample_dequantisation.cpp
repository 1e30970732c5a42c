#include "sim/fit/sample_dequantisation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/cancellable_job.h"
#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Where a curve passes, and its derivative there.
struct Rounded {
  double s;  // m along the curve
  dvec3 value, rate;
};

// The four cubic B-splines that are not 0 at x in [0, 1] of a part, and their derivatives by x.
struct BSplines {
  std::array<double, 4> value, rate;
  explicit BSplines(double x) {
    const double y = 1 - x;
    value = {y * y * y / 6, (x * x * (3 * x - 6) + 4) / 6, (y * y * (3 * y - 6) + 4) / 6, x * x * x / 6};
    rate = {-y * y / 2, x * (3 * x - 4) / 2, y * (4 - 3 * y) / 2, x * x / 2};
  }
};

// The normal equations of B-splines' coefficients: symmetric, each coupled with the three after it.
struct NormalEquations {
  std::vector<std::array<double, 4>> factors;
  std::vector<dvec3> right;
  explicit NormalEquations(std::size_t count) : factors(count, {0, 0, 0, 0}), right(count, dvec3(0)) {}
  // Adds a condition: coefficients from the first one on, times `row`, are to be `value`.
  void add(std::size_t first, const std::array<double, 4>& row, double weight, dvec3 value) {
    for (std::size_t m = 0; m < 4; ++m) {
      right[first + m] += weight * row[m] * value;
      for (std::size_t n = m; n < 4; ++n) factors[first + m][n - m] += weight * row[m] * row[n];
    }
  }
  std::vector<dvec3> solve() {
    const auto end = [&](std::size_t k) { return std::min<std::size_t>(4, right.size() - k); };
    for (std::size_t k = 0; k < right.size(); ++k)
      for (std::size_t m = 1; m < end(k); ++m) {
        const double share = factors[k][m] / factors[k][0];
        for (std::size_t n = m; n < 4; ++n) factors[k + m][n - m] -= share * factors[k][n];
        right[k + m] -= share * right[k];
      }
    for (std::size_t k = right.size(); k-- > 0;) {
      for (std::size_t m = 1; m < end(k); ++m) right[k] -= factors[k][m] * right[k + m];
      right[k] /= factors[k][0];
    }
    return std::move(right);
  }
};

// Returns the smoothest curve within half a step of each row, at the rows: the cubic spline whose third derivative is
// least. Rates are only followed across their direction, and not at all if their step is 0.
std::vector<Rounded> smoothest(std::span<const Rounded> rows, double step, double rate_step) {
  constexpr int kRounds = 16;
  constexpr double kLeast = 1e-4, kMost = 1e6, kAtOnce = 4;  // of weights, and their growth in a round
  constexpr double kChange = 0.02;  // 1/m^2 of the third derivative: costs as much as half a step over as many metres
  constexpr double kTold = 0.1;     // of the progress of an import
  const double length = rows.back().s, spacing = length / static_cast<double>(rows.size() - 1);
  const auto parts = static_cast<std::size_t>(std::ceil(length / std::max(kSites, spacing / 2)));
  const double h = length / static_cast<double>(parts), h2 = h * h, change = 1 / (kChange * kChange * h2 * h2 * h),
               weight = spacing * 4 / (step * step), rate_weight = spacing * 4 / (rate_step * rate_step * h2);
  std::vector<double> shares(rows.size(), 1), rate_shares(rows.size(), 1);
  std::vector<Rounded> found(rows.begin(), rows.end());
  std::vector<dvec3> sites;
  for (int round = 0; round <= kRounds && !base::interrupted(); ++round) {
    NormalEquations normal(parts + 3);
    for (std::size_t k = 0; k < parts; ++k) normal.add(k, {-1, 3, -3, 1}, change, dvec3(0));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Rounded& row = rows[i];
      const std::size_t k = std::min(static_cast<std::size_t>(row.s / h), parts - 1);
      const BSplines basis(row.s / h - static_cast<double>(k));
      if (round > 0) {
        found[i] = {row.s, dvec3(0), dvec3(0)};
        for (std::size_t m = 0; m < 4; ++m)
          found[i].value += basis.value[m] * sites[k + m], found[i].rate += basis.rate[m] / h * sites[k + m];
        const auto weigh = [&](double& share, dvec3 off, double most) {
          const double times = 2 * std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) / most;
          share = std::clamp(share * std::clamp(times * times, 1 / kAtOnce, kAtOnce), kLeast, kMost);
        };
        weigh(shares[i], found[i].value - row.value, step);
        if (rate_step > 0) weigh(rate_shares[i], curve::across(found[i].rate, row.rate), rate_step);
      }
      normal.add(k, basis.value, weight * shares[i], row.value);
      if (rate_step > 0)
        normal.add(k, basis.rate, rate_weight * rate_shares[i], h * glm::dot(row.rate, found[i].rate) * row.rate);
    }
    sites = normal.solve();
    base::report_progress(kTold * round / kRounds);
  }
  return found;
}

// Smooths how the rows turn about their directions, but for jumps.
void smooth_rolls(std::span<FitRow> rows, std::span<const Rounded> places, double step, double jump) {
  std::vector<Rounded> rolls{{0, dvec3(0), dvec3(0)}};
  for (std::size_t n = 1; n < rows.size(); ++n) {
    const FitRow &a = rows[n - 1], &b = rows[n];
    const curve::Frame carried = curve::transport({a.forward, a.up}, a.position, b.position, b.forward);
    const double turn = curve::signed_angle(carried.up, b.up, b.forward),
                 quick = base::radians(kJumpRate) * glm::distance(a.position, b.position);
    const bool jumps = std::abs(turn) > std::max(base::radians(kJumpAngle) + jump, quick);
    rolls.push_back({places[n].s, rolls.back().value + dvec3(jumps ? 0 : turn, 0, 0), dvec3(0)});
  }
  const std::vector<Rounded> found = smoothest(rolls, step, 0);
  for (std::size_t n = 0; n < rows.size(); ++n)
    rows[n].up = curve::rotate(rows[n].up, rows[n].forward, found[n].value.x - rolls[n].value.x);
}

}  // namespace

UnroundedRows unrounded_rows(std::span<const FitRow> rows, bool closed, RowSteps& steps) {
  // Closer bounds would follow errors of the places along the track, and curvature that jumps.
  constexpr double kLeastStep = 1e-4, kLeastTurn = 3e-4;   // m, radians
  constexpr double kTightBend = 0.3, kQuickRoll = 0.4;     // 1/m, radians/m: those errors turn the frame by as much
  constexpr double kShown = 0.1;                           // of a step: what rounding leaves at least, on average
  constexpr double kNoisyTurn = 0.05, kLeastApart = 0.02;  // radians, m
  constexpr double kOverlap = 40;                          // m: a closed track goes on so far beyond both ends
  const std::size_t count = rows.size();
  const auto exact = [&] { return steps = {}, UnroundedRows{}; };
  if (!steps.rounded() || count < 4) return exact();
  std::size_t before = 0;
  for (double gone = 0; closed && before < count && gone < kOverlap; ++before)
    gone += glm::distance(rows[count - 1 - before].position, rows[(count - before) % count].position);
  std::vector<FitRow> smooth;
  std::vector<Rounded> places;
  for (std::size_t n = 0; n < count + 2 * before; ++n) {
    smooth.push_back(rows[(n + count - before) % count]);
    const FitRow &a = smooth[std::max<std::size_t>(n, 1) - 1], &b = smooth[n];
    const dvec3 way = a.forward + b.forward;
    const double ahead = glm::dot(b.position - a.position, way) / std::max(glm::length(way), 1e-9);
    places.push_back({n == 0 ? 0 : places.back().s + std::max(0.0, ahead), b.position - rows[0].position, b.forward});
  }
  if (!(places.back().s > 0)) return exact();  // against their directions
  const double step = std::max(steps.position, kLeastStep),
               turn_step = std::max({steps.direction, kLeastTurn, kTightBend * steps.position}),
               roll_step = std::max({std::numbers::sqrt2 * steps.direction, kLeastTurn, kQuickRoll * steps.position});
  const std::vector<Rounded> found = smoothest(places, step, turn_step);
  double off = 0, turned = 0;  // mean squares
  for (std::size_t n = 0; n < places.size(); ++n) {
    const dvec3 forward = glm::normalize(found[n].rate), miss = found[n].value - places[n].value,
                turn = forward - places[n].rate;
    smooth[n] = {rows[0].position + found[n].value, forward, curve::perpendicular(forward, smooth[n].up)};
    off += glm::dot(miss, miss) / static_cast<double>(3 * places.size());
    turned += glm::dot(turn, turn) / static_cast<double>(2 * places.size());
  }
  off = std::sqrt(off), turned = std::sqrt(turned);
  // Not where numbers have become too large or undefined, either.
  if (!(off <= step && turned <= std::max(turn_step, kNoisyTurn))) return exact();
  const RowSteps shown{off > kShown * steps.position ? steps.position : 0,
                       turned > kShown * steps.direction ? steps.direction : 0};
  if (shown != steps) return steps = shown, unrounded_rows(rows, closed, steps);
  smooth_rolls(smooth, places, roll_step, 4 * turn_step);
  UnroundedRows kept;
  for (std::size_t i = 0; i < count; ++i) {
    const FitRow& row = smooth[before + i];
    const auto near = [&](const FitRow& other) {
      return glm::distance(other.position, row.position) <= std::max(kLeastApart, steps.position);
    };
    if (i > 0 && (near(kept.rows.back()) || (closed && i + 1 == count && near(kept.rows.front())))) continue;
    kept.rows.push_back(row), kept.from.push_back(i);
  }
  return kept;
}

}  // namespace coaster::sim
