// The positions and speeds of the trains: advanced by fixed ticks, hashed, never undone and never saved.
#pragma once

#include <cstdint>

#include "world/document.h"
#include "world/registry.h"

namespace coaster::world {

inline constexpr int kTicksPerSecond = 120;
inline constexpr double kTick = 1.0 / kTicksPerSecond;  // s
inline constexpr double kGravity = 9.81;                // m/s^2, downwards (-Y); one value in the whole program

// The start of a timetable of the whole ride, and the ticks elapsed since. With the document it determines the motion.
struct TimetablePlace {
  bool valid = false;
  double front = 0, speed = 0;  // m from the track's start, m/s
  std::int32_t dwell = 0;
  bool braking = false;
  std::int64_t tick = 0;
  double phase = 0;  // if laps repeat: ticks into the present lap
  friend bool operator==(const TimetablePlace&, const TimetablePlace&) = default;
};

struct TrainMotion {
  Entity segment;
  double s = 0;                 // m of arc length from the segment's start
  double speed = 0;             // m/s along the track, negative backwards
  double segment_length = 0;    // m, the length for which `s` holds: an edit scales s by new / old
  double track_distance = 0;    // m from the start of the track: used if the segment is removed
  double travelled = 0;         // m since the start, signed
  std::int64_t laps = 0;        // whole laps of a closed track, signed
  double reference_energy = 0;  // J/kg, set at the start and reset by an edit under the train
  double peak_kinetic = 0;      // J/kg, the largest since the reference was set
  double work = 0;              // J/kg done on the train by losses and equipment since the reference was set
  double furthest = 0;          // m, the largest `travelled`
  double drive = 0;             // m/s^2 by equipment in the last tick
  double carry = 0;             // s left over by integrators that move from vertex to vertex
  std::int32_t still = 0;       // ticks at rest while nothing holds the train
  std::int32_t dwell = 0;       // ticks left to wait in a station; -1: dispatched
  bool braking = false;         // a brake under the train is braking
  TimetablePlace timetable;     // of integrators with a timetable
  friend bool operator==(const TrainMotion&, const TrainMotion&) = default;
};

// ended: every train has reached an open end. failed: the ride stopped for the reason in Motion::failure.
enum class RideState : std::uint8_t { stopped, running, paused, ended, failed };
inline constexpr base::NameRow kRideStates[] = {{"stopped"}, {"running"}, {"paused"}, {"ended"}, {"failed"}};
constexpr std::span<const base::NameRow> rows_of(RideState) { return kRideStates; }

// Why a ride stopped.
enum class FailureKind : std::uint8_t { none, stall, rollback, off_end, collision, deadlock };
inline constexpr base::NameRow kFailureKinds[] = {
    {"none"}, {"stalled"}, {"rolled back"}, {"ran off the open end"}, {"collided"}, {"deadlocked"}};
constexpr std::span<const base::NameRow> rows_of(FailureKind) { return kFailureKinds; }
struct RideFailure {
  FailureKind kind = FailureKind::none;
  Entity cart;          // the failed train
  double distance = 0;  // m from the track's start
  double speed = 0;     // m/s, when it happened
  friend bool operator==(const RideFailure&, const RideFailure&) = default;
};

struct Motion {
  Pool<TrainMotion> carts;  // by the document's cart entities
  RideState state = RideState::stopped;
  RideFailure failure;  // none if the ride has not failed
  friend bool operator==(const Motion&, const Motion&) = default;
};

// Hash of the motion alone, trains in the order of their names; entities count by name. No tick or frame counters.
std::uint64_t hash(const Document& document, const Motion& motion);

}  // namespace coaster::world
