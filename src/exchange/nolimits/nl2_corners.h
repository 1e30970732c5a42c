// Rounds the corners of a NoLimits 2 element: a track of the document has one direction at every knot.
#pragma once

#include <optional>

#include "exchange/nolimits/nl2_spline.h"

namespace coaster::exchange {

inline constexpr double kCornerOff = 0.03;    // m, the largest distance of a fillet from the corner it replaces
inline constexpr double kSharpest = 90;       // degrees; sharper corners are rejected
inline constexpr double kTurnedOff = 0.0001;  // m; handles are turned if that moves the curve by no more

struct Corner {
  std::size_t vertex = 0;
  double angle = 0;  // rad between the directions before and after it
  double off = 0;    // m, the largest distance of the fillet from the original curve
};

// Replaces each corner by a fillet, a cubic with the directions of its two ends. It takes at most 45 % of the length of
// either neighbour. On a closed track the joint of the last piece and the first is also checked. Adds the corners to
// `corners`; those sharper than kSharpest are unchanged.
std::vector<SplinePiece> round_corners(const std::vector<SplinePiece>& pieces, bool closed,
                                       std::vector<Corner>& corners);

// Returns the first place where the curve turns by more than kSharpest within kCornerOff on either side, between
// corners: a cusp, or nearly one. Vertices that lead back on one line make cusps.
std::optional<Corner> find_fold(const std::vector<SplinePiece>& pieces, bool closed);

}  // namespace coaster::exchange
