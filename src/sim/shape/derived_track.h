// All data derived from document and settings: curves, lengths, frames, polylines. Rebuilt where the key differs; never
// saved, never edited.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "curve/arc_length.h"
#include "curve/evaluators.h"
#include "curve/frames.h"
#include "sim/shape/roll.h"
#include "sim/shape/segment_tree.h"
#include "world/document.h"
#include "world/evaluation_settings.h"
#include "world/settings.h"

namespace coaster::sim {

// The inputs of a segment's shape, compared bit by bit with ==.
struct ShapeKey {
  curve::Cubic cubic;
  glm::vec3 up_from{0}, up_to{0};
  std::int32_t turns = 0;
  // The knots' own tangents: the rounded control points are slightly less accurate.
  glm::vec3 tangent_from{1, 0, 0}, tangent_to{1, 0, 0};
  float spin_from = 0, spin_to = 0;  // rad/m
  double rails = 0;                  // m, of the rails above the curve (sim/shape/rails.h)
  world::CoasterKind kind{};         // of the solids along it
  friend bool operator==(const ShapeKey&, const ShapeKey&) = default;
};

struct PolylineKey {
  curve::EvaluatorId evaluator{};
  int steps = 0;
  friend bool operator==(const PolylineKey&, const PolylineKey&) = default;
};

inline constexpr int kFrameIntervals = 32;

// One segment's derived data. Each rebuild gives `shape_build` and `polyline_build` a new number, which caches compare.
// Frames and polyline are stored only as far as they cannot be recomputed quickly.
struct SegmentShape {
  ShapeKey key;
  curve::PreparedCubic curve;
  curve::ArcLengthMap arc;
  double measured_length = 0;  // m, by the chosen arc-length method
  curve::ArcLengthId measured_by{};
  int measured_steps = 0;
  Roll roll;
  std::array<glm::dvec3, kFrameIntervals + 1> ups{};  // up vectors of the frames at uniform t
  std::uint32_t tight = 0;  // bit i: within interval i frames are carried in several steps, or there is a cusp
  std::uint64_t shape_build = 0;
  std::optional<world::EquipmentKind> fitted;  // the segment's equipment; not part of its shape

  PolylineKey polyline_key;  // steps 0: there is no polyline (for a GPU evaluator)
  double deviation = 0;      // m, largest |vertex - exact point at the same t|, long double oracle
  std::uint64_t polyline_build = 0;

  // Returns frame `i` of kFrameIntervals + 1 at uniform t: rotation-minimising (to curve::kFrameBound), turned by
  // `roll`.
  curve::Frame frame(int i) const {
    return {curve::unit_tangent(key.cubic, static_cast<double>(i) / kFrameIntervals), ups[static_cast<std::size_t>(i)]};
  }
};

// Builds frames and roll from key and arc: rotation-minimising from `up_from`, turned to meet `up_to` by the knots'
// spins.
void build_frames(SegmentShape& shape);

// A segment's polyline: steps+1 vertices; tangents are B'(t), not normalised.
struct Polyline {
  std::vector<glm::vec3> points, tangents;
};
// Evaluates the polyline described by polyline_key; about 3 ns a vertex. Without steps it is empty.
void evaluate_polyline(const SegmentShape& shape, Polyline& polyline);

// The rebuild of a shape: segment `index` in the track's order.
struct ShapeChange {
  std::uint64_t build = 0;
  std::size_t index = 0;
};

struct DerivedTrack {
  world::Pool<SegmentShape> segments;  // by segment entity of the document
  std::vector<world::Entity> order;    // in the order of document.track.segments
  std::vector<double> starts;  // m, distance of segment i's start along the track; size order.size()+1, back() = length
  // rad, rotation of the knots' frames relative to rotation-minimising ones before segment i; the same size as starts.
  std::vector<double> twists;
  SegmentTree tree;  // over `order`, for picking and clearance
  bool closed = false;
  double length = 0;                  // m, adaptive Gauss-Legendre
  double measured_length = 0;         // m, by the chosen arc-length method
  curve::EvaluatedBy evaluated_by{};  // where polylines are evaluated; by a shader, segments hold none
  int steps = 0;                      // steps of a segment's polyline
  std::int64_t vertices = 0;          // of all polylines, wherever evaluated
  double deviation = 0;               // m, the largest of all segments; 0 for a GPU evaluator
  // Statistics of the last derive():
  std::size_t compared = 0;       // knots compared one by one; the others are compared bitwise, many at once
  int rebuilds = 0;               // segments whose shape or polyline was evaluated
  double evaluation_seconds = 0;  // time in the evaluator's polyline function alone
  std::int64_t evaluated_vertices = 0;
  std::uint64_t last_build = 0;

