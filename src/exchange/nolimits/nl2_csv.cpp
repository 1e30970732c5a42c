// Reads and checks the rows of a NoLimits 2 CSV, fits a track to them, and prints the rows of a track.
#include "exchange/nolimits/nl2_csv.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/check.h"
#include "base/text.h"
#include "exchange/nolimits/delimited_text.h"
#include "exchange/nolimits/nl2_spline.h"
#include "exchange/own/import_options.h"
#include "sim/fit/fit_track.h"
#include "sim/fit/sample_dequantisation.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

// Returns how many decimals a number is written with.
std::size_t decimals(std::string_view number) {
  const std::size_t mark = number.find_first_of(".,");
  return mark == std::string_view::npos ? 0 : number.size() - mark - 1;
}

// Reads a file's numbers. The first one with decimals decides whether these follow a point or a comma.
struct DecimalReader {
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
struct DecimalCount {
  static constexpr int kMost = 6;
  static constexpr double kTens[]{1, 10, 100, 1e3, 1e4, 1e5, 1e6};
  int count = 0;
  void add(double number) {
    constexpr double kNoise = 1e-8;  // of numbers that a program has calculated with
    while (count < kMost && std::abs(number * kTens[count] - std::round(number * kTens[count])) > kNoise * kTens[count])
      ++count;
  }
  double step() const { return 1 / kTens[count]; }
};

// Returns whether an axis has float numbers only, as far as they can be read from so many decimals.
bool floats(std::span<const sim::FitRow> rows, int axis, double decimal_step) {
  return std::all_of(rows.begin(), rows.end(), [&](const sim::FitRow& row) {
    const double at = row.position[axis];
    return std::abs(at - static_cast<double>(static_cast<float>(at))) <= 0.51 * decimal_step;
  });
}

// Returns the steps that the rows are rounded to, 0 for finer ones than 4 decimals: that of the decimals, or, of
// positions, that of float numbers as large as the largest, if all of an axis are such numbers.
sim::RowSteps row_steps(std::span<const sim::FitRow> rows, const DecimalCount& positions,
                        const DecimalCount& directions) {
  const auto coarse = [](double step) { return step > 0.99e-4 ? step : 0; };  // finer steps are not felt
  double step = positions.step();
  for (int axis = 0; axis < 3; ++axis)
    if (const double spacing = sim::float_spacing(rows, axis);
        spacing > 2 * positions.step() && floats(rows, axis, positions.step()))
      step = std::max(step, spacing);
  return {coarse(step), coarse(directions.step())};
}

// Returns the warning that names the steps, what they do, and what to do.
std::string told_steps(const sim::RowSteps& steps) {
  std::string told;
  if (steps.position > 0) told = fmt::format("positions are rounded to steps of {:.3g} m", steps.position);
  if (steps.direction > 0)
    told += fmt::format("{}directions are rounded to steps of {:.3g}", told.empty() ? "" : ", ", steps.direction);
  return told + ": followed only within the steps, because riders would feel them as jolts; export with six decimals";
}

constexpr double kSamePlace = 2e-6;  // m: rounding of printed positions

struct Nl2CsvReader {
  static constexpr double kAnywhere = 1e9;  // m
  std::string_view name;
  LineReader lines;
  std::vector<sim::FitRow> rows;
  std::vector<int> row_lines;  // of each row
  std::vector<std::string> warnings;
  std::size_t more_warnings = 0;  // number of omitted warnings
  Separator separator = kSeparators[0];
  std::size_t data_rows = 0;
  std::int64_t first_number = 1;         // of the rows: 0 or 1
  std::size_t first_decimals = 0;        // the fewest decimals of the first row's numbers
  double limit = world::kMaxCoordinate;  // m, of positions
  DecimalReader mark;
  DecimalCount positions, directions;
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

bool read_vector(Nl2CsvReader& r, const Cells& cells, std::size_t first, double limit, dvec3& v,
                 DecimalCount& decimals) {
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
  DecimalCount own;
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

// Read the first line, a header or a row, and each one after it. Return false with `error` if the line is refused.
bool read_first_line(Nl2CsvReader& r, std::string_view line) {
  return find_separator(r, line) && (is_row(r, line) ? read_row(r, line) : read_header(r, line));
}

constexpr double kWrong = 0.75;     // of the steps against Front or off it: the rows are refused
constexpr double kRollDoubt = 0.4;  // g: what riders may feel more or less before it is reported
constexpr double kBendDoubt = 0.8;  // the same of bends, whose figure is up to 16 times the error
constexpr double kNoisySpan = 1;    // m a span on average: smooth rows of a whole track never need so many
constexpr int kNoisyKnots = 20;     // the least number of knots for that
constexpr double kGap = 3;          // times the usual spacing: longer steps are reported

// Takes the rounding off the rows, and closes them; `given` are then those of the file. Then only repeats are warned
// of.
void take_rounding_off(Nl2CsvReader& r) {
  r.steps = row_steps(r.rows, r.positions, r.directions);
  r.closed = r.steps.rounded() && sim::rows_close(r.rows, kSamePlace + 2 * r.steps.position);
  const bool repeated = r.closed && r.rows.front().position == r.rows.back().position;
  sim::UnroundedRows smooth =
      sim::unrounded_rows(std::span(r.rows).first(r.rows.size() - (repeated ? 1 : 0)), r.closed, r.steps);
  if (!r.steps.rounded()) return;
  std::vector<int> lines;
  for (const std::size_t from : smooth.from) r.given.push_back(r.rows[from]), lines.push_back(r.row_lines[from]);
  r.rows = std::move(smooth.rows), r.row_lines = std::move(lines);
  r.warnings.clear(), r.more_warnings = 0;
  r.warn(r.row_lines[0], told_steps(r.steps));
}

// Checks that rows follow each other in the direction of Front; warns of steps that do not, of gaps and of jumps.
bool check_steps(Nl2CsvReader& r) {
  std::vector<double> lengths;
  std::vector<int> against, off;  // lines of rows whose step from the previous one is against, or off, both directions
  for (std::size_t i = 1; i < r.rows.size(); ++i) {
    const sim::FitRow &a = r.rows[i - 1], &b = r.rows[i];
    const dvec3 step = b.position - a.position;
    lengths.push_back(glm::length(step));
    if (glm::dot(step, a.forward) < 0 && glm::dot(step, b.forward) < 0) against.push_back(r.row_lines[i]);
    if (const double degrees = sim::off_deg(a, b); degrees > 0) {
      off.push_back(r.row_lines[i]);
      r.warn(off.back(), fmt::format("the step from the previous row is {:.0f} degrees off Front", degrees));
    }
  }
  const auto refuse = [&](const std::vector<int>& lines, std::string_view expected, std::string_view remedy) {
    r.error = fmt::format("{}:{}: error: expected {}, found {} of {} steps {}", r.name, lines[0], expected,
                          lines.size(), lengths.size(), remedy);
    return false;
  };
  if (against.size() > kWrong * static_cast<double>(lengths.size()))
    return refuse(against, "rows in the direction of Front",
                  "against it: reverse the order of the rows, or Front and Left");
  if (off.size() > kWrong * static_cast<double>(lengths.size()))
    return refuse(
        off, "steps from row to row along Front",
        fmt::format("over {} degrees off it: check axes and columns; Y and Z may be swapped in positions alone",
                    sim::kOffForward));
  std::vector<double> sorted = lengths;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const std::vector<double> jumps = sim::row_jumps(r.rows, false);
  for (std::size_t i = 1; i < r.rows.size(); ++i) {
    if (lengths[i - 1] > kGap * *middle)
      r.warn(r.row_lines[i], fmt::format("a gap of {:.3f} m from the previous row; the usual spacing is {:.3f} m",
                                         lengths[i - 1], *middle));
    if (jumps[i - 1] > 0)
      r.warn(r.row_lines[i], fmt::format("the frame jumps by {:.2f} degrees from the previous row, over {:.3f} m",
                                         jumps[i - 1], lengths[i - 1]));
  }
  return true;
}

// Warns of rows with Up mostly along Z although Front turns in the plane of X and Y: those of a program with Z up.
void check_axes(Nl2CsvReader& r) {
  constexpr double kUpright = 0.6, kTurns = 0.2;  // Z of the mean Up; X and Y of Front, root mean square
  dvec3 up(0), squares(0);
  for (const sim::FitRow& row : r.rows) up += row.up, squares += row.forward * row.forward;
  const auto count = static_cast<double>(r.rows.size());
  if (std::abs(up.z) > kUpright * count && std::min(squares.x, squares.y) > kTurns * kTurns * count)
    r.warn(r.row_lines[0],
           "Up is mostly along Z, but the format has Y up: if the file has Z up, write (x, z, -y) for each (x, y, z), "
           "in positions and vectors");
}

bool read_rows(Nl2CsvReader& r) {
  std::string_view line;
  if (!r.lines.next(line)) {
    r.error = std::string(r.name) + ":1: error: expected the header \"No.\" \"PosX\" ..., found an empty file";
    return false;
  }
  if (!read_first_line(r, line)) return false;
  while (r.lines.next(line))
    if (!read_row(r, line)) return false;
  take_rounding_off(r);
  if (r.rows.size() < 2) return r.fail("at least 2 rows at different positions", std::to_string(r.rows.size()));
  check_axes(r);
  return check_steps(r);
}

void print_number(std::string& out, double value) { fmt::format_to(std::back_inserter(out), "\t{:.6f}", value); }

void print_row(std::string& out, std::size_t number, dvec3 position, const curve::Frame& frame) {
  out += std::to_string(number);
  for (const dvec3& v : {position, frame.forward, frame.left(), frame.up})
    for (int axis = 0; axis < 3; ++axis) print_number(out, v[axis]);
  out += '\n';
}

}  // namespace

bool starts_far(std::string_view text) {
  Nl2CsvReader r{.name = {}, .lines = LineReader(text), .limit = Nl2CsvReader::kAnywhere};
  std::string_view line;
  if (!r.lines.next(line) || !read_first_line(r, line)) return false;
  if (r.rows.empty() && !(r.lines.next(line) && read_row(r, line))) return false;
  return glm::length(r.rows[0].position) > kFar;
}

base::Result<LoadedTrack> parse_nl2_csv(std::string_view text, std::string_view name, bool origin) {
  Nl2CsvReader r{.name = name, .lines = LineReader(text)};
  if (origin) r.limit = Nl2CsvReader::kAnywhere;
  if (!read_rows(r)) return base::Status{base::Code::bad_file, r.error};
  const bool rounded = r.steps.rounded(), closed = rounded ? r.closed : sim::rows_close(r.rows);
  std::string moved;
  if (origin) {
    const dvec3 move = way_to_origin(r.rows, &sim::FitRow::position);
    for (auto* const rows : {&r.rows, &r.given})
      for (sim::FitRow& row : *rows) row.position += move;
    moved = moved_text(move);
  }
  const bool repeated =
      !rounded && r.rows.size() > 4 && glm::distance(r.rows.front().position, r.rows.back().position) <= kSamePlace;
  if (closed && repeated) r.rows.pop_back();
  sim::FittedTrack fitted = sim::fit_track(r.rows, closed, r.given, r.steps.position);
  if (base::interrupted()) return base::Status{base::Code::refused, std::string(name) + ": the import was cancelled"};
  LoadedTrack loaded;
  loaded.note = moved;
  loaded.reshaped = rounded;
  loaded.document = std::move(fitted.document);
  loaded.document.name = name_of_file(name);
  world::add_cart(loaded.document, loaded.document.track.segments[0], 0);
  const sim::FitReport& report = fitted.report;
  const auto tell = [&](const sim::FeltUncertainty& doubt, double most, std::string_view what) {
    if (doubt.g > most)
      r.warn(
          r.row_lines[doubt.row],
          fmt::format("the rows are too far apart for the {} here: riders may feel {:.1f} g more or less than on the "
                      "track they were taken from",
                      what, doubt.g));
  };
  tell(report.roll_doubt, kRollDoubt, "roll"), tell(report.bend_doubt, kBendDoubt, "bends");
  const double span = world::exact_length(loaded.document) / report.knots;
  if (report.knots >= kNoisyKnots && span < kNoisySpan)
    r.warn(r.row_lines[0],
           fmt::format("the rows are noisy: the fit needs {} knots, one every {:.2f} m, and riders feel "
                       "the noise; smooth positions and Front alike",
                       report.knots, span));
  loaded.warnings = std::move(r.warnings);
  if (r.more_warnings > 0) loaded.warnings.push_back(fmt::format("{}: {} more warnings", name, r.more_warnings));
  loaded.import = ImportReport{report.max_error,  report.frame_error,      report.knots,
                               report.jump_error, report.distances.root(), report.angles.root()};
  return loaded;
}

base::Status check_nl2_csv(const world::Document& document, double spacing) {
  if (document.track.segments.empty())
    return {base::Code::refused, "error: expected a track with segments, found none"};
  const double length = world::exact_length(document);
  if (!(length / spacing < static_cast<double>(kMaxNl2Rows - 1)))
    return {base::Code::refused,
            fmt::format("error: expected at most {} rows, found {} m of track", kMaxNl2Rows, base::to_text(length))};
  return {};
}

std::string print_nl2_csv(const world::Document& document, double spacing) {
  COASTER_CHECK(spacing > 0 && check_nl2_csv(document, spacing).ok(), "callers check the track first");
  const sim::DerivedTrack derived = sim::shapes_of(document);
  std::string out;
  for (const std::string_view column : kNl2Columns) out += fmt::format("{}{}\"", out.empty() ? "\"" : "\t\"", column);
  out += '\n';
  std::size_t number = 0;
  const auto row_at = [&](double s) {
    const PlaceOnTrack at = place_on(derived, s);
    print_row(out, ++number, at.position, at.frame);
  };
  // A remainder that would print as the same position gets no row.
  constexpr double kShortest = 1e-5;  // m
  for (double s = 0; s < derived.length - kShortest; s = static_cast<double>(number) * spacing) row_at(s);
  if (!derived.closed) row_at(derived.length);
  return out;
}

}  // namespace coaster::exchange
