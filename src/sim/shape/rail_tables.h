// Tables over arc length of the rails' data for rides: heights, slopes and the riders' forces. Stored per segment, so
// that an edit refills only the changed segments; a ride with them inverts no arc length.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/shape/detail_limits.h"

namespace coaster::sim {

// Felt acceleration of a rider on the heartline, as a linear function of the rail's s'' and s'^2 (m/s^2 each), on the
// seat's axes forward, left, up: felt = (s'' along + s'^2 bend) / g + weight. Along and bend are h' and h'' of the
// heartline h(s) = r(s) + d U(s).
struct FeltEntry {
  glm::vec3 along{1, 0, 0}, bend{0}, weight{0, 0, 1};
  // Returns felt g while the train accelerates by `a` g along the rails and its squared speed is `v2` g m.
  glm::vec3 felt(float a, float v2) const { return a * along + v2 * bend + weight; }
};
// Returns the entry at arc length s of a segment, where its parameter is t and its frame `frame`, for riders d metres
// above the rails: the derivatives of r(s) + d U(s) in closed form. At a cusp the curvature counts as 0; near one it is
// bounded: `slowest` is the least |B'| whose curvature counts, m.
FeltEntry felt_entry(const SegmentShape& shape, double s, double t, const curve::Frame& frame, double d,
                     double slowest = 1e-3);

// A piece of a segment where it bends too sharply for entries at equal steps, with the integrals of an entry's members
// by arc length.
struct FeltCell {
  double from = 0, to = 0;  // m along the segment
  glm::dvec3 along{0}, bend{0}, weight{0};
  int reversal = 0;  // the direction turns round in it: the push is 2 v forwards (1) or backwards (-1)
};

// Tight bends have cells, in ascending order, without gaps within a bend: where the radius falls below kTightRadius,
// until it exceeds twice that and the next entry of the table does not see it.
inline constexpr double kTightRadius = 2;  // m: 8 steps of the table, which turns by 1/8 rad in one

struct SegmentTable {
  std::uint64_t build = 0;            // build number of the shape that filled it
  double heartline = 0;               // m
  double largest_step = 0;            // m, largest step allowed by the track's detail
  double step = 0;                    // m between entries; 0 for a segment of zero length
  double per_metre = 0;               // 1 / step, else 0
  std::vector<double> height, slope;  // n+1 entries, uniform in s
  std::vector<FeltEntry> felt;
  std::vector<FeltCell> cells;  // none on a segment without tight bends
  std::vector<double> peaks;    // m along the segment: the sharpest places of its tight bends
};
// Fills cells and peaks: about 1 us per cell.
void fill_cells(const SegmentShape& shape, SegmentTable& table);

class RailTables {
 public:
  // Refills the parts that changed since the last update from the same DerivedTrack: about 1 us per entry of a changed
  // segment.
  void update(const DerivedTrack& derived, double heartline);

  // Returns a segment's table by index in derived.order.
  const SegmentTable& segment(std::size_t index) const { return tables_.get(order_[index]); }
  std::size_t size() const { return order_.size(); }
  double start(std::size_t index) const { return starts_[index]; }
  double length() const { return starts_.empty() ? 0.0 : starts_.back(); }
  double largest_step() const {
    return largest_step_;
  }  // m between two entries; kTableStep unless the track is very long
  bool closed() const { return closed_; }
  // Increases with each update that changed anything.
  std::uint64_t serial() const { return serial_; }

  // Returns the position of distance d within its segment, wrapped on a closed track, clamped on an open one. `hint` is
  // the segment tried first; it is set to the segment found.
  double locate(double distance, std::size_t& hint) const {
    if (hint < order_.size() && distance >= starts_[hint] && distance <= starts_[hint + 1])
      return distance - starts_[hint];
    return search(distance, hint);
  }

 private:
  double search(double distance, std::size_t& hint) const;

  world::Pool<SegmentTable> tables_;
  std::vector<world::Entity> order_;
  std::vector<double> starts_;
  bool closed_ = false;
  double largest_step_ = kTableStep;
  double heartline_ = 0;
  std::uint64_t last_build_ = 0;
  std::uint64_t serial_ = 0;
};

// Height (m) and slope at s within a segment: cubic Hermite, so the slope is the exact derivative of the height; beyond
// the ends the rails continue straight. Error below 1e-6 m for tracks with bends above 5 m.
inline RailPoint rail_at(const SegmentTable& table, double s) {
  if (s <= 0 || !(table.step > 0))
    return {table.height.front() + std::min(s, 0.0) * table.slope.front(), table.slope.front()};
  const double at = s * table.per_metre;
  const std::size_t n = table.height.size() - 1;
  if (at >= static_cast<double>(n))
    return {table.height.back() + (s - table.step * static_cast<double>(n)) * table.slope.back(), table.slope.back()};
  const auto i = static_cast<std::size_t>(at);
  const double u = at - static_cast<double>(i), y0 = table.height[i], y1 = table.height[i + 1];
  const double m0 = table.step * table.slope[i], m1 = table.step * table.slope[i + 1];
  const double a = 2.0 * (y0 - y1) + m0 + m1, b = 3.0 * (y1 - y0) - 2.0 * m0 - m1;
  return {y0 + u * (m0 + u * (b + u * a)), (m0 + u * (2.0 * b + u * 3.0 * a)) * table.per_metre};
}

// Returns the riders' force at s within a segment, in g on the seat's axes (FeltEntry::felt); linear between entries.
inline glm::vec3 felt_at(const SegmentTable& table, double s, float a, float v2) {
  if (!(table.step > 0)) return table.felt.front().felt(a, v2);
  const std::size_t n = table.felt.size() - 1;
  const double at = std::clamp(s * table.per_metre, 0.0, static_cast<double>(n));
  const std::size_t i = std::min(static_cast<std::size_t>(at), n - 1);
  const glm::vec3 here = table.felt[i].felt(a, v2);
  return here + static_cast<float>(at - static_cast<double>(i)) * (table.felt[i + 1].felt(a, v2) - here);
}

}  // namespace coaster::sim
