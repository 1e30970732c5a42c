#include "sim/fit/sample_span_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/shape/roll.h"
#include "world/components.h"
#include "world/motion.h"

namespace coaster::sim {

using glm::dvec2;

void clip(RollWindow& polygon, dvec2 normal, double limit, RollWindow& spare) {
  constexpr double kRounding = 1e-12;  // radians
  bool all = true;
  for (const dvec2 p : polygon) all = all && glm::dot(normal, p) <= limit + kRounding;
  if (all) return;
  spare.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double x = glm::dot(normal, a) - limit, y = glm::dot(normal, b) - limit;
    if (x <= 0) spare.push_back(a);
    if ((x < 0 && y > 0) || (x > 0 && y < 0)) spare.push_back(a + (x / (x - y)) * (b - a));
  }
  polygon.swap(spare);
}

RollRange second_rolls(const RollWindow& window) {
  RollRange range;
  for (const glm::dvec2 p : window) range.low = std::min(range.low, p.y), range.high = std::max(range.high, p.y);
  return range;
}

double first_roll(const RollWindow& window, double second, double wanted) {
  double low = 1, high = -1;
  const auto take = [&](double x) { low = std::min(low, x), high = std::max(high, x); };
  const glm::dvec2* nearest = nullptr;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const glm::dvec2 &a = window[i], &b = window[i + 1 < window.size() ? i + 1 : 0];
    if (!nearest || std::abs(a.y - second) < std::abs(nearest->y - second)) nearest = &a;
    if (a.y == second) take(a.x);
    if ((a.y < second && b.y > second) || (a.y > second && b.y < second))
      take(a.x + (second - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  if (low > high) return nearest ? nearest->x : wanted;  // rounding has put `second` just outside
  return std::clamp(wanted, low, high);
}

using glm::dvec2, glm::dvec3;

namespace {

constexpr std::size_t kFittedRows = 40;  // rows that handle lengths are fitted to
constexpr int kIterations = 12;
constexpr double kMostHandle = 0.495;  // of the rows' length: a little less than half the curve's
constexpr double kBeyond = 40;         // weight of curvature beyond the limit, relative to that of a deviation
constexpr double kStay = 1e-3;  // 1/m: weight of a change of the handles by the length, relative to that of a deviation
using Curve = curve::CoefficientsD;

// Returns the shortest and the longest handle of a span over so many metres of rows, within a knot's limits.
double least_handle(const SpanEnds& ends, double length) {
  return std::clamp<double>(ends.least_handle * length, world::kMinHandle, world::kMaxHandle);
}
double most_handle(const SpanEnds& ends, double length) {
  return std::clamp<double>(kMostHandle * length, least_handle(ends, length), world::kMaxHandle);
}

}  // namespace

Curve curve_of(const SpanEnds& e, Handles h) {
  const dvec3 d0 = h.out * e.t0, p1 = e.p0 + d0, p2 = e.p3 - h.in * e.t3, d1 = p2 - p1, d2 = e.p3 - p2;
  return {e.p0, 3.0 * d0, 3.0 * (d1 - d0), (d2 - d1) - (d1 - d0)};
}

double nearer(const Curve& c, dvec3 target, double t, int steps) {
  for (int i = 0; i < steps; ++i) {
    const dvec3 d = c.derivative(t), off = c.point(t) - target;
    const double speed = glm::dot(d, d), slope = speed + glm::dot(off, c.second_derivative(t));
    const double step = glm::dot(off, d) / (slope > 0.1 * speed ? slope : std::max(speed, 1e-30));
    t = std::clamp(t - std::clamp(step, -0.2, 0.2), 0.0, 1.0);
    if (std::abs(step) < 1e-9) break;
  }
  return t;
}

dvec3 bend_of(const Curve& c, double t) {
  const dvec3 d = c.derivative(t);
  const double speed = std::max(glm::length(d), 1e-15);
  return curve::across(c.second_derivative(t), d / speed) / (speed * speed);
}

Handles fit_handles(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first,
                    std::size_t last, const SpanEnds& ends, std::vector<double>& parameters,
                    std::vector<double>& stations) {
  const double length = std::max(distances[last] - distances[first], 1e-9);
  const std::size_t inner = std::min(last - first - 1, kFittedRows);
  parameters.resize(inner + 2), stations.resize(inner + 2);
  const auto row_of = [&](std::size_t k) { return first + (last - first) * k / (inner + 1); };
  for (std::size_t k = 0; k < inner + 2; ++k)
    parameters[k] = stations[k] = (distances[row_of(k)] - distances[first]) / length;
  const double low = least_handle(ends, length), high = most_handle(ends, length);
  // Without rows between the ends: the handles of a circle through both.
  const double third = inner > 0 ? length / 3 : length / (1.5 + 0.75 * glm::length(ends.t0 + ends.t3));
  Handles h{std::clamp(third, low, high), std::clamp(third, low, high)};
  for (int iteration = 0; iteration < kIterations && inner > 0; ++iteration) {
    const Curve c = curve_of(ends, h);
    double a00 = 0, a01 = 0, a11 = 0, x0 = 0, x1 = 0, weight = 0;
    for (std::size_t k = 1; k <= inner; ++k) {
      const double t = parameters[k] = nearer(c, rows[row_of(k)].position, parameters[k], 2), u = 1 - t;
      const dvec3 d = c.derivative(t), off = rows[row_of(k)].position - c.point(t);
      const double speed = std::max(glm::dot(d, d), 1e-30);
      const auto across = [&](dvec3 v) { return v - (glm::dot(v, d) / speed) * d; };
      const dvec3 g0 = across(3 * t * u * u * ends.t0), g1 = across(-3 * t * t * u * ends.t3);
      a00 += glm::dot(g0, g0), a01 += glm::dot(g0, g1), a11 += glm::dot(g1, g1);
      x0 += glm::dot(g0, off), x1 += glm::dot(g1, off);
      weight += 9 * t * t * u * u;
    }
    // Slight damping: on a straight the lengths have no effect and stay.
    const double damping = 1e-7 * weight + 1e-12;
    a00 += damping, a11 += damping;
    const double determinant = a00 * a11 - a01 * a01;
    const double limit = 0.2 * length;
    const auto held = [&](double from, double by) {
      return std::clamp(from + std::clamp(by, -limit, limit), low, high) - from;
    };
    // A handle that is held at its bound leaves the other one to fit the rows.
    double out = held(h.out, (a11 * x0 - a01 * x1) / determinant);
    const double in = held(h.in, (x1 - a01 * out) / a11);
    out = held(h.out, (x0 - a01 * in) / a00);
    h = {h.out + out, h.in + in};
    if (std::max(std::abs(out), std::abs(in)) < 1e-4 * length) break;
  }
  return h;
}

Handles most_alike(const SpanEnds& ends, double length, dvec3 from, dvec3 to, double limit, Handles start) {
  Handles h = start;
  const auto cost = [&](Handles at) {
    constexpr int kPlaces = 16;
    const Curve c = curve_of(ends, at);
    double most = 0;
    for (int i = 0; i <= kPlaces; ++i) most = std::max(most, glm::length(bend_of(c, static_cast<double>(i) / kPlaces)));
    const dvec2 off(glm::distance(bend_of(c, 0), from), glm::distance(bend_of(c, 1), to));
    const double moved = std::abs(at.out - start.out) + std::abs(at.in - start.in);
    return glm::length(off) + kBeyond * std::max(0.0, most - limit) + kStay * moved / length;
  };
  const double low = least_handle(ends, length), high = most_handle(ends, length);
  double best = cost(h);
  for (double step = 0.08 * length; step > 0.002 * length;) {
    const Handles before = h;
    for (const dvec2 way : {dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1), dvec2(0, -1), dvec2(1, 1), dvec2(-1, -1)}) {
      const Handles tried{std::clamp(before.out + step * way.x, low, high),
                          std::clamp(before.in + step * way.y, low, high)};
      if (const double found = cost(tried); found < best) best = found, h = tried;
    }
    if (h.out == before.out && h.in == before.in) step /= 2;
  }
  return h;
}

namespace {

using glm::dvec2, glm::dvec3;

constexpr double kBendMargin = 0.98;   // of the limit, because curvature is checked only at some positions
constexpr double kAlikeMargin = 0.97;  // the same of a search, which ends a little beside it
constexpr double kLeanRoom = 0.25;     // of the bound of angles: what knots may lean more or less than the smooth roll
constexpr double kSharp = 1.5;         // times the bound, before a low-pass
constexpr double kShortSpan = 1;       // m: the rows' distances do not determine the handles of a shorter span
constexpr double kMostFitRoll = 2 * base::kPi * (world::kMaxTurns - 1);

// Carries the frame along the curve from row to row, in steps of at most 1/32, and integrates the length.
class Carrier {
 public:
  Carrier(const Curve& c, const curve::Frame& start) : c_(c), frame_(start), place_(c.point(0)), speed_(c.speed(0)) {}
  void go_to(double t) {
    bend_ = glm::length(bend_of(c_, t_));
    const int steps = std::max(1, static_cast<int>(std::ceil((t - t_) * 32)));
    const double from = t_;
    for (int i = 1; i <= steps && t > from; ++i) step(from + (t - from) * i / steps);
  }
  const curve::Frame& frame() const { return frame_; }
  double length() const { return length_; }
  double bend() const { return bend_; }  // the largest curvature of the last go_to(), 1/m

 private:
  void step(double t) {
    const dvec3 place = c_.point(t), d = c_.derivative(t);
    const double speed = glm::length(d);
    length_ += (t - t_) / 6 * (speed_ + 4 * c_.speed(0.5 * (t + t_)) + speed);  // Simpson
    if (speed > 1e-12) frame_ = curve::transport(frame_, place_, place, d / speed);
    t_ = t, place_ = place, speed_ = speed;
    bend_ = std::max(bend_, glm::length(bend_of(c_, t)));
  }
  const Curve& c_;
  curve::Frame frame_;
  dvec3 place_;
  double speed_, t_ = 0, length_ = 0, bend_ = 0;
};

// Follows all rows along the curve. Returns false if one is too far off or has another direction, or if the curvature
// is too large. Fills rolls, parameters, fractions of the length, sines between the directions, and distances, by row
// from `first`.
bool follow_rows(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first, std::size_t last,
                 const Curve& c, const SpanEnds& ends, const SpanBounds& bounds, SpanScratch& s) {
  const std::size_t count = last - first + 1;
  s.rolls.assign(count, 0), s.shares.assign(count, 0), s.fronts.assign(count, 0);
  s.places.assign(count, 0), s.misses.assign(count, dvec3(0));
  Carrier carrier(c, {ends.t0, curve::perpendicular(ends.t0, rows[first].up)});
  const double length = std::max(distances[last] - distances[first], 1e-9);
  double before = 0;
  std::size_t knot = 1;
  for (std::size_t i = 1; i < count; ++i) {
    const FitRow& row = rows[first + i];
    const double station = (distances[first + i] - distances[first]) / length;
    while (knot + 1 < s.stations.size() && s.stations[knot] < station) ++knot;
    const double gap = std::max(s.stations[knot] - s.stations[knot - 1], 1e-12),
                 part = std::clamp((station - s.stations[knot - 1]) / gap, 0.0, 1.0);
    const double guess = s.parameters[knot - 1] + part * (s.parameters[knot] - s.parameters[knot - 1]);
    const double t = i + 1 == count ? 1.0 : std::max(before, nearer(c, row.position, guess, 3));
    before = t;
    if (i + 1 < count && glm::distance(c.point(t), row.position) > bounds.distance) return false;
    carrier.go_to(t);
    const curve::Frame& frame = carrier.frame();
    const double front = glm::length(glm::cross(frame.forward, row.forward));
    const bool free = bounds.free[first + i] != 0;
    if (!free && (front > bounds.angle || glm::dot(frame.forward, row.forward) < 0)) return false;
    s.fronts[i] = front;
    s.places[i] = t, s.misses[i] = c.point(t) - row.position;
    s.shares[i] = carrier.length();
    const dvec3 up = curve::perpendicular(frame.forward, row.up);
    const double roll = curve::signed_angle(frame.up, up, frame.forward);
    s.rolls[i] = s.rolls[i - 1] + std::remainder(roll - s.rolls[i - 1], 2 * base::kPi);
    if (carrier.bend() > kBendMargin * bounds.bends[first + i - 1]) return false;
  }
  s.length = std::max(carrier.length(), 1e-12);
  for (double& share : s.shares) share /= s.length;
  return std::abs(s.rolls.back()) < kMostFitRoll;
}

// Returns what riders feel more or less on the curve than on the rows, nothing if it is over `bounds.felt` somewhere.
// The difference of their accelerations is the second difference of the distance between the paths of their hearts,
// over kMoment on both sides. Where rows are further apart, it follows from the difference of the curvatures, without a
// low-pass, so a larger one is allowed. At an open end it does, too, but no larger one is: a ride's first moment is
// felt without a low-pass. There short spans are free of it, because rows do not determine their curvature.
std::optional<FeltMiss> felt_miss(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first,
                                  std::size_t last, const Curve& c, const Roll& roll, const SpanBounds& bounds,
                                  SpanScratch& s) {
  const std::size_t count = last - first + 1;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double lean = bounds.leans[first] - bounds.leans[first + i];
    const double off = roll.angle(s.shares[i] * s.length) + lean - s.rolls[i];
    s.misses[i] += bounds.heartline * off * glm::cross(rows[first + i].forward, rows[first + i].up);
  }
  const auto apart = [&](std::size_t a, std::size_t b) { return distances[first + b] - distances[first + a]; };
  const bool at_end = bounds.open && count > 2 && apart(0, count - 1) > kShortSpan;
  std::size_t before = 0, after = 0;
  FeltMiss felt;
  for (std::size_t i = 0; i < count; ++i) {
    if (bounds.free[first + i]) continue;
    const double v2 = bounds.speeds[first + i], moment = kMoment * std::sqrt(v2 * world::kGravity);
    while (before + 1 < i && apart(before + 1, i) >= moment) ++before;
    while (after + 1 < count && (after <= i || apart(i, after) < moment)) ++after;
    const double step = apart(i > 0 ? i - 1 : 0, i > 0 ? i : 1);
    const bool end = at_end && (first + i == 0 || first + i + 1 == rows.size());
    double miss = 0;  // g
    if (step > moment || end) {
      const double lean = bounds.heartline * (roll.slope(s.shares[i] * s.length) - bounds.slopes[first + i]);
      const dvec3 right = glm::cross(rows[first + i].forward, rows[first + i].up);
      miss =
          glm::length(bend_of(c, s.places[i]) - bounds.curvatures[first + i] + lean * right) * v2 / (end ? 1 : kSharp);
    } else if (i > 0 && i + 1 < count) {
      const double back = std::max(apart(before, i), moment), ahead = std::max(apart(i, after), moment);
      const dvec3 turn = (s.misses[after] - s.misses[i]) / ahead - (s.misses[i] - s.misses[before]) / back;
      miss = glm::length(turn) / (0.5 * (back + ahead)) * v2;
    }
    if (miss > bounds.felt) return std::nullopt;
    const double seconds = step / std::sqrt(v2 * world::kGravity);
    felt.squares += seconds * miss * miss, felt.seconds += seconds;
  }
  return felt;
}

}  // namespace

