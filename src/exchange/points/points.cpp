// Reads the rows of a list, proposes what its numbers mean, and makes a track of it: places it, smooths it if asked to,
// and finds directions and rolls.
#include "exchange/points/points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/text.h"
#include "curve/natural_spline.h"
#include "exchange/nolimits/delimited_text.h"
#include "sim/fit/fit_track.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

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
  LineReader lines;
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

using Points = std::vector<dvec3>;
constexpr double kSteep = 0.9;      // of the tangent: steeper than 64 degrees, where the horizon is no measure of roll
constexpr double kLoopTop = 60;     // m: shorter track between two steep parts that turn it over is the top of a loop
constexpr double kStillFit = 0.01;  // m of the distance for smoothing: what the fit takes

// Scales and turns the points, moves them to the origin if asked to, and checks where they are.
base::Status place(Points& p, std::string_view name, const ImportOptions& import, std::string& note) {
  for (dvec3& point : p) point = with_y_up(point, *import.up) * *import.scale;
  if (import.origin) {
    const dvec3 way = way_to_origin(p, std::identity());
    for (dvec3& point : p) point += way;
    note = ' ' + moved_text(way);
  }
  for (const dvec3& point : p)
    if (!glm::all(glm::lessThanEqual(glm::abs(point), dvec3(world::kMaxCoordinate))))
      return {base::Code::bad_file,
              fmt::format("{}: error: expected {}, found ({:.6g}, {:.6g}, {:.6g}) m: {}", name,
                          within_text(world::kMaxCoordinate), point.x, point.y, point.z,
                          import.origin ? "give another scale" : "load it with the word origin, or another scale")};
  return {};
}

// Leaves out points that are too near to the one before; ends stay. Returns how many.
std::size_t thin(Points& p, bool closed) {
  const dvec3 end = p.back();
  const std::size_t count = p.size();
  std::size_t kept = 1;
  for (const dvec3 point : p)
    if (glm::distance(p[kept - 1], point) >= kNearest) p[kept++] = point;
  if (closed)
    while (kept > 1 && glm::distance(p[kept - 1], p[0]) < kNearest) --kept;
  p.resize(kept);
  if (!closed && kept > 1) p.back() = end;
  return count - kept;
}

// Lengths of the steps from each point to the next, m; closed: from the last to the first, too.
std::vector<double> steps_of(const Points& p, bool closed) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < p.size(); ++i)
    steps.push_back(glm::distance(p[i], p[(i + 1) % p.size()]));
  return steps;
}

// Returns the points without waves that are short against `reach` m: each of two passes takes away a share 1 / (1 +
// (reach / wave)^2), and what the first one took from the long waves, too, comes back. Ends stay.
Points low_pass(const Points& p, const std::vector<double>& steps, bool closed, double reach) {
  const std::size_t n = p.size();
  const auto pass = [&](const Points& from) {
    std::vector<curve::TridiagonalRow> rows(n);
    for (std::size_t i = 0; i < n; ++i) {
      rows[i].right = from[i];
      if (!closed && (i == 0 || i + 1 == n)) continue;
      const double before = steps[(i + n - 1) % n], after = steps[i], share = 2 * reach * reach / (before + after);
      rows[i].below = -share / before, rows[i].above = -share / after;
      rows[i].middle = 1 - rows[i].below - rows[i].above;
    }
    return curve::solve_tridiagonal(std::move(rows), closed);
  };
  const Points once = pass(p), twice = pass(once);
  Points smooth(n);
  for (std::size_t i = 0; i < n; ++i) smooth[i] = 2.0 * once[i] - twice[i];
  return smooth;
}

double most_apart(const Points& a, const Points& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, glm::distance(a[i], b[i]));
  return most;
}

// Returns the points as smooth as they can be within `most` m.
Points smoothed(const Points& p, bool closed, double most) {
  constexpr int kTries = 24;
  const std::vector<double> steps = steps_of(p, closed);
  Points best = p;
  double low = 0.1, high = 0;  // m
  for (int i = 0; i < kTries && !(high > 0 && high < 1.02 * low) && !base::interrupted(); ++i) {
    const double reach = high > 0 ? std::sqrt(low * high) : 2 * low;
    Points tried = low_pass(p, steps, closed, reach);
    if (most_apart(tried, p) > most) high = reach;
    else low = reach, best = std::move(tried);
  }
  return best;
}

// Returns up vectors that follow the horizon where the track is not steep, and are carried along where it is. The top
// of a loop, between two steep parts, is upside down.
Points level_ups(const Points& p, const Points& forwards) {
  const auto steep = [&](std::size_t i) { return std::abs(forwards[i].y) > kSteep; };
  Points ups;
  bool over = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const dvec3 level = curve::perpendicular(forwards[i], {0, 1, 0});
    if (i > 0 && (steep(i) || steep(i - 1))) {
      ups.push_back(curve::transport({forwards[i - 1], ups[i - 1]}, p[i - 1], p[i], forwards[i]).up);
      if (steep(i)) continue;
      std::size_t next = i;
      for (double top = 0; next + 1 < p.size() && !steep(next) && top < kLoopTop; ++next)
        top += glm::distance(p[next], p[next + 1]);
      over = glm::dot(ups[i], level) < 0 && steep(next);
      ups.pop_back();
    }
    ups.push_back(over ? -level : level);
  }
  return ups;
}

