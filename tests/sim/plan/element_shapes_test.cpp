// The guarantees of each element, checked on its ideal curve at random parameters and ends of track.
#include "sim/plan/element_shapes.h"

#include <gtest/gtest.h>

#include "sim/built_elements.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace element_shapes_test {

using glm::dvec3;
using test::Built;
using test::expect_ahead;
using test::expect_upright;
using test::for_random;
using test::kDegree;
using world::ElementKind;

TEST(element_shapes, a_straight_is_as_long_as_it_says_and_goes_where_it_started_for) {
  for_random(ElementKind::straight, 60, [](const Built& b) {
    EXPECT_LT(glm::length(b.way() - b.first().tangent * b.value("length")), 1e-8 * b.value("length"));
    const double roll = std::remainder(b.value("roll") * kDegree, 2 * M_PI);
    const dvec3 level = curve::perpendicular(b.last().tangent, {0, 1, 0}), right = glm::cross(b.last().tangent, level);
    EXPECT_LT(glm::length(b.last().up - (std::cos(roll) * level + std::sin(roll) * right)), 1e-8)
        << "rolled to the right";
  });
}

TEST(element_shapes, a_curve_turns_by_its_angle_keeps_its_slope_and_is_nowhere_tighter_than_its_radius) {
  for_random(ElementKind::curve, 60, [](const Built& b) {
    const dvec3 t = b.first().tangent;
    const double level = std::sqrt(t.x * t.x + t.z * t.z), angle = b.value("angle") * kDegree;
    const dvec3 turned =
        level * (std::cos(angle) * b.heading() + b.side() * std::sin(angle) * b.left()) + dvec3(0, t.y, 0);
    EXPECT_LT(glm::length(b.last().tangent - turned), 1e-8);
    expect_upright(b.last());
    double bend = 0, bank = 0;
    for (std::size_t i = b.curve.lead; i < b.curve.points.size(); ++i) {
      const ElementPoint& p = b.curve.points[i];
      bend = std::max(bend, glm::length(p.curvature));
      if (p.s > b.faded()) {
        const dvec3 inside = b.side() * glm::cross(dvec3(0, 1, 0), glm::normalize(dvec3(p.tangent.x, 0, p.tangent.z)));
        bank = std::max(bank, std::abs(std::atan2(glm::dot(p.up, inside),
                                                  glm::dot(p.up, curve::perpendicular(p.tangent, {0, 1, 0})))));
        if (b.value("bank") > 0 || b.value("speed") > 0) {
          EXPECT_GT(glm::dot(p.up, inside), -1e-9) << "banked towards the inside";
        }
      }
    }
    EXPECT_LE(bend * b.value("radius"), level * level + 1e-9) << "of the plan's circle, seen along the slope";
    const double wanted = b.value("speed") > 0
                              ? std::atan(b.value("speed") * b.value("speed") / 9.81 / b.value("radius"))
                              : std::abs(b.value("bank")) * kDegree;
    EXPECT_LE(bank, wanted + 1e-9);
  });
}

TEST(element_shapes, a_helix_changes_its_height_and_ends_level) {
  for_random(ElementKind::helix, 60, [](const Built& b) {
    EXPECT_NEAR(b.way().y, b.value("height"), 1e-7 * b.curve.length());
    EXPECT_NEAR(b.last().tangent.y, 0, 1e-9);
    expect_upright(b.last());
    const double angle = b.value("turns") * 2 * M_PI;
    const dvec3 turned = std::cos(angle) * b.heading() + b.side() * std::sin(angle) * b.left();
    EXPECT_LT(glm::length(b.last().tangent - turned), 1e-7);
  });
}

TEST(element_shapes, climb_and_dive_change_the_height_as_they_say_and_are_nowhere_steeper) {
  for (const ElementKind kind : {ElementKind::climb, ElementKind::dive})
    for_random(kind, 60, [&](const Built& b) {
      const double sign = kind == ElementKind::climb ? 1 : -1;
      EXPECT_NEAR(b.way().y, sign * b.value("height"), 1e-7 * b.curve.length() + 1e-6);
      expect_ahead(b);
      EXPECT_NEAR(glm::dot(b.way(), b.left()), 0, 1e-8 * b.curve.length());
      const double from = std::asin(b.first().tangent.y);
      for (std::size_t i = b.curve.lead; i < b.curve.points.size(); ++i) {
        const double slope = std::asin(std::clamp(b.curve.points[i].tangent.y, -1.0, 1.0));
        EXPECT_LE(sign * slope, std::max(sign * from, b.value("angle") * kDegree) + 1e-7);
        EXPECT_LE(glm::length(b.curve.points[i].curvature), 1 / b.value("radius") + 1e-9);
      }
    });
}

