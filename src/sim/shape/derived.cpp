#include "sim/shape/derived.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/portable_math.h"
#include "world/evaluation.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Builds frames at uniform t: rotation-minimising from `up_from`, turned so that they meet `up_to`, by the knots'
// spins.
void build_frames(const ShapeKey& key, SegmentShape& shape) {
  const curve::Cubic& c = key.cubic;
  shape.frames.resize(kFrameIntervals + 1);
  dvec3 last = curve::point(c, 0.0);
  const dvec3 start = curve::unit_tangent(c, 0.0);
  shape.frames[0] = {start, curve::perpendicular(start, dvec3(key.up_from))};
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const double t = static_cast<double>(i) / kFrameIntervals;
    const dvec3 here = curve::point(c, t);
    shape.frames[i] = curve::transport(shape.frames[i - 1], last, here, curve::unit_tangent(c, t));
    last = here;
  }
  const curve::Frame& end = shape.frames.back();
  const dvec3 wanted = curve::perpendicular(end.forward, dvec3(key.up_to));
  const double twist = curve::signed_angle(end.up, wanted, end.forward) + key.turns * 2.0 * base::kPi;
  shape.roll = {shape.arc.length(), twist, key.spin_from, key.spin_to};
  if (!(shape.roll.length > 0)) return;
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const double angle =
        i == kFrameIntervals ? twist : shape.roll.angle(shape.arc.distance(static_cast<double>(i) / kFrameIntervals));
    shape.frames[i].up = curve::rotate(shape.frames[i].up, shape.frames[i].forward, angle);
  }
}

void build_shape(const ShapeKey& key, SegmentShape& shape) {
  shape.key = key;
  shape.curve = curve::prepare(key.cubic);
  shape.arc = curve::ArcLengthMap(key.cubic);
  build_frames(key, shape);
}

// Returns the largest distance of a vertex from the exact point at the same parameter: the evaluator's rounding error.
double deviation_of(const SegmentShape& shape) {
  const int n = static_cast<int>(shape.points.size()) - 1;
  double worst = 0;
  for (int i = 0; i <= n; ++i) {
    const dvec3 exact = curve::point_long_double(shape.key.cubic, static_cast<double>(i) / n);
    const dvec3 d = dvec3(shape.points[i]) - exact;
    worst = std::max(worst, glm::dot(d, d));
  }
  return std::sqrt(worst);
}

ShapeKey key_of(const world::Document& document, const world::Segment& segment) {
  const world::Knot &from = world::knot(document, segment.from), &to = world::knot(document, segment.to);
  return {{from.position, world::out_handle(from), world::in_handle(to), to.position},
          from.up,
          to.up,
          segment.turns,
          from.tangent,
          to.tangent,
          from.spin,
          to.spin,
          world::rails_height(document)};
}

void evaluate_polyline(const curve::Evaluator& row, const PolylineKey& key, const Clock& clock, SegmentShape& shape,
                       Derived& derived) {
  shape.points.resize(static_cast<std::size_t>(key.steps) + 1);
  shape.tangents.resize(shape.points.size());
  const double before = clock ? clock() : 0.0;
  row.polyline(shape.curve, shape.points, shape.tangents);
  if (clock) derived.evaluation_seconds += clock() - before;
  shape.polyline_key = key;
  shape.polyline_build = ++derived.last_build;
  shape.deviation = deviation_of(shape);
  derived.evaluated_vertices += key.steps + 1;
}

// Also frees the memory: GPU evaluators need only the control points.
void drop_polyline(SegmentShape& shape) {
  if (shape.polyline_key.steps == 0) return;
  shape.points = std::vector<glm::vec3>();
  shape.tangents = std::vector<glm::vec3>();
  shape.polyline_key = {};
  shape.deviation = 0;
}

// Refits the tree. `reshaped`: indices of segments with new cubics. Rebuilds it if segments were added, removed or
// reordered, or most of them moved.
void update_tree(bool reordered, std::span<const std::size_t> reshaped, Derived& derived) {
  if (!reordered && reshaped.empty()) return;
  if (reordered || reshaped.size() > derived.order.size() / 2) {
    std::vector<curve::Cubic> cubics;
    cubics.reserve(derived.order.size());
    for (const world::Entity e : derived.order) cubics.push_back(derived.shape(e).key.cubic);
    return build_tree(std::move(cubics), derived.tree);
  }
  for (const std::size_t i : reshaped) derived.tree.cubics[i] = derived.shape_at(i).key.cubic;
  refit_tree(reshaped, derived.tree);
}

}  // namespace

