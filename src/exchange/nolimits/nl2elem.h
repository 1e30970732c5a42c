// Elements of NoLimits 2 (.nl2elem, XML; docs/track-format.md): vertices of clamped uniform B-splines and frames along
// them.
#pragma once

#include <string>
#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

// Parses an element. Its curve (nl2_spline.h) becomes segments, exact except for the rounding of knots to float, for
// runs with different weights (kRationalOff), and for corners, which become fillets (nl2_spline.h) with a warning
// each. Rolls that the track does not match add knots (nl2_spline.h); without rolls the track follows the horizon. The
// track is closed if the first and last vertices coincide. One train at the start. Errors are Code::bad_file, one line
// "NAME:LINE: error: expected ..., found ...". Rejects broken XML, no root/element, missing, repeated or non-finite
// numbers, positions beyond world::kMaxCoordinate, weights that are not positive or differ by more than 100 times from
// the first, coords outside 0..1, frames that are not unit and perpendicular to 5 %, fewer than 2 vertices, more than
// world::kMaxKnots, corners beyond kSharpest, and vertices at which the track has no direction.
base::Result<LoadedTrack> parse_nl2elem(std::string_view text, std::string_view name);

// Checks that the track can be written and read again: it has a segment, is at most kMaxNl2ElemLength long, its handles
// are within world::kMaxCoordinate, and it does not fold (find_fold()).
base::Status check_nl2elem(const world::Document& document);
inline constexpr std::size_t kMaxNl2ElemBytes = 4u
                                                << 20;  // 25,000 vertices; the tree of its XML takes 70 times as much
inline constexpr double kMaxNl2ElemLength = 100'000;    // m

// Returns an element whose curve is the track's: each segment is a run of four vertices, its control points, and the
// knots are strict. Rolls are at the knots and between them as described in nl2_spline.h. A closed track's last vertex
// repeats the first. check_nl2elem() must be ok. Lines end with CRLF. The same document always gives the same bytes.
std::string print_nl2elem(const world::Document& document);

}  // namespace coaster::exchange
