// Rows as other programs write them: fewer of them, with fewer decimals.
#pragma once

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace coaster::test {

// Three numbers each of position, Front, Left and Up.
using Row = std::array<double, 12>;

inline std::vector<Row> rows_of(const std::string& text) {
  std::istringstream in(text.substr(text.find('\n') + 1));
  std::vector<Row> rows;
  for (std::string number; in >> number;) {
    rows.emplace_back();
    for (double& value : rows.back()) in >> value;
  }
  return rows;
}

struct Rounding {
  int positions = 6, directions = 6;  // decimals
  std::size_t every = 1;              // row
  double away = 0;                    // m: X and Z of float positions so far from the origin
  bool zeros = false;                 // written with six decimals nevertheless
  std::size_t part = 1;               // only the first one of so many parts: an open track
};

inline std::string rounded(const std::string& text, const Rounding& as) {
  const std::vector<Row> rows = rows_of(text);
  std::string out = text.substr(0, text.find('\n') + 1);
  for (std::size_t i = 0; i * as.every < rows.size() / as.part; ++i) {
    out += std::to_string(i + 1);
    for (std::size_t k = 0; k < 12; ++k) {
      double value = rows[i * as.every][k];
      if (as.away > 0 && k < 3) value = static_cast<float>(value + (k == 1 ? 0 : as.away));
      const std::string few = fmt::format("{:.{}f}", value, k < 3 ? as.positions : as.directions);
      out += "\t" + (as.zeros ? fmt::format("{:.6f}", std::stod(few)) : few);
    }
    out += "\n";
  }
  return out;
}

}  // namespace coaster::test
