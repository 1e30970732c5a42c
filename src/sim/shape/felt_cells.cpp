// The tables' cells at tight bends. Their borders are where the radius is least, and from there on halves until each
// turns little, so a bend of any sharpness is integrated to its last part.
#include <algorithm>
#include <cmath>
#include <optional>

#include "curve/tight_places.h"
#include "sim/shape/rail_tables.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kNearTight = 2 * kTightRadius;  // m: cells with this radius at an end are tight

class Cells {
 public:
  Cells(const SegmentShape& shape, SegmentTable& table)
      : shape_(shape),
        table_(table),
        curve_(curve::coefficients_d(shape.key.cubic)),
        minima_(curve::tight_places(shape.key.cubic, kNearTight)) {}

  // Distances of the ends of a part without tight cells, m.
  struct Gentle {
    double begin, end;
  };

  // Appends a part in halves, until each turns by at most 0.1 rad and is at most half a table step long. Leaves out
  // what keep_near() would remove: a long segment with one tight bend has few cells.
  void add(double from, double to, int depth = 0, std::optional<Gentle> gentle = {}) {
    constexpr double kLittleTurn = 0.99875;  // cosine of 0.05 rad, for either half
    constexpr int kDeepest = 48;
    const double middle = 0.5 * (from + to);
    if (!(from < middle && middle < to)) return;
    if (!gentle && is_gentle(from, to)) gentle = Gentle{shape_.arc.distance(from), shape_.arc.distance(to)};
    if (gentle && shape_.arc.distance(from) > gentle->begin + 2 * table_.step &&
        shape_.arc.distance(to) < gentle->end - 2 * table_.step)
      return;
    const dvec3 a = curve_.derivative(from), b = curve_.derivative(middle), c = curve_.derivative(to);
    const double length = (glm::length(a) + 4 * glm::length(b) + glm::length(c)) / 6 * (to - from);
    const bool turns = dot(a, b) < kLittleTurn * glm::length(a) * glm::length(b) ||
                       dot(b, c) < kLittleTurn * glm::length(b) * glm::length(c);
    if (depth < kDeepest && (turns || length > 0.5 * kTableStep)) {
      add(from, middle, depth + 1, gentle), add(middle, to, depth + 1, gentle);
      return;
    }
    FeltCell& cell = start(from, to);
    const double h = table_.heartline;
    for (const double t : {from, middle, to}) {
      const double s = shape_.arc.distance(t), weight = (t == middle ? 4 : 1) * curve_.speed(t) * (to - from) / 6;
      const curve::Frame frame = frame_at(shape_, s, t);
      const FeltEntry entry = felt_entry(shape_, s, t, frame, h, 0);
      // The entry's bend along the track is h w k_left and the slope of its `along`, whose integral is exact.
      const double to_left = dot(curve_.second_derivative(t), frame.left()) / std::pow(curve_.speed(t), 2);
      if (t != middle) cell.bend.x += (t == to ? 1.0 : -1.0) * double{entry.along.x};
      cell.along += weight * dvec3(entry.along);
      cell.bend += weight * dvec3(h * shape_.roll.spin(s) * to_left, entry.bend.y, entry.bend.z);
      cell.weight += weight * dvec3(entry.weight);
    }
    near_.push_back(is_tight_at(from) || is_tight_at(to));
  }
  void add_reversal(double from, double to) {
    // Both of a segment's reversals are felt in the axes of the track between them.
    start(from, to).reversal = reversals_++ % 2 == 0 ? 1 : -1;
    near_.push_back(true);
  }
  // Removes the cells that are further from a tight one than the table's entries reach.
  void keep_near() {
    std::vector<FeltCell>& cells = table_.cells;
    const double reach = 1.01 * table_.step;
    double last = -reach;
    std::vector<bool> keep(cells.size(), false);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (near_[i]) last = cells[i].to;
      keep[i] = near_[i] || cells[i].from < last + reach;
    }
    last = cells.empty() ? 0 : cells.back().to + reach;
    for (std::size_t i = cells.size(); i-- > 0;) {
      if (near_[i]) last = cells[i].from;
      keep[i] = keep[i] || cells[i].to > last - reach;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (keep[i]) cells[kept++] = cells[i];
    cells.resize(kept);
  }

 private:
  bool is_tight_at(double t) const { return curve::radius_at(shape_.key.cubic, t) < kNearTight; }
  // True if no cell of this part can be tight: the radius is large at both ends, and has no small minimum between.
  bool is_gentle(double from, double to) const {
    return !is_tight_at(from) && !is_tight_at(to) &&
           std::none_of(minima_.begin(), minima_.end(), [&](const auto& at) { return at.t > from && at.t < to; });
  }
  FeltCell& start(double from, double to) {
    table_.cells.push_back({shape_.arc.distance(from), shape_.arc.distance(to)});
    return table_.cells.back();
  }

  const SegmentShape& shape_;
  SegmentTable& table_;
  curve::CoefficientsD curve_;
  std::vector<curve::TightPlace> minima_;  // of the radius, below kNearTight
  int reversals_ = 0;
  std::vector<bool> near_;  // of each cell: it is tight
};

}  // namespace

void fill_cells(const SegmentShape& shape, SegmentTable& table) {
  table.cells.clear(), table.peaks.clear();
  const std::vector<curve::TightPlace> places = curve::tight_places(shape.key.cubic, kTightRadius);
  if (places.empty() || !(table.step > 0)) return;
  Cells cells(shape, table);
  double done = 0;
  for (const curve::TightPlace& place : places) {
    cells.add(done, place.t - place.half);
    if (place.reversal) cells.add_reversal(place.t - place.half, place.t + place.half);
    done = place.t + place.half;
    table.peaks.push_back(shape.arc.distance(place.t));
  }
  cells.add(done, 1);
  cells.keep_near();
  table.cells.shrink_to_fit();
}

}  // namespace coaster::sim
