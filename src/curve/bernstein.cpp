#include "curve/bernstein.h"

namespace coaster::curve {

using glm::dvec3;

std::array<dvec3, 4> controls(const Cubic& c) { return {dvec3(c.p0), dvec3(c.p1), dvec3(c.p2), dvec3(c.p3)}; }

DeCasteljauPoints construction(const Cubic& cubic, double t) {
  const auto points = controls(cubic);
  const std::vector<dvec3> all = de_casteljau_levels<double, dvec3>(points, t);
  return {{all[4], all[5], all[6]}, {all[7], all[8]}, all[9]};
}

}  // namespace coaster::curve
