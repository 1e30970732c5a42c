#include "sim/fit/sample_interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>

#include "base/portable_math.h"
#include "curve/natural_spline.h"
#include "sim/shape/roll.h"
#include "world/motion.h"

namespace coaster::sim {

using glm::dvec3;

double frame_angle_deg(const curve::Frame& a, const curve::Frame& b) {
  // The squared distances of the three axes add up to 8 sin^2(angle / 2).
  const dvec3 f = a.forward - b.forward, u = a.up - b.up, l = a.left() - b.left();
  const double sine = std::sqrt(std::min(1.0, (glm::dot(f, f) + glm::dot(u, u) + glm::dot(l, l)) / 8));
  return base::degrees(2 * base::arc_tangent(sine, std::sqrt(1 - sine * sine)));
}

std::vector<double> row_jumps(std::span<const FitRow> rows, bool closed) {
  const std::size_t count = rows.size(), steps = closed ? count : count - 1;
  std::vector<double> angles, rates, jumps(steps, 0);
  for (std::size_t i = 0; i < steps; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    angles.push_back(frame_angle_deg({a.forward, a.up}, {b.forward, b.up}));
    rates.push_back(angles[i] / std::max(glm::distance(a.position, b.position), 1e-9));
  }
  for (std::size_t i = 0; i < steps; ++i) {
    const double before = closed || i > 0 ? rates[(i + steps - 1) % steps] : 0,
                 after = closed || i + 1 < steps ? rates[(i + 1) % steps] : 0;
    if (angles[i] > kJumpAngle && rates[i] > std::max(kJumpRate, kJumpTimes * std::max(before, after)))
      jumps[i] = angles[i];
  }
  return jumps;
}

double off_deg(const FitRow& a, const FitRow& b) {
  const auto angle = [](dvec3 u, dvec3 v) {
    return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
  };
  // The chord of an arc has the mean of the directions at its ends.
  const double off = angle(b.position - a.position, a.forward + b.forward);
  return off > kOffForward + angle(a.forward, b.forward) / 2 ? off : 0;
}

namespace {

// Returns the larger curvature at the ends of a step times its length, if it changes linearly in between.
double end_turn(const FitRow& a, const FitRow& b) {
  const dvec3 chord = glm::normalize(b.position - a.position);
  return std::max(glm::length(curve::across(6.0 * chord - 2.0 * b.forward, a.forward)),
                  glm::length(curve::across(6.0 * chord - 2.0 * a.forward, b.forward)));
}

}  // namespace

std::vector<double> bend_limits(std::span<const FitRow> rows, bool closed) {
  const auto count = static_cast<std::ptrdiff_t>(rows.size()), steps = closed ? count : count - 1;
  std::vector<double> starts{0}, bends, limits;
  for (std::ptrdiff_t i = 0; i < steps; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    const double length = std::max(glm::distance(a.position, b.position), 1e-9);
    starts.push_back(starts.back() + length);
    const double turn =
        base::arc_tangent(glm::length(glm::cross(a.forward, b.forward)), glm::dot(a.forward, b.forward));
    bends.push_back(std::max(turn, length < kLongStep ? 0 : end_turn(a, b)) / length);
  }
  const double whole = starts.back();
  // Distances of steps before the first and after the last, on a closed track.
  const auto lap = [&](std::ptrdiff_t i) { return i < 0 ? -1 : i >= steps ? 1 : 0; };
  const auto start = [&](std::ptrdiff_t i) { return starts[i - lap(i) * steps] + lap(i) * whole; };
  const auto bend = [&](std::ptrdiff_t i) { return bends[i - lap(i) * steps]; };
  const std::ptrdiff_t least = closed ? -steps : 0, most = closed ? 2 * steps : steps;
  // The steps near step i with falling curvatures: the first has the largest.
  std::deque<std::ptrdiff_t> near;
  std::ptrdiff_t next = 0;
  while (next > least && start(next) >= starts[1] - kBendReach) --next;
  for (std::ptrdiff_t i = 0; i < steps; ++i) {
    for (; next < most && start(next) <= start(i) + kBendReach; ++next) {
      while (!near.empty() && bend(near.back()) <= bend(next)) near.pop_back();
      near.push_back(next);
    }
    while (near.front() < i && start(near.front() + 1) < start(i + 1) - kBendReach) near.pop_front();
    limits.push_back(kBendShare * bend(near.front()) + kBendSpare);
  }
  return limits;
}

std::vector<double> row_speeds(std::span<const FitRow> rows) {
  double top = rows[0].position.y;
  for (const FitRow& row : rows) top = std::max(top, row.position.y);
  std::vector<double> speeds;
  for (const FitRow& row : rows) speeds.push_back(kTopSpeed * kTopSpeed / world::kGravity + 2 * (top - row.position.y));
  return speeds;
}

std::vector<char> near_jumps(std::span<const FitRow> rows, bool closed, double reach) {
  const std::size_t count = rows.size();
  std::vector<char> near(count, 0);
  std::vector<double> steps(count, 0), jumps = row_jumps(rows, closed);
  jumps.resize(count);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
    steps[i] = glm::distance(rows[i].position, rows[(i + 1) % count].position);
  // Computes the distance to the last jump in a forward pass, then to the next in a backward pass, from the middle of
  // the jump's step. A closed track needs two rounds, because the second knows the jumps of the first.
  const std::size_t laps = closed ? 2 * count : count;
  double gone = 2 * reach + 1;
  for (std::size_t n = 1; n < laps; ++n) {
    const std::size_t k = n % count, before = (n - 1) % count;
    gone = jumps[before] > 0 ? 0.5 * steps[before] : gone + steps[before];
    if (gone <= reach) near[k] = 1;
  }
  gone = 2 * reach + 1;
  for (std::size_t n = laps - (closed ? 0 : 1); n-- > 0;) {
    const std::size_t k = n % count;
    gone = jumps[k] > 0 ? 0.5 * steps[k] : gone + steps[k];
    if (gone <= reach) near[k] = 1;
  }
  return near;
}

bool rows_close(std::span<const FitRow> rows, double rounding) {
  if (rows.size() < 4) return false;
  const FitRow &first = rows.front(), &last = rows.back();
  double longest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    longest = std::max(longest, glm::distance(rows[i - 1].position, rows[i].position));
  const dvec3 gap = first.position - last.position;
  constexpr double kSameWay = 0.5;  // cosine
  return glm::length(gap) <= 1.01 * longest + rounding && glm::dot(gap, last.forward) >= -rounding &&
         glm::dot(first.forward, last.forward) > kSameWay;
}

double float_spacing(std::span<const FitRow> rows, int axis) {
  float most = 0;
  for (const FitRow& row : rows) most = std::max(most, std::abs(static_cast<float>(row.position[axis])));
  return std::nextafter(most, std::numeric_limits<float>::infinity()) - most;
}

using glm::dvec3;

namespace {

// Returns the rate (rad/m) at an open end, the first or the last: that of the polynomial through the rolls of the rows
// there, four of them if there are as many.
double end_rate(std::span<const double> lengths, std::span<const double> rates, bool first) {
  const auto at = [&](std::size_t i) { return first ? i : rates.size() - 1 - i; };  // from the end
  const double a = lengths[at(0)], rate = rates[at(0)];
  if (rates.size() < 2) return rate;
  const double b = lengths[at(1)], change = (rates[at(1)] - rate) / (a + b);  // divided differences
  if (rates.size() < 3) return rate - a * change;
  const double c = lengths[at(2)], next = (rates[at(2)] - rates[at(1)]) / (b + c);
  return rate - a * change + a * (a + b) * (next - change) / (a + b + c);
}

// Returns the rates (rad/m) at the rows of the cubic spline that turns by `rates` over the steps of these lengths. A
// track may begin and end within a roll.
std::vector<double> spline_rates(std::span<const double> lengths, std::span<const double> rates, bool closed) {
  // Round a closed track the roll comes back to its start once the mean rate is taken off.
  double whole = 0, turned = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) whole += lengths[i], turned += lengths[i] * rates[i];
  const double mean = turned / whole;
  std::vector<dvec3> rolls{dvec3(0)};
  for (std::size_t i = 0; i < rates.size(); ++i)
    rolls.push_back(rolls.back() + dvec3(lengths[i] * (rates[i] - mean), 0, 0));
  std::optional<dvec3> first, last;
  if (closed) {
    rolls.pop_back();
  } else {
    first = dvec3(end_rate(lengths, rates, true) - mean, 0, 0);
    last = dvec3(end_rate(lengths, rates, false) - mean, 0, 0);
  }
  std::vector<double> found;
  for (const dvec3& rate : curve::spline_derivatives({rolls, lengths, first, last, closed}))
    found.push_back(mean + rate.x);
  return found;
}

// The rows' rolls as a function of the place: linear over each step.
struct RowRollSteps {
  std::span<const double> lengths, rates;  // m, rad/m
  bool closed;

