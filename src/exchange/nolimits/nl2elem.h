// Elements of NoLimits 2 (.nl2elem, XML; docs/track-format.md): vertices of a uniform cubic B-spline and frames along
// it.
#pragma once

#include <string>
#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

// The spline's spans become segments, exact but for the rounding of knots to float; a knot is added where a roll stands
// between vertices. Whose last vertex is at the place of the first is closed. Between rolls the angle about a
// rotation-minimising frame goes on evenly along the track; without rolls the track keeps to the horizon. One cart at
// the start. Errors are Code::bad_file, one line "NAME:LINE: error: expected ..., found ...". Refuses: broken XML, no
// root/element, missing or repeated or non-finite numbers, places beyond world::kMaxCoordinate, coords outside 0..1,
// frames that are not unit and perpendicular to 5 %, fewer than 2 vertices (3 places when closed), more than
// world::kMaxKnots, neighbours between which the track has no direction.
base::Result<LoadedTrack> parse_nl2elem(std::string_view text, std::string_view name);

// Whether the track can be written: it has a segment and is at most kMaxNl2ElemLength long.
base::Status check_nl2elem(const world::Document& document);
inline constexpr double kMaxNl2ElemLength = 100'000;  // m

// Strict vertices and rolls every metre, or closer (down to 1/8 m) until the spline through them stays within
// kNl2ElemError of the track and kNl2ElemTurn of its direction, which where the curvature jumps takes the closest.
// check_nl2elem() must be ok. Lines end with CRLF. The same document always gives the same bytes.
std::string print_nl2elem(const world::Document& document);
inline constexpr double kNl2ElemError = 0.004;  // m
inline constexpr double kNl2ElemTurn = 0.005;   // rad

}  // namespace coaster::exchange
