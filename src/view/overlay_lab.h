// The laboratory's pictures over the scene: construction, frames, comb, osculating circle, rounding and Frenet's
// failures, as lines and marks. Rebuilt each frame; whatever the track's size, each layer stays within its limit, with
// less detail where there is less to see.
#pragma once

#include <span>

#include "sim/shape/frame_methods.h"
#include "view/overlay.h"

namespace coaster::view {

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
inline constexpr int kMaxSpanPieces = 4000;  // of all red spans
inline constexpr int kMaxConflicts = 300;
inline constexpr int kCircleSides = 96;
inline constexpr double kMaxRadius = 1e4;  // m; a flatter curve has no circle worth drawing
inline constexpr double kMaxTooth = 1e3;   // m; at a cusp the curvature has no bound

// De Casteljau's construction on a segment at t: 3, 2 and 1 points, the lines between them, and the tangent as an arrow
// of length |B'|/3. Lines, in this order: the two of the first level, the one of the second, the arrow.
void add_construction(const sim::SegmentShape& shape, double t, const View& view, float scale, Overlay& overlay);

// The osculating circle at t, a polygon that touches the curve with a corner, its centre and radius. Nothing where
// curve::frenet gives no normal or the radius is over kMaxRadius.
void add_circle(const sim::SegmentShape& shape, double t, float scale, Overlay& overlay);

// Teeth from the curve along -kappa N, kappa * comb_scale long (at most kMaxTooth), joined at their ends within each
// segment: at a joint that is not G2 the envelope breaks.
void add_comb(const sim::Derived& derived, const world::Settings& settings, const View& view, Overlay& overlay);

// Tangent, normal (the method's up) and binormal (T x N) of the chosen frame method, as arrows of one length on screen,
// at multiples of a power of two metres along the track. Where the method is undefined, what stands in is drawn
// faintly.
void add_frames(const sim::Derived& derived, const world::Settings& settings, const View& view, Overlay& overlay);

// The polyline of the selected segment, of those at a selected knot, or else of the first ones of the track within the
// limit, each vertex moved by (vertex - exact) * magnification. The last step, where the pinned end meets what the
// evaluator has gathered, is the seam: red.
void add_rounding(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                  Overlay& overlay);

// A cross and the normals on both sides of a flip; a broad line where there is no curvature.
void add_breaks(const sim::Derived& derived, std::span<const sim::FrenetBreak> breaks, const View& view, float scale,
                Overlay& overlay);

// What of the ride lasts longer than it may: a broad line over the rails, each span about the car that feels it.
void add_spans(const sim::Derived& derived, std::span<const sim::RedSpan> spans, float scale, Overlay& overlay);

// Where the track is in its own way: a broad line over both stretches, and a sign between their narrowest places.
void add_conflicts(const sim::Derived& derived, std::span<const sim::Conflict> conflicts, const View& view, float scale,
                   Overlay& overlay);

// The layers that are on, the wide-spread ones first, over dark rims. What they show is read of `findings` while they
// are on alone.
void add_laboratory(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                    const View& view, const Findings& findings, Overlay& overlay);

}  // namespace coaster::view
