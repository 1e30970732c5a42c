#include "sim/fit/fit_rows.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/portable_math.h"
#include "curve/natural_spline.h"
#include "world/motion.h"

namespace coaster::sim {

using glm::dvec3;

double frame_angle_deg(const curve::Frame& a, const curve::Frame& b) {
  // The squared distances of the three axes add up to 8 sin^2(angle / 2).
  const dvec3 f = a.forward - b.forward, u = a.up - b.up, l = a.left() - b.left();
  const double sine = std::sqrt(std::min(1.0, (glm::dot(f, f) + glm::dot(u, u) + glm::dot(l, l)) / 8));
  return base::degrees(2 * base::arc_tangent(sine, std::sqrt(1 - sine * sine)));
}

double jump_deg(const FitRow& a, const FitRow& b) {
  const double angle = frame_angle_deg({a.forward, a.up}, {b.forward, b.up});
  return angle > kJumpAngle && angle > kJumpRate * glm::distance(a.position, b.position) ? angle : 0;
}

std::vector<double> bend_limits(std::span<const FitRow> rows, bool closed) {
  const auto count = static_cast<std::ptrdiff_t>(rows.size()), steps = closed ? count : count - 1;
  std::vector<double> starts{0}, bends, limits;
  for (std::ptrdiff_t i = 0; i < steps; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    const double length = std::max(glm::distance(a.position, b.position), 1e-9);
    starts.push_back(starts.back() + length);
    bends.push_back(base::arc_tangent(glm::length(glm::cross(a.forward, b.forward)), glm::dot(a.forward, b.forward)) /
                    length);
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

namespace {

// Returns the rates (rad/m) at the rows of the cubic spline that turns by `rates` over the steps of these lengths.
std::vector<double> spline_rates(std::span<const double> lengths, std::span<const double> rates, bool closed) {
  // Round a closed track the roll comes back to its start once the mean rate is taken off.
  double whole = 0, turned = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) whole += lengths[i], turned += lengths[i] * rates[i];
  const double mean = turned / whole;
  std::vector<dvec3> rolls{dvec3(0)};
  for (std::size_t i = 0; i < rates.size(); ++i)
    rolls.push_back(rolls.back() + dvec3(lengths[i] * (rates[i] - mean), 0, 0));
  if (closed) rolls.pop_back();
  std::vector<double> found;
  for (const dvec3& rate : curve::spline_derivatives({rolls, lengths, {}, {}, closed})) found.push_back(mean + rate.x);
  return found;
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
  if (!closed) rolls.slopes.push_back(0);  // a natural spline's
  std::vector<double> near;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    near.clear();
    // Adds the rates of the steps from `first` on, within the reach.
    const auto take = [&](std::ptrdiff_t first, std::ptrdiff_t way) {
      double gone = 0;
      for (std::ptrdiff_t k = first, taken = 0; taken < steps && gone < kSpinReach; k += way, ++taken) {
        if (!closed && (k < 0 || k >= steps)) return;
        near.push_back(rates[(k + steps) % steps]), gone += lengths[(k + steps) % steps];
      }
    };
    take(i - 1, -1);
    const std::size_t behind = near.size();
    take(i, 1);
    const double before = behind > 0 ? near[0] : near[behind], after = behind < near.size() ? near[behind] : near[0];
    if (behind == 1 && near.size() == 2) continue;  // rows far apart
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::nth_element(near.begin(), middle, near.end());
    const double upper = *middle, lower = near.size() % 2 == 1 ? upper : *std::max_element(near.begin(), middle);
    rolls.spins[i] = std::clamp(0.5 * (lower + upper), std::min(before, after), std::max(before, after));
  }
  return rolls;
}

namespace {

constexpr double kUneven =
    2;  // times a neighbour's correction: larger corrections come from a bend that begins or ends

// The curve from a row to the next one on one side: the angles to its position and to its direction, divided by the
// length.
struct RowSide {
  std::ptrdiff_t row = -1;
  double length = 0;
  dvec3 off{0}, turn{0};  // 1/m

  // Returns the curvature at the row, if it changes linearly along the curve.
  dvec3 curvature() const { return 6.0 * off - 2.0 * turn; }
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
  struct Row {
    RowSide before, after;
    bool corrected = false;  // there are both sides
    dvec3 correction{0};     // of the polynomial of degree 5 to the mean of both sides
  };
  std::vector<Row> found;
  std::vector<dvec3> curvatures;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    Row row{side_of(rows, closed, at, -1), side_of(rows, closed, at, 1)};
    const RowSide &before = row.before, &after = row.after;
    const double a = before.length, b = after.length, whole = a + b;
    if (!(a > 0) || !(b > 0)) {
      curvatures.push_back((a > 0 ? before : after).curvature());
    } else {
      // c2 of c2 x^2 + c3 x^3 + c4 x^4 + c5 x^5, which is `off` x^2, with the slope `turn` x, at -a and b.
      const dvec3 even = a * a * (5.0 * after.off - after.turn) - b * b * (5.0 * before.off - before.turn),
                  odd = a * a * a * (4.0 * after.off - after.turn) + b * b * b * (4.0 * before.off - before.turn),
                  mean = (b * before.curvature() + a * after.curvature()) / whole;
      row.correction = 4 / (whole * whole * whole) * (odd - 0.5 * (a - b) * even) - mean;
      row.corrected = true;
      curvatures.push_back(mean);
    }
    found.push_back(row);
  }
  // Where a bend begins or ends between rows, the polynomial oscillates, so the correction is limited by those of the
  // neighbours.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const dvec3 correction = found[i].correction;
    double share = 1;
    for (const std::ptrdiff_t k : {found[i].before.row, found[i].after.row})
      if (k >= 0 && found[k].corrected && correction != dvec3(0))
        share = std::min(share, kUneven * glm::dot(correction, found[k].correction) / glm::dot(correction, correction));
    curvatures[i] += std::max(0.0, share) * correction;
  }
  return curvatures;
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
  std::vector<char> near(count, 0), jumps(count, 0);  // jumps: from row i to the next
  std::vector<double> steps(count, 0);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const FitRow &a = rows[i], &b = rows[(i + 1) % count];
    steps[i] = glm::distance(a.position, b.position);
    jumps[i] = jump_deg(a, b) > 0 ? 1 : 0;
  }
  // Computes the distance to the last jump in a forward pass, then to the next in a backward pass, from the middle of
  // the jump's step. A closed track needs two rounds, because the second knows the jumps of the first.
  const std::size_t laps = closed ? 2 * count : count;
  double gone = 2 * reach + 1;
  for (std::size_t n = 1; n < laps; ++n) {
    const std::size_t k = n % count, before = (n - 1) % count;
    gone = jumps[before] ? 0.5 * steps[before] : gone + steps[before];
    if (gone <= reach) near[k] = 1;
  }
  gone = 2 * reach + 1;
  for (std::size_t n = laps - (closed ? 0 : 1); n-- > 0;) {
    const std::size_t k = n % count;
    gone = jumps[k] ? 0.5 * steps[k] : gone + steps[k];
    if (gone <= reach) near[k] = 1;
  }
  return near;
}

bool rows_close(std::span<const FitRow> rows) {
  if (rows.size() < 4) return false;
  const FitRow &first = rows.front(), &last = rows.back();
  double longest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    longest = std::max(longest, glm::distance(rows[i - 1].position, rows[i].position));
  const dvec3 gap = first.position - last.position;
  constexpr double kRounding = 1e-5, kSameWay = 0.5;  // m, rounding of printed positions; cosine
  return glm::length(gap) <= 1.01 * longest + kRounding && glm::dot(gap, last.forward) >= -kRounding &&
         glm::dot(first.forward, last.forward) > kSameWay;
}

}  // namespace coaster::sim
