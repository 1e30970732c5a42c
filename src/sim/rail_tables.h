// Tables over arc length of everything that a ride needs of the rails: heights, slopes and what riders feel. Kept per segment, so that an
// edit refills those that it changed alone; no ride over them inverts an arc length.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/derived.h"

namespace coaster::sim {

inline constexpr double kTableStep = 0.25;  // m, at most, between two entries

// Felt acceleration of a rider on the heartline, as a linear function of the rail's s'' and s'^2 (m/s^2 each), on the seat's axes
// forward, left, up: felt = (s'' along + s'^2 bend) / g + weight. Along and bend are h' and h'' of the heartline h(s) = r(s) + d U(s).
struct FeltEntry {
  glm::vec3 along{1, 0, 0}, bend{0}, weight{0, 0, 1};
};

struct SegmentTable {
  std::uint64_t build = 0;   // of the shape it was filled from
  double heartline = 0;      // m
  double step = 0;           // m between entries; 0 for a segment of no length
  std::vector<double> height, slope;  // n+1 entries, uniform in s
  std::vector<FeltEntry> felt;
};

class RailTables {
 public:
  // Refills what changed. Cost: one comparison for a segment that did not, about 1 us for each entry of one that did.
  void update(const Derived& derived, double heartline);

  // By place in derived.order.
  const SegmentTable& segment(std::size_t index) const { return tables_.get(order_[index]); }
  std::size_t size() const { return order_.size(); }
  double start(std::size_t index) const { return starts_[index]; }
  double length() const { return starts_.empty() ? 0.0 : starts_.back(); }
  bool closed() const { return closed_; }
  // Grows with each update that changed anything.
  std::uint64_t serial() const { return serial_; }

  // The segment on which distance d lies, wrapped on a closed track, clamped on an open one; `hint` is looked at first and set.
  double locate(double distance, std::size_t& hint) const;

 private:
  world::Pool<SegmentTable> tables_;
  std::vector<world::Entity> order_;
  std::vector<double> starts_;
  bool closed_ = false;
  std::uint64_t serial_ = 0;
};

// Height (m) and slope at s within a segment: cubic Hermite, so the slope is the height's exact derivative; beyond the ends the rails go on
// straight. Error below 1e-6 m for tracks with bends above 5 m.
struct TableRail {
  double height, slope;
};
TableRail rail_at(const SegmentTable& table, double s);
// Linear between entries.
FeltEntry felt_at(const SegmentTable& table, double s);

}  // namespace coaster::sim
