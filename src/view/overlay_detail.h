// Parts of the overlay: lines and arrows of constant size on screen, the track that is close enough for detail, and the
// laboratory's pictures over the scene. Rebuilt each frame. Each layer stays within its limit for every track size,
// with less detail at a distance.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "sim/shape/frame_methods.h"
#include "view/overlay.h"

namespace coaster::view {

// Returns pixels per metre perpendicular to the line of sight at a point; 0 behind the eye.
class PixelScale {
 public:
  explicit PixelScale(const View& view);
  double operator()(glm::dvec3 at) const;

 private:
  glm::dvec3 eye_, forward_;
  double focal_px_;
  bool parallel_;
};

inline std::uint32_t faded(std::uint32_t rgba, std::uint32_t alpha) { return (rgba & 0xffffff00u) | alpha; }

inline void add_line(glm::dvec3 from, glm::dvec3 to, float width_px, std::uint32_t rgba, Overlay& overlay) {
  overlay.lines.push_back({glm::vec3(from), glm::vec3(to), width_px, rgba});
}

inline void add_disc(glm::dvec3 at, float radius_px, std::uint32_t rgba, Overlay& overlay) {
  overlay.marks.push_back({glm::vec3(at), radius_px, rgba, MarkShape::disc});
}

// Adds a curve in `pieces` straight lines; at(x) is its point at x, from one x to another.
template <class At>
void add_curve(const At& at, double from, double to, int pieces, float width_px, std::uint32_t rgba, Overlay& overlay) {
  glm::dvec3 before = at(from);
  for (int i = 1; i <= pieces; ++i) {
    const glm::dvec3 next = at(from + (to - from) * i / pieces);
    add_line(before, next, width_px, rgba, overlay);
    before = next;
  }
}

// Adds an arc of a ring from one angle to another, in steps of at most `step`; at(angle) is a point of the ring.
template <class At>
void add_arc(const At& at, double from, double to, double step, float width_px, std::uint32_t rgba, Overlay& overlay) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));
  add_curve(at, from, to, pieces, width_px, rgba, overlay);
}

// Returns the angle (rad) about the unit axis, from `zero` m, at which a ray meets the plane of a ring; nothing if the
// plane is seen edge-on or the ray meets its middle.
std::optional<double> angle_on_ring(const Ray& ray, glm::dvec3 centre, glm::dvec3 axis, glm::dvec3 zero, double radius);

// Returns the selected segment, or the segments at the selected knot.
std::vector<world::Entity> selected_segments(const world::Document& document, world::Entity selected);

// Returns the point `height` metres above the rails at a distance along the track.
glm::dvec3 over_rails(const sim::DerivedTrack& derived, double distance, double height);

// Adds an arrow from `from` along the unit `direction`, `length` metres long. Its head, two barbs that face the eye, is
// omitted if the arrow points along the view.
void add_arrow(glm::dvec3 from, glm::dvec3 direction, double length, const View& view, float width_px,
               std::uint32_t rgba, Overlay& overlay);

// Adds a round sign of constant size on screen that faces the eye: a disc with dark dots at `glyph`, in pixels to the
// right and up.
void add_sign(glm::dvec3 at, std::uint32_t rgba, std::span<const glm::dvec2> glyph, const View& view, float scale,
              Overlay& overlay);

// 0xRRGGBBAA.
inline constexpr std::uint32_t kConstructionColour = 0x7fd1b9ff, kCombColour = 0xb39ddbff, kCircleColour = 0xf4e9a6ff;
inline constexpr std::uint32_t kTangentColour = 0xe5534bff, kNormalColour = 0x4fb477ff, kBinormalColour = 0x4c9affff;
inline constexpr std::uint32_t kRoundingColour = 0xff8ac4ff, kLimitColour = 0xff3b30ff, kSeamColour = 0xe5534bff,
                               kBreakColour = 0xf2b84bff;
inline constexpr std::uint32_t kConflictColour = 0xffdd33ff;

inline constexpr int kMaxFrames = 200;  // three arrows each
inline constexpr int kMaxTeeth = 3000;
inline constexpr int kMaxRoundingVertices = 8200;  // two segments at the highest resolution
inline constexpr int kMaxBreaks = 500;
inline constexpr int kMaxSpanPieces = 4000;  // for all overloads
inline constexpr int kMaxConflicts = 300;
inline constexpr int kMaxJolts = 300;
inline constexpr int kCircleSides = 96;
inline constexpr double kMaxRadius = 1e4;  // m; flatter curves get no circle
inline constexpr double kMaxTooth = 1e3;   // m; curvature is unbounded at a cusp

// Adds de Casteljau's construction on a segment at t: 3, 2 and 1 points, the lines between them, and the tangent as an
// arrow of length |B'|/3. Lines, in this order: the two of the first level, the one of the second, the arrow.
void add_construction(const sim::SegmentShape& shape, double t, const View& view, float scale, Overlay& overlay);

// Adds the osculating circle at t, a polygon that touches the curve with a corner, with its centre and radius. Adds
// nothing where curve::frenet gives no normal or the radius exceeds kMaxRadius.
void add_circle(const sim::SegmentShape& shape, double t, float scale, Overlay& overlay);

// Adds teeth from the curve along -kappa N, kappa * comb_scale long (at most kMaxTooth), joined at their ends within
// each segment. The envelope breaks at a joint that is not G2.
void add_comb(const sim::DerivedTrack& derived, const world::Settings& settings, const View& view, Overlay& overlay);

// Adds tangent, normal (the method's up) and binormal (T x N) of the chosen frame method, as arrows of one length on
// screen, at multiples of a power of two metres along the track. Where the method is undefined, its substitute is drawn
// faintly.
void add_frames(const sim::DerivedTrack& derived, const world::Settings& settings, const View& view, Overlay& overlay);

// Adds the polyline of the selected segment, of the segments at a selected knot, or else of the first segments within
// the limit, each vertex moved by (vertex - exact) * magnification. The last step, from the evaluator's accumulated
// error to the pinned end, is the seam: red.
void add_rounding(const world::Document& document, const sim::DerivedTrack& derived, const world::Settings& settings,
                  const View& view, Overlay& overlay);

// Adds a cross and the normals on both sides of a flip, and a broad line where the curvature is 0.
void add_breaks(const sim::DerivedTrack& derived, std::span<const sim::FrenetBreak> breaks, const View& view,
                float scale, Overlay& overlay);

// Adds overloads: a broad line over the rails, each span at the car that feels it.
void add_spans(const sim::DerivedTrack& derived, std::span<const sim::Overload> spans, float scale, Overlay& overlay);

// Adds the visible layers, the most extensive ones first, over dark rims. Each layer reads `findings` only while it is
// visible.
void add_laboratory(const world::Document& document, const sim::DerivedTrack& derived, const world::Settings& settings,
                    const View& view, const MarkedFindings& findings, Overlay& overlay);

}  // namespace coaster::view
