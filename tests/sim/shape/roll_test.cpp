#include "sim/shape/roll.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/shape/derived_track.h"
#include "world/sample_documents.h"
#include "world/topology.h"

namespace coaster::sim {
namespace roll_test {

using glm::dvec3;

// A closed track of 12 knots at random places with random rolls and automatic spins.
world::Document tumbling(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  world::Document d;
  for (int i = 0; i < 12; ++i) {
    world::Knot knot;
    const double angle = 2 * M_PI * i / 12;
    knot.position = glm::vec3(40 * std::cos(angle), 20 + 6 * unit(random), 40 * std::sin(angle));
    knot.joint = world::JointKind::automatic;
    world::append_knot(d, knot);
  }
  world::set_closed(d, true);
  world::settle_joints(d);
  for (const world::Entity e : d.track.knots)
    world::set_roll(d.entities.get<world::Knot>(e), 170.0 * static_cast<double>(unit(random)));
  set_automatic_spins(d);
  return d;
}

// The spin at a place by brute force: a rotation-minimising frame carried over 2 h in 64 steps, and the angle of the
// track's frame against it.
double spin_by_steps(const SegmentShape& shape, double s, double h) {
  constexpr int kSteps = 64;
  curve::Frame carried = frame_at(shape, s - h);
  dvec3 last = curve::point(shape.key.cubic, shape.arc.parameter(s - h));
  for (int i = 1; i <= kSteps; ++i) {
    const double t = shape.arc.parameter(s - h + 2 * h * i / kSteps);
    const dvec3 here = curve::point(shape.key.cubic, t);
    carried = curve::transport(carried, last, here, curve::unit_tangent(shape.key.cubic, t));
    last = here;
  }
  const dvec3 up = frame_at(shape, s + h).up;
  return std::atan2(glm::dot(glm::cross(carried.up, up), carried.forward), glm::dot(carried.up, up)) / (2 * h);
}

TEST(roll, the_cubic_meets_both_ends_and_both_spins) {
  const Roll roll{7.3, 2.9, 0.31, -0.23};
  EXPECT_EQ(roll.angle(0), 0);
  EXPECT_EQ(roll.angle(7.3), 2.9);
  EXPECT_DOUBLE_EQ(roll.spin(0), 0.31);
  EXPECT_NEAR(roll.spin(7.3), -0.23, 1e-15);
  for (const double s : {0.4, 1.9, 3.65, 6.8}) {
    constexpr double kStep = 1e-4;
    EXPECT_NEAR((roll.angle(s + kStep) - roll.angle(s - kStep)) / (2 * kStep), roll.spin(s), 1e-7) << s;
    EXPECT_NEAR((roll.spin(s + kStep) - roll.spin(s - kStep)) / (2 * kStep), roll.slope(s), 1e-7) << s;
  }
}

TEST(roll, with_the_mean_spin_at_both_ends_it_is_linear) {
  const Roll roll{12, 3, 0.25, 0.25};
  for (const double s : {0.5, 4.0, 11.0}) EXPECT_NEAR(roll.angle(s), s / 4, 1e-14);
}

TEST(roll, without_spin_it_is_the_smooth_step) {
  const Roll roll{2, 1, 0, 0};
  EXPECT_DOUBLE_EQ(roll.angle(0.5), 3.0 / 16 - 2.0 / 64);
  EXPECT_DOUBLE_EQ(roll.slope(0), 6.0 / 4);
}

TEST(roll, frames_roll_at_the_same_rate_on_both_sides_of_every_joint) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const world::Document d = tumbling(seed);
    const DerivedTrack derived = shapes_of(d);
    for (std::size_t i = 0; i < derived.order.size(); ++i) {
      const SegmentShape &before = derived.shape_at(i), &after = derived.shape_at((i + 1) % derived.order.size());
      const double spin = double{world::knot(d, d.track.knots[(i + 1) % d.track.knots.size()]).spin};
      // Three positions next to the joint, and their parabola's value at it.
      const auto at_joint = [&](const SegmentShape& shape, bool end) {
        constexpr double h = 0.02;
        double values[3];
        for (int k = 0; k < 3; ++k) {
          const double off = (k + 1) * 2 * h;
          values[k] = spin_by_steps(shape, end ? shape.arc.length() - off : off, h);
        }
        return 3 * values[0] - 3 * values[1] + values[2];
      };
      EXPECT_NEAR(at_joint(before, true), spin, 2e-4) << seed << " " << i;
      EXPECT_NEAR(at_joint(after, false), spin, 2e-4) << seed << " " << i;
    }
  }
}

