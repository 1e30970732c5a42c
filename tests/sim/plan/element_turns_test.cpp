// Banked curves with ramps of a given length, S-bends, overbanked turns, and hills in a row: by symmetry, energy and
// closed forms.
#include <gtest/gtest.h>

#include "sim/built_elements.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace element_turns_test {

using glm::dvec3;
using test::Built;
using test::expect_ahead;
using test::expect_upright;
using test::for_random;
using test::kDegree;
using world::ElementKind;

Built built_at(world::Element element, const TrackEnd& end = {}) {
  Built built{element, end, {}};
  std::vector<std::string> lines;
  built.curve = element_shape(built.element, end, lines).curve;
  return built;
}

// Curvature 3v^2 - 2v^3 over a ramp turns by half of ramp / radius: the whole length is radius * angle + ramp.
TEST(element_turns, the_ramps_of_a_curve_are_as_long_as_they_say) {
  for_random(ElementKind::curve, 60, [](const Built& b) {
    if (b.value("ramp") == 0 || b.first().tangent.y != 0) return;
    EXPECT_NEAR(b.last().s - b.first().s, b.value("radius") * b.value("angle") * kDegree + b.value("ramp"), 1e-6);
  });
  world::Element curve = world::usual_element(ElementKind::curve);
  curve.values = {25, 90, 40, 0, 12};
  const Built b = built_at(curve);
  double bend = 0;
  for (const ElementPoint& p : b.curve.points) {
    if (p.s < 11.9) {
      EXPECT_LT(glm::length(p.curvature), 1 / 25.0 - 1e-9) << p.s;
    }
    bend = std::max(bend, glm::length(p.curvature));
  }
  EXPECT_NEAR(bend, 1 / 25.0, 1e-9);
  test::expect_continuous(b);
}

TEST(element_turns, an_s_bend_is_its_own_image_in_its_middle_and_shorter_than_two_curves) {
  for_random(ElementKind::s_bend, 60, [](const Built& b) {
    EXPECT_LT(glm::length(b.last().tangent - b.first().tangent), 1e-8);
    expect_upright(b.last());
    const std::vector<ElementPoint>& p = b.curve.points;
    const std::size_t first = b.curve.lead, last = p.size() - 1;
    const dvec3 sum = p[first].position + p[last].position;
    double bend = 0, turned = 0;
    const double level = 1 - b.first().tangent.y * b.first().tangent.y;
    for (std::size_t i = first; i <= last; ++i) {
      EXPECT_LT(glm::distance(p[i].position + p[first + last - i].position, sum), 1e-6 * b.curve.length());
      bend = std::max(bend, glm::length(p[i].curvature));
      const dvec3 flat = glm::normalize(dvec3(p[i].tangent.x, 0, p[i].tangent.z));
      turned = std::max(turned, std::atan2(glm::dot(flat, b.left()) * b.side(), glm::dot(flat, b.heading())));
    }
    EXPECT_LE(bend * b.value("radius"), level + 1e-9);
    if (b.value("angle") < 170) {
      EXPECT_NEAR(turned, b.value("angle") * kDegree, 0.02) << "in the middle";
    }
    world::Element curve = world::usual_element(ElementKind::curve);
    for (const std::size_t i : {0, 1, 2, 3}) curve.values[i] = b.element.values[i];
    const Built one = built_at(curve, {{0, 2, 0}, b.first().tangent, {0, 1, 0}, {0, 0, 0}});
    EXPECT_LT(b.last().s - b.first().s, 2 * one.curve.length());
  });
}

