#include "sim/ride/ghost_tables.h"

#include <cmath>

namespace coaster::sim {

Landscape::Landscape(const RailTables& tables, std::span<const SegmentTable* const> segments, int cars, double spacing)
    : closed_(tables.closed()), length_(tables.length()) {
  const auto n = static_cast<std::size_t>(std::max(4.0, std::ceil(length_ / tables.largest_step())));
  step_ = length_ / static_cast<double>(n), per_metre_ = 1.0 / step_;
  std::vector<RailPoint> sums(n + 1, RailPoint{0, 0});
  for (int car = 0; car < cars; ++car) add_car(tables, segments, car * spacing, sums);
  const double share = 1.0 / cars;
  cells_.resize(n), last_ = static_cast<std::int64_t>(n) - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double m0 = share * sums[i].slope, m1 = share * sums[i + 1].slope,
                 rise = share * (sums[i + 1].height - sums[i].height) * per_metre_;
    cells_[i] = {m0, 2.0 * (3.0 * rise - 2.0 * m0 - m1), 3.0 * (m0 + m1 - 2.0 * rise)};
  }
}

// Visits the segments in the order of the grid.
void Landscape::add_car(const RailTables& tables, std::span<const SegmentTable* const> segments, double back,
                        std::vector<RailPoint>& sums) const {
  std::size_t index = segments.size();
  const double first = tables.locate(-back, index);
  double offset = first;  // the position in the segment is step * i + offset
  double left = tables.start(index + 1) - tables.start(index);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    double s = step_ * static_cast<double>(i) + offset;
    for (std::size_t joints = 0; s > left && (closed_ || index + 1 < segments.size()) && joints < segments.size();
         ++joints) {
      offset -= left;
      index = index + 1 < segments.size() ? index + 1 : 0;
      left = tables.start(index + 1) - tables.start(index);
      s = step_ * static_cast<double>(i) + offset;
    }
    const RailPoint rail = rail_at(*segments[index], s);
    sums[i].height += rail.height, sums[i].slope += rail.slope;
  }
}

}  // namespace coaster::sim
