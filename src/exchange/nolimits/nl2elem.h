// Elements of NoLimits 2 (.nl2elem, XML; docs/track-format.md): vertices of a uniform cubic B-spline and frames along
// it.
#pragma once

#include <string>
#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

// Parses an element. The spline's spans become segments, exact except for the rounding of knots to float; a roll
// between vertices adds a knot. The track is closed if the first and last vertices coincide. Between rolls the angle to
// the rotation-minimising frame is linear along the track; without rolls the track follows the horizon. One train at
// the start. Errors are Code::bad_file, one line "NAME:LINE: error: expected ..., found ...". Rejects broken XML, no
// root/element, missing, repeated or non-finite numbers, positions beyond world::kMaxCoordinate, coords outside 0..1,
// frames that are not unit and perpendicular to 5 %, fewer than 2 vertices (3 positions if closed), more than
// world::kMaxKnots, and neighbours between which the track has no direction.
base::Result<LoadedTrack> parse_nl2elem(std::string_view text, std::string_view name);

// Checks that the track can be written: it has a segment and is at most kMaxNl2ElemLength long.
base::Status check_nl2elem(const world::Document& document);
inline constexpr double kMaxNl2ElemLength = 100'000;  // m

// Returns strict vertices and rolls every metre, or closer (down to 1/8 m) until the spline through them stays within
// kNl2ElemError of the track and kNl2ElemTurn of its direction; jumps of curvature need the closest. check_nl2elem()
// must be ok. Lines end with CRLF. The same document always gives the same bytes.
std::string print_nl2elem(const world::Document& document);
inline constexpr double kNl2ElemError = 0.004;  // m
inline constexpr double kNl2ElemTurn = 0.005;   // rad

}  // namespace coaster::exchange
