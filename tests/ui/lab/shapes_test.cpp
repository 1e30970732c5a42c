// Planes for pictures of space curves (ui/lab/page_widgets.h).
#include "ui/lab/page_widgets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace coaster::ui {
namespace lab_shapes_test {

double arbitrary_metres() {
  return *rc::gen::map(rc::gen::inRange(-100000, 100001), [](int v) { return v * 1.37e-3; });
}
glm::dvec3 arbitrary_point() { return {arbitrary_metres(), arbitrary_metres(), arbitrary_metres()}; }

RC_GTEST_PROP(lab_shapes, axes_of_a_sheet_are_perpendicular_units_and_higher_is_higher, ()) {
  const std::vector<glm::dvec3> points{arbitrary_point(), arbitrary_point(), arbitrary_point(), arbitrary_point()};
  const DrawingPlane sheet = sheet_of(points);
  RC_ASSERT(std::abs(glm::length(sheet.right) - 1) < 1e-9);
  RC_ASSERT(std::abs(glm::length(sheet.up) - 1) < 1e-9);
  RC_ASSERT(std::abs(glm::dot(sheet.right, sheet.up)) < 1e-9);
  RC_ASSERT(glm::dot(points.back() - points.front(), sheet.right) >= -1e-9);
  RC_ASSERT(sheet.up.y >= 0);
}

RC_GTEST_PROP(lab_shapes, coplanar_points_keep_their_distances, ()) {
  const glm::dvec3 origin = arbitrary_point(), a = arbitrary_point(), b = arbitrary_point();
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 4; ++i) {
    const double u = *rc::gen::inRange(-300, 301) * 0.01, v = *rc::gen::inRange(-300, 301) * 0.01;
    points.push_back(origin + u * a + v * b);
  }
  const DrawingPlane sheet = sheet_of(points);
  for (const glm::dvec3 p : points)
    for (const glm::dvec3 q : points) {
      const double there = glm::length(p - q), here = glm::length(sheet.at(p) - sheet.at(q));
      RC_ASSERT(std::abs(there - here) < 1e-6 * (1 + there));
    }
}

TEST(lab_shapes, points_on_a_line_or_in_one_place_have_a_sheet) {
  for (const glm::dvec3 way : {glm::dvec3(0), glm::dvec3(0, 3.7, 0), glm::dvec3(1.3, -0.2, 8.9)}) {
    const glm::dvec3 from(17.3, 4.1, -6.7);
    const std::vector<glm::dvec3> points{from, from + way, from + 2.5 * way, from + 3.1 * way};
    const DrawingPlane sheet = sheet_of(points);
    EXPECT_NEAR(glm::length(sheet.right), 1, 1e-9);
    EXPECT_NEAR(glm::length(sheet.up), 1, 1e-9);
    EXPECT_NEAR(glm::length(sheet.at(points[3]) - sheet.at(points[0])), 3.1 * glm::length(way), 1e-9);
  }
}

}  // namespace lab_shapes_test
}  // namespace coaster::ui
