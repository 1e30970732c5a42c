// A challenge in progress, the end of a ride, and the verdict on both: values in the session. Rules are evaluated above
// this room: the referee is passed in as functions (query/challenge_rules.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "exchange/challenge_file.h"
#include "exchange/own/challenge_progress_file.h"
#include "sim/shape/shape_distance.h"
#include "sim/study/ratings.h"

namespace coaster::edit {

struct Session;

// The result of judging a challenge.
struct ChallengeVerdict {
  int medal = 0;                // 0 not passed, 1 bronze, 2 silver, 3 gold
  std::string reason;           // why it failed: "Lateral: you have 1.40 g at 87.0 m; you need ..."; empty if it passed
  std::optional<double> place;  // m along the track, where it failed
  std::vector<exchange::BestValue> values;  // values that its rules compare
};

struct ActiveChallenge {
  exchange::ChallengeFile file;
  std::string path;          // the challenge's file
  int hints = 0;             // number of hints shown
  int medal = 0;             // the best since it was started
  std::uint64_t judged = 0;  // number of judgements
  ChallengeVerdict last;
  sim::ShapeTrace shape;  // of the start track
};

// How far a session is from a goal such as "ride.lap_time == 40 +-0.1".
struct GoalState {
  double found = 0, wanted = 0, tolerance = 0;  // in the query's unit; tolerance > 0
  bool met = false;
  std::string name, unit;  // "Lap time", "s"
};

// Evaluates expressions for the session. If all are null, challenges are loaded unchecked and never judged, and seek is
// unavailable.
struct ExpressionEvaluator {
  // Checks that every expression can be parsed; else Code::bad_file with "PATH: error: goals[1].expect: ...".
  base::Status (*check)(const exchange::ChallengeFile& challenge, const std::string& path) = nullptr;
  // Judges the session's challenge, which must exist, on the present session; only findings change. `result`: how the
  // ride ended, null for JudgedWhen::build.
  ChallengeVerdict (*judge)(Session& session, const struct RideResult* result) = nullptr;
  // Measures a goal. Code::usage if it cannot be parsed, Code::refused if its query has no value.
  base::Result<GoalState> (*measure)(Session& session, const std::string& goal) = nullptr;
};

enum class RideEnd : std::uint8_t { lap, open_end, time, failed };
inline constexpr base::NameRow kRideEnds[] = {{"lap", "Lap completed"},
                                              {"open end", "End of the track reached"},
                                              {"time", "Time limit reached"},
                                              {"failed", "Ride failed"}};
constexpr std::span<const base::NameRow> rows_of(RideEnd) { return kRideEnds; }

// The end of a ride, for the score card.
struct RideResult {
  RideEnd end = RideEnd::lap;
  std::string reason;           // reason of a failure: "stalled at 132.4 m, 2.1 m below the top at 141.0 m, ..."
  std::optional<double> place;  // m along the track, where it failed
  bool below_top = false;       // it stopped on the way up: a lift there would take it over the top
  bool whole = true;            // the train ran from its start on this track, and `ratings` are of this ride
  sim::Ratings ratings;
  double seconds = 0;                       // from the start to the end of the ride
  std::optional<ChallengeVerdict> verdict;  // of the challenge, if there was one
  std::uint64_t serial = 0;                 // number of the result
};

// A ride in progress.
struct RideInProgress {
  bool under_way = false;      // running, and its end not yet reported
  bool whole = false;          // from the start, and not moved by hand since
  std::uint64_t document = 0;  // hash at the start
  std::uint64_t ticks = 0;
};

}  // namespace coaster::edit
