#include "sim/ride/simulated_ride_detail.h"

#include <array>
#include <cmath>
#include <utility>

namespace coaster::sim {

MeanSlopeTable::MeanSlopeTable(const RailTables& tables, std::span<const SegmentTable* const> segments, int cars,
                               double spacing)
    : tables_(tables), segments_(segments), closed_(tables.closed()), length_(tables.length()) {
  const auto cells = static_cast<std::size_t>(std::max(4.0, std::ceil(length_ / tables.largest_step())));
  step_ = length_ / static_cast<double>(cells), per_metre_ = 1.0 / step_;
  for (int i = 0; i < cars; ++i) {
    Car car{segments.size(), {}};
    car.offsets.push_back(tables.locate(-(i * spacing), car.first));
    cars_.push_back(std::move(car));
  }
  blocks_.resize((cells + kBlock - 1) / kBlock), last_ = static_cast<std::int64_t>(cells) - 1;
}

void MeanSlopeTable::fill(std::size_t block) {
  const std::size_t from = block * kBlock, count = std::min(kBlock, static_cast<std::size_t>(last_) + 1 - from);
  std::array<RailPoint, kBlock + 1> sums;
  sums.fill(RailPoint{0, 0});
  for (Car& car : cars_) add_car(car, from, std::span(sums.data(), count + 1));
  const double share = 1.0 / static_cast<double>(cars_.size());
  std::vector<Cell>& cells = blocks_[block];
  cells.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double m0 = share * sums[i].slope, m1 = share * sums[i + 1].slope,
                 rise = share * (sums[i + 1].height - sums[i].height) * per_metre_;
    cells.push_back({m0, 2.0 * (3.0 * rise - 2.0 * m0 - m1), 3.0 * (m0 + m1 - 2.0 * rise)});
  }
}

bool MeanSlopeTable::is_past(const Car& car, std::size_t k, std::size_t point) const {
  const bool more = closed_ ? k < 2 * segments_.size() : car.first + k + 1 < segments_.size();
  return more && step_ * static_cast<double>(point) + car.offsets[k] > length_of(segment(car, k));
}

void MeanSlopeTable::add_car(Car& car, std::size_t point, std::span<RailPoint> sums) const {
  std::vector<double>& offsets = car.offsets;
  const auto go_on = [&](std::size_t at) {
    while (is_past(car, offsets.size() - 1, at))
      offsets.push_back(offsets.back() - length_of(segment(car, offsets.size() - 1)));
  };
  go_on(point);
  const double* const here = std::partition_point(
      offsets.data(), offsets.data() + offsets.size() - 1,
      [&](const double& offset) { return is_past(car, static_cast<std::size_t>(&offset - offsets.data()), point); });
  auto k = static_cast<std::size_t>(here - offsets.data());
  for (RailPoint& sum : sums) {
    go_on(point);
    while (is_past(car, k, point)) ++k;
    const RailPoint rail = rail_at(*segments_[segment(car, k)], step_ * static_cast<double>(point++) + offsets[k]);
    sum.height += rail.height, sum.slope += rail.slope;
  }
}

namespace {

using glm::dvec3;

FeltAcceleration force_from(dvec3 g) {
  return {static_cast<float>(g.x), static_cast<float>(g.y), static_cast<float>(g.z)};
}

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

TightBendMotion::Moment TightBendMotion::at(double share) const {
  return {std::lerp(then_.speed, now_.speed, share), std::lerp(then_.acceleration, now_.acceleration, share)};
}

void TightBendMotion::add(const SegmentTable& table, double s0, double s1, double u0, double u1) {
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

void TightBendMotion::take_peak(const SegmentTable& table, double peak, double share) {
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

bool TightBendMotion::is_needed(const dvec3& before, const dvec3& after, bool joint) const {
  constexpr double kNoise = 1e-4;  // g s: 1.2 mg low-passed
  const dvec3 missed_before = before_ - seconds_ * (before / 3.0 + after / 6.0),
              missed_after = after_ - seconds_ * (before / 6.0 + after / 3.0);
  return tight_ &&
         (joint || glm::length(missed_before) + glm::length(missed_after) > kNoise || glm::length(impulse_) > kNoise);
}

BendPassage TightBendMotion::passage() const {
  return {{.time = seconds_ * peak_share_, .speed = at(peak_share_).speed, .impulse = force_from(impulse_)},
          force_from(before_),
          force_from(after_)};
}

}  // namespace coaster::sim
