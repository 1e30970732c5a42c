// Searches for numbers of the track for which a query has a given value.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/least_change_solver.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/job_result.h"
#include "edit/perform/perform_context.h"
#include "edit/session/session.h"

namespace coaster::edit {

// Returns why the command's `by` names no number of what `of` names, with the nearest word; nothing if it may. Whether
// a section of that name has the number depends on the track.
std::optional<std::string> wrong_by(const SeekGoal& command);

// Prepares a search on a copy of the session; calling the result once, in any thread, runs it. Refused then if the goal
// cannot be parsed or measured, if nothing that could change is named, or if the goal is not reached. The same bits
// everywhere. A trial costs a ride, some milliseconds; at most 400, and ten for each number.
std::function<base::Result<SeekResult>()> search_for(const Session& session, const SeekGoal& command);

inline constexpr std::size_t kMaxSeekNumbers = 300;

enum class SeekKind : std::uint8_t { x, height, z, roll, parameter, force_length, force_key };

struct SeekNumber {
  SeekKind kind{};
  world::Entity entity;   // a knot, or the section that has the parameter, the length or the key
  std::string parameter;  // its name
  std::string_view unit;
  base::Unknown unknown;
  world::ForceChannel channel{};  // of the key
  std::size_t key = 0;            // its index
};

// Returns the numbers that the command names, in track order, those of a force section one after the other; refused if
// there are none.
base::Result<std::vector<SeekNumber>> seek_numbers(const Session& session, const SeekGoal& command);

// Sets each number whose value differs from its start; values[i] belongs to numbers[i]. Data derived from the document
// are not updated.
base::Status give(Session& session, Change& change, const std::vector<SeekNumber>& numbers,
                  const std::vector<double>& values);

// Returns what the numbers are in a sentence: "height", or "vertical keys" for the command's word vertical.
std::string words_of(const SeekGoal& command, const std::vector<SeekNumber>& numbers);

// Returns "Height: from 20 to 22.4 m." or "Height: 5 of 7 changed, by up to 1.25 m."; values[i] belongs to numbers[i].
std::string changed_text(std::string by, const std::vector<SeekNumber>& numbers, const std::vector<double>& values);

}  // namespace coaster::edit