TEST(element_turns, an_s_bend_banks_to_the_inside_of_each_of_its_turns) {
  const Built b = built_at(world::usual_element(ElementKind::s_bend));
  double to_left = 0, to_right = 0;
  for (const ElementPoint& p : b.curve.points) {
    const dvec3 left = glm::cross(dvec3(0, 1, 0), glm::normalize(dvec3(p.tangent.x, 0, p.tangent.z)));
    const double bank = std::atan2(glm::dot(p.up, left), p.up.y), bend = glm::dot(p.curvature, left);
    EXPECT_NEAR(bank, bend * 25 * 40 * kDegree, 1e-9) << "in proportion to the curvature";
    to_left = std::max(to_left, bank), to_right = std::min(to_right, bank);
  }
  EXPECT_NEAR(to_left, 40 * kDegree, 1e-3);
  EXPECT_NEAR(to_right, -40 * kDegree, 1e-3);
  test::expect_continuous(b);
}

TEST(element_turns, an_overbanked_turn_rises_to_its_middle_and_at_its_speed_nothing_pushes_sideways) {
  for_random(ElementKind::overbanked_turn, 60, [](const Built& b) {
    const double angle = b.value("angle") * kDegree, v = b.value("speed");
    const dvec3 turned = std::cos(angle) * b.heading() + b.side() * std::sin(angle) * b.left();
    EXPECT_LT(glm::length(b.last().tangent - turned), 1e-8);
    expect_upright(b.last());
    EXPECT_NEAR(b.way().y, 0, 1e-7 * b.curve.length());
    EXPECT_NEAR(b.top(), b.value("height"), 5e-3 * b.value("height"));
    double bank = 0;
    for (std::size_t i = b.curve.lead; i < b.curve.points.size(); ++i) {
      const ElementPoint& p = b.curve.points[i];
      if (p.s < b.faded()) continue;
      if (v > 0) {
        const dvec3 force = test::felt(b, p, v);
        EXPECT_NEAR(glm::dot(force, glm::cross(p.tangent, p.up)), 0, 1e-6 * (1 + glm::length(force)));
        EXPECT_GT(glm::dot(force, p.up), 0);
      }
      const dvec3 level = curve::perpendicular(p.tangent, {0, 1, 0});
      bank = std::max(bank, std::acos(std::clamp(glm::dot(p.up, level), -1.0, 1.0)));
    }
    if (v == 0 && b.faded() < 0.4 * b.curve.length()) {
      EXPECT_NEAR(bank, b.value("bank") * kDegree, 0.01);
    }
  });
}

TEST(element_turns, an_overbanked_turn_at_25_m_s_is_banked_beyond_the_vertical) {
  world::Element turn = world::usual_element(ElementKind::overbanked_turn);
  turn.values[4] = 25;
  const Built b = built_at(turn);
  EXPECT_EQ(test::turned_over(b), 2) << "heads point down at the top";
  test::expect_continuous(b);
  test::expect_continuous(built_at(world::usual_element(ElementKind::overbanked_turn)));
}

TEST(element_turns, bunny_hops_are_as_many_as_they_say_and_riders_float_over_each) {
  for_random(ElementKind::bunny_hops, 60, [](const Built& b) {
    const double hops = b.value("hops"), v = b.value("speed");
    EXPECT_EQ(hops, std::floor(hops));
    expect_ahead(b);
    EXPECT_LT(std::abs(b.way().y), 1e-6);
    EXPECT_NEAR(b.top(), b.value("height"), 1e-2 * b.value("height"));
    int crests = 0, floats = 0;
    bool floated = false;
    const std::vector<ElementPoint>& p = b.curve.points;
    for (std::size_t i = b.curve.lead + 1; i < p.size(); ++i) {
      crests += p[i - 1].tangent.y > 0 && p[i].tangent.y <= 0;
      const bool floating = glm::length(test::felt(b, p[i], v)) < 1e-6;
      floats += floating && !floated;
      floated = floating;
      EXPECT_LE(p[i].curvature.y, 1 / b.value("radius") + 1e-9);
    }
    EXPECT_EQ(crests, static_cast<int>(hops));
    EXPECT_EQ(floats, static_cast<int>(hops));
  });
  test::expect_continuous(built_at(world::usual_element(ElementKind::bunny_hops)));
}

}  // namespace element_turns_test
}  // namespace coaster::sim
