#include "sim/shape/rail_tables.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/bits.h"
#include "base/interrupted.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

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

void RailTables::update(const Derived& derived, double heartline) {
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