  // Calls take(step, rate, from, to) for the parts of steps within `reach` behind (way -1) or ahead of (1) row i, in
  // that order, with their distances from it. Beyond an open end the rate goes on changing as before it: steps there
  // are those before it, point for point.
  template <class Take>
  void walk(std::ptrdiff_t i, std::ptrdiff_t way, double reach, const Take& take) const {
    const auto count = static_cast<std::ptrdiff_t>(rates.size());
    double gone = 0;
    for (std::ptrdiff_t k = way > 0 ? i : i - 1; gone < reach; k += way) {
      const bool beyond = !closed && (k < 0 || k >= count);
      const std::ptrdiff_t mirrored = k < 0 ? -1 - k : 2 * count - 1 - k;
      const std::ptrdiff_t step = closed   ? (k + 2 * count) % count
                                  : beyond ? std::clamp<std::ptrdiff_t>(mirrored, 0, count - 1)
                                           : k;
      const double to = std::min(reach, gone + lengths[step]);
      take(step, beyond ? 2 * end_rate(lengths, rates, k < 0) - rates[step] : rates[step], gone, to);
      gone = to;
    }
  }
  template <class Take>
  void walk(std::ptrdiff_t i, double reach, const Take& take) const {
    for (const std::ptrdiff_t way : {-1, 1})
      walk(i, way, reach,
           [&](std::ptrdiff_t step, double rate, double from, double to) { take(way, step, rate, from, to); });
  }
};

// Returns the distance over which a change of the rates about row i may be spread while it leans the row by at most
// kMostLean: a sudden change w, spread by a triangle that reaches a to either side, leans it by w a / 6.
double spread_of(const RowRollSteps& steps, std::ptrdiff_t i) {
  double change = 0;
  steps.walk(i, kSpinReach, [&](std::ptrdiff_t way, std::ptrdiff_t, double rate, double from, double to) {
    change += static_cast<double>(way) * (to - from) / kSpinReach * rate;
  });
  return std::min(kSpinReach, 6 * kMostLean / std::max(std::abs(change), 1e-9));
}

double median_rate(const RowRollSteps& steps, std::ptrdiff_t i) {
  std::vector<double> near;
  steps.walk(i, kSpinReach, [&](std::ptrdiff_t, std::ptrdiff_t, double rate, double, double) { near.push_back(rate); });
  const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
  std::nth_element(near.begin(), middle, near.end());
  return *middle;
}

constexpr int kSpread = 6;  // steps within the reach, on both sides together: with fewer, spans spread a change as far

// Sets spins and leans where rows are close together.
void spread_rolls(const RowRollSteps& steps, RowRolls& rolls) {
  const auto count = static_cast<std::ptrdiff_t>(rolls.spins.size());
  std::vector<double> spreads;
  for (std::ptrdiff_t i = 0; i < count; ++i) spreads.push_back(spread_of(steps, i));
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    int near = 0;
    double reach = kSpinReach;  // the least spread of the rows within kSpinReach
    steps.walk(i, kSpinReach, [&](std::ptrdiff_t way, std::ptrdiff_t step, double, double, double) {
      reach = std::min(reach, spreads[way > 0 ? step : (step + 1) % count]), ++near;
    });
    if (near == 2) continue;  // rows far apart
    double spin = 0, lean = 0;
    steps.walk(i, reach, [&](std::ptrdiff_t way, std::ptrdiff_t, double rate, double from, double to) {
      const double a = 1 - from / reach, b = 1 - to / reach;
      spin += rate * (a * a - b * b) / 2;
      lean += static_cast<double>(way) * rate * reach * (a * a * a - b * b * b) / 6;
    });
    const bool jump = std::abs(lean) > 1.1 * kMostLean;
    rolls.spins[i] = jump ? median_rate(steps, i) : spin;
    rolls.leans[i] = jump || near < kSpread ? 0 : lean;
  }
}

}  // namespace

