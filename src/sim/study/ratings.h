// The figures of a ride, the ratings that park games derive from them, near misses, and the report.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/ground/ground.h"
#include "sim/ground/plants.h"
#include "sim/ride/simulated_ride.h"
#include "sim/study/force_limits.h"
#include "sim/study/riders.h"

namespace coaster::sim {

// --- What a ride passes on a land: tunnels, and earth, water and trees near the riders' heads

struct Surroundings {
  int tunnels = 0;        // passed on the lap
  double in_tunnels = 0;  // m of track in them
  double close = 0;       // share of the lap, 0..1, within kCloseBy of earth, water or trees
  int near_misses = 0;    // of these, portals among them
};

// Earth counts where it rises beside a head or above it: in the half plane across the track that begins on both sides
// at the height of the head. The ground on which the track stands does not. Water counts by its depth below the head,
// a tree by the distance to its crown or trunk.
inline constexpr double kCloseBy = 6;  // m
// m from a head: a near miss. Trees are planted at least about 4.5 m off.
inline constexpr double kNearEarth = 1.2, kNearWater = 2.2, kNearTree = 5.0;

// Returns what the first car's riders pass on the first lap; nothing without a land. Near misses are as those of track:
// slower passes than kSlowestMiss do not count, and those within kMissApart along the rails are one. About ten
// microseconds per metre.
Surroundings surroundings_of(const SimulatedRide& simulated, const DerivedTrack& derived, const Ground& ground,
                             const Plants& plants);

class Supports;

struct Ratings {
  bool complete = false;                            // completed the lap, or reached the end of an open track
  double seconds = 0, length = 0;                   // of the lap; m of track
  Extreme top_speed;                                // m/s
  Extreme highest, lowest;                          // m, of the rails under the first car
  Extreme up_most, up_least, side_most;             // g, low-passed; side: absolute
  Extreme forward_most, back_most;                  // g, low-passed; both positive
  Extreme road_most, up_stop_most, side_load_most;  // kN, of a car's wheels of that kind together, low-passed
  Extreme jolt_most;                                // g (jolt.h)
  double mean_speed = 0;                            // m/s
  double airtime = 0;       // s during which the middle car's riders are lifted (vertical g below 0)
  int drops = 0;            // descents of kDrop or more
  double highest_drop = 0;  // m
  int inversions = 0;       // number of times that riders are turned upside down
  int near_misses = 0;      // of track and supports; on a land of earth, water and trees, too
  int tunnels = 0;          // passed on the lap
  double in_tunnels = 0;    // m of them
  double close = 0;         // share of the lap near earth, water or trees (Surroundings), 0..1; 0 without a land
  double overload = 0;      // sum of the overloads' excess over their limits, relative to the limits
  // 0 to 10: see excitement_of(). Intensity and nausea are OpenRCT2's published terms of g and drops, with real g.
  double excitement = 0, intensity = 0, nausea = 0;
};
inline constexpr double kDrop = 3.0;  // m

// Returns the excitement from the other members: rises with drops, speed, airtime, near misses, inversions and vertical
// g, each by ever less, and falls with jolts and overloads; on a land also with tunnels and what it passes closely.
// Weights and reasons: docs/ride.md.
double excitement_of(const Ratings& ratings);

// Properties of a ride that its simulated ride does not contain: near misses of track and supports, overloads, and what
// it passes on a land.
struct RideIncidents {
  int near_misses = 0;
  std::span<const Overload> overloads = {};
  Surroundings around = {};
};

// Returns the ratings of a simulated ride on these tables; `cutoff` in Hz is that of the forces' low-pass. An inversion
// counts where the riders' up, that is the rotation-minimising frame with its banking, points below the horizon by more
// than 0.2 and then above it again. Takes about 1 ms for a lap of a minute with one car.
Ratings rate(const SimulatedRide& simulated, const RailTables& tables, double cutoff, const RideIncidents& marks = {});

// Return a readable report, and the ride by time as CSV (one line per kForceEvery ticks and one at the end,
// units in the heading, named by the car whose forces it has).
// `riders`: all cars, first to last.
std::string report_text(const SimulatedRide& simulated, const Ratings& ratings, std::span<const Rider> riders,
                        std::span<const Overload> red, const std::string& track_name);
std::string report_csv(const SimulatedRide& simulated, std::span<const Rider> riders);

// An extreme value of the report: "top speed", in m/s.
struct ReportRow {
  const char *name, *unit;
  Extreme at;
};
// Returns the report's extreme values, in its order; `riders`: all cars, first to last.
std::vector<ReportRow> report_figures(const Ratings& ratings, std::span<const Rider> riders);

struct NearMisses {
  int track = 0, supports = 0;
  int count() const { return track + supports; }
};

// The distance of a near miss from a rider's head (CoasterForm::head), m: to the middle of other track, and to the
// surface of a support's bar.
inline constexpr double kNearTrack = 3.0, kNearBar = 2.2;
inline constexpr double kSlowestMiss = 5;  // m/s: slower passes do not count
inline constexpr double kMissApart =
    12;  // m along the rails: closer parts are one stretch, and closer near misses are one

// Counts the near misses of the first lap, for the first car's riders; without `supports` only those of track. About a
// microsecond per metre of track and of ride.
NearMisses near_misses(const SimulatedRide& simulated, const DerivedTrack& derived, const Supports* supports);

}  // namespace coaster::sim
