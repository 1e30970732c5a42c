// The table of integrators.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "sim/ride/live_ride.h"
#include "sim/tracks.h"
#include "world/evaluation_settings.h"

namespace coaster::sim {
namespace integrators_test {

TEST(integrators, names_are_unique_and_found) {
  for (std::size_t i = 0; i < integrators().size(); ++i)
    EXPECT_EQ(base::value_named<world::IntegratorId>(integrators()[i].name), world::IntegratorId{static_cast<int>(i)});
  EXPECT_EQ(base::value_named<world::IntegratorId>("explicit_euler"), std::nullopt);
  EXPECT_EQ(integrators()[0].name, "rk4");
}

TEST(integrators, rails_go_on_straight_beyond_the_ends_of_a_segment) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  const SegmentShape& shape = derived.shape(derived.order[1]);
  const double length = shape.arc.length();
  for (const auto& [end, beyond] : {std::pair(0.0, -3.1), std::pair(length, length + 3.1)}) {
    const RailPoint at = rail_point(shape, end), off = rail_point(shape, beyond);
    EXPECT_NEAR(off.slope, at.slope, 1e-12);
    EXPECT_NEAR(off.height, at.height + (beyond - end) * at.slope, 1e-9);
  }
}

TEST(integrators, the_slope_is_the_derivative_of_the_height) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  for (const world::Entity e : derived.order) {
    const SegmentShape& shape = derived.shape(e);
    for (const double share : {0.13, 0.47, 0.81}) {
      const double s = share * shape.arc.length(), h = 1e-4;
      EXPECT_NEAR((rail_point(shape, s + h).height - rail_point(shape, s - h).height) / (2 * h),
                  rail_point(shape, s).slope, 1e-5);
    }
  }
}

// On a level ring without losses a train keeps its speed, to both sides over the closing joint: by chords of length
// 2 r sin(a/2) in place of arcs r a it gets further. Where a shader evaluates, there are no polylines.
TEST(integrators, by_vertices_a_level_ring_is_ridden_chord_by_chord) {
  constexpr int kCount = 12, kSteps = 4, kTicks = 60'000;
  constexpr double kRadius = 60, kAngle = 2 * base::kPi / (kCount * kSteps);
  for (const bool by_shader : {false, true})
    for (const double speed : {11.0, -11.0}) {
      test::LiveRide ride(test::ring_document(kCount, kRadius, 0));
      world::add_cart(ride.document, ride.document.track.segments[2], 0.5);
      ride.document.start_speed = speed;
      world::Settings settings;
      settings.evaluation->steps = kSteps;
      if (by_shader) {
        const auto rows = rows_of(curve::EvaluatorId{});
        const auto shader = std::ranges::find_if(
            rows, [](const auto& row) { return row.evaluated_by == curve::EvaluatedBy::vertex_shader; });
        ASSERT_NE(shader, rows.end());
        settings.evaluation->evaluator = curve::EvaluatorId{static_cast<int>(shader - rows.begin())};
      }
      derive(ride.document, settings, {}, ride.derived);
      reset(ride.document, ride.derived, ride.motion);
      ride.motion.state = world::RideState::running;
      ride.step(kTicks, "vertices");
      const double by_arcs = 11 * kTicks * world::kTick * 0.5 * kAngle / std::sin(0.5 * kAngle);
      const double travelled = std::copysign(1.0, speed) * ride.train().travelled;
      EXPECT_LE(travelled, by_arcs + 0.1) << by_shader << " " << speed;
      EXPECT_GE(travelled, by_arcs - kRadius * kAngle) << by_shader << " " << speed;
      EXPECT_NEAR(ride.train().laps, ride.train().travelled / (2 * base::kPi * kRadius), 1);
      EXPECT_NEAR(ride.train().speed, speed, 1e-6);
    }
}

// A single car at arc length s of a segment, without losses.
struct Alone {
  std::array<TrackPlace, 1> car;
  TrainContext context;
  Alone(const DerivedTrack& derived, std::size_t index, double s, double datum = 0, double energy = 0)
      : car{TrackPlace{index, s}}, context{derived, car, datum, energy, {}, 0, 0} {}
};

// The order of a method: halving the step of a smooth problem divides the error by 2^order.
TEST(integrators, have_their_orders) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  const Alone alone(derived, 1, 0.21 * derived.shape(derived.order[1]).arc.length());
  const auto run = [&](world::IntegratorId row, int steps) {
    TrainState state{0, 9.7, 0};
    for (int i = 0; i < steps; ++i) state = base::row_of(row).advance(alone.context, state, 1.1 / steps);
    return state.x;
  };
  const double exact = run({}, 4096);
  const auto order = [&](world::IntegratorId row, int steps) {
    return std::log2(std::abs(run(row, steps) - exact) / std::abs(run(row, 2 * steps) - exact));
  };
  EXPECT_NEAR(order(*base::value_named<world::IntegratorId>("rk4"), 32), 4, 0.4);
  EXPECT_NEAR(order(*base::value_named<world::IntegratorId>("verlet"), 64), 2, 0.2);
  EXPECT_NEAR(order(*base::value_named<world::IntegratorId>("euler"), 64), 1, 0.2);
}

TEST(integrators, the_papers_method_takes_the_speed_from_the_energy) {
  const DerivedTrack derived = test::derived_of(test::sample_document());
  const SegmentShape& shape = derived.shape(derived.order[0]);
  const double s = 0.3 * shape.arc.length(), height = rail_point(shape, s).height, datum = 2.7;
  const Alone alone(derived, 0, s, datum, 9.81 * (height - datum) + 0.5 * 8.1 * 8.1);
  const Integrator& row = base::row_of(*base::value_named<world::IntegratorId>("energy"));
  const TrainState forward = row.advance(alone.context, {0, 1, 0}, 0.01),
                   backward = row.advance(alone.context, {0, -1, 0}, 0.01);
  EXPECT_NEAR(forward.speed, 8.1, 1e-12);
  EXPECT_NEAR(forward.x, 0.081, 1e-12);
  EXPECT_NEAR(backward.speed, -8.1, 1e-12);
  const Alone too_high(derived, 0, s, datum, 9.81 * (height - datum) - 1);
  EXPECT_EQ(row.advance(too_high.context, {0, 1, 0}, 0.01).x, 0);
}

}  // namespace integrators_test
}  // namespace coaster::sim
