#include "sim/fit/fit_doubt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/motion.h"

namespace coaster::sim {
namespace {

// A row with its neighbours, and the lengths of the steps between them.
struct Neighbours {
  Neighbours(std::span<const FitRow> rows, std::size_t i)
      : before((i + rows.size() - 1) % rows.size()),
        after((i + 1) % rows.size()),
        back(glm::distance(rows[before].position, rows[i].position)),
        ahead(glm::distance(rows[i].position, rows[after].position)) {}
  double longest() const { return std::max(back, ahead); }

  std::size_t before, after;
  double back, ahead;
};

// Returns the doubt of roll_doubts() at the first or the last row of an open track. The rate there is that of a cubic,
// off by a quarter of h^3 of the roll's fourth derivative, and the second derivative of a spline with that rate by
// 2 sqrt(3) / h times as much.
double end_doubt(std::span<const FitRow> rows, const RowRolls& rolls, std::span<const double> speeds, double heartline,
                 bool first) {
  constexpr double kShare = std::numbers::sqrt3 / 2;
  constexpr double kNear = 0.2;  // m: between closer rows rounding hides the fourth derivative
  const auto at = [&](std::size_t i) { return first ? i : rows.size() - 1 - i; };  // from the end
  const auto apart = [&](std::size_t i, std::size_t k) {
    return std::max(glm::distance(rows[at(i)].position, rows[at(k)].position), 1e-9);
  };
  const double step = apart(0, 1);
  const std::size_t n = static_cast<std::size_t>(std::max(1.0, std::round(kNear / step)));
  if (rows.size() <= 3 * n) return 0;
  const auto third = [&](std::size_t i) { return (rolls.slopes[at(i + n)] - rolls.slopes[at(i)]) / apart(i, i + n); };
  const double fourth = 2 * std::abs(third(2 * n) - third(n)) / apart(n, 3 * n);
  return kShare * step * step * fourth * heartline * speeds[at(0)];
}

}  // namespace

std::vector<double> roll_doubts(std::span<const FitRow> rows, bool closed, const RowRolls& rolls,
                                std::span<const double> speeds, double heartline) {
  constexpr double kCutoff = 5;  // Hz
  std::vector<double> doubts(rows.size(), 0);
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < rows.size(); ++i) {
    const Neighbours n(rows, i);
    const double fourth = 2 *
                          ((rolls.slopes[n.after] - rolls.slopes[i]) / std::max(n.ahead, 1e-9) -
                           (rolls.slopes[i] - rolls.slopes[n.before]) / std::max(n.back, 1e-9)) /
                          std::max(n.back + n.ahead, 1e-9);
    // Squared frequency of the error, relative to the cutoff's. In steps shorter than kMoment only an error that lasts
    // several of them is felt.
    const double steps = n.longest() < kMoment * std::sqrt(speeds[i] * world::kGravity) ? 3 : 2;
    const double wave = steps * kCutoff * n.longest(), share = speeds[i] * world::kGravity / (wave * wave);
    const double passed = 1 / std::sqrt(1 + share * share * share * share);  // a Butterworth low-pass of four poles
    doubts[i] = 4 * passed * n.back * n.ahead / 12 * std::abs(fourth) * heartline * speeds[i];
  }
  if (!closed)
    for (const bool first : {true, false})
      doubts[first ? 0 : rows.size() - 1] = end_doubt(rows, rolls, speeds, heartline, first);
  return doubts;
}

std::vector<double> bend_doubts(std::span<const FitRow> rows, bool closed, std::span<const double> speeds) {
  std::vector<double> doubts(rows.size(), 0);
  const std::vector<glm::dvec3> bends = row_curvatures(rows, closed);
  for (const std::size_t odd : {0, 1}) {
    std::vector<FitRow> kept;
    for (std::size_t i = odd; i < rows.size(); i += 2) kept.push_back(rows[i]);
    const std::vector<glm::dvec3> wide = row_curvatures(kept, closed);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const std::size_t next = (k + 1) % kept.size(), left_out = (2 * k + odd + 1) % rows.size();
      if (next == 0 && (!closed || rows.size() % 2 != 0)) continue;
      const Neighbours n(rows, left_out);
      if (n.longest() < kMoment * std::sqrt(speeds[left_out] * world::kGravity)) continue;
      const RowQuintic quintic(kept[k], wide[k], kept[next], wide[next], n.back + n.ahead);
      const glm::dvec3 there = quintic.curvature(n.back / (n.back + n.ahead));
      doubts[left_out] = glm::distance(there, bends[left_out]) * speeds[left_out];
    }
  }
  return doubts;
}

}  // namespace coaster::sim