RowRolls row_rolls(std::span<const FitRow> rows, bool closed) {
  const auto count = static_cast<std::ptrdiff_t>(rows.size()), steps = closed ? count : count - 1;
  std::vector<double> lengths, rates;
  for (std::ptrdiff_t i = 0; i < steps; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    const curve::Frame carried = curve::transport({a.forward, a.up}, a.position, b.position, b.forward);
    const double angle = curve::signed_angle(carried.up, curve::perpendicular(b.forward, b.up), b.forward);
    lengths.push_back(std::max(glm::distance(a.position, b.position), 1e-9));
    rates.push_back(angle / lengths.back());
  }
  RowRolls rolls{spline_rates(lengths, rates, closed), {}};
  for (std::ptrdiff_t i = 0; i < steps; ++i)  // the spline's second derivative at the start of each step
    rolls.slopes.push_back(2 * (3 * rates[i] - 2 * rolls.spins[i] - rolls.spins[(i + 1) % count]) / lengths[i]);
  if (!closed)  // and at the end of the last one
    rolls.slopes.push_back(2 * (2 * rolls.spins[steps] + rolls.spins[steps - 1] - 3 * rates[steps - 1]) /
                           lengths[steps - 1]);
  rolls.leans.assign(rolls.spins.size(), 0);
  spread_rolls({lengths, rates, closed}, rolls);
  return rolls;
}

