#include "sim/plan/closing_curve.h"

#include <array>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec2;

constexpr int kGrid = 144;  // steps of a whole turn
constexpr double kGridStep = 2.0 * kPi / kGrid;
constexpr double kUnit = 1000;  // m, a radius at which no bend is too short

dvec2 along(double heading) {
  const auto [sin, cos] = base::sin_cos(heading);
  return {cos, sin};
}
dvec2 swung(dvec2 v, double heading) {
  const dvec2 e = along(heading);
  return {v.x * e.x - v.y * e.y, v.x * e.y + v.y * e.x};
}

// Returns the bend with soft ramps: the roll follows the curvature, whose second derivative must not jump.
Bend soft(Bend bend) {
  bend.soft = true;
  return bend;
}

// Displacements of bends by their angle, up to two whole turns, for a radius of 1 m and the heading 0.
struct TurnTable {
  std::array<dvec2, 2 * kGrid + 1> moved{};
  std::array<double, 2 * kGrid + 1> length{};
  TurnTable() {
    for (std::size_t i = 1; i < moved.size(); ++i) {
      const Bend bend = soft({0, static_cast<double>(i) * kGridStep, kUnit});
      moved[i] = bend.run_and_rise() / kUnit, length[i] = bend.length() / kUnit;
    }
  }
  dvec2 at(double angle, double radius, double shortest) const {
    const double place = angle / kGridStep;
    const auto i = std::min(static_cast<std::size_t>(place), moved.size() - 2);
    const double share = place - static_cast<double>(i);
    const double whole = length[i] + share * (length[i + 1] - length[i]);
    const double real = radius * whole < shortest && whole > 0 ? shortest / whole : radius;
    return real * (moved[i] + share * (moved[i + 1] - moved[i]));
  }
};

Bend turn_of(const TurnChoice& c, double from, double to) { return soft({from, to, c.radius, 0, c.shortest}); }

// The remaining displacement after a first turn by `turn`, along and across the heading between the turns.
struct RemainingDisplacement {
  double ahead = 0, aside = 0;  // m
  double second = 0;            // rad, the second turn
};

template <class Moved>
RemainingDisplacement rest_after(const PlanPose& from, const PlanPose& to, const TurnChoice& c, double turn,
                                 const Moved& moved) {
  const double heading = from.heading + c.first * turn;
  double second = c.second * (to.heading - heading) / (2.0 * kPi);
  second = (second - std::floor(second) + c.more_second) * 2.0 * kPi;
  const auto shift = [&](double angle, int side, double at) {
    const dvec2 m = moved(angle, c);
    return swung({m.x, side * m.y}, at);
  };
  const dvec2 rest = to.place - from.place - c.before * along(from.heading) - c.after * along(to.heading) -
                     shift(turn, c.first, from.heading) - shift(second, c.second, heading);
  const dvec2 e = along(heading);
  return {glm::dot(rest, e), rest.y * e.x - rest.x * e.y, second};
}

TurnsInPlan turns_of(const PlanPose& from, const TurnChoice& c, double turn, const RemainingDisplacement& rest) {
  const double heading = from.heading + c.first * turn;
  return {c.before, std::max(0.0, rest.ahead), c.after, turn_of(c, from.heading, heading),
          turn_of(c, heading, heading + c.second * rest.second)};
}

// Adds the roots of the rest's `aside` as a function of the first turn's angle.
void add_roots(const PlanPose& from, const PlanPose& to, TurnChoice c, std::vector<TurnChoice>& out) {
  static const TurnTable kTable;
  const auto moved = [](double angle, const TurnChoice& choice) {
    return kTable.at(angle, choice.radius, choice.shortest);
  };
  const int begin = c.more_first * kGrid;
  RemainingDisplacement last = rest_after(from, to, c, begin * kGridStep, moved);
  const auto take = [&](double low, double high, double turn) {
    const RemainingDisplacement rest = rest_after(from, to, c, turn, moved);
    if (rest.ahead < -0.05) return;
    c.low = low, c.high = high, c.rough = turns_of(from, c, turn, rest);
    out.push_back(c);
  };
  if (last.aside == 0) take(begin * kGridStep, begin * kGridStep, begin * kGridStep);
  for (int i = begin + 1; i <= begin + kGrid; ++i) {
    const RemainingDisplacement next = rest_after(from, to, c, i * kGridStep, moved);
    if ((last.aside < 0) != (next.aside < 0) && std::abs(last.second - next.second) < kPi)
      take((i - 1) * kGridStep, i * kGridStep, (i - 1 + last.aside / (last.aside - next.aside)) * kGridStep);
    last = next;
  }
}

}  // namespace

