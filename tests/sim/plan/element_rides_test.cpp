// Every element with its default values, ridden by the simulated ride at its design speed: forces and inversions.
#include <gtest/gtest.h>

#include "sim/plan/element_plan.h"
#include "sim/study/ratings.h"
#include "sim/tracks.h"
#include "world/element_rows.h"
#include "world/topology.h"

namespace coaster::sim {
namespace element_rides_test {

using world::ElementKind;

struct Ride {
  ElementKind kind;
  double speed;      // m/s, at its start
  double most_side;  // g
  int inversions;
};

Ratings rated(const Ride& ride, world::TrackCurve curve) {
  world::Document d;
  d.curve = curve;
  TrackEnd end;
  end.position = {0, 40, 0};
  for (const world::Element& element : {world::usual_element(ElementKind::straight), world::usual_element(ride.kind)}) {
    const ElementPlan plan = plan_element(element, end);
    EXPECT_TRUE(plan.refusal.empty()) << plan.refusal;
    EXPECT_TRUE(plan.lines.empty()) << plan.lines[0];
    EXPECT_TRUE(plan.fit.within);
    const std::vector<world::Knot>& knots = plan.fit.knots;
    if (d.track.knots.empty()) world::append_knot(d, knots[0]);
    else d.entities.get<world::Knot>(d.track.knots.back()).out_length = knots[0].out_length;
    for (std::size_t k = 1; k < knots.size(); ++k) world::append_knot(d, knots[k]);
    end = *open_end(d);
  }
  const world::Entity cart = world::add_cart(d, d.track.segments.front(), 0.5);
  d.start_speed = ride.speed;
  const DerivedTrack derived = test::derived_of(d);
  RideCache cache;
  const SimulatedRide& simulated = *cache.ride(d, derived, cart);
  const double end_place = simulated.samples.back().travelled + simulated.start.front;
  EXPECT_GT(end_place, simulated.track_length - 2) << base::name_of(ride.kind) << " is ridden to its end";
  return rate(simulated, cache.tables(d, derived), 5.0);
}

constexpr Ride kRides[] = {
    {ElementKind::curve, 14, 0.6, 0},           {ElementKind::s_bend, 14, 0.9, 0},
    {ElementKind::overbanked_turn, 25, 0.9, 1}, {ElementKind::bunny_hops, 16, 0.05, 0},
    {ElementKind::zero_g_roll, 28, 0.6, 1},     {ElementKind::immelmann, 26, 1.15, 1},
    {ElementKind::dive_loop, 19, 1.15, 1},      {ElementKind::cobra_roll, 21, 1.15, 2},
};

TEST(element_rides, usual_elements_at_their_speed_stay_within_what_riders_bear) {
  for (const Ride& ride : kRides)
    for (const world::TrackCurve curve : {world::TrackCurve::rails, world::TrackCurve::heartline}) {
      const Ratings r = rated(ride, curve);
      const std::string what = std::string(base::name_of(ride.kind)) +
                               (curve == world::TrackCurve::rails ? " about the rails" : " about the heartline");
      EXPECT_LT(r.up_most.value, 5) << what;
      EXPECT_GT(r.up_least.value, -1.5) << what;
      EXPECT_LT(r.side_most.value, ride.most_side) << what;
      EXPECT_EQ(r.inversions, ride.inversions) << what;
    }
}

TEST(element_rides, a_brake_run_stops_a_fast_train_in_its_station) {
  world::Document d;
  const ElementPlan plan = plan_element(world::usual_element(ElementKind::brake_run), TrackEnd{});
  for (const world::Knot& knot : plan.fit.knots) world::append_knot(d, knot);
  ASSERT_EQ(plan.equipment.size(), 2u);
  std::size_t segment = 0;
  for (const EquippedSpans& part : plan.equipment)
    for (std::size_t i = 0; i < part.spans; ++i) d.entities.put(d.track.segments.at(segment++), part.equipment);
  ASSERT_EQ(segment, d.track.segments.size());
  const world::Entity cart = world::add_cart(d, d.track.segments.front(), 0);
  d.start_speed = 23;
  const DerivedTrack derived = test::derived_of(d);
  RideCache cache;
  const SimulatedRide& simulated = *cache.ride(d, derived, cart);
  double in_station = 0, waiting = 1e9;
  for (std::size_t i = 0; i < simulated.samples.size(); ++i) {
    const double place = simulated.distance(i), speed = std::abs(simulated.samples[i].speed);
    if (place > 45.5 && place < 46) in_station = speed;
    if (place > 46) waiting = std::min(waiting, speed);
  }
  EXPECT_NEAR(in_station, 4, 0.6) << "after the brakes";
  EXPECT_LT(waiting, 1e-6);
}

}  // namespace element_rides_test
}  // namespace coaster::sim