namespace {

// The curve from a row to the next one on one side: the angles to its position and to its direction, divided by the
// length.
struct RowSide {
  std::ptrdiff_t row = -1;
  double length = 0;
  dvec3 off{0}, turn{0};  // 1/m
};

RowSide side_of(std::span<const FitRow> rows, bool closed, std::ptrdiff_t i, std::ptrdiff_t way) {
  const auto count = static_cast<std::ptrdiff_t>(rows.size());
  const dvec3 forward = rows[i].forward;
  RowSide side;
  dvec3 chord(0);
  for (std::ptrdiff_t k = i + way, n = 1; n < count; k += way, ++n) {
    if (!closed && (k < 0 || k >= count)) break;
    side.row = (k + count) % count;
    chord = rows[side.row].position - rows[i].position;
    if (glm::dot(chord, chord) >= kCurvatureReach * kCurvatureReach) break;
  }
  if (side.row < 0) return side;
  const dvec3 there = rows[side.row].forward;
  // An arc is longer than its chord.
  const double sign = static_cast<double>(way), half = 0.5 * glm::distance(forward, there);
  side.length = std::max(glm::length(chord) * (1 + half * half / 6), 1e-9);
  const auto angle = [&](dvec3 to) {
    const dvec3 across = curve::across(to, forward);
    const double sine = glm::length(across);
    return sine > 0 ? base::arc_tangent(sine, sign * glm::dot(to, forward)) / sine * across : dvec3(0);
  };
  side.off = angle(chord) / side.length, side.turn = angle(sign * there) / side.length;
  return side;
}

}  // namespace

