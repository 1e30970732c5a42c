// Evaluates functions of an openFVD project, and makes force keys that follow a function.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "exchange/fvd/fvd_file.h"
#include "world/force.h"

namespace coaster::exchange {

// The start of a piece that rolls to the horizon: the roll in degrees to the left, and the derivative of the roll's
// rate by the fraction of the piece.
struct FvdLevelling {
  double roll = 0, slope = 0;
};

// Returns a piece's value at x, clamped to the piece. `levelling` is used only for pieces `to_zero`.
double value_of(const FvdPiece& piece, double x, const FvdLevelling& levelling = {});

// Returns the piece for x; beyond the end the last one.
const FvdPiece& piece_at(const FvdFunction& function, double x);

// Shifts each piece to start with the value at which the previous one ends, as openFVD does when it opens a file, the
// first with `start`, and sets the ends of pieces that follow the section's end.
void join_pieces(FvdFunction& function, double start, double length);

// Returns the end of the section: that of the shortest function without a piece that follows it. 0: none.
double shared_length(std::span<const FvdFunction* const> functions);

// Returns keys whose curve follows f over [0, length] within `tolerance`, at least `gap` apart: at the given positions
// where f or its derivative jumps, the curve cuts the corner over one gap. Values are clamped to `limit`. If more than
// world::kMostForceKeys are needed, the tolerance is doubled until they suffice.
std::vector<world::ForceKey> keys_along(const std::function<double(double)>& f, std::vector<double> corners,
                                        double length, double tolerance, double gap, double limit);

}  // namespace coaster::exchange
