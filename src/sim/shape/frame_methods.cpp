// The rows of the table of frame methods, and the places where Frenet-Serret frames fail.
#include "sim/shape/frame_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/check.h"
#include "base/portable_math.h"
#include "curve/carried_frame.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Returns the rotation of the knots' frames since the track's start, relative to rotation-minimising frames.
double turned(const DerivedTrack& derived, std::size_t index, double s) {
  const SegmentShape& shape = derived.shape_at(index);
  return derived.twists[index] + shape.roll.angle(std::clamp(s, 0.0, shape.roll.length));
}

curve::Frame rolled(curve::Frame frame, double radians) {
  frame.up = curve::rotate(frame.up, frame.forward, radians);
  return frame;
}

TrackFrame by_knots(const DerivedTrack& derived, std::size_t index, double s) {
  return {frame_at(derived.shape_at(index), s)};
}

TrackFrame minimising(const DerivedTrack& derived, std::size_t index, double s) {
  // Double reflection turns a vector rigidly with the frame, so the knots' frame gives all carried frames.
  const double spread = derived.length > 0 ? loop_twist(derived) * (derived.starts[index] + s) / derived.length : 0.0;
  return {rolled(frame_at(derived.shape_at(index), s), spread - turned(derived, index, s))};
}

// The last Frenet normal before a position without one: its angle to the knots' frame there, and that frame's rotation.
struct LastNormal {
  double angle, turned;
};
std::optional<LastNormal> last_normal(const DerivedTrack& derived, std::size_t index, double before) {
  const std::size_t count = derived.order.size();
  double whole_laps = 0;
  for (std::size_t back = 0; back <= std::min<std::size_t>(kFrenetReach, count); ++back) {
    const SegmentShape& shape = derived.shape_at(index);
    // The current segment is searched finely, those before it coarsely: most are straight from end to end or nowhere.
    const int intervals = back == 0 ? kFrameIntervals : 8;
    for (int i = intervals; i >= 0; --i) {
      const double t = static_cast<double>(i) / intervals;
      if (back == 0 && t >= before) continue;
      const auto found = curve::frenet(shape.key.cubic, t);
      if (!found) continue;
      const double s = shape.arc.distance(t);
      const curve::Frame frame = frame_at(shape, s);
      return LastNormal{curve::signed_angle(frame.up, found->normal, frame.forward),
                        turned(derived, index, s) + whole_laps};
    }
    if (index == 0 && !derived.closed) return std::nullopt;
    if (index == 0) whole_laps -= derived.twists.back();
    index = index == 0 ? count - 1 : index - 1;
  }
  return std::nullopt;
}

TrackFrame frenet_serret(const DerivedTrack& derived, std::size_t index, double s) {
  const SegmentShape& shape = derived.shape_at(index);
  const double t = shape.arc.parameter(s);
  if (const auto found = curve::frenet(shape.key.cubic, t)) return {{found->tangent, found->normal}};
  const curve::Frame frame = frame_at(shape, s);
  const auto last = last_normal(derived, index, t);
  if (!last) return {frame, false};
  return {rolled(frame, last->angle + last->turned - turned(derived, index, s)), false};
}

TrackFrame world_up(const DerivedTrack& derived, std::size_t index, double s) {
  const SegmentShape& shape = derived.shape_at(index);
  const dvec3 forward = curve::unit_tangent(shape.key.cubic, shape.arc.parameter(s));
  const bool vertical = forward.x * forward.x + forward.z * forward.z < 1e-12;
  return {{forward, curve::perpendicular(forward, vertical ? dvec3(1, 0, 0) : dvec3(0, 1, 0))}, !vertical};
}

constexpr std::array<FrameMethodRow, 4> kFrameMethods{{
    {"knots", "Banked by the knots",
     "The knots' up carried by double reflection, and turned to the next knot's up by the spins of both knots.",
     by_knots},
    {"rmf", "Rotation-minimising",
     "The first knot's up carried along the whole track by double reflection (Wang et al. 2008); a loop's remaining "
     "twist is spread.",
     minimising},
    {"frenet", "Frenet-Serret",
     "T, N = T'/|T'|, B = T \u00D7 N. Undefined on straights, and flips across an inflection.", frenet_serret},
    {"world_up", "World up", "As upright as possible: left is level. Undefined on a vertical, and unstable near one.",
     world_up},
}};
static_assert(static_cast<std::size_t>(world::FrameMethod::world_up) + 1 == kFrameMethods.size(),
              "one row for each enumerator");

using Kind = FrenetBreak::Kind;

constexpr double kHalfSpan = 1.0 / 64;  // of the parameter: a flip happens within twice that

bool defined(const curve::Cubic& cubic, double t) { return curve::frenet(cubic, t).has_value(); }

// Adds runs of undefined samples. A single one at an end belongs to the joint there, one next to a flip to the flip.
void add_undefined(const curve::Cubic& cubic, world::Entity segment, std::vector<FrenetBreak>& found) {
  const std::size_t flips = found.size();
  const auto at = [](int i) { return static_cast<double>(i) / kFrameIntervals; };
  for (int i = 0; i <= kFrameIntervals; ++i) {
    if (defined(cubic, at(i))) continue;
    const int first = i;
    while (i < kFrameIntervals && !defined(cubic, at(i + 1))) ++i;
    const bool lone = i == first;
    if (lone && (i == 0 || i == kFrameIntervals)) continue;
    const bool beside = std::any_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(flips),
                                    [&](const FrenetBreak& flip) { return std::abs(flip.t - at(first)) <= kHalfSpan; });
    if (lone && beside) continue;
    found.push_back({Kind::undefined, segment, at(first), at(i), 0});
  }
  std::ranges::sort(found, {}, &FrenetBreak::t);
}

