#include "exchange/nolimits/nl2_csv_read.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.h"
#include "base/words.h"
#include "exchange/nolimits/within_text.h"
#include "exchange/own/import.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr auto& kColumns = kNl2Columns;
constexpr double kSquare = 0.01;  // tolerance for unit and perpendicular frames
constexpr const char* kFarHint = ": load it with the word origin to move it there";

// Finds the file's separator in its first line: one that makes 13 columns, else the only one. Blanks may only be it if
// there is no other.
bool find_separator(Nl2CsvReader& r, std::string_view line) {
  Cells cells;
  std::size_t kinds = 0;
  for (const Separator& s : kSeparators) {
    if (line.find(s.mark) == std::string_view::npos || (kinds > 0 && s.mark == ' ')) continue;
    r.separator = s, ++kinds;
    r.mark.commas = s.mark == '\t' || s.mark == ';';
    if (split(line, s.mark, cells) == cells.size()) return true;
  }
  return kinds == 1 || r.fail("a header of 13 columns, separated by tabs",
                              kinds > 1 ? "several separators" : base::quoted_start(line));
}

// True if the line is a row, so that the file has no header: the checks of frames find columns of another order.
bool is_row(const Nl2CsvReader& r, std::string_view line) {
  Cells cells;
  return split(line, r.separator.mark, cells) == cells.size() && base::parse_double(cells[0]);
}

bool read_header(Nl2CsvReader& r, std::string_view line) {
  Cells cells;
  const std::size_t count = split(line, r.separator.mark, cells);
  for (std::size_t i = 0; i < kColumns.size() && i < count; ++i) {
    const std::string name = base::lower(cells[i]);
    if (name != base::lower(kColumns[i]) && !(i == 0 && name == "no"))
      return r.fail(fmt::format("column {} of the header to be \"{}\"", i + 1, kColumns[i]),
                    base::quoted_start(cells[i]) + ": name and order the columns as NoLimits 2 does");
  }
  return count == kColumns.size() || r.fail(fmt::format("a header of 13 columns, separated by {}", r.separator.name),
                                            count > kColumns.size() ? "more" : std::to_string(count));
}

bool read_vector(Nl2CsvReader& r, const Cells& cells, std::size_t first, double limit, dvec3& v, Decimals& decimals) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = first + static_cast<std::size_t>(axis);
    const auto number = r.mark.read(cells[i]);
    const auto expected = [&](std::string_view what) { return fmt::format("{} in column {}", what, kColumns[i]); };
    if (!number) return r.fail(expected("a finite number"), r.mark.quoted(cells[i]));
    if (!(std::abs(*number) <= limit))
      return r.fail(expected(within_text(limit)), base::quoted_start(cells[i]) + (i < 4 ? kFarHint : ""));
    v[axis] = *number;
    decimals.add(*number);
  }
  return true;
}

// Reads a frame. It must be right-handed, unit and perpendicular within kSquare, or within what its decimals can round.
// Makes it exactly so; Front keeps its direction.
bool read_frame(Nl2CsvReader& r, const Cells& cells, sim::FitRow& row) {
  dvec3 front, left, up;
  Decimals own;
  if (!read_vector(r, cells, 4, 2, front, own) || !read_vector(r, cells, 7, 2, left, own) ||
      !read_vector(r, cells, 10, 2, up, own))
    return false;
  r.directions.count = std::max(r.directions.count, own.count);
  const double rounding = std::numbers::sqrt3 / 2 * std::min(own.step(), 0.1);  // of a vector
  const auto unit = [&](dvec3 v, std::string_view which) {
    const double length = glm::length(v);
    return std::abs(length - 1) <= std::max(kSquare, rounding) ||
           r.fail(fmt::format("{} to be a unit vector", which), "one of length " + base::to_text(length));
  };
  if (!unit(front, "Front") || !unit(left, "Left") || !unit(up, "Up")) return false;
  const double cosine = glm::dot(front, up);
  if (std::abs(cosine) > std::max(kSquare, 2.1 * rounding))
    return r.fail("Up perpendicular to Front", fmt::format("a cosine of {} between them", base::to_text(cosine)));
  const double off = glm::distance(glm::cross(front, left), up);
  if (off > std::max(2 * kSquare, 3.2 * rounding))
    return r.fail("Up = Front x Left", fmt::format("a vector that is {:.3g} off", off));
  row.forward = glm::normalize(front);
  row.up = curve::perpendicular(row.forward, up);
  return true;
}

// Detects a file that was truncated within its last number: the number is valid, but has fewer than the format's six
// decimals.
bool check_cut(Nl2CsvReader& r, const Cells& cells) {
  if (r.data_rows == 0) {
    r.first_decimals = decimals(cells[1]);
    for (std::size_t i = 2; i + 1 < cells.size(); ++i)
      r.first_decimals = std::min(r.first_decimals, decimals(cells[i]));
  }
  if (r.lines.ended() || r.first_decimals != 6 || decimals(cells.back()) >= 6) return true;
  return r.fail("a last number with 6 decimals", base::quoted_start(cells.back()) + ": the file is truncated");
}

}  // namespace

bool read_first_line(Nl2CsvReader& r, std::string_view line) {
  return find_separator(r, line) && (is_row(r, line) ? read_row(r, line) : read_header(r, line));
}

bool read_row(Nl2CsvReader& r, std::string_view line) {
  Cells cells;
  const std::size_t count = split(line, r.separator.mark, cells);
  if (count != kColumns.size())
    return r.fail(fmt::format("13 columns, separated by {}", r.separator.name),
                  count > kColumns.size() ? "more" : std::to_string(count));
  if (r.data_rows >= kMaxNl2Rows) return r.fail(fmt::format("at most {} rows", kMaxNl2Rows), "more");
  const auto number = base::parse_int(cells[0]);
  if (r.data_rows == 0 && number == 0) r.first_number = 0;
  const auto expected = r.first_number + static_cast<std::int64_t>(r.data_rows);
  if (!number || *number != expected)
    return r.fail(fmt::format("the row's number {}", expected), base::quoted_start(cells[0]));
  sim::FitRow row;
  if (!read_vector(r, cells, 1, r.limit, row.position, r.positions) || !read_frame(r, cells, row) ||
      !check_cut(r, cells))
    return false;
  ++r.data_rows;
  if (!r.rows.empty() && glm::distance(r.rows.back().position, row.position) <= kSamePlace) {
    r.warn(r.lines.number(), "the row repeats the previous position; left out");
    return true;
  }
  r.rows.push_back(row);
  r.row_lines.push_back(r.lines.number());
  return true;
}

bool starts_far(std::string_view text) {
  Nl2CsvReader r{.name = {}, .lines = Lines(text), .limit = Nl2CsvReader::kAnywhere};
  std::string_view line;
  if (!r.lines.next(line) || !read_first_line(r, line)) return false;
  if (r.rows.empty() && !(r.lines.next(line) && read_row(r, line))) return false;
  return glm::length(r.rows[0].position) > kFar;
}

}  // namespace coaster::exchange
