// The numbers that a search may change. Private to this room.
#pragma once

#include "base/least_change.h"
#include "edit/commands/commands_seek.h"
#include "edit/perform/perform.h"

namespace coaster::edit {

inline constexpr std::size_t kMaxSeekNumbers = 300;

enum class SeekKind : std::uint8_t { x, height, z, roll, parameter };

struct SeekNumber {
  SeekKind kind{};
  world::Entity entity;   // a knot, or the section that has the parameter
  std::string parameter;  // its name
  std::string_view unit;
  base::Unknown unknown;
};

// Returns the numbers that the command names, in track order; refused if there are none.
base::Result<std::vector<SeekNumber>> seek_numbers(const Session& session, const Seek& command);

// Sets a number; data derived from the document are not updated.
base::Status give(Session& session, Change& change, const SeekNumber& number, double value);

// Returns "Height: from 20 to 22.4 m." or "Height: 5 of 7 changed, by up to 1.25 m."; values[i] belongs to numbers[i].
std::string changed_text(std::string by, const std::vector<SeekNumber>& numbers, const std::vector<double>& values);

}  // namespace coaster::edit
