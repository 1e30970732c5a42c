#include "sim/fit/heartline_rails_conversion.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "curve/continuity.h"
#include "curve/span_fit.h"
#include "sim/shape/folds.h"
#include "sim/shape/rail_tables.h"
#include "sim/shape/rails.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Below kRailsBound, so that switching there and back stays within it.
constexpr double kStretchBound = 0.004;           // m
constexpr double kUpBound = base::radians(0.25);  // of `up`
constexpr double kShortStretch = 0.1;             // m of the former curve; never halved
constexpr int kChecks = 16;                       // per span, between its ends
constexpr float kSameHandles = 1e-4f;             // relative; closer lengths are made equal, as smooth joints need

// Part of a former segment, and the segment that it becomes.
struct FormerSegmentPart {
  std::size_t index = 0;  // of the former segment
  double from = 0, to = 1;
  world::Knot first, second;  // with the handles inside the span
  std::int32_t turns = 0;
};

struct Switching {
  const world::Document& document;
  const DerivedTrack& derived;
  world::TrackCurve to;
  double offset;  // m, of the new curve above the former one

  const SegmentShape& shape(std::size_t index) const { return derived.shape_at(index); }
  OffsetPoint at(std::size_t index, double t) const {
    return offset_point(shape(index), shape(index).arc.distance(t), offset);
  }
};

world::Knot knot_of(const dvec3& position, const dvec3& tangent, const dvec3& up, double spin) {
  world::Knot knot;
  knot.position = glm::vec3(position);
  knot.tangent = glm::vec3(tangent);
  knot.up = glm::vec3(curve::perpendicular(tangent, up));
  knot.spin = static_cast<float>(std::clamp<double>(spin, -world::kMaxSpin, world::kMaxSpin));
  world::orthonormalise(knot);
  return knot;
}

// Returns the new knot for knot `k` of the track. Where curvature jumps it has the mean direction and spin.
world::Knot moved_knot(const Switching& w, std::size_t k) {
  const std::size_t count = w.derived.order.size();
  const bool before = count > 0 && (w.derived.closed || k > 0), after = w.derived.closed || k < count;
  const world::Knot& former = world::knot(w.document, w.document.track.knots[k]);
  dvec3 tangent(before || after ? glm::vec3(0) : former.tangent);
  double spin = 0;
  const auto add = [&](const OffsetPoint& at) { tangent += at.tangent(), spin += at.spin; };
  if (before) add(w.at((k + count - 1) % count, 1));
  if (after) add(w.at(k, 0));
  if (before && after) spin /= 2;
  if (w.offset == 0) spin = double{former.spin};
  const dvec3 up(former.up);
  return knot_of(dvec3(former.position) + w.offset * up, glm::normalize(tangent), up, spin);
}

// Returns the new curve's end of a span at parameter t of the former segment, in the knot's direction.
curve::PathPoint end_of(const Switching& w, std::size_t index, double t, const world::Knot& knot, double s) {
  const SegmentShape& shape = w.shape(index);
  const double at = shape.arc.distance(t);
  const curve::Frame frame = frame_at(shape, at, t);
  const FeltEntry line = felt_entry(shape, at, t, frame, w.offset);
  const dvec3 bend = double{line.bend.x} * frame.forward + double{line.bend.y} * frame.left() +
                     double{line.bend.z} * frame.up,
              tangent(knot.tangent);
  const double stretch = glm::length(glm::dvec3(line.along));
  return {s, dvec3(knot.position), tangent, curve::across(bend, tangent) / (stretch * stretch)};
}

// Properties of the new curve over a span.
struct NewCurveExtent {
  double length = 0, roll = 0;  // m, rad
};

// Computed by the midpoint rule.
NewCurveExtent covered_by(const Switching& w, const FormerSegmentPart& span) {
  constexpr int kSteps = 64;
  const SegmentShape& shape = w.shape(span.index);
  const double start = shape.arc.distance(span.from), step = (shape.arc.distance(span.to) - start) / kSteps;
  NewCurveExtent covered;
  for (int i = 0; i < kSteps; ++i) {
    const OffsetPoint at = offset_point(shape, start + (i + 0.5) * step, w.offset);
    covered.length += at.stretch() * step, covered.roll += at.spin * at.stretch() * step;
  }
  return covered;
}

// Sets the handles with which the span's cubic has the new curve's curvature at both ends.
void set_handles(const Switching& w, double length, FormerSegmentPart& span) {
  const curve::HandleLengths handles = curve::handle_lengths(end_of(w, span.index, span.from, span.first, 0),
                                                             end_of(w, span.index, span.to, span.second, length));
  span.first.out_length = world::as_handle(handles.out), span.second.in_length = world::as_handle(handles.in);
  span.first.joint = span.second.joint = world::JointKind::aligned;
}

