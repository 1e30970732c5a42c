// The rails of a segment: the curve itself, or a line below it (world::rails_height). Trains move along the curve;
// these functions are for drawing and contact with the rails.
#pragma once

#include "sim/shape/derived_track.h"

namespace coaster::sim {

// Return the middle of the rails at a parameter of the curve, and at arc length s of it.
glm::dvec3 rails_point(const SegmentShape& shape, double t);
glm::dvec3 rails_at(const SegmentShape& shape, double s);
// Returns the frame at arc length s of the curve, its forward along the rails.
curve::Frame rails_frame_at(const SegmentShape& shape, double s);
// Returns a box that contains the rails.
curve::Box rails_box(const SegmentShape& shape);

// A point of the line h metres above the curve along `up`. With the tangent T, the curvature vector k and the spin w,
// up' = -(k up) T + w (T x up), so the line's derivative by the curve's arc length is (1 - h k up) T + h w (T x up). It
// is perpendicular to `up`, so `up` serves both lines.
struct OffsetPoint {
  glm::dvec3 position{0};
  curve::Frame frame;           // of the curve
  double along = 1, aside = 0;  // components of the derivative; the line folds where `along` is 0 or less
  double spin = 0;              // rad/m, of the line, by its own length
  double stretch() const { return std::sqrt(along * along + aside * aside); }  // m of the line per metre of curve
  // Returns the unit tangent of the line; the curve's own where the line's derivative vanishes.
  glm::dvec3 tangent() const;
};
OffsetPoint offset_point(const SegmentShape& shape, double s, double height);

}  // namespace coaster::sim
