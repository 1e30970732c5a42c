// Energy drift over 24 simulated hours of a track, frictionless, at 120 Hz, by one integrator, relative to the largest
// kinetic energy, hour by hour. Arguments: INTEGRATOR HOURS FILE... . A separate program, because it takes minutes.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "exchange/formats.h"
#include "sim/ride/ride.h"

namespace coaster::bench {
namespace ride_drift {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Drift {
  std::vector<double> hours;  // the largest drift in each
  std::int64_t not_finite = 0, laps = 0;
  double seconds = 0;  // of the processor
};

Drift ride(const world::Document& document, world::IntegratorId integrator, int hours) {
  sim::DerivedTrack derived;
  sim::derive(document, {}, {}, derived);
  sim::RideCache cache;
  world::Motion motion;
  sim::reset(document, derived, motion);
  motion.state = world::RideState::running;
  Drift drift;
  const double before = thread_seconds();
  constexpr int kEvery = 24, kHour = 3600 * world::kTicksPerSecond;  // ticks between two checks
  const world::Entity cart = world::first_cart(document);
  for (int hour = 0; hour < hours && motion.state == world::RideState::running; ++hour) {
    double worst = 0;
    for (int tick = 0; tick < kHour; tick += kEvery) {
      sim::step(document, derived, integrator, kEvery, cache, motion);
      const world::TrainMotion& at = motion.carts.get(cart);
      const double now = sim::energy_drift(document, derived, cart, at);
      drift.not_finite += !std::isfinite(now) || !std::isfinite(at.s) || !std::isfinite(at.speed);
      worst = std::max(worst, now);
    }
    drift.hours.push_back(worst);
  }
  drift.seconds = thread_seconds() - before, drift.laps = motion.carts.get(cart).laps;
  return drift;
}

int run(const std::string& name, int hours, const std::vector<std::string>& files) {
  const auto integrator = base::value_named<world::IntegratorId>(name);
  if (!integrator || hours < 1) return std::fprintf(stderr, "usage: coaster_drift INTEGRATOR HOURS FILE...\n"), 2;
  base::Files disk;
  for (const std::string& file : files) {
    auto track = exchange::load_track(disk, file);
    if (!track.ok()) return std::fprintf(stderr, "%s\n", track.status().message.c_str()), 1;
    world::Document& document = track->document;
    document.resistance = {};
    for (const world::Entity e : document.track.segments) document.entities.pool<world::Equipment>().erase(e);
    const Drift drift = ride(document, *integrator, hours);
    const double most = *std::max_element(drift.hours.begin(), drift.hours.end());
    std::printf("%s %s: %zu h, %lld laps, drift %.2e (hour 1 %.2e, hour %zu %.2e), not finite %lld, %.0f ns a tick\n",
                name.c_str(), file.c_str(), drift.hours.size(), static_cast<long long>(drift.laps), most,
                drift.hours.front(), drift.hours.size(), drift.hours.back(), static_cast<long long>(drift.not_finite),
                drift.seconds * 1e9 / (static_cast<double>(drift.hours.size()) * 3600 * world::kTicksPerSecond));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace ride_drift
}  // namespace coaster::bench

int main(int argc, char** argv) {
  if (argc < 4) return coaster::bench::ride_drift::run("", 0, {});
  return coaster::bench::ride_drift::run(argv[1], std::atoi(argv[2]), {argv + 3, argv + argc});
}
