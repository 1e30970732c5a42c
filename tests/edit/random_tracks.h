// Random open tracks as a player would build them, for tests of circuits.
#pragma once

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "edit/session_fixture.h"

namespace coaster::test {

class RandomTracks : public SessionTest {
 protected:
  RandomTracks() : SessionTest(world::Document{}) {}

  const sim::CircuitProposals& proposals() { return *find(session, edit::Want::circuit).circuit; }
  std::uint32_t below(std::uint32_t n) { return bits_() % n; }
  double uniform(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }

  // A station, then up to six elements as a player would choose them; those below the ground or in the way of others
  // are left out.
  void random_track(std::uint32_t seed) {
    bits_.seed(seed);
    start_on(world::Document{});
    good(fmt::format("append at {} {} {}", uniform(-80, 80), uniform(2, 6), uniform(-80, 80)));
    const double heading = uniform(0, 6.28);
    const glm::vec3 at = knot(1).position;
    good(fmt::format("append at {} {} {}", at.x + 20 * std::cos(heading), at.y, at.z + 20 * std::sin(heading)));
    good(fmt::format("start_speed {}", uniform(16, 30)));
    const std::uint32_t count = 1 + below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
      const char* const side = below(2) ? "left" : "right";
      const std::string line[] = {
          fmt::format("element straight length {:.1f} roll {:.0f}", uniform(5, 60), below(3) ? 0 : uniform(-40, 40)),
          fmt::format("element curve {} radius {:.1f} angle {:.0f} bank {:.0f}", side, uniform(12, 50),
                      uniform(20, 200), uniform(0, 60)),
          fmt::format("element climb height {:.1f} angle {:.0f}", uniform(3, 20), uniform(10, 50)),
          fmt::format("element dive height {:.1f} angle {:.0f}", uniform(3, 20), uniform(10, 60)),
          fmt::format("element camelback height {:.1f} speed 18", uniform(4, 10)),
          fmt::format("element loop {} height {:.1f}", side, uniform(8, 18)),
          fmt::format("element helix {} radius {:.1f} turns 1.2 height {:.1f}", side, uniform(12, 25), uniform(5, 14))};
      if (!apply(line[below(7)])) continue;
      bool bad = !find(session, edit::Want::conflicts).conflicts.empty();
      for (const world::Entity e : session.document.track.knots)
        bad = bad || world::knot(session.document, e).position.y < 1.5f;
      if (bad) good("undo");
    }
  }

  std::mt19937 bits_;
};

}  // namespace coaster::test
