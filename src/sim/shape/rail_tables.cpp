// The tables of the rails. The borders of cells at tight bends are where the radius is least, and from there on halves
// until each turns little, so a bend of any sharpness is integrated to its last part.
#include "sim/shape/rail_tables.h"

#include <cmath>
#include <optional>
#include <utility>

#include "base/bits.h"
#include "base/cancellable_job.h"
#include "curve/tight_places.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kNearTight = 2 * kTightRadius;  // m: cells with this radius at an end are tight

class FeltCellBuilder {
 public:
  FeltCellBuilder(const SegmentShape& shape, SegmentTable& table)
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

void fill(const SegmentShape& shape, double heartline, double largest_step, SegmentTable& table) {
  const double length = shape.arc.length();
  const int n = std::max(2, static_cast<int>(std::ceil(length / largest_step)));
  const auto count = static_cast<std::size_t>(n) + 1;
  table.build = shape.shape_build, table.heartline = heartline, table.largest_step = largest_step;
  table.step = length / n;
  table.per_metre = table.step > 0 ? 1.0 / table.step : 0.0;
  table.height.resize(count), table.slope.resize(count), table.felt.resize(count);
  for (std::size_t i = 0; i < count && !base::interrupted(); ++i) {
    const double s = i + 1 == count ? length : table.step * static_cast<double>(i);
    const double t = shape.arc.parameter(s);
    const curve::Frame frame = frame_at(shape, s, t);
    table.height[i] = curve::point(shape.key.cubic, t).y;
    table.slope[i] = frame.forward.y;
    table.felt[i] = felt_entry(shape, s, t, frame, heartline);
  }
  if (!base::interrupted()) fill_cells(shape, table);
}

}  // namespace

void fill_cells(const SegmentShape& shape, SegmentTable& table) {
  table.cells.clear(), table.peaks.clear();
  const std::vector<curve::TightPlace> places = curve::tight_places(shape.key.cubic, kTightRadius);
  if (places.empty() || !(table.step > 0)) return;
  FeltCellBuilder cells(shape, table);
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

FeltEntry felt_entry(const SegmentShape& shape, double s, double t, const curve::Frame& frame, double d,
                     double slowest) {
  const dvec3 left = frame.left(), &up = frame.up;
  const double w = shape.roll.spin(s), w_slope = shape.roll.slope(s);
  // Curvature towards left and up, and the curvature vector's change towards up.
  const dvec3 r1 = curve::derivative(shape.key.cubic, t), r2 = curve::second_derivative(shape.key.cubic, t);
  const double square = glm::dot(r1, r1);
  double to_left = 0, to_up = 0, up_slope = 0;
  if (square > slowest * slowest) {  // below it is a cusp
    to_left = glm::dot(r2, left) / square, to_up = glm::dot(r2, up) / square;
    const double third = glm::dot(curve::third_derivative(shape.key.cubic), up) / square;
    up_slope = (third - 3.0 * to_up * glm::dot(r1, r2) / square) / std::sqrt(square);
  }
  // With T' = to_left L + to_up U and the spin w: L' = -to_left T + w U, U' = -to_up T - w L, and w changes by w_slope.
  FeltEntry entry;
  entry.along = {1.0 - d * to_up, -d * w, 0.0};
  entry.bend = {d * (2.0 * w * to_left - up_slope), to_left - d * (to_left * to_up + w_slope),
                to_up - d * (to_up * to_up + w * w)};
  entry.weight = {frame.forward.y, left.y, up.y};
  return entry;
}

void RailTables::update(const DerivedTrack& derived, double heartline) {
  const double largest_step = detail_of(derived).table_step;
  auto changes = derived.changes_since(std::exchange(last_build_, derived.last_build));
  if (largest_step_ != largest_step || heartline_ != heartline) changes.reset();
  heartline_ = heartline, largest_step_ = largest_step;
  std::vector<std::size_t> stale;
  const auto look_at = [&](std::size_t i) {
    const SegmentTable& table = tables_.obtain(derived.order[i]);
    if (table.build != derived.shape_at(i).shape_build || table.heartline != heartline ||
        table.largest_step != largest_step)
      stale.push_back(i);
  };
  if (changes) {
    for (const ShapeChange& change : *changes) look_at(change.index);
    std::ranges::sort(stale);
    stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
  } else {
    tables_.reserve(derived.order.size());
    for (std::size_t i = 0; i < derived.order.size(); ++i) look_at(i);
  }
  constexpr std::size_t kPart = 16;  // segments
  base::in_parts(stale.size(), kPart, base::cores(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      fill(derived.shape_at(stale[k]), heartline, largest_step, tables_.get(derived.order[stale[k]]));
  });
  const bool reordered = !changes && !base::same_bits(order_, derived.order);
  if (!reordered && stale.empty() && closed_ == derived.closed && starts_ == derived.starts) return;
  ++serial_;
  if (reordered) {
    tables_.keep_those_of(derived.segments);
    order_ = derived.order;
  }
  starts_ = derived.starts;
  closed_ = derived.closed;
}

double RailTables::search(double distance, std::size_t& hint) const {
  if (const double total = length(); distance < 0 || distance >= total) {
    distance = within_lap(distance, total, closed_);
    if (closed_ && distance >= total) distance = 0;
  }
  const std::size_t last = order_.size() - 1;
  if (hint > last || distance < starts_[hint] || distance > starts_[hint + 1]) {
    if (hint < last && distance >= starts_[hint + 1] && distance <= starts_[hint + 2]) {
      ++hint;
    } else {
      const auto above = std::upper_bound(starts_.begin(), starts_.end(), distance);
      const auto index = static_cast<std::size_t>(above - starts_.begin());
      hint = std::min(index == 0 ? 0 : index - 1, last);
    }
  }
  return distance - starts_[hint];
}

}  // namespace coaster::sim
