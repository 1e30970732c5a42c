#include "sim/shape/rail_tables.h"

#include <algorithm>
#include <cmath>

#include "curve/continuity.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

glm::vec3 on_axes(const dvec3& v, const curve::Frame& frame) {
  return {glm::dot(v, frame.forward), glm::dot(v, frame.left()), glm::dot(v, frame.up)};
}

void fill(const SegmentShape& shape, double heartline, SegmentTable& table) {
  const double length = shape.arc.length();
  const int n = std::max(2, static_cast<int>(std::ceil(length / kTableStep)));
  const auto count = static_cast<std::size_t>(n) + 1;
  table.build = shape.shape_build, table.heartline = heartline, table.step = length / n;
  table.per_metre = table.step > 0 ? 1.0 / table.step : 0.0;
  table.height.resize(count), table.slope.resize(count), table.felt.resize(count);
  std::vector<curve::Frame> frames(count);
  std::vector<dvec3> bends(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = i + 1 == count ? length : table.step * static_cast<double>(i), t = shape.arc.parameter(s);
    frames[i] = frame_at(shape, s);
    bends[i] = curve::curvature_vector(shape.key.cubic, t);
    table.height[i] = curve::point(shape.key.cubic, t).y;
    table.slope[i] = frames[i].forward.y;
  }
  for (std::size_t i = 0; i < count; ++i) {
    FeltEntry& entry = table.felt[i];
    entry.weight = on_axes(dvec3(0, 1, 0), frames[i]);
    if (!(table.step > 0)) continue;
    // U' and U'' by differences of neighbouring entries; at an end those of the next entry.
    const std::size_t k = std::clamp<std::size_t>(i, 1, count - 2);
    const dvec3 first = (frames[k + 1].up - frames[k - 1].up) / (2.0 * table.step);
    const dvec3 second = (frames[k + 1].up - 2.0 * frames[k].up + frames[k - 1].up) / (table.step * table.step);
    const double away = (static_cast<double>(i) - static_cast<double>(k)) * table.step;
    entry.along = on_axes(frames[i].forward + heartline * (first + away * second), frames[i]);
    entry.bend = on_axes(bends[i] + heartline * second, frames[i]);
  }
}

}  // namespace

void RailTables::update(const Derived& derived, double heartline) {
  bool changed = closed_ != derived.closed || starts_ != derived.starts || order_ != derived.order;
  for (const world::Entity e : derived.order) {
    const SegmentShape& shape = derived.shape(e);
    SegmentTable& table = tables_.obtain(e);
    if (table.build == shape.shape_build && table.heartline == heartline) continue;
    fill(shape, heartline, table);
    changed = true;
  }
  if (!changed) return;
  ++serial_;
  tables_.keep_those_of(derived.segments);
  order_ = derived.order;
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
