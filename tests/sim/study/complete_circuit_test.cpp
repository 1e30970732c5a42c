// Closing sections from the end of a straight, whose minimum length follows from the paths of Dubins. Whole circuits
// are tested on documents (tests/edit/perform/complete_circuit_test.cpp).
#include "sim/study/complete_circuit.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace complete_circuit_test {

constexpr float kLength = 60;  // m
constexpr double kLeastRadius = 8;

world::Document straight(float length = kLength) {
  world::Document d;
  for (const float x : {0.0f, length}) world::append_knot(d, test::skew_knot({x, 5, 0}, {1, 0, 0}, 20, 20));
  return d;
}

// Its train passes the open end at about `speed`, m/s.
world::Document ridden_straight(float length, float speed) {
  world::Document d = straight(length);
  d.start_speed = speed;
  world::add_cart(d, d.track.segments.front(), 0);
  return d;
}

CircuitProposals closing_sections(const world::Document& document) {
  const DerivedTrack derived = test::derived_of(document);
  Conflicts conflicts;
  conflicts.update(derived);
  RideCache rides;
  ProposalCache cache;
  return cache.update(document, derived, conflicts, rides.ride(document, derived, world::first_cart(document)));
}

// The shortest path back to the start of a straight, in its direction, is two half circles and a straight.
TEST(complete_circuit, no_closing_section_is_shorter_than_the_path_of_dubins) {
  const CircuitProposals found = closing_sections(straight());
  ASSERT_FALSE(found.list.empty()) << found.refusal;
  for (const CircuitProposal& closing : found.list) {
    EXPECT_GT(closing.plan.length, 2 * std::numbers::pi * kLeastRadius + kLength);
    EXPECT_EQ(closing.plan.fit.knots.back().position, glm::vec3(0, 5, 0));
    EXPECT_LT(glm::distance(closing.plan.fit.knots.back().tangent, {1, 0, 0}), 1e-6f);
  }
}

TEST(complete_circuit, assumes_a_speed_where_no_train_reaches_the_end) {
  const CircuitProposals found = closing_sections(straight());
  EXPECT_TRUE(found.assumed);
  EXPECT_EQ(found.speed, kAssumedSpeed);
}

// The simulated ride's speeds give the drag: v falls by the factor exp(-C s) on a level straight.
TEST(complete_circuit, plans_with_the_drag_that_the_train_has_by_its_mass) {
  for (const float mass : {0.5f * world::kCarMass, world::kCarMass, 3.0f * world::kCarMass}) {
    world::Document document = straight();
    document.resistance = {0, 1e-3f};
    document.start_speed = 20;
    const world::Entity cart = world::add_cart(document, document.track.segments.front(), 0);
    document.entities.get<world::Train>(cart).mass = mass;
    RideCache cache;
    const SimulatedRide& ride = *cache.ride(document, test::derived_of(document), cart);
    const std::optional<CircuitTask> task = circuit_task(document, test::derived_of(document), &ride);
    ASSERT_TRUE(task);
    ASSERT_TRUE(task->coasts);
    const RideSample& last = *(ride.samples.end() - 2);  // the very last is cut at the end of the track
    const double drag = std::log(ride.samples.front().speed / last.speed) / last.travelled;
    EXPECT_NEAR(task->losses.drag, drag, 1e-3 * drag) << mass << " kg";
  }
}

// Rougher ways are offered only where no gentle one is found.
TEST(complete_circuit, offers_gentle_ways_alone_where_there_are_any) {
  int gentle = 0, ways = 0;
  for (const float speed : {12.0f, 18.0f, 24.0f})
    for (const float length : {40.0f, 120.0f}) {
      const CircuitProposals found = closing_sections(ridden_straight(length, speed));
      ASSERT_FALSE(found.assumed);
      int of_these = 0;
      for (const CircuitProposal& closing : found.list) of_these += closing.felt.side <= kGentleSide;
      EXPECT_TRUE(of_these == 0 || of_these == static_cast<int>(found.list.size()))
          << speed << " m/s, " << length << " m";
      gentle += of_these, ways += static_cast<int>(found.list.size());
    }
  EXPECT_GT(gentle, ways / 2);
}

TEST(complete_circuit, is_refused_without_a_segment_and_for_a_closed_track) {
  EXPECT_FALSE(circuit_task(world::Document{}, {}, nullptr));
  EXPECT_FALSE(closing_sections(world::Document{}).refusal.empty());
  world::Document closed = straight();
  world::set_closed(closed, true);
  EXPECT_FALSE(circuit_task(closed, test::derived_of(closed), nullptr));
  EXPECT_TRUE(closing_sections(closed).list.empty());
}

}  // namespace complete_circuit_test
}  // namespace coaster::sim