std::vector<double> TurnsInPlan::breaks() const {
  std::vector<double> at{before};
  const auto add = [&](const Bend& bend, double straight) {
    const double begin = at.back();
    if (bend.length() > 0) at.insert(at.end(), {begin, begin + bend.ramp(), begin + bend.ramp() + bend.arc()});
    at.push_back(begin + bend.length());
    at.push_back(at.back() + straight);
  };
  add(first, between), add(second, after);
  return at;
}

TurnsInPlan::At TurnsInPlan::at(double u) const {
  double begin = 0, end = before;
  if (u <= end) return {first.from, 0};
  begin = end, end = begin + first.length();
  if (u <= end) return {first.angle(u - begin), first.bend(u - begin)};
  begin = end, end = begin + between;
  if (u <= end) return {first.to, 0};
  begin = end, end = begin + second.length();
  if (u <= end) return {second.angle(u - begin), second.bend(u - begin)};
  return {second.to, 0};
}

std::vector<TurnChoice> turn_choices(const PlanPose& from, const PlanPose& to, std::span<const double> radii,
                                     std::span<const double> straights, double shortest) {
  std::vector<TurnChoice> choices;
  const auto add_sides = [&](TurnChoice c) {
    for (c.first = -1; c.first <= 1; c.first += 2)
      for (c.second = -1; c.second <= 1; c.second += 2) add_roots(from, to, c, choices);
  };
  TurnChoice c;
  c.shortest = shortest;
  for (const double radius : radii) {
    c.radius = radius;
    for (const double before : straights)
      for (const double after : straights) c.before = before, c.after = after, add_sides(c);
    c.before = c.after = 0;
    c.more_first = 1, add_sides(c), c.more_first = 0;
    c.more_second = 1, add_sides(c), c.more_second = 0;
  }
  return choices;
}

// By regula falsi (Illinois): a few steps from a bracket of 2.5 degrees.
std::optional<TurnsInPlan> exact_turns(const PlanPose& from, const PlanPose& to, const TurnChoice& choice) {
  constexpr int kSteps = 60;
  constexpr double kDone = 1e-11;  // m
  const auto moved = [](double angle, const TurnChoice& c) { return turn_of(c, 0, angle).run_and_rise(); };
  const auto rest = [&](double turn) { return rest_after(from, to, choice, turn, moved); };
  // The interpolated root may lie just outside the exact bracket.
  double low = std::max(0.0, choice.low - 0.01), high = choice.high + 0.01;
  if (choice.low == choice.high) low = high = choice.low;
  const RemainingDisplacement at_low = rest(low), at_high = rest(high);
  RemainingDisplacement here = at_low;
  double turn = low, aside_low = at_low.aside, aside_high = at_high.aside;
  if (low < high && ((aside_low < 0) == (aside_high < 0) || std::abs(at_low.second - at_high.second) > kPi))
    return std::nullopt;
  int side = 0;  // of the last two steps
  for (int i = 0; i < kSteps && low < high; ++i) {
    turn = (low * aside_high - high * aside_low) / (aside_high - aside_low);
    here = rest(turn);
    if (std::abs(here.aside) < kDone) break;
    const bool above = (here.aside < 0) == (aside_high < 0);
    (above ? high : low) = turn, (above ? aside_high : aside_low) = here.aside;
    if (side == (above ? 1 : -1)) (above ? aside_low : aside_high) *= 0.5;
    side = above ? 1 : -1;
  }
  if (!(std::abs(here.aside) < 1e-8) || here.ahead < 0) return std::nullopt;
  return turns_of(from, choice, turn, here);
}