// Returns a track of only this span.
world::Document track_of(const Switching& w, const FormerSegmentPart& span) {
  world::Document track;
  track.curve = w.to, track.heartline = w.document.heartline;
  world::append_knot(track, span.first), world::append_knot(track, span.second);
  track.entities.get<world::Segment>(track.track.segments[0]).turns = span.turns;
  return track;
}

struct StretchError {
  double distance = 0, angle = 0;  // m, rad
  bool within() const { return distance <= kStretchBound && angle <= kUpBound; }
};

// Returns the parameter of the new curve that corresponds to t on the former one.
double beside(const SegmentShape& former, double t, const SegmentShape& now) {
  const dvec3 up = frame_at(former, former.arc.distance(t), t).up;
  return curve::nearest_point(now.key.cubic, rails_point(former, t) - now.key.rails * up).t;
}

// Compares the rails at corresponding points: an upper bound of their distance.
StretchError error_of(const Switching& w, const FormerSegmentPart& span, const SegmentShape& now) {
  const SegmentShape& former = w.shape(span.index);
  StretchError error;
  for (int i = 0; i <= kChecks; ++i) {
    const double t = std::lerp(span.from, span.to, static_cast<double>(i) / kChecks), there = beside(former, t, now);
    error.distance = std::max(error.distance, glm::distance(rails_point(former, t), rails_point(now, there)));
    error.angle = std::max(error.angle, curve::angle_between(frame_at(former, former.arc.distance(t)).up,
                                                             frame_at(now, now.arc.distance(there)).up));
  }
  return error;
}

base::Status too_far(const Switching& w, const FormerSegmentPart& span) {
  const double at = w.derived.starts[span.index] + w.shape(span.index).arc.distance(span.from);
  return {base::Code::refused,
          fmt::format("the rails would move by more than {} m at {:.1f} m; smooth the track there", kRailsBound, at)};
}

// Adds the span to `out`, halved while it misses the bounds. Refused if a short stretch misses kRailsBound.
base::Status fit(const Switching& w, FormerSegmentPart span, std::vector<FormerSegmentPart>& out) {
  const NewCurveExtent covered = covered_by(w, span);
  set_handles(w, covered.length, span);
  DerivedTrack alone = shapes_of(track_of(w, span));
  const double turns = std::round((covered.roll - alone.shape_at(0).roll.twist) / (2 * base::kPi));
  if (turns != 0) {
    span.turns = static_cast<std::int32_t>(std::clamp<double>(turns, -world::kMaxTurns, world::kMaxTurns));
    alone = shapes_of(track_of(w, span));
  }
  const StretchError error = error_of(w, span, alone.shape_at(0));
  // The former length: where handles reach their limits, the new one may not shrink.
  const curve::ArcLengthMap& arc = w.shape(span.index).arc;
  const bool is_short = arc.distance(span.to) - arc.distance(span.from) < kShortStretch;
  if (is_short && !(error.distance <= kRailsBound)) return too_far(w, span);
  if (is_short || error.within()) return out.push_back(span), base::Status{};
  const double middle = 0.5 * (span.from + span.to);
  const OffsetPoint at = w.at(span.index, middle);
  const world::Knot knot = knot_of(at.position, at.tangent(), at.frame.up, at.spin);
  if (base::Status first = fit(w, {span.index, span.from, middle, span.first, knot}, out); !first) return first;
  return fit(w, {span.index, middle, span.to, knot, span.second}, out);
}

base::Result<std::vector<FormerSegmentPart>> fit_all(const Switching& w) {
  const std::size_t knots = w.document.track.knots.size();
  std::vector<world::Knot> moved;
  for (std::size_t k = 0; k < knots; ++k) moved.push_back(moved_knot(w, k));
  std::vector<FormerSegmentPart> spans;
  for (std::size_t i = 0; i < w.derived.order.size(); ++i) {
    const FormerSegmentPart whole{i, 0, 1, moved[i], moved[(i + 1) % knots]};
    if (w.offset == 0) spans.push_back(whole);
    else if (base::Status fitted = fit(w, whole, spans); !fitted) return fitted;
  }
  return spans;
}

// Splits the former segments where spans begin inside them. Returns the first span that is too short for handles.
const FormerSegmentPart* split_at(const Switching& w, const std::vector<FormerSegmentPart>& spans, SwitchedCurve& out) {
  world::Entity last;
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const FormerSegmentPart& span = spans[k];
    const world::Entity former = w.derived.order[span.index];
    if (span.from == 0) {
      last = former;
      out.pieces.put(former, {{0, former}});
      continue;
    }
    const double done = spans[k - 1].from;
    const world::SplitResult split =
        world::split_segment(out.document, last, (span.from - done) / (1 - done),
                             glm::vec3(frame_at(w.shape(span.index), w.shape(span.index).arc.distance(span.from)).up));
    if (split.knot == world::kNone) return &span;
    last = split.second;
    out.pieces.get(former).push_back({span.from, last});
    ++out.added;
  }
  return nullptr;
}

