#include "sim/plan/upright_move.h"

#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/plan/element_path.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kSame = 1e-5;  // rad
constexpr double kSteep = 0.1;  // m, of a unit tangent's horizontal part: below it `up` gives the heading

dvec3 heading(const world::Knot& knot) {
  const bool steep = glm::length(glm::dvec2(knot.tangent.x, knot.tangent.z)) < kSteep;
  return dvec3(steep ? knot.up : knot.tangent);
}

// Returns the angle with one decimal, or down to the first digit that is not 0.
std::string degrees_text(double rad) {
  const double deg = std::abs(base::degrees(rad));
  return deg < 0.05 ? fmt::format("{:.1g}", deg) : fmt::format("{:.1f}", deg);
}

base::Status refused(std::string reason) { return {base::Code::refused, std::move(reason)}; }

}  // namespace

world::Knot UprightMove::knot(world::Knot k) const {
  k.position = glm::vec3(point(dvec3(k.position)));
  if (cos == 1 && sin == 0) return k;
  k.tangent = glm::vec3(glm::normalize(direction(dvec3(k.tangent))));
  k.up = glm::vec3(glm::normalize(direction(dvec3(k.up))));
  world::orthonormalise(k);
  return k;
}

UprightMove move_between(dvec3 from, dvec3 from_heading, dvec3 to, dvec3 to_heading) {
  const dvec3 was(from_heading.x, 0, from_heading.z), is(to_heading.x, 0, to_heading.z);
  const double scale = glm::length(was) * glm::length(is);
  UprightMove carry{from, to};
  if (!(scale > 0) || was == is) return carry;
  carry.cos = glm::dot(was, is) / scale, carry.sin = glm::cross(was, is).y / scale;
  return carry;
}

base::Result<UprightMove> move_between(const world::Knot& from, const world::Knot& to) {
  const UprightMove carry = move_between(dvec3(from.position), heading(from), dvec3(to.position), heading(to));
  const dvec3 forward = glm::normalize(dvec3(to.tangent)), carried = carry.direction(dvec3(from.tangent));
  if (const double off = curve::angle_between(carried, forward); !(off <= kSame)) {
    const double steeper = slope_of(forward) - slope_of(carried);
    const char* const where = std::abs(steeper) < 0.5 * off ? "aside" : steeper > 0 ? "up" : "down";
    return refused(fmt::format("the track would end pointing {} degrees further {} than what follows begins",
                               degrees_text(off), where));
  }
  const double roll = curve::signed_angle(curve::perpendicular(forward, carry.direction(dvec3(from.up))),
                                          curve::perpendicular(forward, dvec3(to.up)), forward);
  if (!(std::abs(roll) <= kSame))
    return refused(
        fmt::format("the track would end there rolled by {} degrees against what follows", degrees_text(roll)));
  return carry;
}

}  // namespace coaster::sim
