// The CSV that NoLimits 2 writes as "Export Track Spline" (docs/track-format.md): positions and frames along the track,
// without speeds. Reading fits a track to them.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

inline constexpr std::array<std::string_view, 13> kNl2Columns{
    "No.", "PosX", "PosY", "PosZ", "FrontX", "FrontY", "FrontZ", "LeftX", "LeftY", "LeftZ", "UpX", "UpY", "UpZ"};
inline constexpr std::size_t kMaxNl2Rows = 500'000;
inline constexpr double kNl2Spacing = 0.05;  // m between saved rows; the same as in NoLimits 2

// Parses a whole file and fits a track to its rows (sim/fit/fit_track.h), with one train at its start. Errors are
// Code::bad_file with one line "NAME:LINE: error: expected ..., found ...". Columns are separated by tabs, commas,
// semicolons or blanks; LF, CRLF or CR; accepts a byte-order mark, blank lines, comments (# and //), separators at the
// end of lines, a missing last newline, column names without quotes, a missing header, and rows that count from 0.
// Rejects other columns, row numbers that do not count up, NaN, infinities, positions beyond world::kMaxCoordinate,
// frames that are not unit, perpendicular and right-handed to 1 % (better ones are made exact), fewer than 2 rows, more
// than kMaxNl2Rows, a truncated last number, and rows that run against Front. Leaves out rows at the position of the
// previous row, with a warning. Where tabs or semicolons separate, decimals may follow a comma, in the whole file. Rows
// with few decimals are followed within 1.5 of their steps, with a warning (sim/fit/sample_dequantisation.h). Warns of
// single steps against Front, of gaps and of jumps of the frame. Reports progress, and is refused once it is cancelled.
// `origin`: moves rows from anywhere to the origin (exchange/own/import_options.h).
base::Result<LoadedTrack> parse_nl2_csv(std::string_view text, std::string_view name, bool origin = false);
// True if the first row can be read and is further than kFar from the origin.
bool starts_far(std::string_view text);

// Checks that the track can be written: it has a segment and at most kMaxNl2Rows rows. `spacing` in m, above 0.
base::Status check_nl2_csv(const world::Document& document, double spacing);

// Returns rows every `spacing` m of the track's length from its start, with %.6f, LF after every line. An open track's
// last row is its end; a closed one's first row is not repeated. check_nl2_csv() must be ok. The same document always
// gives the same bytes.
std::string print_nl2_csv(const world::Document& document, double spacing);

}  // namespace coaster::exchange
