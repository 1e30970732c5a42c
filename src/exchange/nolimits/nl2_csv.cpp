// Checks the rows of a NoLimits 2 CSV, and fits a track to them.
#include "exchange/nolimits/nl2_csv.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/interrupted.h"
#include "base/text.h"
#include "exchange/nolimits/nl2_csv_read.h"
#include "exchange/own/import.h"
#include "sim/fit/fit_track.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

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

}  // namespace

base::Result<LoadedTrack> parse_nl2_csv(std::string_view text, std::string_view name, bool origin) {
  Nl2CsvReader r{.name = name, .lines = Lines(text)};
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
  const auto tell = [&](const sim::Doubt& doubt, double most, std::string_view what) {
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

}  // namespace coaster::exchange