namespace {

using glm::dvec3;

// Returns the piece in which the curvature falls from k towards `towards` to 0, as 1 - soft_step().
LeadPiece ease_piece(dvec3 forward, dvec3 towards, double k) {
  LeadPiece piece{forward, towards, glm::cross(forward, towards), 0, {}};
  const double length = std::min(kLongestEase, 2.0 * kEaseAngle / k);
  piece.length = length;
  piece.rate = [k, length](double u) {
    const double v = u / length, angle = k * length * (v - soft_step_integral(v));
    const double rate = k * (1.0 - soft_step(v));
    const auto [sin, cos] = base::sin_cos(angle);
    return ElementDerivatives{{cos, sin, 0}, {-sin * rate, cos * rate, 0}, dvec3(0), 0};
  };
  return piece;
}

// Sets the up of the ease so that it is `after` (in the world) at its end.
void carry_up(LeadPiece& ease, dvec3 after) {
  const dvec3 local(glm::dot(after, ease.forward), glm::dot(after, ease.up), glm::dot(after, ease.left));
  const double k = ease.rate(0).d2.y, length = ease.length, whole = 0.5 * k * length;
  ease.rate = [rate = ease.rate, local, k, length, whole](double u) {
    ElementDerivatives r = rate(u);
    const double v = u / length, angle = k * length * (v - soft_step_integral(v));
    r.up = curve::rotate(local, {0, 0, 1}, angle - whole);
    return r;
  };
}

// Returns the level direction in which a track bends upright: its own, but a steep track turns towards its riders'
// heads if it points down, and away from them if it points up.
dvec3 ahead_of(dvec3 forward, dvec3 up) {
  constexpr double kVertical = 1e-6, kSteep = 0.87, kSure = 0.2;
  const dvec3 level(forward.x, 0, forward.z), wish = (forward.y < 0 ? 1.0 : -1.0) * dvec3(up.x, 0, up.z);
  if (glm::length(level) < kVertical) return curve::perpendicular({0, 1, 0}, wish);
  const dvec3 ahead = glm::normalize(level);
  return std::abs(forward.y) > kSteep && glm::dot(ahead, wish) < -kSure ? -ahead : ahead;
}

}  // namespace

CircuitLead lead_from(const TrackEnd& end, double radius) {
  CircuitLead lead;
  const double k = glm::length(end.curvature);
  const bool bent = k >= kStraightEnd;
  ElementPath path(end.position, end.forward, bent ? end.curvature : dvec3(0), end.up);
  const auto add = [&] {
    const LeadPiece& piece = lead.pieces.back();
    path.set_axes(piece.forward, piece.up, piece.left);
    path.add(piece.length, piece.rate);
  };
  if (bent) lead.pieces.push_back(ease_piece(end.forward, curve::perpendicular(end.forward, end.curvature), k)), add();
  const dvec3 forward = path.end().tangent, ahead = ahead_of(forward, end.up);
  const double angle = base::arc_tangent(forward.y, glm::dot(forward, ahead)), gentle = base::radians(kGentle_deg);
  if (std::abs(angle) > gentle) {
    lead.steep = true;
    const Bend bend{angle, angle < 0 ? -0.75 * gentle : 0.75 * gentle, radius};
    const dvec3 up(0, 1, 0), left = glm::cross(up, ahead);
    if (bent) {
      const auto [sin, cos] = base::sin_cos(angle);
      carry_up(lead.pieces.back(), -sin * ahead + cos * up);
    }
    lead.pieces.push_back(
        {ahead, up, left, bend.length(), [bend](double u) { return upright_rate(bend.angle(u), bend.bend(u)); }});
    add();
  }
  const ElementPoint& last = path.end();
  lead.pose = {{last.position.x, last.position.z}, base::arc_tangent(last.tangent.z, last.tangent.x)};
  lead.height = last.position.y;
  lead.slope = last.tangent.y / std::sqrt(last.tangent.x * last.tangent.x + last.tangent.z * last.tangent.z);
  lead.length = last.s;
  return lead;
}

