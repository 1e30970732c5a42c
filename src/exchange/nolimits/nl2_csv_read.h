// Reads the lines of a NoLimits 2 CSV, each by itself. For nl2_csv.cpp.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "exchange/nolimits/nl2_csv_lines.h"
#include "exchange/nolimits/nl2_numbers.h"

namespace coaster::exchange {

inline constexpr double kSamePlace = 2e-6;  // m: rounding of printed positions

struct Nl2CsvReader {
  static constexpr double kAnywhere = 1e9;  // m
  std::string_view name;
  Lines lines;
  std::vector<sim::FitRow> rows;
  std::vector<int> row_lines;  // of each row
  std::vector<std::string> warnings;
  std::size_t more_warnings = 0;  // number of omitted warnings
  Separator separator = kSeparators[0];
  std::size_t data_rows = 0;
  std::int64_t first_number = 1;         // of the rows: 0 or 1
  std::size_t first_decimals = 0;        // the fewest decimals of the first row's numbers
  double limit = world::kMaxCoordinate;  // m, of positions
  DecimalMark mark;
  Decimals positions, directions;
  sim::RowSteps steps;             // 0 where the rows are not rounded
  std::vector<sim::FitRow> given;  // as they are in the file, if they are rounded
  bool closed = false;             // set if they are
  std::string error;

  bool fail(std::string_view expected, std::string_view found) {
    error = fmt::format("{}:{}: error: expected {}, found {}", name, lines.number(), expected, found);
    return false;
  }
  void warn(int line, std::string_view what) {
    constexpr std::size_t kMost = 20;
    if (warnings.size() < kMost) warnings.push_back(fmt::format("{}:{}: warning: {}", name, line, what));
    else ++more_warnings;
  }
};

// Read the first line, a header or a row, and each one after it. Return false with `error` if the line is refused.
bool read_first_line(Nl2CsvReader& r, std::string_view line);
bool read_row(Nl2CsvReader& r, std::string_view line);

}  // namespace coaster::exchange