SpanFit fit_span(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first, std::size_t last,
                 double roll_low, double roll_high, const SpanBounds& bounds, SpanScratch& s) {
  const FitRow &from = rows[first], &to = rows[last];
  const SpanEnds ends{dvec3(glm::vec3(from.position)), from.forward, dvec3(glm::vec3(to.position)), to.forward,
                      bounds.least_handle};
  Handles h = fit_handles(rows, distances, first, last, ends, s.parameters, s.stations);
  SpanFit fit;
  Roll roll;
  const auto good = [&] {
    const Curve c = curve_of(ends, h);
    const bool near = follow_rows(rows, distances, first, last, c, ends, bounds, s);
    fit.out_length = h.out, fit.in_length = h.in, fit.roll = s.rolls.back();
    roll = {s.length, fit.roll, bounds.spins[first], bounds.spins[last]};
    Roll smooth = roll;
    smooth.twist += bounds.leans[last] - bounds.leans[first];
    const auto felt = near ? felt_miss(rows, distances, first, last, c, smooth, bounds, s) : std::nullopt;
    if (felt) fit.felt = *felt;
    return felt.has_value();
  };
  if (!good()) {
    // The rounding of rows close together hides their handles.
    const bool neighbours = last == first + 1;
    const double length = distances[last] - distances[first];
    if (!neighbours && length > kShortSpan) return fit;
    const dvec3 bend0 = bounds.curvatures[first], bend3 = bounds.curvatures[last];
    // Between rows far apart the track may bend more than their directions show.
    const double own = length > kShortSpan ? std::max(glm::length(bend0), glm::length(bend3)) : 0;
    h = most_alike(ends, length, bend0, bend3, std::max(kAlikeMargin * bounds.bends[first], own), h);
    fit.bent = !good();
    if (fit.bent && !neighbours) return fit;
  }
  const double most = bounds.angle;
  // Other rolls than the smooth one's would be felt, the more the shorter the span is.
  const double slack = kLeanRoom * most, from_lean = bounds.leans[first], to_lean = bounds.leans[last];
  const double low = std::max({roll_low, from_lean - slack, -most}),
               high = std::min({roll_high, from_lean + slack, most}), least = std::max(to_lean - slack, -most),
               largest = std::min(to_lean + slack, most);
  if (!(low <= high)) return fit;
  fit.window = {{low, least}, {high, least}, {high, largest}, {low, largest}};
  RollWindow spare;
  // Additional rolls of the knots add a fraction of both, with spins of 0, to the roll by the rows' own spins.
  const Roll part{1, 1, 0, 0};
  for (std::size_t i = 1; first + i < last && !fit.window.empty(); ++i) {
    if (bounds.free[first + i]) continue;
    // For small angles, the angle of the whole rotation is the hypotenuse of its two parts.
    const double room = std::sqrt(std::max(0.0, most * most - s.fronts[i] * s.fronts[i]));
    const double share = part.angle(s.shares[i]), error = roll.angle(s.shares[i] * s.length) - s.rolls[i];
    const dvec2 normal(1 - share, share);
    clip(fit.window, normal, room - error, spare);
    clip(fit.window, -normal, room + error, spare);
  }
  fit.within = !fit.window.empty();
  return fit;
}

}  // namespace coaster::sim
