#include "sim/ride/ghost_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace coaster::sim {

Landscape::Landscape(const RailTables& tables, std::span<const SegmentTable* const> segments, int cars, double spacing)
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

void Landscape::fill(std::size_t block) {
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

bool Landscape::is_past(const Car& car, std::size_t k, std::size_t point) const {
  const bool more = closed_ ? k < 2 * segments_.size() : car.first + k + 1 < segments_.size();
  return more && step_ * static_cast<double>(point) + car.offsets[k] > length_of(segment(car, k));
}

void Landscape::add_car(Car& car, std::size_t point, std::span<RailPoint> sums) const {
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

}  // namespace coaster::sim
