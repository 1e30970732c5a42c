#include "sim/shape/rails.h"

#include "curve/continuity.h"

namespace coaster::sim {

using glm::dvec3;

dvec3 OffsetPoint::tangent() const {
  const double length = stretch();
  if (!(length > 0)) return frame.forward;
  return glm::normalize(along * frame.forward - aside * frame.left());
}

OffsetPoint offset_point(const SegmentShape& shape, double s, double height) {
  const curve::Cubic& c = shape.key.cubic;
  const double t = shape.arc.parameter(s);
  OffsetPoint at{curve::point(c, t), frame_at(shape, s)};
  at.spin = shape.roll.spin(s);
  if (height == 0) return at;
  at.position += height * at.frame.up;
  at.along = 1 - height * glm::dot(curve::curvature_vector(c, t), at.frame.up);
  at.aside = height * at.spin;
  // The same up' about the line's own tangent, by the line's own length.
  const double square = at.along * at.along + at.aside * at.aside;
  if (square > 0) at.spin /= square;
  return at;
}

dvec3 rails_point(const SegmentShape& shape, double t) {
  const dvec3 at = curve::point(shape.key.cubic, t);
  return shape.key.rails == 0 ? at : at + shape.key.rails * frame_at(shape, shape.arc.distance(t)).up;
}

dvec3 rails_at(const SegmentShape& shape, double s) {
  const dvec3 at = curve::point(shape.key.cubic, shape.arc.parameter(s));
  return shape.key.rails == 0 ? at : at + shape.key.rails * frame_at(shape, s).up;
}

curve::Frame rails_frame_at(const SegmentShape& shape, double s) {
  if (shape.key.rails == 0) return frame_at(shape, s);
  const OffsetPoint at = offset_point(shape, s, shape.key.rails);
  return {at.tangent(), at.frame.up};
}

curve::Box rails_box(const SegmentShape& shape) {
  const curve::Box box = tight_box(shape.key.cubic);
  const auto by = static_cast<float>(std::abs(shape.key.rails));
  return {box.low - by, box.high + by};
}

}  // namespace coaster::sim
