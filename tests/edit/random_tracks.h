// Random open tracks as a player would build them, for tests of circuits.
#pragma once

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "edit/session_fixture.h"
#include "sim/study/complete_circuit.h"

namespace coaster::test {

class RandomTracks : public SessionTest {
 protected:
  RandomTracks() : SessionTest(world::Document{}) {}

  const sim::CircuitProposals& proposals() { return edit::SessionFindings(session).circuit(); }
  std::uint32_t below(std::uint32_t n) { return bits_() % n; }
  double uniform(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }

  // Builds a station, then up to six elements as a player would choose them; those below the ground or too close to
  // others are left out.
  void random_track(std::uint32_t seed) {
    bits_.seed(seed);
    start_on(world::Document{});
    const double z = uniform(-80, 80), y = uniform(2, 6), x = uniform(-80, 80);
    good(fmt::format("append at {} {} {}", x, y, z));
    const double heading = uniform(0, 6.28);
    const glm::vec3 at = knot(1).position;
    good(fmt::format("append at {} {} {}", at.x + 20 * std::cos(heading), at.y, at.z + 20 * std::sin(heading)));
    good(fmt::format("start_speed {}", uniform(16, 30)));
    const std::uint32_t count = 1 + below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
      const char* const side = below(2) ? "left" : "right";
      // Drawn one after the other, because compilers evaluate a call's arguments in different orders.
      const double roll = below(3) ? 0 : uniform(-40, 40), straight = uniform(5, 60);
      const double bank = uniform(0, 60), turn = uniform(20, 200), radius = uniform(12, 50);
      const double up = uniform(10, 50), rise = uniform(3, 20), down = uniform(10, 60), drop = uniform(3, 20);
      const double hill = uniform(4, 10), loop = uniform(8, 18), descent = uniform(5, 14), coil = uniform(12, 25);
      const std::string line[] = {
          fmt::format("element straight length {:.1f} roll {:.0f}", straight, roll),
          fmt::format("element curve {} radius {:.1f} angle {:.0f} bank {:.0f}", side, radius, turn, bank),
          fmt::format("element climb height {:.1f} angle {:.0f}", rise, up),
          fmt::format("element dive height {:.1f} angle {:.0f}", drop, down),
          fmt::format("element camelback height {:.1f} speed 18", hill),
          fmt::format("element loop {} height {:.1f}", side, loop),
          fmt::format("element helix {} radius {:.1f} turns 1.2 height {:.1f}", side, coil, descent)};
      if (!apply(line[below(7)])) continue;
      bool bad = !edit::SessionFindings(session).conflicts().empty();
      for (const world::Entity e : session.document.track.knots)
        bad = bad || world::knot(session.document, e).position.y < 1.5f;
      if (bad) good("undo");
    }
  }

  std::mt19937 bits_;
};

}  // namespace coaster::test
