// The numbers that a search may change. Private to this room.
#pragma once

#include "base/least_change.h"
#include "edit/commands/commands_seek.h"
#include "edit/perform/perform.h"

namespace coaster::edit {

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
base::Result<std::vector<SeekNumber>> seek_numbers(const Session& session, const Seek& command);

// Sets each number whose value differs from its start; values[i] belongs to numbers[i]. Data derived from the document
// are not updated.
base::Status give(Session& session, Change& change, const std::vector<SeekNumber>& numbers,
                  const std::vector<double>& values);

// Returns what the numbers are in a sentence: "height", or "vertical keys" for the command's word vertical.
std::string words_of(const Seek& command, const std::vector<SeekNumber>& numbers);

// Returns "Height: from 20 to 22.4 m." or "Height: 5 of 7 changed, by up to 1.25 m."; values[i] belongs to numbers[i].
std::string changed_text(std::string by, const std::vector<SeekNumber>& numbers, const std::vector<double>& values);

}  // namespace coaster::edit
