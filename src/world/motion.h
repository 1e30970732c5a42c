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

// Where a timetable of the whole ride began, and how many ticks of it have passed: with the document it tells the
// motion again.
struct TimetablePlace {
  bool valid = false;
  double front = 0, speed = 0;  // m from the track's start, m/s
  std::int32_t dwell = 0;
  bool braking = false;
  std::int64_t tick = 0;
  double phase = 0;  // of a ride whose laps repeat: ticks into the present one
  friend bool operator==(const TimetablePlace&, const TimetablePlace&) = default;
};

struct CartMotion {
  Entity segment;
  double s = 0;                 // m of arc length from the segment's start
  double speed = 0;             // m/s along the track, negative backwards
  double segment_length = 0;    // m, the length that `s` was measured on: an edit scales s by new / old
  double track_distance = 0;    // m from the start of the track: where to go when the segment vanishes
  double travelled = 0;         // m since the start, signed
  std::int64_t laps = 0;        // whole rounds of a closed track, signed
  double reference_energy = 0;  // J/kg, set at the start and anew by an edit under the cart
  double peak_kinetic = 0;      // J/kg, the largest since the reference was set
  double work = 0;              // J/kg done on the train by losses and equipment since then
  double furthest = 0;          // m, the largest `travelled`
  double drive = 0;             // m/s^2 by equipment in the last tick
  double carry = 0;             // s not yet used by integrators that go from place to place
  std::int32_t still = 0;       // ticks at rest with nothing that holds the train
  std::int32_t dwell = 0;       // ticks left to wait in a station; -1: it was let out
  bool braking = false;         // a brake under the train is on
  TimetablePlace timetable;     // of the integrator that has one
  friend bool operator==(const CartMotion&, const CartMotion&) = default;
};

// ended: every cart has come to an open end. failed: the ride stopped for the reason in Motion::failure.
enum class RideState : std::uint8_t { stopped, running, paused, ended, failed };
inline constexpr base::NameRow kRideStates[] = {{"stopped"}, {"running"}, {"paused"}, {"ended"}, {"failed"}};
constexpr std::span<const base::NameRow> rows_of(RideState) { return kRideStates; }

// Why a ride stopped by itself.
enum class FailureKind : std::uint8_t { none, stall, rollback, off_end, collision };
inline constexpr base::NameRow kFailureKinds[] = {
    {"none"}, {"stalled"}, {"rolled back"}, {"ran off the open end"}, {"collided"}};
constexpr std::span<const base::NameRow> rows_of(FailureKind) { return kFailureKinds; }
struct Failure {
  FailureKind kind = FailureKind::none;
  Entity cart;          // the one that failed
  double distance = 0;  // m from the track's start
  double speed = 0;     // m/s, when it happened
  friend bool operator==(const Failure&, const Failure&) = default;
};

struct Motion {
  Pool<CartMotion> carts;  // by the document's cart entities
  RideState state = RideState::stopped;
  Failure failure;  // none while all is well
  friend bool operator==(const Motion&, const Motion&) = default;
};

// Hash of the motion alone, carts in the order of their names; entities count by name. No tick or frame counters.
std::uint64_t hash(const Document& document, const Motion& motion);

}  // namespace coaster::world
