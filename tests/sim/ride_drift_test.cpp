// Simulated minutes of the sample tracks, frictionless: a method that loses energy in a day shows it here. The day
// itself takes minutes: tools/bench --drift.
#include <gtest/gtest.h>

#include "exchange/formats.h"
#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace ride_drift_test {

struct Drift {
  double first = 0, last = 0;  // largest in the first and in the last fifth
  std::int64_t laps = 0;
  bool finite = true;
};

Drift drift_of(world::Document document, const char* row, int minutes) {
  document.resistance = {};
  DerivedTrack derived;
  derive(document, {}, {}, derived);
  RideCache cache;
  world::Motion motion;
  reset(document, derived, motion);
  motion.state = world::RideState::running;
  const world::Entity entity = world::first_cart(document);
  const int looks = minutes * 60 * 5;
  Drift drift;
  for (int i = 0; i < looks; ++i) {
    step(document, derived, base::value_named<world::IntegratorId>(row).value(), 24, cache, motion);
    const world::TrainMotion& cart = motion.carts.get(entity);
    const double now = energy_drift(document, derived, entity, cart);
    drift.finite = drift.finite && std::isfinite(now) && std::isfinite(cart.s) && std::isfinite(cart.speed);
    if (i < looks / 5) drift.first = std::max(drift.first, now);
    if (i >= looks - looks / 5) drift.last = std::max(drift.last, now);
  }
  drift.laps = motion.carts.get(entity).laps;
  return drift;
}

world::Document sample(const char* name) {
  base::Files files;
  auto track = exchange::load_track(files, std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  EXPECT_TRUE(track.ok()) << name;
  return track->document;
}

TEST(ride_drift, the_samples_keep_their_energy_for_minutes) {
  for (const char* name : {"loop", "helix", "gentle"}) {
    const Drift rk4 = drift_of(sample(name), "rk4", 1);
    EXPECT_TRUE(rk4.finite);
    EXPECT_GE(rk4.laps, 1) << name;
    // 1440 times as long may make 2e-6 of it.
    EXPECT_LT(rk4.last, 2e-6 / 1440) << name;
    const Drift verlet = drift_of(sample(name), "verlet", 8);
    EXPECT_TRUE(verlet.finite);
    EXPECT_LT(std::max(verlet.first, verlet.last), 5e-5) << name;
    EXPECT_GT(verlet.first, 1e-9) << name;  // of second order: it swings
    EXPECT_LT(verlet.last, 1.5 * verlet.first) << name << ": it must not grow";
  }
}

TEST(ride_drift, verlet_goes_over_joints_and_counts_laps_as_runge_kutta_does) {
  for (const double speed : {14.3, -14.3}) {
    world::Document d = test::ring_document(12, 20.3);
    const world::Entity cart = world::add_cart(d, d.track.segments[4], 0.37);
    d.entities.get<world::Train>(cart).cars = 3;
    d.start_speed = speed, d.rollback_fails = false;
    DerivedTrack derived;
    derive(d, {}, {}, derived);
    RideCache cache;
    world::Motion a, b;
    reset(d, derived, a), reset(d, derived, b);
    a.state = b.state = world::RideState::running;
    step(d, derived, base::value_named<world::IntegratorId>("rk4").value(), 120 * 60, cache, a);
    step(d, derived, base::value_named<world::IntegratorId>("verlet").value(), 120 * 60, cache, b);
    const world::TrainMotion &x = a.carts.items()[0], &y = b.carts.items()[0];
    EXPECT_EQ(x.laps, y.laps);
    EXPECT_GT(std::abs(x.laps), 4);
    EXPECT_NEAR(x.travelled, y.travelled, 0.5);
    // Laps, position and distance travelled agree.
    const double start = derived.starts[4] + 0.37 * derived.shape(derived.order[4]).arc.length();
    EXPECT_NEAR(static_cast<double>(y.laps) * derived.length + y.track_distance - start, y.travelled, 1e-6);
  }
}

TEST(ride_drift, verlet_stops_at_open_ends_and_where_friction_holds) {
  world::Document d = test::straight_document({1.1f, 2.3f, 2.7f}, {31.1f, 2.3f, 7.7f}, 3);
  world::add_cart(d, d.track.segments[1], 0.4);
  d.start_speed = 7.3;
  for (const float rolling : {0.0f, 0.3f}) {
    d.resistance.rolling = rolling;
    DerivedTrack derived;
    derive(d, {}, {}, derived);
    RideCache cache;
    world::Motion motion;
    reset(d, derived, motion);
    motion.state = world::RideState::running;
    const double from = motion.carts.items()[0].track_distance;
    step(d, derived, base::value_named<world::IntegratorId>("verlet").value(), 320, cache, motion);
    const world::TrainMotion& cart = motion.carts.items()[0];
    EXPECT_EQ(cart.speed, 0);
    const double way = rolling > 0 ? 7.3 * 7.3 / (2 * 9.81 * 0.3) : derived.length - from;  // v^2 = 2 mu g x
    EXPECT_NEAR(cart.track_distance - from, way, 1e-3);
  }
}

}  // namespace ride_drift_test
}  // namespace coaster::sim
