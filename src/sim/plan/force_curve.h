// The curve of one channel of a force section: cubic Bezier pieces between its keys. For force_law.h.
#pragma once

#include <array>
#include <vector>

#include "world/force.h"

namespace coaster::sim {

// One channel of a program as a function of the position.
class ForceCurve {
 public:
  struct Value {
    double value = 0, slope = 0;  // in the channel's unit; the same per metre or second
  };
  ForceCurve(const world::ForceProgram& program, world::ForceChannel channel);
  // Returns the value at x m or s; error below 1e-10 of the largest value. The same bits everywhere.
  Value at(double x) const;
  // Returns the second derivative there.
  double bend_at(double x) const;

 private:
  using Piece = std::array<glm::dvec2, 4>;
  // Returns the piece that holds x; null before the first and behind the last.
  const Piece* piece_at(double x) const;

  double before_, after_;  // the values before and after the pieces
  std::vector<Piece> pieces_;
};

// Adds a key at a position of the section on the channel's curve; the curve keeps its shape (de Casteljau).
void insert_on_curve(world::ForceProgram& program, world::ForceChannel channel, double at);

}  // namespace coaster::sim
