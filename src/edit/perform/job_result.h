// What another thread finds for a command: a file's track, the values of a search, or a closing section.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "exchange/own/track_file.h"
#include "sim/study/closing_replan.h"

namespace coaster::edit {

// What a search (command seek) found: with these values the goal is met.
struct SeekResult {
  std::vector<double> values;  // of the numbers that the command names, in their order
  std::string note;            // "ride.lap_time is 40 s, from 43.2 s. ..."
};

using JobResult = std::variant<exchange::LoadedTrack, SeekResult, sim::ClosingReplanResult>;

// What apply() leaves to another thread, and what that has found. A change of a circuit plans the closing section
// again, which may take longer than a frame.
struct ClosingSearch {
  bool leaves = false;  // true: a command that would search for a closing section is refused without a notice instead,
  std::optional<sim::ClosingReplanTask> wanted = {};  // and leaves here what is to be searched for
  std::optional<JobResult> found = {};                // for the command, which then neither reads nor searches
  std::optional<sim::ClosingReplanTask> asked = {};   // what a closing section that was found answers
};

}  // namespace coaster::edit