TEST(roll, frames_turn_as_the_roll_says_within_segments) {
  const DerivedTrack derived = shapes_of(tumbling(4));
  for (const world::Entity e : derived.order) {
    const SegmentShape& shape = derived.shape(e);
    for (const double share : {0.2, 0.5, 0.83}) {
      const double s = share * shape.arc.length();
      EXPECT_NEAR(spin_by_steps(shape, s, 0.01), shape.roll.spin(s), 2e-4);
    }
  }
}

TEST(roll, automatic_spins_never_overshoot_the_knots) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> twist(-4, 4), length(0.2, 30);
  for (int n = 0; n < 2000; ++n) {
    double twists[3], lengths[3];
    for (int k = 0; k < 3; ++k) twists[k] = twist(random), lengths[k] = length(random);
    const double a = automatic_spin(twists[0], lengths[0], twists[1], lengths[1]),
                 b = automatic_spin(twists[1], lengths[1], twists[2], lengths[2]);
    const Roll middle{lengths[1], twists[1], a, b};
    double last = 0;
    for (int i = 1; i <= 200; ++i) {
      const double angle = middle.angle(lengths[1] * i / 200);
      EXPECT_GE((angle - last) * twists[1], -1e-12) << n << ": roll turns back";
      last = angle;
    }
  }
}

TEST(roll, an_automatic_spin_is_between_its_neighbours_and_nearer_to_the_shorter) {
  EXPECT_DOUBLE_EQ(automatic_spin(1, 4, 1, 4), 0.25);
  EXPECT_DOUBLE_EQ(automatic_spin(1, 4, 3, 4), 2 / (1 / 0.25 + 1 / 0.75));  // the harmonic mean
  EXPECT_EQ(automatic_spin(1, 4, -1, 4), 0);
  EXPECT_EQ(automatic_spin(1, 4, 0, 4), 0);
  EXPECT_EQ(automatic_spin(1, 0, 1, 4), 0);
  EXPECT_EQ(automatic_spin(1e-9, 4, 1e-9, 4), 0);
  const double mean = automatic_spin(1, 1, 6, 2);  // spins of 1 and 3
  EXPECT_LT(mean, automatic_spin(2, 2, 3, 1));
  EXPECT_GT(mean, 1);
  EXPECT_LT(mean, 3);
}

TEST(roll, an_open_track_ends_without_spin_and_set_spins_stay) {
  world::Document d;
  for (int i = 0; i < 4; ++i) {
    world::Knot knot = test::skew_knot({10.3f * static_cast<float>(i), 5.1f, 2.7f}, {1, 0, 0}, 3, 3);
    world::set_roll(knot, 30.0 * i);
    world::append_knot(d, knot);
  }
  world::Knot& third = d.entities.get<world::Knot>(d.track.knots[2]);
  third.spin = 0.7f, third.spin_kind = world::SpinKind::set;
  set_automatic_spins(d);
  const auto spin = [&](std::size_t i) { return world::knot(d, d.track.knots[i]).spin; };
  EXPECT_EQ(spin(0), 0);
  EXPECT_NEAR(spin(1), 30 * M_PI / 180 / 10.3, 1e-6);
  EXPECT_EQ(spin(2), 0.7f);
  EXPECT_EQ(spin(3), 0);
}

}  // namespace roll_test
}  // namespace coaster::sim
