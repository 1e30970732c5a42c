// What a ride sounds like: wind, wheels on the rails, the clacking chain of a lift. What there is to hear follows from
// the state; the sound itself is synthesised, a pure function over a small state, without a device (platform/sound.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sim/shape/derived.h"
#include "world/motion.h"

namespace coaster::view {

// Metres between two teeth of the rack beneath a lift: as the ratchet under the train passes one, it clacks. 4 m/s are
// 20 clacks a second.
inline constexpr double kRackPitch = 0.2;

struct RideNoise {
  double speed = 0;   // m/s along the rails, without sign
  double rack = 0;    // m/s over a lift's rack; 0: on none
  double load = 1;    // g that presses the wheels on the rails, by size
  double volume = 0;  // 0..1
  friend bool operator==(const RideNoise&, const RideNoise&) = default;
};

// Of the first train: silent while nothing runs. One walk over the equipment.
RideNoise ride_noise(const world::Document& document, const sim::Derived& derived, const world::Motion& motion,
                     double volume);

// A resonator, two poles: what the mouth of the wind and the steel of a tooth ring like.
struct Resonator {
  double before = 0, last = 0;
};

// What goes on from one block to the next; the same state and noise give the same samples, in one block or in several.
struct RideVoice {
  RideNoise heard;           // smoothed: no jumps
  RideNoise toned;           // what filters and loudness were last computed for
  std::uint64_t frames = 0;  // since the start
  std::array<std::uint32_t, 3> seeds{0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u};
  std::array<Resonator, 2> wind;  // left, right
  std::array<double, 2> low{};    // the wheels' noise, twice low-passed
  double turn = 0;                // of the wheels, 0..1
  double tooth = 0;               // from one clack to the next, 0..1
  std::array<Resonator, 3> steel;
  std::uint64_t clacks = 0;  // since the start
};

// Goes on by out.size() / 2 frames (left, right) at `rate` frames a second, 8,000 or more, towards `noise`, which is
// reached with a time constant of 30 ms. Samples are within -1..1 and finite for every noise; what is not finite counts
// as 0. Louder with speed: wind as its square, wheels nearly in proportion.
void synthesise(RideVoice& voice, const RideNoise& noise, int rate, std::span<float> out);

}  // namespace coaster::view
