#include "sim/plan/circuit_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "sim/plan/circuit_fade.h"
#include "world/motion.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

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
void add_middle(const CircuitWay& way, ElementPath& path) {
  path.set_axes({1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  const double end = way.turns.length();
  double begin = 0;
  for (const double u : merged(way.turns.breaks(), way.heights.breaks(), end)) {
    path.add(u - begin, [&way, begin](double v) {
      const Turns::At turn = way.turns.at(begin + v);
      const Heights::At height = way.heights.at(begin + v);
      const auto [sin, cos] = base::sin_cos(turn.angle);
      return ElementRate{{cos, height.slope, -sin}, {-sin * turn.bend, height.change, -cos * turn.bend}, dvec3(0), 0};
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
  return static_cast<std::size_t>(std::lower_bound(curve.points.begin(), curve.points.end(), s,
                                                   [](const ElementPoint& p, double at) { return p.s < at; }) -
                                  curve.points.begin());
}

// Turns one end of the curve to the required roll, spin and slope: the start, or with `last` the end, seen backwards.
void fade_end(const TrackEnd& end, double slope, const std::vector<double>& squares, bool last, ElementCurve& curve) {
  std::vector<ElementPoint>& points = curve.points;
  const std::size_t all = points.size();
  const double whole = curve.length(), way = last ? -1.0 : 1.0;
  const auto index = [&](std::size_t i) { return last ? all - 1 - i : i; };
  const ElementPoint& first = points[index(0)];
  const double angle = curve::signed_angle(first.up, curve::perpendicular(first.tangent, end.up), first.tangent),
               square = squares[index(0)], most = kMostFade * whole, most_slope = fade_slope(most, square),
               more = std::clamp(slope - slopes_at(first, points[index(1)], points[index(2)]).spin, -most_slope,
                                 most_slope);  // more than that jolts
  const RollFade fade(std::min(fade_length(angle, more, square), most), angle, way * (end.spin - first.spin), more);
  for (std::size_t i = 0; i < all; ++i) {
    ElementPoint& p = points[index(i)];
    const double s = last ? whole - p.s : p.s;
    if (s >= fade.length()) break;
    turn_up(p, fade.angle(s), way * fade.spin(s));
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

double lowest_of(const Heights& heights) {
  constexpr int kSteps = 64;
  double lowest = heights.start;
  const double length = heights.length();
  for (int i = 1; i <= kSteps; ++i) lowest = std::min(lowest, heights.at(length * i / kSteps).height);
  return lowest;
}

std::optional<FeltRange> estimate(const CircuitTask& task, const CircuitWay& way, int steps) {
  constexpr double kSteepestRollRate = 5.8;  // of soft_step()'s second derivative, over a ramp
  FeltRange felt;
  const double length = way.turns.length(), from = task.from.position.y;
  for (int i = 0; i <= steps; ++i) {
    const double u = length * i / steps;
    const Heights::At h = way.heights.at(u);
    const double square = square_speed(task, h.height - from, way.in.length + u * std::sqrt(1 + h.slope * h.slope));
    if (square < slowest(task) * slowest(task)) return std::nullopt;
    const double flat = 1.0 + h.slope * h.slope, root = std::sqrt(flat);
    const double side = square * way.turns.at(u).bend / (flat * world::kGravity),
                 up = 1.0 / root + square * h.change / (flat * root * world::kGravity);
    felt.most = std::max(felt.most, std::sqrt(side * side + up * up));
    felt.least = std::min(felt.least, up);
  }
  const Turns& turns = way.turns;
  for (const auto& [bend, begin] :
       {std::pair{&turns.first, turns.before}, {&turns.second, length - turns.after - turns.second.length()}}) {
    const double ramp = bend->ramp();
    if (!(ramp > 0)) continue;
    for (const double u : {begin, begin + bend->length()}) {
      const double square = square_speed(task, way.heights.at(u).height - from, way.in.length + u),
                   side = square / (bend->radius * world::kGravity);
      felt.side = std::max(felt.side, square * task.riders * kSteepestRollRate * side / std::sqrt(1 + side * side) /
                                          (ramp * ramp * world::kGravity));
    }
  }
  return felt;
}

std::vector<WayPlace> rough_line(const CircuitTask& task, const CircuitWay& way, double step) {
  const double length = way.turns.length(), from = task.from.position.y;
  constexpr int kMostPlaces = 300;
  const int steps = std::clamp(static_cast<int>(length / step) + 1, 2, kMostPlaces);
  const double each = length / steps;
  std::vector<WayPlace> line;
  dvec2 at = way.in.pose.place;
  double s = way.in.length;
  for (int i = 0; i <= steps; ++i) {
    const double u = each * i;
    const Turns::At turn = way.turns.at(u);
    const Heights::At h = way.heights.at(u);
    const auto [sin, cos] = base::sin_cos(turn.angle);
    const double flat = 1.0 + h.slope * h.slope, root = std::sqrt(flat);
    const dvec3 d1(cos, h.slope, sin), d2(-sin * turn.bend, h.change, cos * turn.bend), tangent = d1 / root;
    const dvec3 curvature = curve::across(d2, tangent) / flat, place(at.x, h.height, at.y);
    const dvec3 up = felt_up(tangent, curvature, std::max(0.0, square_speed(task, h.height - from, s)));
    line.push_back({s, place + task.rails * up, up});
    at += integral(each, 1, [&](double v) {
      const auto [side, ahead] = base::sin_cos(way.turns.at(u + v).angle);
      return dvec2(ahead, side);
    });
    s += root * each;
  }
  return line;
}

ElementCurve way_curve(const CircuitTask& task, const CircuitWay& way) {
  const TrackEnd& from = task.from;
  ElementPath path(from.position, from.forward, glm::length(from.curvature) < kStraightEnd ? dvec3(0) : from.curvature,
                   from.up, from.spin);
  add_lead(way.in, path);
  const std::size_t middle = path.curve().points.size() - 1;
  add_middle(way, path);
  const std::size_t after = path.curve().points.size() - 1;
  add_lead(way.out, path);
  ElementCurve curve = path.curve();
  ElementPoint& last = curve.points.back();
  last.position = task.home.position, last.tangent = task.home.forward, last.curvature = task.home.curvature;
  const std::vector<double> squares = squares_on(task, curve);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    ElementPoint& p = curve.points[i];
    const bool kept = (way.in.steep && i < middle) || (way.out.steep && i > after);
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
