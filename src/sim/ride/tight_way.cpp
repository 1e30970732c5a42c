#include "sim/ride/tight_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coaster::sim {
namespace {

using glm::dvec3;

Force force_from(dvec3 g) { return {static_cast<float>(g.x), static_cast<float>(g.y), static_cast<float>(g.z)}; }

// A piece of the rails in or between cells, or half of one around a Gauss node.
struct FeltPiece {
  const SegmentTable& table;
  const FeltCell* cell;  // null between cells
  double s, length;      // m: a place on it

  // Returns felt g on it, at a speed in m/s (negative backwards) and an acceleration in m/s^2.
  dvec3 felt(double speed, double a) const {
    if (!cell || !(cell->to > cell->from))
      return felt_at(table, s, static_cast<float>(a / world::kGravity),
                     static_cast<float>(speed * speed / world::kGravity));
    dvec3 sum = (a * cell->along + speed * speed * cell->bend) / world::kGravity + cell->weight;
    sum.x += 2 * cell->reversal * speed * speed / world::kGravity;
    return sum / (cell->to - cell->from);
  }
};

// Calls visit() for each piece between two places, ascending; true if there are cells among them.
template <class Visit>
bool for_pieces(const SegmentTable& table, double low, double high, const Visit& visit) {
  bool tight = false;
  const auto gap = [&](double from, double to) {
    constexpr double kNode = 0.21132486540518708;  // (1 - 1 / sqrt(3)) / 2
    if (!(to > from)) return;
    for (const double u : {kNode, 1 - kNode})
      visit(FeltPiece{table, nullptr, std::lerp(from, to, u), 0.5 * (to - from)});
  };
  auto cell =
      std::partition_point(table.cells.begin(), table.cells.end(), [&](const FeltCell& c) { return c.to <= low; });
  for (; cell != table.cells.end() && cell->from < high; ++cell) {
    gap(low, cell->from);
    const double from = std::max(low, cell->from), to = std::min(high, cell->to);
    visit(FeltPiece{table, &*cell, 0.5 * (from + to), to - from});
    low = to, tight = true;
  }
  gap(low, high);
  return tight;
}

}  // namespace

TightWay::Moment TightWay::at(double share) const {
  return {std::lerp(then_.speed, now_.speed, share), std::lerp(then_.acceleration, now_.acceleration, share)};
}

void TightWay::add(const SegmentTable& table, double s0, double s1, double u0, double u1) {
  if (s0 == s1) return;
  const double per_metre = (u1 - u0) / (s1 - s0), low = std::min(s0, s1), high = std::max(s0, s1);
  const auto share_of = [&](double s) { return u0 + per_metre * (s - s0); };
  const bool tight = for_pieces(table, low, high, [&](const FeltPiece& piece) {
    const double share = share_of(piece.s);
    const Moment moment = at(share);
    const dvec3 felt = std::abs(per_metre) * piece.length * seconds_ * piece.felt(moment.speed, moment.a);
    before_ += (1 - share) * felt, after_ += share * felt;
  });
  tight_ = tight_ || tight;
  for (const double peak : table.peaks)
    if (tight && peak >= low && peak < high) take_peak(table, peak, share_of(peak));
}

void TightWay::take_peak(const SegmentTable& table, double peak, double share) {
  const Moment moment = at(share);
  const double speed = std::abs(moment.speed), reach = 0.5 * kSharpSeconds * speed;
  const double low = std::max(0.0, peak - reach),
               high = std::min(table.step * static_cast<double>(table.felt.size() - 1), peak + reach);
  if (!(high > low)) return;
  dvec3 sum(0), first(0), last(0);
  bool begun = false;
  for_pieces(table, low, high, [&](const FeltPiece& piece) {
    last = piece.felt(moment.speed, moment.a);
    if (!std::exchange(begun, true)) first = last;
    sum += piece.length / speed * last;
  });
  sum -= 0.5 * (high - low) / speed * (first + last);
  if (glm::length(sum) > glm::length(impulse_)) impulse_ = sum, peak_share_ = share;
}

bool TightWay::is_needed(const dvec3& before, const dvec3& after, bool joint) const {
  constexpr double kNoise = 1e-4;  // g s: 1.2 mg low-passed
  const dvec3 missed_before = before_ - seconds_ * (before / 3.0 + after / 6.0),
              missed_after = after_ - seconds_ * (before / 6.0 + after / 3.0);
  return tight_ &&
         (joint || glm::length(missed_before) + glm::length(missed_after) > kNoise || glm::length(impulse_) > kNoise);
}

BendPassage TightWay::passage() const {
  return {{.time = seconds_ * peak_share_, .speed = at(peak_share_).speed, .impulse = force_from(impulse_)},
          force_from(before_),
          force_from(after_)};
}

}  // namespace coaster::sim