// Adds the cusps that no sample found: there the curvature is unbounded and the normal undefined.
void add_cusps(const curve::Cubic& cubic, world::Entity segment, std::vector<FrenetBreak>& found) {
  const curve::Cusps cusps = curve::cusps(cubic);
  for (int k = 0; k < cusps.count; ++k) {
    const double t = cusps.t[k];
    const auto after = std::ranges::find_if(found, [t](const FrenetBreak& at) { return at.t_end >= t - kHalfSpan; });
    if (after == found.end() || after->t > t + kHalfSpan) found.insert(after, {Kind::undefined, segment, t, t, 0});
  }
}

// The normal at an end of a segment, taken slightly inside if the end itself has none; nothing if that has none either.
struct EndNormal {
  std::optional<dvec3> normal;
  bool at_end = true;
};
EndNormal end_normal(const curve::Cubic& cubic, bool at_start) {
  if (const auto f = curve::frenet(cubic, at_start ? 0.0 : 1.0)) return {f->normal, true};
  const auto f = curve::frenet(cubic, at_start ? kHalfSpan : 1.0 - kHalfSpan);
  return {f ? std::optional(f->normal) : std::nullopt, false};
}

// Adds the joint before segment `index`, at t = 0 of that segment. Next to a span without normals it is part of the
// span.
void add_joint(const DerivedTrack& derived, std::size_t index, std::vector<FrenetBreak>& found) {
  if (index == 0 && !derived.closed) return;
  const std::size_t before = index == 0 ? derived.order.size() - 1 : index - 1;
  const world::Entity segment = derived.order[index];
  const EndNormal from = end_normal(derived.shape_at(before).key.cubic, false),
                  to = end_normal(derived.shape(segment).key.cubic, true);
  if (!from.normal || !to.normal) return;
  const double cosine = glm::dot(*from.normal, *to.normal);
  if (cosine < 0.0) found.push_back({Kind::flip, segment, 0, 0, std::acos(std::clamp(cosine, -1.0, 1.0))});
  else if (!from.at_end && !to.at_end) found.push_back({Kind::undefined, segment, 0, 0, 0});
}

}  // namespace

std::span<const FrameMethodRow> frame_methods() { return kFrameMethods; }

TrackFrame track_frame(const DerivedTrack& derived, world::FrameMethod method, std::size_t index, double s) {
  COASTER_CHECK(index < derived.order.size(), "frames exist only on segments of the track");
  return base::row_of(method).frame(derived, index, s);
}

std::size_t index_of_segment(const DerivedTrack& derived, world::Entity segment, double near) {
  if (!derived.order.empty()) {
    const std::size_t guess = place_at(derived, near).index;
    if (derived.order[guess] == segment) return guess;
  }
  return static_cast<std::size_t>(std::find(derived.order.begin(), derived.order.end(), segment) -
                                  derived.order.begin());
}

double loop_twist(const DerivedTrack& derived) {
  if (!derived.closed || derived.twists.empty()) return 0.0;
  const double twist = std::remainder(derived.twists.back(), 2.0 * base::kPi);
  return twist <= -base::kPi ? base::kPi : twist;
}

std::vector<FrenetBreak> frenet_breaks(const SegmentShape& shape, world::Entity segment) {
  std::vector<FrenetBreak> found;
  const curve::Cubic& cubic = shape.key.cubic;
  const curve::BinormalTurns turns = curve::binormal_turns(curve::binormal_curve(cubic));
  bool all_defined = defined(cubic, 0.0) && defined(cubic, 1.0) && defined(cubic, 0.5);
  for (int i = 0; i < turns.count; ++i) {
    const curve::BinormalTurn& turn = turns.at[i];
    all_defined = all_defined && defined(cubic, turn.t);
    // Between two near inflections there is hardly any curvature, but beside them there is, unless all is straight.
    const double before = std::max(0.0, turn.t - kHalfSpan), after = std::min(1.0, turn.t + kHalfSpan);
    if (turn.angle > 0.5 * base::kPi && defined(cubic, before) && defined(cubic, after))
      found.push_back({Kind::flip, segment, turn.t, turn.t, turn.angle});
  }
  if (!all_defined) add_undefined(cubic, segment, found);
  if (shape.tight != 0) add_cusps(cubic, segment, found);
  return found;
}

std::vector<FrenetBreak> frenet_breaks(const DerivedTrack& derived) { return FrenetBreaks().update(derived); }

const std::vector<FrenetBreak>& FrenetBreaks::update(const DerivedTrack& derived) {
  if (last_build_ == derived.last_build && closed_ == derived.closed && order_ == derived.order) return all_;
  last_build_ = derived.last_build;
  closed_ = derived.closed;
  if (order_ != derived.order) {
    order_ = derived.order;
    entries_ = {};  // a removed segment's slot may be reused
  }
  all_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const SegmentShape& shape = derived.shape(order_[i]);
    Entry* entry = entries_.find(order_[i]);
    if (!entry || entry->build != shape.shape_build)
      entry = &entries_.put(order_[i], {shape.shape_build, frenet_breaks(shape, order_[i])});
    // The joint also depends on the previous segment; recomputing it after any change is cheap.
    add_joint(derived, i, all_);
    all_.insert(all_.end(), entry->found.begin(), entry->found.end());
  }
  return all_;
}

}  // namespace coaster::sim