  // The inputs of the segments and the summed figures of each, in the track's order, so that an edit reads only the
  // shapes that it changes.
  struct BuiltInputs {
    std::vector<world::Knot> knots;
    std::vector<std::int32_t> turns;
    std::vector<std::optional<world::EquipmentKind>> fitted;
    std::vector<double> lengths, twists, measured_lengths, deviations;
    world::Pool<world::Equipment> equipment;
    world::Evaluation evaluation;
    double rails = 0;
    world::CoasterKind kind{};
    std::vector<ShapeChange> changes;  // all changes after the build `known_since`
    std::uint64_t known_since = 0;
  } made;

  // Returns the rebuilds of shapes after `build`, an earlier value of last_build, ascending; nothing if segments were
  // added, removed or reordered since then, or if there are very many changes: then any shape may be new.
  std::optional<std::span<const ShapeChange>> changes_since(std::uint64_t build) const;

  const SegmentShape& shape(world::Entity segment) const { return segments.get(segment); }
  const SegmentShape& shape_at(std::size_t index) const { return shape(order[index]); }  // index into `order`
};

// Seconds on a monotonic clock, for measuring; no derived value depends on it. An empty function measures nothing. It
// is called from several threads at once where many segments are derived.
using Clock = std::function<double()>;

// Updates `derived`. Costs one comparison per knot and segment, and a rebuild for each segment that changed. The result
// has the same bits with any number of `workers`, which are threads.
void derive(const world::Document& document, const world::Settings& settings, const Clock& clock, DerivedTrack& derived,
            unsigned workers = base::cores());

// Returns curves and frames only, without polylines.
DerivedTrack shapes_of(const world::Document& document);

// Returns `distance` (m) minus whole laps of `length` on a closed track, in [0, length] (rounding can reach the end).
inline double within_lap(double distance, double length, bool closed) {
  return closed && length > 0 ? distance - length * std::floor(distance / length) : distance;
}

struct TrackPlace {
  std::size_t index = 0;  // index into derived.order
  double s = 0;           // m within the segment
};
// Returns the position by distance from the track's start; wraps on a closed track, clamps on an open one. Needs a
// segment.
TrackPlace place_at(const DerivedTrack& derived, double distance);

// A point of the rails, as integrators use it.
struct RailPoint {
  double height;  // m (y)
  double slope;   // dy/ds, the tangent's y
};

// True if a segment has a cusp or turns back on itself inside. There the frame makes a half turn about `up`, so that no
// rotation-minimising frame leads from knot to knot, and roll.twist is no twist.
bool has_cusp(const SegmentShape& shape);
bool has_cusp(const DerivedTrack& derived);  // in any segment

// Returns the frame at arc length s of a segment (rotation-minimising from the first knot's up to curve::kFrameBound,
// turned by the roll); forward is exactly the unit tangent.
curve::Frame frame_at(const SegmentShape& shape, double s);
// The same, if the parameter t at s is known.
curve::Frame frame_at(const SegmentShape& shape, double s, double t);

}  // namespace coaster::sim
