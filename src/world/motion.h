// Where the carts are: advanced by fixed ticks, hashed, never undone and never saved.
#pragma once

#include <cstdint>
#include <string>

#include "world/document.h"
#include "world/registry.h"

namespace coaster::world {

inline constexpr int kTicksPerSecond = 120;
inline constexpr double kTick = 1.0 / kTicksPerSecond;  // s
inline constexpr double kGravity = 9.81;                // m/s^2, downwards (-Y); the one value in the whole program

struct CartMotion {
  Entity segment;
  double s = 0;               // m of arc length from the segment's start
  double speed = 0;           // m/s along the track, negative backwards
  double segment_length = 0;  // m, the length that `s` was measured on: an edit scales s by new / old
  double track_distance = 0;  // m from the start of the track: where to go when the segment vanishes
  double travelled = 0;       // m since the start, signed
  std::int64_t laps = 0;      // whole rounds of a closed track, signed
  double reference_energy = 0;  // J/kg, set at the start and anew by an edit under the cart
  double peak_kinetic = 0;      // J/kg, the largest since the reference was set
  friend bool operator==(const CartMotion&, const CartMotion&) = default;
};

// ended: every cart has come to an open end.
enum class RideState : std::uint8_t { stopped, running, paused, ended };

struct Motion {
  Pool<CartMotion> carts;  // by the document's cart entities
  RideState state = RideState::stopped;
  friend bool operator==(const Motion&, const Motion&) = default;
};

// Hash of the motion alone, carts in the order of their names; entities count by name. No tick or frame counters.
std::uint64_t hash(const Document& document, const Motion& motion);

}  // namespace coaster::world
