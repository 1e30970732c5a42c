#include "sim/plan/carry.h"

#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kSame = 1e-5;  // rad
constexpr double kSteep = 0.1;  // m, of a unit tangent's horizontal part: `up` gives the heading then

// Returns the angle above the horizon, degrees.
double slope_deg(dvec3 direction) {
  return base::degrees(
      base::arc_tangent(direction.y, std::sqrt(direction.x * direction.x + direction.z * direction.z)));
}

dvec3 heading(const world::Knot& knot) {
  const bool steep = glm::length(glm::dvec2(knot.tangent.x, knot.tangent.z)) < kSteep;
  return dvec3(steep ? knot.up : knot.tangent);
}

base::Status refused(std::string reason) { return {base::Code::refused, std::move(reason)}; }

}  // namespace

world::Knot Carry::knot(world::Knot k) const {
  k.position = glm::vec3(point(dvec3(k.position)));
  if (cos == 1 && sin == 0) return k;
  k.tangent = glm::vec3(glm::normalize(direction(dvec3(k.tangent))));
  k.up = glm::vec3(glm::normalize(direction(dvec3(k.up))));
  world::orthonormalise(k);
  return k;
}

Carry carry_between(dvec3 from, dvec3 from_heading, dvec3 to, dvec3 to_heading) {
  const dvec3 was(from_heading.x, 0, from_heading.z), is(to_heading.x, 0, to_heading.z);
  const double scale = glm::length(was) * glm::length(is);
  Carry carry{from, to};
  if (!(scale > 0) || was == is) return carry;
  carry.cos = glm::dot(was, is) / scale, carry.sin = glm::cross(was, is).y / scale;
  return carry;
}

base::Result<Carry> carry_between(const world::Knot& from, const world::Knot& to) {
  const Carry carry = carry_between(dvec3(from.position), heading(from), dvec3(to.position), heading(to));
  const dvec3 forward = glm::normalize(dvec3(to.tangent)), carried = carry.direction(dvec3(from.tangent));
  if (!(curve::angle_between(carried, forward) <= kSame)) {
    const double steeper = slope_deg(forward) - slope_deg(carried);
    return refused(fmt::format("the track would end pointing {:.1f} degrees further {} than what follows begins",
                               std::abs(steeper), steeper > 0 ? "up" : "down"));
  }
  const double roll = curve::signed_angle(curve::perpendicular(forward, carry.direction(dvec3(from.up))),
                                          curve::perpendicular(forward, dvec3(to.up)), forward);
  if (!(std::abs(roll) <= kSame))
    return refused(fmt::format("the track would end there rolled by {:.1f} degrees against what follows",
                               std::abs(base::degrees(roll))));
  return carry;
}

}  // namespace coaster::sim