std::vector<dvec3> row_curvatures(std::span<const FitRow> rows, bool closed) {
  constexpr int kRounds = 16;  // each leaves less than a third of the error
  std::vector<std::array<RowSide, 2>> found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    found.push_back({side_of(rows, closed, at, -1), side_of(rows, closed, at, 1)});
  }
  std::vector<dvec3> curvatures(rows.size(), dvec3(0)), next(rows.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      dvec3 sum(0);
      double weight = 0;
      for (const RowSide& side : found[i]) {
        if (side.row < 0) continue;
        const dvec3 there = rows[side.row].forward, here = rows[i].forward;
        const dvec3 bend =
            curve::least_rotation(there, here, curvatures[side.row], curve::perpendicular(there, rows[side.row].up));
        sum += (60.0 * side.off - 24.0 * side.turn + 3.0 * bend) / side.length, weight += 9 / side.length;
      }
      next[i] = weight > 0 ? sum / weight : dvec3(0);
    }
    curvatures.swap(next);
  }
  return curvatures;
}

FilledRows fill_rows(std::span<const FitRow> rows, bool closed) {
  constexpr int kFine = 8;         // steps of the frame per part
  constexpr double kSwing = 1.15;  // the curve swings slightly beside a bend; a span fitted to it bends less
  const RowRolls rolls = row_rolls(rows, closed);
  const std::vector<dvec3> bends = row_curvatures(rows, closed);
  const std::vector<double> limits = bend_limits(rows, closed);
  FilledRows filled;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    filled.rows.push_back(rows[i]), filled.from.push_back(i);
    if (!closed && i + 1 == rows.size()) break;
    const std::size_t j = (i + 1) % rows.size();
    const FitRow &a = rows[i], &b = rows[j];
    const double half = 0.5 * glm::distance(a.forward, b.forward),
                 length = glm::distance(a.position, b.position) * (1 + half * half / 6);  // as of an arc
    if (!(length > kLeastFill && length <= kMostFill)) continue;
    const int parts = static_cast<int>(std::ceil(length / kFillStep)), steps = parts * kFine;
    const RowQuintic quintic(a, bends[i], b, bends[j], length);
    std::vector<FitRow> carried{a};
    double bend = 0;  // the largest
    for (int k = 1; k <= steps; ++k) {
      const double x = static_cast<double>(k) / steps;
      const dvec3 place = quintic.point(x), forward = k < steps ? quintic.direction(x) : b.forward;
      const FitRow& last = carried.back();
      bend = std::max(bend, glm::distance(forward, last.forward) / glm::distance(place, last.position));
      carried.push_back({place, forward, curve::transport({last.forward, last.up}, last.position, place, forward).up});
    }
    if (!(bend <= kSwing * limits[i])) continue;
    const double twist = curve::signed_angle(carried.back().up, curve::perpendicular(b.forward, b.up), b.forward);
    const Roll roll{length, twist, rolls.spins[i], rolls.spins[j]};
    for (int k = 1; k < parts; ++k) {
      FitRow row = carried[static_cast<std::size_t>(k * kFine)];
      row.up = curve::perpendicular(row.forward, curve::rotate(row.up, row.forward, roll.angle(k * length / parts)));
      filled.rows.push_back(row), filled.from.push_back(i);
    }
  }
  return filled;
}

namespace {

// A row with its neighbours, and the lengths of the steps between them.
struct Neighbours {
  Neighbours(std::span<const FitRow> rows, std::size_t i)
      : before((i + rows.size() - 1) % rows.size()),
        after((i + 1) % rows.size()),
        back(glm::distance(rows[before].position, rows[i].position)),
        ahead(glm::distance(rows[i].position, rows[after].position)) {}
  double longest() const { return std::max(back, ahead); }