TEST(element_shapes, riders_of_a_camelback_float_over_its_crest_at_its_speed) {
  for_random(ElementKind::camelback, 60, [](const Built& b) {
    EXPECT_LT(std::abs(b.way().y), 1e-6) << "returns to the height of its start";
    expect_ahead(b);
    EXPECT_NEAR(b.top(), b.value("height"), 2e-3 * b.value("height"));
    const double v = b.value("speed");
    int floating = 0;
    for (std::size_t i = b.curve.lead; i < b.curve.points.size(); ++i) {
      const ElementPoint& p = b.curve.points[i];
      const double square = v * v - 2 * 9.81 * (p.position.y - b.first().position.y);
      const double felt = glm::dot(square * p.curvature + dvec3(0, 9.81, 0), p.up) / 9.81;
      EXPECT_GT(felt, -0.01) << "never thrown out of the seat";
      floating += felt < 1e-6;
    }
    EXPECT_GT(floating, 10);
  });
}

TEST(element_shapes, a_loop_is_as_high_as_it_says_and_ends_ahead_upright_and_shifted_aside) {
  for_random(ElementKind::loop, 60, [](const Built& b) {
    expect_ahead(b);
    EXPECT_LT(std::abs(b.way().y), 1e-6);
    EXPECT_NEAR(glm::dot(b.way(), b.left()) * b.side(), b.value("shift"), 1e-7 * b.curve.length());
    EXPECT_NEAR(b.top(), b.value("height"), 2e-3 * b.value("height"));
    // A teardrop: the curvature rises from the foot to the top and falls again.
    const std::vector<ElementPoint>& p = b.curve.points;
    const std::size_t middle = (b.curve.lead + p.size() - 1) / 2;
    for (std::size_t i = b.curve.lead + 1; i < p.size(); ++i) {
      const double rise = glm::length(p[i].curvature) - glm::length(p[i - 1].curvature);
      if (i + 1 < middle) {
        EXPECT_GE(rise, -1e-9);
      }
      if (i > middle + 1) {
        EXPECT_LE(rise, 1e-9);
      }
    }
    EXPECT_LT(p[middle].up.y, -0.9) << "upside down at the top";
    // It does not hit itself: where it crosses its own plan, it is the wider apart the more it is shifted.
    double nearest = 1e9;
    for (std::size_t i = b.curve.lead; i < middle; i += 3)
      for (std::size_t k = middle; k < p.size(); k += 3)
        if (p[k].s - p[i].s > b.value("height"))
          nearest = std::min(nearest, glm::distance(p[i].position, p[k].position));
    EXPECT_GT(nearest, 0.35 * b.value("shift"));
  });
}

TEST(element_shapes, a_corkscrew_turns_riders_over_once_and_lets_them_out_upright_and_ahead) {
  for_random(ElementKind::corkscrew, 60, [](const Built& b) {
    expect_ahead(b);
    EXPECT_LT(std::abs(b.way().y), 1e-6);
    EXPECT_GT(glm::dot(b.way(), b.left()) * b.side(), 0);
    EXPECT_NEAR(b.top(), b.value("height"), 5e-3 * b.value("height"));
    const ElementPoint& middle = b.curve.points[(b.curve.lead + b.curve.points.size() - 1) / 2];
    EXPECT_LT(middle.up.y, -0.98);
    const dvec3 axis =
        std::sin(b.value("angle") * kDegree) * b.heading() + b.side() * std::cos(b.value("angle") * kDegree) * b.left();
    for (std::size_t i = b.curve.lead; i < b.curve.points.size(); ++i) {
      const ElementPoint& p = b.curve.points[i];
      EXPECT_NEAR(glm::dot(p.tangent, axis), std::sin(b.value("angle") * kDegree), 1e-9)
          << "one angle with the axis all along";
      if (p.s > b.faded() && glm::length(p.curvature) > 1e-9) {
        EXPECT_NEAR(glm::dot(glm::normalize(p.curvature), p.up), 1, 1e-6) << "pressed into the seat";
      }
    }
  });
}

TEST(element_shapes, an_end_that_bends_sharply_or_is_steep_is_refused_by_what_needs_a_heading) {
  std::vector<std::string> lines;
  TrackEnd steep;
  steep.forward = {0, 1, 0}, steep.up = {0, 0, 1};
  TrackEnd sharp;
  sharp.curvature = {0, 0.6, 0};
  for (std::size_t kind = 0; kind < world::elements().size(); ++kind) {
    world::Element element = world::usual_element(static_cast<ElementKind>(kind));
    EXPECT_EQ(element_shape(element, steep, lines).refusal.empty(), element.kind == ElementKind::straight);
    EXPECT_EQ(element_shape(element, sharp, lines).refusal,
              "the open end is too sharp for an element: its radius is 1.667 m");
  }
}

}  // namespace element_shapes_test
}  // namespace coaster::sim
