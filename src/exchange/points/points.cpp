// Reads the rows of a list, and proposes what its numbers mean.
#include "exchange/points/points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "base/words.h"
#include "exchange/nolimits/nl2_csv_lines.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;
using Row = std::array<std::string_view, 3>;

// Splits a row at blanks, commas and semicolons; one at its end counts for nothing. Returns the number of cells.
std::size_t split_row(std::string_view line, Row& cells) {
  const auto skip_blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  std::size_t count = 0;
  for (line = line.substr(0, line.find('#')); !line.empty(); ++count) {
    const std::size_t end = std::min(line.find_first_of(" \t,;"), line.size());
    if (count < cells.size()) cells[count] = content(line.substr(0, end));
    line.remove_prefix(end), skip_blanks();
    if (line.starts_with(',') || line.starts_with(';')) line.remove_prefix(1), skip_blanks();
  }
  return count;
}

struct PointReader {
  std::string_view name;
  Lines lines;
  std::array<std::size_t, 3> columns{0, 1, 2};  // of x, y and z
  std::optional<std::int64_t> count;            // a number alone in the first row
  std::size_t rows = 0;
  PointList list;
  std::string error;

  bool fail(std::string_view expected, std::string_view found) {
    error = fmt::format("{}:{}: error: expected {}, found {}", name, lines.number(), expected, found);
    return false;
  }
};

// Reads a row above the first point: a count, or names. Returns false if it is neither.
bool read_head(PointReader& r, std::string_view line) {
  Row cells;
  const std::size_t count = split_row(line, cells);
  if (const auto number = count == 1 && !r.count ? base::parse_int(cells[0]) : std::nullopt)
    return r.count = number, true;
  if (count != 3 || std::any_of(cells.begin(), cells.end(), base::is_number)) return false;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i)
      if (base::lower(cells[i]) == std::string_view("xyz").substr(axis, 1)) r.columns[axis] = i;
  return true;
}

bool read_point(PointReader& r, std::string_view line) {
  Row cells;
  if (const std::size_t count = split_row(line, cells); count != 3)
    return r.fail("a row of three numbers: x, y and z",
                  count == 1 ? base::quoted_start(cells[0]) : fmt::format("one of {}", count));
  if (r.rows++ >= kMaxPoints) return r.fail(fmt::format("at most {} points", kMaxPoints), "more");
  dvec3 point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view cell = cells[r.columns[axis]];
    const auto number = base::parse_double(cell);
    if (!number) return r.fail("three finite numbers", base::quoted_number(cell));
    point[static_cast<int>(axis)] = *number;
  }
  std::vector<dvec3>& points = r.list.points;
  if (!points.empty() && points.back() == point) return ++r.list.repeated, true;
  points.push_back(point);
  return true;
}

// Finds bounds and length, and whether the ends meet: at one point, or one usual step apart in the direction of travel.
void measure(PointList& list) {
  std::vector<dvec3>& p = list.points;
  if (p.size() > 3 && p.front() == p.back()) p.pop_back(), list.closed = true;
  list.low = list.high = p[0];
  std::vector<double> steps;
  for (std::size_t i = 0; i < p.size(); ++i) {
    list.low = glm::min(list.low, p[i]), list.high = glm::max(list.high, p[i]);
    if (i > 0) steps.push_back(glm::distance(p[i - 1], p[i])), list.length += steps.back();
  }
  const dvec3 gap = p.front() - p.back();
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  constexpr double kUsual = 1.5;  // times the median step
  list.closed = list.closed || (p.size() > 3 && glm::length(gap) <= kUsual * *middle &&
                                glm::dot(gap, p[1] - p[0]) >= 0 && glm::dot(gap, p.back() - p[p.size() - 2]) >= 0);
  if (list.closed) list.length += glm::length(gap);
}

}  // namespace

base::Result<PointList> read_points(std::string_view text, std::string_view name) {
  PointReader r{.name = name, .lines = Lines(text)};
  const auto failed = [&] { return base::Status{base::Code::bad_file, r.error}; };
  for (std::string_view line; r.lines.next(line);)
    if ((r.rows > 0 || !read_head(r, line)) && !read_point(r, line)) return failed();
  if (r.count && *r.count != static_cast<std::int64_t>(r.rows))
    return r.fail(fmt::format("{} points, the number in the first row", *r.count), std::to_string(r.rows)), failed();
  if (r.list.points.size() < 2)
    return r.fail("at least 2 points at different places", std::to_string(r.list.points.size())), failed();
  measure(r.list);
  return std::move(r.list);
}

bool is_points(std::string_view text, bool sure) {
  PointReader r{.name = {}, .lines = Lines(text)};
  Row cells;
  std::string_view line;
  if (!sure) return r.lines.next(line) && (split_row(line, cells) == 3 || (read_head(r, line) && r.count));
  while (r.lines.next(line))
    if (!read_head(r, line)) return read_point(r, line);
  return false;
}

Import proposed(const PointList& list, Import import) {
  constexpr double kMuch = 1.5, kShortest = 30, kLongest = 20'000, kHighest = 600, kGood = 300;  // m
  const dvec3 size = list.high - list.low;
  if (!import.up) {
    const bool profile = size.z == 0 && !list.closed;
    import.up = size.y > kMuch * size.z && !profile ? world::Axis::z : world::Axis::y;
  }
  if (import.scale) return import;
  const double height = std::abs(with_y_up(size, *import.up).y);
  double& scale = import.scale.emplace(1);
  if (list.length >= kShortest && list.length <= kLongest && height <= kHighest) return import;
  while (list.length * scale < kGood && scale < kMostScale) scale *= 10;
  while (list.length * scale >= 10 * kGood && scale > 1 / kMostScale) scale /= 10;
  return import;
}

dvec3 with_y_up(dvec3 of_file, world::Axis up) {
  if (up == world::Axis::x) return {-of_file.y, of_file.x, of_file.z};
  return up == world::Axis::z ? dvec3(of_file.x, of_file.z, -of_file.y) : of_file;
}

}  // namespace coaster::exchange
