#include "sim/solids/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/solids/track_mesh.h"
#include "sim/solids/train_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

double square(dvec3 v) { return glm::dot(v, v); }

// Returns the t in [0,1] of the point nearest to p on the line a + t d.
double nearest_place(dvec3 p, dvec3 a, dvec3 d) {
  const double length = square(d);
  return length > 0 ? std::clamp(glm::dot(p - a, d) / length, 0.0, 1.0) : 0.0;
}

// Returns the distance in metres along the rails from the held position to one of another segment, the shorter way
// round.
double along_rails(const DerivedTrack& derived, TrackPlace held, std::size_t index, float along) {
  const double start = derived.starts[index],
               ring = start + static_cast<double>(along) * (derived.starts[index + 1] - start);
  const double onward = ring - derived.starts[held.index] - held.s;
  if (!derived.closed || std::abs(onward) <= 0.5 * derived.length) return onward;
  return onward > 0 ? onward - derived.length : onward + derived.length;
}

Ring between(const Ring& a, const Ring& b, double share) {
  return {glm::mix(a.position, b.position, share),
          {glm::mix(a.frame.forward, b.frame.forward, share), glm::mix(a.frame.up, b.frame.up, share)},
          0};
}

struct BarClearance {
  dvec3 from, to;
  double radius;
  const CoasterForm& form;
  bool keeps(double room, const Ring& a, const Ring& b, double left, double up) const {
    return distance_between(from, to, a.place(left, up), b.place(left, up)) >= room + radius + kBarMargin;
  }
  bool keeps(const ClearanceTube& tube, const Ring& a, const Ring& b) const {
    return keeps(tube.radius, a, b, 0, tube.lift);
  }
};

bool clear_of_piece(const BarClearance& bar, const Ring& a, const Ring& b, bool held) {
  if (!held) return bar.keeps(bar.form.envelope, a, b);
  return bar.keeps(bar.form.riders, a, b) && bar.keeps(bar.form.wheels, a, b, 0.5 * kGauge, 0) &&
         bar.keeps(bar.form.wheels, a, b, -0.5 * kGauge, 0);
}

// Tests a chord from `from` to `to` metres along the rails from the held position, split into the pieces within its
// reach and those outside.
bool clear_of_chord(const BarClearance& bar, const Ring& a, const Ring& b, double from, double to) {
  std::array<double, 4> ends{from, std::clamp(-kHeldReach, std::min(from, to), std::max(from, to)),
                             std::clamp(kHeldReach, std::min(from, to), std::max(from, to)), to};
  if (from > to) std::swap(ends[1], ends[2]);
  const auto ring = [&](double s) { return s == from ? a : s == to ? b : between(a, b, (s - from) / (to - from)); };
  for (std::size_t i = 0; i < 3; ++i) {
    if (ends[i] == ends[i + 1]) continue;
    if (!clear_of_piece(bar, ring(ends[i]), ring(ends[i + 1]), std::abs(0.5 * (ends[i] + ends[i + 1])) < kHeldReach))
      return false;
  }
  return true;
}

}  // namespace

// The distance is a convex function of both parameters: if the nearest points of the infinite lines are outside, the
// minimum is on a border.
double distance_between(dvec3 a, dvec3 b, dvec3 c, dvec3 d) {
  const dvec3 u = b - a, v = d - c, w = a - c;
  const double uu = square(u), uv = glm::dot(u, v), vv = square(v), det = uu * vv - uv * uv;
  double best = std::min({square(a - c - nearest_place(a, c, v) * v), square(b - c - nearest_place(b, c, v) * v),
                          square(c - a - nearest_place(c, a, u) * u), square(d - a - nearest_place(d, a, u) * u)});
  if (det > 1e-12 * uu * vv) {
    const double s = (uv * glm::dot(v, w) - vv * glm::dot(u, w)) / det,
                 t = (uu * glm::dot(v, w) - uv * glm::dot(u, w)) / det;
    if (s > 0 && s < 1 && t > 0 && t < 1) best = std::min(best, square(w + s * u - t * v));
  }
  return std::sqrt(best);
}

bool meet(const curve::Box& a, const curve::Box& b) {
  for (int i = 0; i < 3; ++i)
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return false;
  return true;
}

curve::Box widened(curve::Box box, float by) { return {box.low - by, box.high + by}; }

bool is_clear(const DerivedTrack& derived, std::span<const SegmentClearance* const> lanes, const Bar& bar,
              TrackPlace held) {
  const BarClearance question{dvec3(bar.from), dvec3(bar.to),
                              static_cast<double>(std::max(bar.from_radius, bar.to_radius)),
                              form_of(derived.made.kind)};
  const double reach = reach_of(question.form.envelope) + question.radius + 0.1;
  const curve::Box box = widened({glm::min(bar.from, bar.to), glm::max(bar.from, bar.to)}, static_cast<float>(reach));
  const auto off_curve = static_cast<float>(std::abs(derived.shape_at(held.index).key.rails));
  return all_near(derived.tree, widened(box, off_curve), [&](std::size_t i) {
    if (lanes[i] == nullptr || !meet(lanes[i]->box, box)) return true;
    const SegmentClearance& lane = *lanes[i];
    for (std::size_t k = 0; k + 1 < lane.rings.size(); ++k) {
      const Ring &a = lane.rings[k], &b = lane.rings[k + 1];
      if (!clear_of_chord(question, a, b, along_rails(derived, held, i, a.along),
                          along_rails(derived, held, i, b.along)))
        return false;
    }
    return true;
  });
}

}  // namespace coaster::sim