void derive(const world::Document& document, const world::Settings& settings, const Clock& clock, Derived& derived) {
  const bool reordered = derived.order != document.track.segments;
  std::vector<std::size_t> reshaped;
  if (reordered) {
    derived.order = document.track.segments;
    derived.segments.keep_those_of(document.entities.pool<world::Segment>());
  }
  derived.closed = document.track.closed;
  derived.rebuilds = 0;
  derived.evaluation_seconds = 0;
  derived.evaluated_vertices = 0;
  derived.vertices = 0;
  derived.deviation = 0;
  derived.measured_length = 0;
  derived.starts.resize(derived.order.size() + 1);
  derived.starts[0] = 0;
  derived.twists.resize(derived.starts.size());
  derived.twists[0] = 0;
  const curve::Evaluator& row = base::row_of(settings.evaluation->evaluator);
  const curve::ArcLengthMethod& method = base::row_of(settings.evaluation->arc_length);
  const PolylineKey polyline{settings.evaluation->evaluator, settings.evaluation->steps};
  derived.evaluated_by = row.evaluated_by;
  derived.steps = settings.evaluation->steps;

  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const world::Entity entity = derived.order[i];
    const ShapeKey key = key_of(document, world::segment(document, entity));
    SegmentShape& shape = derived.segments.obtain(entity);
    const bool new_shape = shape.shape_build == 0 || !(shape.key == key);
    if (new_shape) {
      build_shape(key, shape);
      shape.shape_build = ++derived.last_build;
      reshaped.push_back(i);
    }
    const world::Equipment* const equipment = document.entities.find<world::Equipment>(entity);
    shape.fitted = equipment ? std::optional(equipment->kind) : std::nullopt;
    if (new_shape || shape.measured_by != settings.evaluation->arc_length ||
        shape.measured_steps != settings.evaluation->steps) {
      shape.measured_length = method.length(key.cubic, settings.evaluation->steps);
      shape.measured_by = settings.evaluation->arc_length;
      shape.measured_steps = settings.evaluation->steps;
    }
    const bool on_processor = row.evaluated_by == curve::EvaluatedBy::processor;
    const bool stale = new_shape || (on_processor && !(shape.polyline_key == polyline));
    if (!on_processor) drop_polyline(shape);
    if (on_processor && stale) evaluate_polyline(row, polyline, clock, shape, derived);
    if (stale) ++derived.rebuilds;
    derived.starts[i + 1] = derived.starts[i] + shape.arc.length();
    derived.twists[i + 1] = derived.twists[i] + shape.roll.twist;
    derived.measured_length += shape.measured_length;
    derived.vertices += settings.evaluation->steps + 1;
    derived.deviation = std::max(derived.deviation, shape.deviation);
  }
  derived.length = derived.starts.back();
  update_tree(reordered, reshaped, derived);
}

Derived shapes_of(const world::Document& document) {
  world::Settings settings;
  settings.evaluation->steps = 1;
  Derived derived;
  derive(document, settings, {}, derived);
  return derived;
}

TrackPlace place_at(const Derived& derived, double distance) {
  COASTER_CHECK(!derived.order.empty(), "a place needs a segment");
  distance = within_lap(distance, derived.length, derived.closed);
  if (derived.closed && distance >= derived.length) distance = 0;
  distance = std::clamp(distance, 0.0, derived.length);
  const auto above = std::upper_bound(derived.starts.begin(), derived.starts.end(), distance);
  std::size_t index = static_cast<std::size_t>(above - derived.starts.begin());
  index = std::min(index == 0 ? 0 : index - 1, derived.order.size() - 1);
  return {index, distance - derived.starts[index]};
}

curve::Frame frame_at(const SegmentShape& shape, double s) { return frame_at(shape, s, shape.arc.parameter(s)); }

curve::Frame frame_at(const SegmentShape& shape, double s, double t) {
  const curve::Cubic& c = shape.key.cubic;
  const double length = shape.arc.length();
  if (!(s > 0)) return shape.frames.front();
  if (s >= length) return shape.frames.back();
  const int below = std::min(static_cast<int>(t * kFrameIntervals), kFrameIntervals - 1);
  const double t0 = static_cast<double>(below) / kFrameIntervals;
  curve::Frame frame =
      curve::transport(shape.frames[below], curve::point(c, t0), curve::point(c, t), curve::unit_tangent(c, t));
  frame.up = curve::rotate(frame.up, frame.forward, shape.roll.angle(s) - shape.roll.angle(shape.arc.distance(t0)));
  return frame;
}

}  // namespace coaster::sim
