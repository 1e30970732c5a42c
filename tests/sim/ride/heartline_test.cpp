// A roll on a level straight at constant speed, about the riders' hearts and about the rails.
#include <gtest/gtest.h>

#include "sim/ride/ride.h"
#include "sim/ride/simulated_ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace heartline_test {

constexpr double kSpeed = 17;  // m/s

// Level, 90 m long, rolls to 85 degrees and back.
world::Document rolling(world::TrackCurve curve) {
  world::Document d = test::straight_document({1.3f, 9.7f, 2.1f}, {91.3f, 9.7f, 2.1f}, 3);
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[1]), 85);
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[2]), 30);
  world::add_cart(d, d.track.segments[0], 0);
  d.start_speed = kSpeed;
  d.curve = curve;
  return d;
}

struct Roll {
  double angle, rate, bend;  // rad, rad/m, rad/m^2
};

// The roll and its derivatives from the frames alone.
Roll roll_at(const SegmentShape& shape, double s) {
  const double step = 0.5;
  const auto angle = [&](double at) {
    const glm::dvec3 up = frame_at(shape, at).up;
    return std::atan2(up.z, up.y);
  };
  const double before = angle(s - step), here = angle(s), after = angle(s + step);
  return {here, (after - before) / (2 * step), (after - 2 * here + before) / (step * step)};
}

// Calls visit(roll, felt) at places well inside the segments.
template <class Visit>
void each_place(const world::Document& document, const Visit& visit) {
  const DerivedTrack derived = test::derived_of(document);
  const world::Entity entity = document.entities.pool<world::Train>().entities()[0];
  world::Motion motion;
  reset(document, derived, motion);
  RideCache cache;
  const RailTables& tables = cache.tables(document, derived);
  for (std::size_t i = 0; i < derived.order.size(); ++i)
    for (double s = 2; s < derived.shape_at(i).arc.length() - 2; s += 0.7) {
      seek(document, derived, entity, derived.starts[i] + s, motion);
      const FeltAcceleration exact = felt(document, derived, entity, motion.carts.items()[0]);
      visit(roll_at(derived.shape_at(i), s), exact);
      const glm::dvec3 table = felt_at(tables.segment(i), s, 0, static_cast<float>(kSpeed * kSpeed / world::kGravity));
      EXPECT_NEAR(table.y, exact.left, 5e-3) << s;
      EXPECT_NEAR(table.z, exact.up, 5e-3) << s;
    }
}

TEST(heartline, a_roll_about_it_gives_gravitys_lean_and_no_more) {
  double most = 0;
  each_place(rolling(world::TrackCurve::heartline), [&](const Roll& roll, const FeltAcceleration& felt) {
    EXPECT_NEAR(felt.left, std::sin(roll.angle), 1e-3);
    EXPECT_NEAR(felt.up, std::cos(roll.angle), 1e-3);
    EXPECT_NEAR(felt.forward, 0, 1e-3);
    most = std::max(most, std::abs(roll.rate));
  });
  EXPECT_GT(most, 0.03);
}

// Riders h above the rails: a = v^2 h (angle'' to the side, -angle'^2 along `up`).
TEST(heartline, a_roll_about_the_rails_throws_the_riders_about) {
  double most = 0;
  each_place(rolling(world::TrackCurve::rails), [&](const Roll& roll, const FeltAcceleration& felt) {
    const double thrown = kSpeed * kSpeed * 1.1 / world::kGravity;
    EXPECT_NEAR(felt.left, std::sin(roll.angle) - thrown * roll.bend, 0.02);
    EXPECT_NEAR(felt.up, std::cos(roll.angle) - thrown * roll.rate * roll.rate, 0.02);
    most = std::max(most, std::abs(felt.up - std::cos(roll.angle)));
  });
  EXPECT_GT(most, 0.05);
}

}  // namespace heartline_test
}  // namespace coaster::sim
