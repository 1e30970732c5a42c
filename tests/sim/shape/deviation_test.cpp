#include "sim/shape/deviation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coaster::sim {
namespace deviation_test {

using glm::dvec3;

// A quarter circle of radius 10 as a cubic: within 3 mm of the circle, whose chords are off by r (1 - cos(angle/2n)).
TEST(deviation, the_chord_error_of_an_arc_is_its_sagitta) {
  const float k = 10 * 0.5522847f;
  const curve::Cubic arc{{10, 0, 0}, {10, k, 0}, {k, 10, 0}, {0, 10, 0}};
  for (const int steps : {4, 8, 64}) {
    const double sagitta = 10 * (1 - std::cos(M_PI / 4 / steps));
    EXPECT_NEAR(chord_error(arc, steps), sagitta, 0.12 * sagitta) << steps;  // steps are up to 6 % longer than others
  }
}

// By brute force: every chord, a hundred points each.
TEST(deviation, the_chord_error_is_that_of_all_points_of_all_chords) {
  const curve::Cubic cubics[] = {{{0, 0, 0}, {17, 3, -4}, {5, 22, 9}, {30, 8, 11}},
                                 {{100, 2, 50}, {108, 2, 50}, {90, 30, 41}, {120, 31, 60}},
                                 {{0, 5, 0}, {10, 5, 0}, {20, 5, 0}, {30, 5, 0}}};
  for (const curve::Cubic& cubic : cubics)
    for (const int steps : {1, 2, 7, 64, 500}) {
      double worst = 0;
      for (int i = 0; i < steps; ++i) {
        const dvec3 a = curve::point(cubic, static_cast<double>(i) / steps),
                    b = curve::point(cubic, static_cast<double>(i + 1) / steps);
        for (int j = 1; j < 100; ++j) {
          const dvec3 off = dvec3(curve::point(cubic, (i + j / 100.0) / steps)) - a, way = b - a;
          worst = std::max(worst, glm::length(off - glm::dot(off, way) / glm::dot(way, way) * way));
        }
      }
      EXPECT_NEAR(chord_error(cubic, steps), worst, 0.06 * worst + 1e-9 + (steps < 3 ? 0.2 * worst : 0)) << steps;
    }
}

}  // namespace deviation_test
}  // namespace coaster::sim