  std::size_t before, after;
  double back, ahead;
};

// Returns the doubt of roll_doubts() at the first or the last row of an open track. The rate there is that of a cubic,
// off by a quarter of h^3 of the roll's fourth derivative, and the second derivative of a spline with that rate by
// 2 sqrt(3) / h times as much.
double end_doubt(std::span<const FitRow> rows, const RowRolls& rolls, std::span<const double> speeds, double heartline,
                 bool first) {
  constexpr double kShare = std::numbers::sqrt3 / 2;
  constexpr double kNear = 0.2;  // m: between closer rows rounding hides the fourth derivative
  const auto at = [&](std::size_t i) { return first ? i : rows.size() - 1 - i; };  // from the end
  const auto apart = [&](std::size_t i, std::size_t k) {
    return std::max(glm::distance(rows[at(i)].position, rows[at(k)].position), 1e-9);
  };
  const double step = apart(0, 1);
  const std::size_t n = static_cast<std::size_t>(std::max(1.0, std::round(kNear / step)));
  if (rows.size() <= 3 * n) return 0;
  const auto third = [&](std::size_t i) { return (rolls.slopes[at(i + n)] - rolls.slopes[at(i)]) / apart(i, i + n); };
  const double fourth = 2 * std::abs(third(2 * n) - third(n)) / apart(n, 3 * n);
  return kShare * step * step * fourth * heartline * speeds[at(0)];
}

}  // namespace

std::vector<double> roll_doubts(std::span<const FitRow> rows, bool closed, const RowRolls& rolls,
                                std::span<const double> speeds, double heartline) {
  constexpr double kCutoff = 5;  // Hz
  std::vector<double> doubts(rows.size(), 0);
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < rows.size(); ++i) {
    const Neighbours n(rows, i);
    const double fourth = 2 *
                          ((rolls.slopes[n.after] - rolls.slopes[i]) / std::max(n.ahead, 1e-9) -
                           (rolls.slopes[i] - rolls.slopes[n.before]) / std::max(n.back, 1e-9)) /
                          std::max(n.back + n.ahead, 1e-9);
    // Squared frequency of the error, relative to the cutoff's. In steps shorter than kMoment only an error that lasts
    // several of them is felt.
    const double steps = n.longest() < kMoment * std::sqrt(speeds[i] * world::kGravity) ? 3 : 2;
    const double wave = steps * kCutoff * n.longest(), share = speeds[i] * world::kGravity / (wave * wave);
    const double passed = 1 / std::sqrt(1 + share * share * share * share);  // a Butterworth low-pass of four poles
    doubts[i] = 4 * passed * n.back * n.ahead / 12 * std::abs(fourth) * heartline * speeds[i];
  }
  if (!closed)
    for (const bool first : {true, false})
      doubts[first ? 0 : rows.size() - 1] = end_doubt(rows, rolls, speeds, heartline, first);
  return doubts;
}

std::vector<double> bend_doubts(std::span<const FitRow> rows, bool closed, std::span<const double> speeds) {
  std::vector<double> doubts(rows.size(), 0);
  const std::vector<glm::dvec3> bends = row_curvatures(rows, closed);
  for (const std::size_t odd : {0, 1}) {
    std::vector<FitRow> kept;
    for (std::size_t i = odd; i < rows.size(); i += 2) kept.push_back(rows[i]);
    const std::vector<glm::dvec3> wide = row_curvatures(kept, closed);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const std::size_t next = (k + 1) % kept.size(), left_out = (2 * k + odd + 1) % rows.size();
      if (next == 0 && (!closed || rows.size() % 2 != 0)) continue;
      const Neighbours n(rows, left_out);
      if (n.longest() < kMoment * std::sqrt(speeds[left_out] * world::kGravity)) continue;
      const RowQuintic quintic(kept[k], wide[k], kept[next], wide[next], n.back + n.ahead);
      const glm::dvec3 there = quintic.curvature(n.back / (n.back + n.ahead));
      doubts[left_out] = glm::distance(there, bends[left_out]) * speeds[left_out];
    }
  }
  return doubts;
}

}  // namespace coaster::sim