CircuitLead lead_to(TrackEnd home, double radius) {
  home.forward = -home.forward;
  CircuitLead lead = lead_from(home, radius);
  std::reverse(lead.pieces.begin(), lead.pieces.end());
  for (LeadPiece& piece : lead.pieces)
    piece.rate = [rate = piece.rate, length = piece.length](double u) {
      ElementDerivatives r = rate(length - u);
      r.d1 = -r.d1;
      return r;
    };
  lead.pose.heading += base::kPi;
  lead.slope = -lead.slope;
  return lead;
}

void add_lead(const CircuitLead& lead, ElementPath& path) {
  for (const LeadPiece& piece : lead.pieces) {
    path.set_axes(piece.forward, piece.up, piece.left);
    path.add(piece.length, piece.rate);
  }
}

namespace {

constexpr double kLeastWeight = 0.25;  // g: if less presses riders down, banking no longer follows it
constexpr double kMostFade = 0.45;     // of the whole length
constexpr double kSlopeError = 1.5;    // rad/s^2, for each span's roll: a joint of two of them jolts 0.37 g

// Returns the felt direction perpendicular to the track. Its upright part is smoothed to stay above 0, so that airtime
// turns nobody over: sqrt(x^2 + c^2) instead of |x|.
dvec3 felt_up(dvec3 tangent, dvec3 curvature, double square) {
  const dvec3 upright = curve::perpendicular(tangent, {0, 1, 0}), aside = glm::cross(upright, tangent);
  const dvec3 felt = square * curvature + dvec3(0, world::kGravity, 0);
  const double up = glm::dot(felt, upright), least = kLeastWeight * world::kGravity;
  return glm::normalize(0.5 * (up + std::sqrt(up * up + least * least)) * upright + glm::dot(felt, aside) * aside);
}

// Returns the squared speeds at the points of a curve that starts at the open end.
std::vector<double> squares_on(const CircuitTask& task, const ElementCurve& curve) {
  std::vector<double> squares;
  for (const ElementPoint& p : curve.points)
    squares.push_back(square_speed(task, p.position.y - curve.points.front().position.y, p.s));
  return squares;
}

std::vector<double> merged(std::vector<double> a, const std::vector<double>& b, double end) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  std::vector<double> out;
  for (const double u : a)
    if (u > (out.empty() ? 0.0 : out.back()) + 1e-6 && u < end - 1e-6) out.push_back(u);
  out.push_back(end);
  return out;
}