// Makes a knot at each point.
void add_knots(const Points& p, bool closed, world::Document& document) {
  const std::size_t n = p.size();
  std::vector<world::Knot> knots(n);
  Points forwards;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::vec3 before(p[(i + n - 1) % n]), after(p[(i + 1) % n]);
    const bool comes = closed || i > 0, goes = closed || i + 1 < n;
    knots[i].position = glm::vec3(p[i]);
    world::shape_between(knots[i], comes ? &before : nullptr, goes ? &after : nullptr);  // right at open ends
    if (comes && goes)
      knots[i].in_length = knots[i].out_length = world::as_handle(glm::distance(dvec3(before), dvec3(after)) / 6);
    forwards.push_back(glm::normalize(dvec3(knots[i].tangent)));
  }
  const Points ups = level_ups(p, forwards);
  for (std::size_t i = 0; i < n; ++i) {
    knots[i].up = glm::vec3(ups[i]);
    world::orthonormalise(knots[i]);
    world::append_knot(document, knots[i]);
  }
  if (closed) world::set_closed(document, true);
  sim::set_automatic_spins(document);
}

// Fits a track to the smoothed list. Returns the most that it may leave the points by, m.
double fit_knots(const Points& given, bool closed, double most, world::Document& document) {
  const Points p = smoothed(given, closed, most - kStillFit);
  Points forwards = curve::spline_derivatives({p, steps_of(p, closed), {}, {}, closed});
  for (dvec3& forward : forwards) forward = glm::normalize(forward);
  const Points ups = level_ups(p, forwards);
  std::vector<sim::FitRow> rows;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (rows.empty() || glm::distance(rows.back().position, p[i]) > 1e-5) rows.push_back({p[i], forwards[i], ups[i]});
  sim::FittedTrack fitted = sim::fit_track(rows, closed);
  document = std::move(fitted.document);
  return most_apart(p, given) + fitted.report.max_error;
}

}  // namespace

base::Result<PointList> read_points(std::string_view text, std::string_view name) {
  PointReader r{.name = name, .lines = LineReader(text)};
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
  PointReader r{.name = {}, .lines = LineReader(text)};
  Row cells;
  std::string_view line;
  if (!sure) return r.lines.next(line) && (split_row(line, cells) == 3 || (read_head(r, line) && r.count));
  while (r.lines.next(line))
    if (!read_head(r, line)) return read_point(r, line);
  return false;
}

ImportOptions proposed(const PointList& list, ImportOptions import) {
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

base::Result<LoadedTrack> parse_points(std::string_view text, std::string_view name, const ImportOptions& import) {
  base::Result<PointList> list = read_points(text, name);
  if (!list) return list.status();
  const ImportOptions as = proposed(*list, import);
  const auto wrong = [&](const std::string& words) {
    return base::Status{base::Code::bad_file, fmt::format("{}: error: {}", name, words)};
  };
  if (!(*as.scale >= 1 / kMostScale && *as.scale <= kMostScale))
    return wrong(fmt::format("expected a scale of {:g} to {:g}, found {}", 1 / kMostScale, kMostScale,
                             base::to_text(*as.scale)));
  if (as.smooth && !(*as.smooth >= kLeastSmooth && *as.smooth <= kMostSmooth))
    return wrong(fmt::format("expected smoothing within {:g} to {:g} m, found {}", kLeastSmooth, kMostSmooth,
                             base::to_text(*as.smooth)));
  Points& points = list->points;
  const std::size_t count = points.size();
  LoadedTrack loaded;
  std::string moved;
  if (const base::Status placed = place(points, name, as, moved); !placed) return placed;
  const std::size_t near = thin(points, list->closed);
  if (points.size() < 2)
    return wrong(fmt::format("all points are within {} m at a scale of {}", kNearest, base::to_text(*as.scale)));
  const bool closed = list->closed && points.size() > 2;
  ImportReport& report = loaded.import.emplace();
  if (as.smooth) report.max_error = fit_knots(points, closed, *as.smooth, loaded.document);
  else add_knots(points, closed, loaded.document);
  if (base::interrupted()) return base::Status{base::Code::refused, std::string(name) + ": the import was cancelled"};
  report.knots = static_cast<int>(loaded.document.track.knots.size());
  loaded.document.name = name_of_file(name);
  loaded.note = fmt::format("{} points, {}: {} up{}, {} m a unit{}.", count, closed ? "closed" : "open",
                            base::row_of(*as.up).label, import.up ? "" : " (proposed)", base::to_text(*as.scale),
                            import.scale ? "" : " (proposed)");
  if (list->repeated > 0)
    loaded.note += fmt::format(" Left out {} repeated {}.", list->repeated, list->repeated == 1 ? "point" : "points");
  if (near > 0)
    loaded.note += fmt::format(" Left out {} {} nearer than {} m to the one before.", near,
                               near == 1 ? "point" : "points", kNearest);
  if (as.smooth)
    loaded.note += fmt::format(" {} knots, at most {:.3f} m from the points.", report.knots, report.max_error);
  loaded.note += moved;
  return loaded;
}

}  // namespace coaster::exchange
