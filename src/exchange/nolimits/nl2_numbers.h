// The numbers of a NoLimits 2 CSV: their decimal mark and the step that they are rounded to.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/text.h"
#include "sim/fit/fit_rounding.h"

namespace coaster::exchange {

// Returns how many decimals a number is written with.
inline std::size_t decimals(std::string_view number) {
  const std::size_t mark = number.find_first_of(".,");
  return mark == std::string_view::npos ? 0 : number.size() - mark - 1;
}

// Reads a file's numbers. The first one with decimals decides whether these follow a point or a comma.
struct DecimalMark {
  bool commas = false;  // may be decimal ones: they do not separate columns
  char mark = 0;        // '.' or ',' once known
  std::optional<double> read(std::string_view text) {
    const std::size_t at = text.find_first_of(commas ? ".," : ".");
    if (at == std::string_view::npos) return base::parse_double(text);
    if (mark == 0) mark = text[at];
    return text[at] == mark ? base::parse_double(std::string(text).replace(at, 1, ".")) : std::nullopt;
  }
  // Returns a text that is no number, for messages.
  std::string quoted(std::string_view text) const {
    const bool point = mark == ',' && base::parse_double(text);
    return point ? base::quoted_start(text) + ": decimals follow a comma here" : base::quoted_number(text);
  }
};

// The fewest decimals with which all numbers can be written, at most kMost.
struct Decimals {
  static constexpr int kMost = 6;
  int count = 0;
  void add(double number);
  double step() const;
};

// Returns the steps that the rows are rounded to, 0 for finer ones than 4 decimals: that of the decimals, or, of
// positions, that of float numbers as large as the largest, if all of an axis are such numbers.
sim::RowSteps row_steps(std::span<const sim::FitRow> rows, const Decimals& positions, const Decimals& directions);

// Returns the warning that names the steps, what they do, and what to do.
std::string told_steps(const sim::RowSteps& steps);

}  // namespace coaster::exchange
