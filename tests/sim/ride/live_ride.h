// A ride of a document, advanced tick by tick.
#pragma once

#include <utility>

#include "sim/ride/ride.h"

namespace coaster::test {

struct LiveRide {
  world::Document document;
  sim::DerivedTrack derived;
  world::Motion motion;
  sim::RideCache cache;

  explicit LiveRide(world::Document d) : document(std::move(d)) {
    sim::derive(document, {}, {}, derived);
    sim::reset(document, derived, motion);
    motion.state = world::RideState::running;
  }
  void step(int ticks, const char* row = "rk4") {
    sim::step(document, derived, base::value_named<world::IntegratorId>(row).value(), ticks, cache, motion);
  }
  bool runs() const { return motion.state == world::RideState::running; }
  world::TrainMotion& train(std::size_t i = 0) { return motion.carts.items().at(i); }
  double drift(std::size_t i = 0) {
    return sim::energy_drift(document, derived, motion.carts.entities().at(i), train(i));
  }
  const sim::SimulatedRide& simulated() { return *cache.ride(document, derived, world::first_cart(document)); }
};

}  // namespace coaster::test