// Copies the spans' values to the knots and segments of the split document; a knot without segments moves alone.
void take_values(const Switching& w, const std::vector<FormerSegmentPart>& spans, world::Document& document) {
  const world::Track& track = document.track;
  const auto set = [&](world::Entity e, const world::Knot& value) -> world::Knot& {
    world::Knot& knot = document.entities.get<world::Knot>(e);
    knot.position = value.position, knot.tangent = value.tangent, knot.up = value.up, knot.spin = value.spin;
    return knot;
  };
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const world::Entity e = track.segments[k];
    world::Segment& segment = document.entities.get<world::Segment>(e);
    segment.turns = spans[k].turns;
    set(segment.from, spans[k].first).out_length = spans[k].first.out_length;
    set(segment.to, spans[k].second).in_length = spans[k].second.in_length;
  }
  if (spans.empty())
    for (std::size_t k = 0; k < track.knots.size(); ++k) set(track.knots[k], moved_knot(w, k));
  if (!w.derived.closed && !spans.empty()) {
    world::Knot &first = document.entities.get<world::Knot>(track.knots.front()),
                &last = document.entities.get<world::Knot>(track.knots.back());
    first.in_length = first.out_length, last.out_length = last.in_length;
  }
  for (const world::Entity e : track.knots) {
    world::Knot& knot = document.entities.get<world::Knot>(e);
    const world::Knot* const former = w.document.entities.find<world::Knot>(e);
    const float in = knot.in_length, out = knot.out_length;
    knot.joint = world::JointKind::aligned;
    if (former == nullptr || former->joint == world::JointKind::aligned) continue;
    if (std::abs(in - out) > kSameHandles * std::max(in, out)) continue;
    knot.in_length = knot.out_length = 0.5f * (in + out);
    knot.joint = world::JointKind::smooth;
  }
}

void move_trains(const Switching& w, SwitchedCurve& out) {
  auto& carts = out.document.entities.pool<world::Train>();
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const world::Train& former = w.document.entities.get<world::Train>(carts.entities()[i]);
    const curve::ArcLengthMap& arc = w.derived.shape(former.segment).arc;
    const CurvePlace now = out.place(w.derived, {former.segment, arc.parameter(former.fraction * arc.length())});
    const curve::ArcLengthMap& there = out.shapes.shape(now.segment).arc;
    carts.items()[i].segment = now.segment;
    carts.items()[i].fraction = std::clamp(there.distance(now.t) / there.length(), 0.0, std::nextafter(1.0, 0.0));
  }
}

}  // namespace

CurvePlace SwitchedCurve::place(const DerivedTrack& former, CurvePlace at) const {
  const std::vector<Piece>& all = pieces.get(at.segment);
  std::size_t k = 0;
  while (k + 1 < all.size() && all[k + 1].from <= at.t) ++k;
  return {all[k].segment, beside(former.shape(at.segment), at.t, shapes.shape(all[k].segment))};
}

base::Result<SwitchedCurve> switch_curve(const world::Document& document, const DerivedTrack& derived,
                                         world::TrackCurve to) {
  SwitchedCurve out;
  out.document = document;
  out.document.curve = to;
  const Switching w{document, derived, to, world::rails_height(document) - world::rails_height(out.document)};
  if (const std::vector<Fold> folds = folds_of(derived, w.offset); !folds.empty())
    return base::Status{base::Code::refused,
                        fmt::format("the {} {}", to == world::TrackCurve::rails ? "rails fold" : "heartline would fold",
                                    fold_text(folds.front(), w.offset))};
  const base::Result<std::vector<FormerSegmentPart>> fitted = fit_all(w);
  if (!fitted) return fitted.status();
  const std::vector<FormerSegmentPart>& spans = *fitted;
  if (const FormerSegmentPart* const tiny = split_at(w, spans, out)) return too_far(w, *tiny);
  if (w.offset != 0) take_values(w, spans, out.document);
  if (const auto broken = world::broken_invariant(out.document))
    return base::Status{base::Code::refused, "the curve would leave the world: " + *broken};
  out.shapes = shapes_of(out.document);
  for (std::size_t k = 0; k < spans.size(); ++k) {
    out.max_error = std::max(out.max_error, error_of(w, spans[k], out.shapes.shape_at(k)).distance);
    if (out.max_error > kRailsBound) return too_far(w, spans[k]);
  }
  if (w.offset != 0) move_trains(w, out);
  return out;
}

}  // namespace coaster::sim
