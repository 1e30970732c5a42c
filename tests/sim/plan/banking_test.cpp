#include "sim/plan/banking.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace banking_test {

constexpr double kG = world::kGravity;

struct Banked {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  world::Entity cart;
  Banked(world::Document d, double speed, int cars = 1, std::size_t segment = 0) : document(std::move(d)) {
    cart = world::add_cart(document, document.track.segments.at(segment), 0.2);
    document.entities.get<world::Train>(cart).cars = cars;
    document.start_speed = speed, document.heartline = 0;
    derive(document, {}, {}, derived);
  }
  const SimulatedRide& simulated() { return *cache.ride(document, derived, cart); }
  void bank() {
    const std::vector<glm::vec3> ups = banked_ups(document, derived, simulated());
    for (std::size_t i = 0; i < ups.size(); ++i) {
      world::Knot& knot = document.entities.get<world::Knot>(document.track.knots[i]);
      knot.up = ups[i];
      world::orthonormalise(knot);
    }
    derive(document, {}, {}, derived);
  }
};

// A coordinated turn: tan(bank) = v^2 / (R g), towards the centre.
TEST(banking, a_flat_circle_is_banked_by_the_angle_of_a_coordinated_turn) {
  for (const double speed : {5.3, 14.3, 23.7}) {
    const double radius = 20.3;
    Banked ring(test::ring_document(48, radius, 0.0), speed);
    const std::vector<glm::vec3> ups = banked_ups(ring.document, ring.derived, ring.simulated());
    ASSERT_EQ(ups.size(), 48u);
    for (std::size_t i = 0; i < ups.size(); ++i) {
      const world::Knot& knot = world::knot(ring.document, ring.document.track.knots[i]);
      EXPECT_NEAR(std::acos(std::clamp(ups[i].y, -1.0f, 1.0f)), std::atan(speed * speed / (radius * kG)), 2e-3) << i;
      EXPECT_GT(glm::dot(ups[i], glm::vec3(13.3f, 21.7f, -7.9f) - knot.position), 0) << i;
      EXPECT_NEAR(glm::dot(ups[i], knot.tangent), 0, 1e-5);
    }
  }
}

TEST(banking, riders_feel_no_lateral_g_once_it_is_applied) {
  Banked ring(test::ring_document(24, 30.3, 1.7), 17.3, 3);
  const auto worst_side = [&] {
    float worst = 0;
    const SimulatedRide& simulated = ring.simulated();
    for (std::size_t k = 1; k < simulated.forces.size(); k += 3)
      worst = std::max(worst, std::abs(simulated.forces[k].left));  // the middle car
    return worst;
  };
  const float before = worst_side();
  ring.bank();
  EXPECT_GT(before, 0.8f);
  EXPECT_LT(worst_side(), 0.1f * before);
}

TEST(banking, airtime_does_not_turn_riders_over) {
  // At the top of a hill taken fast what is felt points down.
  world::Document d = test::circle_document(20.3, {3.3, 1.7, -2.9}, {0.6, 0, 0.8});
  for (const world::Entity e : d.track.knots)
    d.entities.get<world::Knot>(e).up *= -1.0f;  // a train outside on the circle
  Banked hill(d, 31.7);
  const std::vector<glm::vec3> ups = banked_ups(hill.document, hill.derived, hill.simulated());
  for (std::size_t i = 0; i < ups.size(); ++i)
    EXPECT_GT(glm::dot(ups[i], world::knot(hill.document, hill.document.track.knots[i]).up), 0) << i;
}

TEST(banking, knots_that_the_simulated_ride_does_not_reach_keep_their_up) {
  world::Document d = test::ring_document(24, 30.3, 9.7);
  Banked stuck(d, 0.0, 1, 2);  // from just behind one top to just before the next, and back
  stuck.document.rollback_fails = true;
  const SimulatedRide& simulated = stuck.simulated();
  ASSERT_FALSE(simulated.lap);
  const std::vector<glm::vec3> ups = banked_ups(stuck.document, stuck.derived, simulated);
  int kept = 0;
  for (std::size_t i = 0; i < ups.size(); ++i)
    kept += ups[i] == world::knot(stuck.document, stuck.document.track.knots[i]).up;
  EXPECT_GT(kept, 8);
  EXPECT_LT(kept, 24);
}

}  // namespace banking_test
}  // namespace coaster::sim
