// The sound of a ride: wind, wheels on the rails, the ratchet of a lift, echoes in tunnels, water. The state gives the
// noise to make; the synthesis is a pure function over a small state of its own, without a device (platform/sound.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/shape/derived_track.h"
#include "world/motion.h"

namespace coaster::sim {
class Ground;
}

namespace coaster::view {

// Metres between two teeth of a lift's rack. The ratchet under the train clicks as it passes each: 20 clicks a second
// at 4 m/s.
inline constexpr double kRackPitch = 0.2;

struct RideNoise {
  double speed = 0;   // m/s along the rails, absolute
  double rack = 0;    // m/s over a lift's rack; 0: not on a rack
  double load = 1;    // g on the wheels, absolute
  double volume = 0;  // 0..1
  double rumble = 0;  // of the wheels, by the coaster's kind, 0..1
  double inside = 0;  // how much of the train is in a tunnel, 0..1
  double splash = 0;  // of water that the train passes closely, 0..1
  friend bool operator==(const RideNoise&, const RideNoise&) = default;
};

// Returns the noise of the first train: silent while the ride is not running. One pass over the equipment.
RideNoise ride_noise(const world::Document& document, const sim::DerivedTrack& derived, const world::Motion& motion,
                     double volume, const sim::Ground* ground = nullptr);
inline constexpr double kSplashHeight = 1.5;  // m of the rails over water, below which it splashes

// A two-pole resonator, for the wind and the steel of a tooth.
struct Resonator {
  double before = 0, last = 0;
};

// A delay line whose end is fed back, duller each time; without samples outside tunnels.
struct EchoLine {
  std::vector<float> samples;
  std::size_t at = 0;
  double dull = 0;
};

// The state of the synthesis between blocks. The same state and noise give the same samples, in one block or in
// several.
struct RideVoice {
  RideNoise heard;           // smoothed noise
  RideNoise toned;           // noise for which filters and volume were last computed
  std::uint64_t frames = 0;  // since the start
  std::array<std::uint32_t, 4> seeds{0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u, 0x27d4eb2fu};
  std::array<Resonator, 2> wind;  // left, right
  std::array<double, 2> low{};    // the wheels' noise, twice low-passed
  double turn = 0;                // rotation of the wheels, 0..1
  double tooth = 0;               // from one click to the next, 0..1
  std::array<Resonator, 3> steel;
  std::uint64_t clacks = 0;                     // since the start
  std::array<std::array<EchoLine, 3>, 2> echo;  // left, right
  double spray = 0;                             // the splash's noise, low-passed
};

// Synthesises out.size() / 2 frames (left, right) at `rate` frames a second, 8,000 or more. `noise` is reached with a
// time constant of 30 ms. Samples are within -1..1 and finite for every noise; values that are not finite count as 0.
// Volume grows with speed: wind with its square, wheels nearly in proportion. In tunnels wheels are louder, and all of
// it echoes.
void synthesise(RideVoice& voice, const RideNoise& noise, int rate, std::span<float> out);

}  // namespace coaster::view
