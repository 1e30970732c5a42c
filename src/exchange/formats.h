// The formats of track files, one row each. Whoever reads or writes a track by its path asks this table.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

struct Format {
  std::string_view ending;  // with the dot, in lower case; paths may have either case
  std::string_view label;   // for messages and lists
  base::Result<LoadedTrack> (*parse)(std::string_view bytes,
                                     std::string_view name);  // as parse_track; null: can only be written
  std::string (*print)(const world::Document& document);      // null: can only be read
  bool binary;                                                // the bytes are not text
  bool whole;  // holds everything that a document has: saving to it counts as saving
  base::Status (*check)(const world::Document& document) =
      nullptr;  // whether it can be printed; null: every document can
  // As parse, where that may take longer than a frame; null elsewhere.
  base::Result<LoadedTrack> (*parse_watched)(std::string_view bytes, std::string_view name,
                                             base::Progress* progress) = nullptr;
};

// The project's own format first.
std::span<const Format> formats();

// The row for the path's ending, or null.
const Format* format_of(const std::filesystem::path& path);

// Reads or writes the file in the format of its extension. An unknown extension is refused with the list of those known
// for that direction.
base::Result<LoadedTrack> load_track(base::Files& files, const std::filesystem::path& path,
                                     base::Progress* progress = nullptr);
base::Status save_track(base::Files& files, const std::filesystem::path& path, const world::Document& document);

// Endings that can be read or written, for messages: ".json, .obj or .svg".
enum class Direction { read, write };
std::string known_endings(Direction direction);

}  // namespace coaster::exchange
