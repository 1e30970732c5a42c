// The formats of track files, one row each. All reading and writing of tracks by path uses this table.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "exchange/own/import_options.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {

struct TrackFormat {
  std::string_view ending;  // with the dot, in lower case; paths may use either case
  std::string_view label;   // for messages and lists
  base::Result<LoadedTrack> (*parse)(std::string_view bytes,
                                     std::string_view name);  // as parse_track; null: write-only
  std::string (*print)(const world::Document& document);      // null: read-only
  bool binary;                                                // the bytes are not text
  bool whole;                                                 // holds the whole document: saving to it counts as saving
  base::Status (*check)(const world::Document& document) =
      nullptr;                                   // true if the document can be printed; null: always
  std::size_t most_bytes = base::kMaxFileBytes;  // larger files are rejected before they are read, and not written
  // Parses by the words of an import and reports progress, for rows and points; null for the other formats.
  base::Result<LoadedTrack> (*parse_watched)(std::string_view bytes, std::string_view name,
                                             const ImportOptions& import) = nullptr;
  bool cubics = false;  // prints the curve's control points, so it is given a track whose curve is the rails
  std::string (*print_park)(const world::Document&) = nullptr;  // prints the track in its park; null: cannot
  std::string (*materials)(const world::Document&, bool with_park) = nullptr;  // prints the file of materials_of()
};

// Returns the table; the project's own format is first.
std::span<const TrackFormat> formats();

// True for the lines of a list of points in place of a path.
bool is_pasted(std::string_view path);

// Returns the path of the materials that are written beside a file; empty for formats without.
std::filesystem::path materials_of(const std::filesystem::path& path);

// Returns the row for the path's extension, or null.
const TrackFormat* format_of(const std::filesystem::path& path);

// Read or write the file in the format of its extension. An unknown extension is refused with the list of those known
// for that direction. A shared link is read like a file (exchange/own/share_link.h). A track from a format that does
// not hold everything gets a train at its start, if it has none, and, unless the file gives one, a start speed with
// which its ride completes (sim/ride/simulated_ride.h), if there is one; the note or a warning says so.
base::Result<LoadedTrack> load_track(base::Files& files, const std::filesystem::path& path,
                                     const ImportOptions& import = {});
// What a window asks before it opens a list of points, or rows that begin far from the origin.
struct ImportQuestion {
  ImportOptions proposed;  // for rows without axis and scale
  std::size_t points = 0;  // 0: rows
  double length = 0;       // of the list, in its units
  glm::dvec3 size{0};      // of its bounds
};
// Reads the file; nothing for other files and for lists with errors, which load_track() reports.
std::optional<ImportQuestion> question_of(base::Files& files, const std::filesystem::path& path);

// Writes a track. Formats that do not hold everything get the rails, even of a heartline track; they are refused where
// rails fold. `content` gets the hash of the bytes as soon as they are printed. `with_park`: with land, water and
// plants beside the track; refused without a land, and for formats that cannot hold them.
base::Status save_track(base::Files& files, const std::filesystem::path& path, const world::Document& document,
                        std::uint64_t* content = nullptr,
                        base::ReplaceableFiles replaces = base::ReplaceableFiles::made, bool with_park = false);

// Returns the extensions that can be read or written, for messages: ".json, .obj or .svg".
enum class FormatUse { read, write };
std::string known_endings(FormatUse direction);

}  // namespace coaster::exchange
