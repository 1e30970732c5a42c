// A challenge under way, how a ride ended, and what a referee makes of both: values that the session holds. Who may
// read the rules' expressions is above this room: the referee is handed in as functions (query/challenge.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exchange/challenge_file.h"
#include "exchange/own/progress_file.h"
#include "sim/shape/shape_distance.h"
#include "sim/study/ratings.h"

namespace coaster::edit {

struct Session;

// What was found when a challenge was judged.
struct Verdict {
  int medal = 0;       // 0 not passed, 1 bronze, 2 silver, 3 gold
  std::string reason;  // why it is not passed: "lateral g: 1.40 g at 87.0 m, wanted <= 1.2 g"; empty when it is
  std::optional<double> place;              // m along the track, where that is
  std::vector<exchange::BestValue> values;  // of what its rules compare
};

struct ActiveChallenge {
  exchange::ChallengeFile file;
  std::string path;          // of the challenge's file
  int hints = 0;             // that are shown
  int medal = 0;             // the best since it was begun
  std::uint64_t judged = 0;  // how often
  Verdict last;
  sim::ShapeTrace shape;  // of the start track
};

// Reads expressions for the session. Both null: challenges are loaded unchecked and never judged.
struct Referee {
  // Whether every expression can be read; else Code::bad_file with "PATH: error: goals[1].expect: ...".
  base::Status (*check)(const exchange::ChallengeFile& challenge, const std::string& path) = nullptr;
  // Of the session's challenge, which there is, on the session as it is now, of which findings alone change; `result`:
  // how the ride ended, null for Judged::build.
  Verdict (*judge)(Session& session, const struct RideResult* result) = nullptr;
};

enum class RideEnd : std::uint8_t { lap, open_end, time, failed };
inline constexpr base::NameRow kRideEnds[] = {{"lap", "A whole lap"},
                                              {"open end", "To the end of the track"},
                                              {"time", "The time is up"},
                                              {"failed", "The ride failed"}};
constexpr std::span<const base::NameRow> rows_of(RideEnd) { return kRideEnds; }

// How a ride ended, for the score card.
struct RideResult {
  RideEnd end = RideEnd::lap;
  std::string reason;           // of a failure: "stalled at 132.4 m, 2.1 m below the top at 141.0 m, ..."
  std::optional<double> place;  // m along the track, of the failure
  bool whole = true;            // the train was let run from its start on this track, and `ratings` are of this ride
  sim::Ratings ratings;
  double seconds = 0;              // from the start to here
  std::optional<Verdict> verdict;  // of the challenge, when one was under way
  std::uint64_t serial = 0;        // counts up
};

// A ride on its way.
struct RideRun {
  bool under_way = false;      // set off and not told of yet
  bool whole = false;          // from the start, and not put elsewhere by hand since
  std::uint64_t document = 0;  // hash when it set off
  std::uint64_t ticks = 0;
};

}  // namespace coaster::edit
