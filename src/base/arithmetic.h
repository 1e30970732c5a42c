// Evaluation of typed numbers: "7.25", "5+5", "2*(3 - 0.5)", "50 cm", "90 km/h".
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/status.h"

namespace coaster::base {

enum class Dimension : std::uint8_t { length, speed, acceleration, time, angle, spin, mass };

struct Unit {
  std::string_view name;
  Dimension dimension;
  double size;  // in the dimension's first unit of the table
};
// Returns all units that can be typed. To add one: a row.
std::span<const Unit> units();

// Evaluates numbers with + - * / and brackets, by the usual precedence, from left to right, in double precision. The
// result is in `unit`, a name of the table or any other text ("" for a plain number). A number or bracket may be
// followed by a unit, if it is `unit` itself or has the same dimension; a term without one is in `unit`. Code::usage
// with the reason for everything else: other words, a decimal comma, a unit of another dimension, a product of two
// units, division by zero, results beyond double. The result is finite, never inf or NaN.
Result<double> evaluate(std::string_view text, std::string_view unit = {});

}  // namespace coaster::base
