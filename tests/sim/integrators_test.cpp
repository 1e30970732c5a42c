#include <gtest/gtest.h>

#include "sim/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace {

TEST(integrators, names_are_unique_and_found) {
  for (std::size_t i = 0; i < integrators().size(); ++i) EXPECT_EQ(find_integrator(integrators()[i].name), static_cast<int>(i));
  EXPECT_EQ(find_integrator("euler"), std::nullopt);
  EXPECT_EQ(integrators()[0].name, "rk4");
}

TEST(integrators, rails_go_on_straight_beyond_the_ends_of_a_segment) {
  const Derived derived = test::derived_of(test::sample_document());
  const SegmentShape& shape = derived.shape(derived.order[1]);
  const double length = shape.arc.length();
  for (const auto& [end, beyond] : {std::pair(0.0, -3.1), std::pair(length, length + 3.1)}) {
    const RailPoint at = rail_point(shape, end), off = rail_point(shape, beyond);
    EXPECT_NEAR(off.slope, at.slope, 1e-12);
    EXPECT_NEAR(off.height, at.height + (beyond - end) * at.slope, 1e-9);
  }
}

TEST(integrators, the_slope_is_the_derivative_of_the_height) {
  const Derived derived = test::derived_of(test::sample_document());
  for (const world::Entity e : derived.order) {
    const SegmentShape& shape = derived.shape(e);
    for (const double share : {0.13, 0.47, 0.81}) {
      const double s = share * shape.arc.length(), h = 1e-4;
      EXPECT_NEAR((rail_point(shape, s + h).height - rail_point(shape, s - h).height) / (2 * h), rail_point(shape, s).slope, 1e-5);
    }
  }
}

// The order of a method: halving the step of a smooth problem divides the error by 2^order.
TEST(integrators, runge_kutta_is_of_order_4_and_verlet_of_order_2) {
  const Derived derived = test::derived_of(test::sample_document());
  const SegmentShape& shape = derived.shape(derived.order[1]);
  const RailContext context{shape, 0, 0};
  const auto run = [&](int row, int steps) {
    RailState state{0.21 * shape.arc.length(), 9.7};
    for (int i = 0; i < steps; ++i) state = integrators()[static_cast<std::size_t>(row)].advance(context, state, 1.1 / steps);
    return state.s;
  };
  const double exact = run(0, 4096);
  const auto order = [&](int row, int steps) { return std::log2(std::abs(run(row, steps) - exact) / std::abs(run(row, 2 * steps) - exact)); };
  EXPECT_NEAR(order(*find_integrator("rk4"), 32), 4, 0.4);
  EXPECT_NEAR(order(*find_integrator("verlet"), 64), 2, 0.2);
}

TEST(integrators, the_papers_method_takes_the_speed_from_the_energy) {
  const Derived derived = test::derived_of(test::sample_document());
  const SegmentShape& shape = derived.shape(derived.order[0]);
  const double s = 0.3 * shape.arc.length(), height = rail_point(shape, s).height, datum = 2.7;
  const RailContext context{shape, datum, 9.81 * (height - datum) + 0.5 * 8.1 * 8.1};
  const RailState forward = integrators()[2].advance(context, {s, 1}, 0.01), backward = integrators()[2].advance(context, {s, -1}, 0.01);
  EXPECT_NEAR(forward.speed, 8.1, 1e-12);
  EXPECT_NEAR(forward.s, s + 0.081, 1e-12);
  EXPECT_NEAR(backward.speed, -8.1, 1e-12);
  const RailContext too_high{shape, datum, 9.81 * (height - datum) - 1};
  EXPECT_EQ(integrators()[2].advance(too_high, {s, 1}, 0.01).s, s);
}

}  // namespace
}  // namespace coaster::sim
