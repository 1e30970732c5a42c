// Elements at random parameters and ends of track, and checks of their ideal curves.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/random_elements.h"

namespace coaster::test {

inline constexpr double kDegree = M_PI / 180;

struct Built {
  world::Element element;  // as clamped
  sim::TrackEnd end;
  sim::ElementCurve curve;
  double value(std::string_view name) const { return world::value_of(element, name); }
  const sim::ElementPoint& first() const { return curve.points[curve.lead]; }
  const sim::ElementPoint& last() const { return curve.points.back(); }
  glm::dvec3 way() const { return last().position - first().position; }
  glm::dvec3 heading() const { return glm::normalize(glm::dvec3(first().tangent.x, 0, first().tangent.z)); }
  glm::dvec3 left() const { return glm::cross(glm::dvec3(0, 1, 0), heading()); }
  double side() const { return element.right ? -1 : 1; }
  // m, where the roll of the start has faded out
  double faded() const {
    for (const std::size_t at : curve.breaks)
      if (curve.points[at].s >= 8) return curve.points[at].s;
    return curve.length();
  }
  double top() const {
    double y = -1e9;
    for (std::size_t i = curve.lead; i < curve.points.size(); ++i) y = std::max(y, curve.points[i].position.y);
    return y - first().position.y;
  }
};

// Calls check(built) for `count` elements of the kind that can be built.
template <class Check>
void for_random(world::ElementKind kind, int count, Check check) {
  test::RandomElements random(100 + static_cast<std::uint32_t>(kind));
  for (int i = 0; i < count; ++i) {
    Built built{random.of_kind(kind), random.end(), {}};
    std::vector<std::string> lines;
    sim::ElementShape shape = sim::element_shape(built.element, built.end, lines);
    if (!shape.refusal.empty()) {
      EXPECT_NE(shape.refusal.find("steeper"), std::string::npos) << shape.refusal;
      continue;
    }
    for (const std::string& line : lines) EXPECT_NE(line.find("limit"), std::string::npos) << line;
    built.curve = std::move(shape.curve);
    check(built);
  }
}

inline void expect_upright(const sim::ElementPoint& p) {
  EXPECT_NEAR(glm::dot(p.up, glm::cross(p.tangent, glm::dvec3(0, 1, 0))), 0, 1e-9) << "no roll";
  EXPECT_GT(p.up.y, 0);
}
inline void expect_ahead(const Built& b) {
  EXPECT_LT(glm::length(b.last().tangent - b.heading()), 1e-9) << "level and straight ahead";
  expect_upright(b.last());
}

// Felt acceleration of a point on the rails in g, by conservation of energy from the speed at the element's start.
// Along the rails it is 0: the train falls freely.
inline glm::dvec3 felt(const Built& b, const sim::ElementPoint& p, double speed) {
  const double square = speed * speed - 2 * 9.81 * (p.position.y - b.first().position.y);
  return square / 9.81 * p.curvature + glm::dvec3(0, 1, 0) - p.tangent.y * p.tangent;
}

// Returns how often the riders' heads change between up and down.
inline int turned_over(const Built& b) {
  int count = 0;
  for (std::size_t i = b.curve.lead + 1; i < b.curve.points.size(); ++i)
    count += (b.curve.points[i].up.y < 0) != (b.curve.points[i - 1].up.y < 0);
  return count;
}

// Curvature and spin have no jumps: between neighbouring points they change by little of their largest value.
inline void expect_continuous(const Built& b) {
  const std::vector<sim::ElementPoint>& p = b.curve.points;
  double bend = 0, spin = 0, bend_jump = 0, spin_jump = 0, before = 0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    bend = std::max(bend, glm::length(p[i].curvature));
    bend_jump = std::max(bend_jump, glm::distance(p[i].curvature, p[i - 1].curvature));
    const curve::Frame carried =
        curve::transport({p[i - 1].tangent, p[i - 1].up}, p[i - 1].position, p[i].position, p[i].tangent);
    const double rate = curve::signed_angle(carried.up, p[i].up, p[i].tangent) / (p[i].s - p[i - 1].s);
    EXPECT_NEAR(rate, 0.5 * (p[i].spin + p[i - 1].spin), 0.05 * std::max(0.1, spin)) << "at " << p[i].s;
    spin = std::max(spin, std::abs(rate));
    if (i > 1) spin_jump = std::max(spin_jump, std::abs(rate - before));
    before = rate;
  }
  EXPECT_LE(bend_jump, 0.2 * bend);
  EXPECT_LE(spin_jump, 0.2 * spin + 1e-6);
}

}  // namespace coaster::test