// Adds the curve between the leads.
void add_middle(const ClosingCurve& closing, ElementPath& path) {
  path.set_axes({1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  const double end = closing.turns.length();
  double begin = 0;
  for (const double u : merged(closing.turns.breaks(), closing.heights.breaks(), end)) {
    path.add(u - begin, [&closing, begin](double v) {
      const TurnsInPlan::At turn = closing.turns.at(begin + v);
      const HeightProfile::At height = closing.heights.at(begin + v);
      const auto [sin, cos] = base::sin_cos(turn.angle);
      return ElementDerivatives{
          {cos, height.slope, -sin}, {-sin * turn.bend, height.change, -cos * turn.bend}, dvec3(0), 0};
    });
    begin = u;
  }
}

void turn_up(ElementPoint& p, double angle, double spin) {
  p.up = curve::perpendicular(p.tangent, curve::rotate(p.up, p.tangent, angle));
  p.spin += spin;
}

void add_break(ElementCurve& curve, std::size_t at) {
  const auto place = std::lower_bound(curve.breaks.begin(), curve.breaks.end(), at);
  if (place != curve.breaks.end() && *place != at) curve.breaks.insert(place, at);
}

std::size_t first_from(const ElementCurve& curve, double s) {
  return static_cast<std::size_t>(std::ranges::lower_bound(curve.points, s, {}, &ElementPoint::s) -
                                  curve.points.begin());
}

// Turns one end of the curve to the required roll, spin and slope: the start, or with `last` the end, seen backwards.
void fade_end(const TrackEnd& end, double slope, const std::vector<double>& squares, bool last, ElementCurve& curve) {
  std::vector<ElementPoint>& points = curve.points;
  const std::size_t all = points.size();
  const double whole = curve.length(), sign = last ? -1.0 : 1.0;
  const auto index = [&](std::size_t i) { return last ? all - 1 - i : i; };
  const ElementPoint& first = points[index(0)];
  const double angle = curve::signed_angle(first.up, curve::perpendicular(first.tangent, end.up), first.tangent),
               square = squares[index(0)], most = kMostFade * whole, most_slope = fade_slope(most, square),
               more = std::clamp(slope - slopes_at(first, points[index(1)], points[index(2)]).spin, -most_slope,
                                 most_slope);  // more than that jolts
  const RollFade fade(std::min(fade_length(angle, more, square), most), angle, sign * (end.spin - first.spin), more);
  for (std::size_t i = 0; i < all; ++i) {
    ElementPoint& p = points[index(i)];
    const double s = last ? whole - p.s : p.s;
    if (s >= fade.length()) break;
    turn_up(p, fade.angle(s), sign * fade.spin(s));
  }
  for (const double s : {fade.first_joint(), fade.second_joint(), fade.length()})
    add_break(curve, first_from(curve, last ? whole - s : s));
}

}  // namespace

double square_speed(const CircuitTask& task, double rise, double length) {
  const double start = task.speed * task.speed;
  if (!task.coasts) return start;
  const double drag = 1.0 / (1.0 + 2.0 * double{task.losses.drag} * length);  // exp(-2 C s) to first order
  return start * drag - 2.0 * world::kGravity * (rise + double{task.losses.rolling} * length);
}

double lowest_of(const HeightProfile& heights) {
  constexpr int kSteps = 64;
  double lowest = heights.start;
  const double length = heights.length();
  for (int i = 1; i <= kSteps; ++i) lowest = std::min(lowest, heights.at(length * i / kSteps).height);
  return lowest;
}

std::optional<FeltRange> estimate(const CircuitTask& task, const ClosingCurve& closing, int steps) {
  constexpr double kSteepestRollRate = 5.8;  // of soft_step()'s second derivative, over a ramp
  FeltRange felt;
  const double length = closing.turns.length(), from = task.from.position.y;
  for (int i = 0; i <= steps; ++i) {
    const double u = length * i / steps;
    const HeightProfile::At h = closing.heights.at(u);
    const double square = square_speed(task, h.height - from, closing.in.length + u * std::sqrt(1 + h.slope * h.slope));
    if (square < slowest(task) * slowest(task)) return std::nullopt;
    const double flat = 1.0 + h.slope * h.slope, root = std::sqrt(flat);
    const double side = square * closing.turns.at(u).bend / (flat * world::kGravity),
                 up = 1.0 / root + square * h.change / (flat * root * world::kGravity);
    felt.most = std::max(felt.most, std::sqrt(side * side + up * up));
    felt.least = std::min(felt.least, up);
  }
  const TurnsInPlan& turns = closing.turns;
  for (const auto& [bend, begin] :
       {std::pair{&turns.first, turns.before}, {&turns.second, length - turns.after - turns.second.length()}}) {
    const double ramp = bend->ramp();
    if (!(ramp > 0)) continue;
    for (const double u : {begin, begin + bend->length()}) {
      const double square = square_speed(task, closing.heights.at(u).height - from, closing.in.length + u),
                   side = square / (bend->radius * world::kGravity);
      felt.side = std::max(felt.side, square * task.riders * kSteepestRollRate * side / std::sqrt(1 + side * side) /
                                          (ramp * ramp * world::kGravity));
    }
  }
  return felt;
}

std::vector<ClosingPlace> rough_line(const CircuitTask& task, const ClosingCurve& closing, double step) {
  const double length = closing.turns.length(), from = task.from.position.y;
  constexpr int kMostPlaces = 300;
  const int steps = std::clamp(static_cast<int>(length / step) + 1, 2, kMostPlaces);
  const double each = length / steps;
  std::vector<ClosingPlace> line;
  dvec2 at = closing.in.pose.place;
  double s = closing.in.length;
  for (int i = 0; i <= steps; ++i) {
    const double u = each * i;
    const TurnsInPlan::At turn = closing.turns.at(u);
    const HeightProfile::At h = closing.heights.at(u);
    const auto [sin, cos] = base::sin_cos(turn.angle);
    const double flat = 1.0 + h.slope * h.slope, root = std::sqrt(flat);
    const dvec3 d1(cos, h.slope, sin), d2(-sin * turn.bend, h.change, cos * turn.bend), tangent = d1 / root;
    const dvec3 curvature = curve::across(d2, tangent) / flat, place(at.x, h.height, at.y);
    const dvec3 up = felt_up(tangent, curvature, std::max(0.0, square_speed(task, h.height - from, s)));
    line.push_back({s, place + task.rails * up, up});
    at += integral(each, 1, [&](double v) {
      const auto [side, ahead] = base::sin_cos(closing.turns.at(u + v).angle);
      return dvec2(ahead, side);
    });
    s += root * each;
  }
  return line;
}

ElementCurve ideal_closing(const CircuitTask& task, const ClosingCurve& closing) {
  const TrackEnd& from = task.from;
  ElementPath path(from.position, from.forward, glm::length(from.curvature) < kStraightEnd ? dvec3(0) : from.curvature,
                   from.up, from.spin);
  add_lead(closing.in, path);
  const std::size_t middle = path.curve().points.size() - 1;
  add_middle(closing, path);
  const std::size_t after = path.curve().points.size() - 1;
  add_lead(closing.out, path);
  ElementCurve curve = path.curve();
  ElementPoint& last = curve.points.back();
  last.position = task.home.position, last.tangent = task.home.forward, last.curvature = task.home.curvature;
  const std::vector<double> squares = squares_on(task, curve);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    ElementPoint& p = curve.points[i];
    const bool kept = (closing.in.steep && i < middle) || (closing.out.steep && i > after);
    p.slope_error = kSlopeError / std::max(squares[i], 1.0);
    p.up = kept ? curve::perpendicular(p.tangent, p.up) : felt_up(p.tangent, p.curvature, std::max(0.0, squares[i]));
  }
  measure_spins(curve);
  fade_end(from, task.from_slope, squares, false, curve), fade_end(task.home, task.home_slope, squares, true, curve);
  curve.points.back().up = task.home.up;
  curve.points.front().spin = from.spin, curve.points.back().spin = task.home.spin;
  merge_short_pieces(curve);
  return curve;
}

