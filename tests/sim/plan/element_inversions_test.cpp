// Zero-g roll, Immelmann, dive loop and cobra roll: by energy, symmetry, and the count of inversions.
#include <gtest/gtest.h>

#include "sim/built_elements.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace element_inversions_test {

using glm::dvec3;
using test::Built;
using test::expect_ahead;
using test::expect_upright;
using test::for_random;
using world::ElementKind;

Built built_usual(ElementKind kind, bool right = false) {
  Built built{world::usual_element(kind), {}, {}};
  built.element.right = right;
  std::vector<std::string> lines;
  built.curve = element_shape(built.element, built.end, lines).curve;
  EXPECT_TRUE(lines.empty()) << lines[0];
  return built;
}

// Returns the part of the curve, m, on which riders float upright and upside down.
struct Floated {
  double upright = 0, inverted = 0;
};
Floated floated(const Built& b) {
  Floated sum;
  for (std::size_t i = b.curve.lead + 1; i < b.curve.points.size(); ++i) {
    const ElementPoint& p = b.curve.points[i];
    if (glm::length(test::felt(b, p, b.value("speed"))) > 1e-6) continue;
    (p.up.y > 0 ? sum.upright : sum.inverted) += p.s - b.curve.points[i - 1].s;
  }
  return sum;
}

void expect_back(const Built& b) {
  EXPECT_LT(glm::length(b.last().tangent + b.heading()), 1e-8) << "level, in the opposite direction";
  expect_upright(b.last());
}

TEST(element_inversions, riders_of_a_zero_g_roll_float_while_they_are_rolled_over_once) {
  for_random(ElementKind::zero_g_roll, 60, [](const Built& b) {
    expect_ahead(b);
    EXPECT_LT(std::abs(b.way().y), 1e-6);
    EXPECT_NEAR(b.top(), b.value("height"), 5e-3 * b.value("height"));
    const Floated float_length = floated(b);
    // 3v^2 - 2v^3 is between a quarter and three quarters for about a third of the parabola's width.
    EXPECT_GT(float_length.inverted, 0.15 * (float_length.upright + float_length.inverted));
    EXPECT_GT(float_length.upright, 0.5 * float_length.inverted);
  });
  for (const bool right : {false, true}) {
    const Built b = built_usual(ElementKind::zero_g_roll, right);
    EXPECT_EQ(test::turned_over(b), 2);
    for (const ElementPoint& p : b.curve.points)
      if (std::abs(p.up.y) < 0.2 && p.s < b.curve.length() / 2) {
        EXPECT_GT(glm::dot(p.up, glm::cross(p.tangent, dvec3(0, 1, 0))) * (right ? 1 : -1), 0.9)
            << "rolled to its side first";
      }
    test::expect_continuous(b);
  }
}

TEST(element_inversions, an_immelmann_ends_higher_and_a_dive_loop_lower_both_backwards_in_the_same_plane) {
  for (const ElementKind kind : {ElementKind::immelmann, ElementKind::dive_loop})
    for_random(kind, 60, [&](const Built& b) {
      expect_back(b);
      EXPECT_NEAR(b.way().y, (kind == ElementKind::immelmann ? 1 : -1) * b.value("height"), 1e-7 * b.curve.length());
      EXPECT_NEAR(glm::dot(b.way(), b.left()), 0, 1e-8 * b.curve.length());
      const Floated float_length = floated(b);
      EXPECT_GT(float_length.inverted, 1);
      EXPECT_GT(float_length.upright, 1);
      for (std::size_t i = b.curve.lead; i < b.curve.points.size(); ++i)
        if (b.curve.points[i].s > b.faded()) {
          const ElementPoint& p = b.curve.points[i];
          EXPECT_NEAR(glm::dot(test::felt(b, p, b.value("speed")), glm::cross(p.tangent, p.up)), 0, 1e-6);
        }
    });
  for (const ElementKind kind : {ElementKind::immelmann, ElementKind::dive_loop}) {
    const Built b = built_usual(kind);
    EXPECT_EQ(test::turned_over(b), 2);
    test::expect_continuous(b);
  }
}

// A train that leaves an Immelmann at its speed there rides the reversed curve as a dive loop.
TEST(element_inversions, a_dive_loop_is_an_immelmann_ridden_backwards) {
  const Built up = built_usual(ElementKind::immelmann);
  Built down{world::usual_element(ElementKind::dive_loop), {}, {}};
  down.element.values = up.element.values;
  down.element.values[1] = std::sqrt(26.0 * 26.0 - 2 * 9.81 * 16);
  std::vector<std::string> lines;
  down.curve = element_shape(down.element, down.end, lines).curve;
  const std::size_t count = up.curve.points.size();
  ASSERT_EQ(down.curve.points.size(), count);
  const dvec3 start = up.last().position;
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 there = up.curve.points[count - 1 - i].position - start,
                here = down.curve.points[i].position - down.first().position;
    EXPECT_LT(glm::distance(there, here), 1e-6) << i;
  }
}

TEST(element_inversions, a_cobra_roll_inverts_twice_and_leaves_backwards_beside_its_entry) {
  for_random(ElementKind::cobra_roll, 60, [](const Built& b) {
    expect_back(b);
    EXPECT_LT(std::abs(b.way().y), 1e-6);
    EXPECT_NEAR(glm::dot(b.way(), b.heading()), 0, 1e-6) << "where it began";
    EXPECT_GT(glm::dot(b.way(), b.left()) * b.side(), 0.8 * b.value("height"));
    EXPECT_NEAR(b.top(), b.value("height"), 5e-3 * b.value("height"));
    const std::vector<ElementPoint>& p = b.curve.points;
    const std::size_t first = b.curve.lead, last = p.size() - 1, middle = (first + last) / 2;
    EXPECT_NEAR(glm::dot(p[middle].tangent, b.left()) * b.side(), 1, 1e-8) << "across the entry";
    expect_upright(p[middle]);
    for (std::size_t i = first; i <= middle; ++i) {
      const dvec3 a = p[i].position - p[first].position, c = p[first + last - i].position - p[first].position;
      EXPECT_NEAR(glm::dot(a - c, b.heading()), 0, 1e-6) << "mirrored";
      EXPECT_NEAR(a.y, c.y, 1e-6);
      EXPECT_NEAR(glm::dot(a + c - b.way(), b.left()), 0, 1e-6);
      if (p[i].s > b.faded() && glm::length(p[i].curvature) > 1e-9) {
        EXPECT_NEAR(glm::dot(glm::normalize(p[i].curvature), p[i].up), 1, 1e-6) << "pressed into the seat";
      }
    }
  });
  const Built b = built_usual(ElementKind::cobra_roll);
  EXPECT_EQ(test::turned_over(b), 4);
  test::expect_continuous(b);
  // Almost up to its top it is a loop without a shift: in the plane of its entry.
  for (const ElementPoint& p : b.curve.points) {
    EXPECT_NEAR(p.position.z, 0, 1e-9);
    if (p.up.y < -0.86) break;
  }
}

}  // namespace element_inversions_test
}  // namespace coaster::sim
