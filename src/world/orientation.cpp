// Turns knots: tangent, up and roll. Computed in double and rounded to float once; stored values use no libm function
// except sqrt, so knots have the same bits everywhere.
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "world/topology.h"

namespace coaster::world {
namespace {

constexpr double kAcceptedTolerance = 1e-6;  // of squared length and of the cosine between tangent and up
constexpr double kShortDirection = 1e-9;     // m, shorter vectors have no reliable direction

bool unit(glm::vec3 v) {
  const glm::dvec3 d(v);
  return std::abs(glm::dot(d, d) - 1.0) <= kAcceptedTolerance;
}
glm::dvec3 forward_of(const Knot& knot) { return glm::normalize(glm::dvec3(knot.tangent)); }

}  // namespace

void orthonormalise(Knot& knot) {
  const glm::dvec3 tangent(knot.tangent);
  const double length = glm::length(tangent);
  if (!(length > 0) || !std::isfinite(length)) knot.tangent = {1, 0, 0};
  else if (!unit(knot.tangent)) knot.tangent = glm::vec3(tangent / length);
  const bool right = std::abs(glm::dot(glm::dvec3(knot.tangent), glm::dvec3(knot.up))) <= kAcceptedTolerance;
  if (!unit(knot.up) || !right) knot.up = glm::vec3(curve::perpendicular(forward_of(knot), glm::dvec3(knot.up)));
}

void set_tangent(Knot& knot, glm::vec3 direction) {
  const glm::dvec3 wanted(direction);
  const double length = glm::length(wanted);
  if (!(length >= kShortDirection) || !std::isfinite(length)) return;
  const glm::vec3 tangent(wanted / length);
  if (tangent == knot.tangent) return;  // keeps the bits of `up`: settling twice changes nothing
  const glm::dvec3 from = forward_of(knot), up = curve::perpendicular(from, glm::dvec3(knot.up));
  knot.tangent = tangent;
  const glm::dvec3 forward = forward_of(knot);
  // For a reversal the axis is up itself, which does not change.
  knot.up = glm::vec3(curve::perpendicular(forward, curve::least_rotation(from, forward, up, up)));
}

double roll_deg(const Knot& knot) {
  const glm::dvec3 forward = forward_of(knot), level = curve::perpendicular(forward, {0, 1, 0});
  return base::degrees(curve::signed_angle(level, glm::dvec3(knot.up), forward));
}

void set_roll(Knot& knot, double degrees) {
  if (!std::isfinite(degrees)) return;
  const glm::dvec3 forward = forward_of(knot), level = curve::perpendicular(forward, {0, 1, 0});
  // remainder() is exact, so any number of whole turns gives the same bits.
  const glm::dvec3 up = curve::rotate(level, forward, base::radians(std::remainder(degrees, 360.0)));
  knot.up = glm::vec3(curve::perpendicular(forward, up));
}

}  // namespace coaster::world