// By differences over the points, which are at most 0.25 m apart: along and bend of the riders' line.
FeltRange felt_on(const CircuitTask& task, const ElementCurve& curve) {
  const std::vector<double> squares = squares_on(task, curve);
  const double whole = curve.length(), lift = task.riders / world::kGravity;
  const auto brought = [&](double slope, double square, double s) {  // g, at s m from an end
    return lift * square * std::abs(slope) * std::max(0.0, 1.0 - s / kFadeTaper);
  };
  FeltRange felt;
  const std::vector<ElementPoint>& points = curve.points;
  const auto riders = [&](std::size_t i) { return points[i].position + task.riders * points[i].up; };
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before = points[i].s - points[i - 1].s, after = points[i + 1].s - points[i].s, both = before + after;
    const dvec3 in = (riders(i) - riders(i - 1)) / before, out = (riders(i + 1) - riders(i)) / after;
    const dvec3 along = (in * after + out * before) / both, bend = 2.0 * (out - in) / both;
    const double push = 0.5 * (squares[i + 1] - squares[i - 1]) / both;
    const dvec3 g = (squares[i] * bend + push * along) / world::kGravity + dvec3(0, 1, 0);
    const double up = glm::dot(g, points[i].up), side = glm::dot(g, glm::cross(points[i].up, points[i].tangent));
    felt.most = std::max(felt.most, up), felt.least = std::min(felt.least, up);
    felt.side = std::max(felt.side, std::abs(side) - brought(task.from_slope, squares.front(), points[i].s) -
                                        brought(task.home_slope, squares.back(), whole - points[i].s));
  }
  return felt;
}

}  // namespace coaster::sim
