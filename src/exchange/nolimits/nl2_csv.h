// The CSV that NoLimits 2 writes as "Export Track Spline" (docs/track-format.md): places and frames along the track,
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
inline constexpr double kNl2Spacing = 0.05;  // m between the rows that are saved; what NoLimits 2 writes, too

// Parses a whole file and fits a track to its rows (sim/plan/fit_track.h), with one cart at its start. Errors are
// Code::bad_file with one line "NAME:LINE: error: expected ..., found ...". Tabs between the columns; LF or CRLF; a
// byte-order mark, blank lines at the end and a missing last newline are fine; names of columns may lack their quotes.
// Refuses: other columns, numbers not from 1 in steps of 1, NaN, infinities, places beyond world::kMaxCoordinate,
// frames that are not unit, perpendicular and right-handed to 1 % (better ones are made exact), fewer than 2 rows, more
// than kMaxNl2Rows, a last number that was cut off. Rows at the place of the row before are left out, with a warning.
base::Result<LoadedTrack> parse_nl2_csv(std::string_view text, std::string_view name);
// The same, told how far it is; refused once it is cancelled.
base::Result<LoadedTrack> parse_nl2_csv_watched(std::string_view text, std::string_view name, base::Progress* progress);

// Whether the track can be written: a segment, and at most kMaxNl2Rows rows. `spacing` in m, above 0.
base::Status check_nl2_csv(const world::Document& document, double spacing);

// Rows every `spacing` m of the track's length from its start, with %.6f, LF after every line. An open track's last row
// is its end; a closed one's first row is not repeated. check_nl2_csv() must be ok. The same document always gives the
// same bytes.
std::string print_nl2_csv(const world::Document& document, double spacing);

}  // namespace coaster::exchange
