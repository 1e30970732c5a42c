#include "sim/plan/force_bridge.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// P(u) by the values and first two derivatives at u = 0 and 1.
class Quintic {
 public:
  Quintic(const TrackEnd& from, const TrackEnd& to, double size)
      : p_{from.position, size * from.forward, 0.5 * size * size * from.curvature} {
    const dvec3 place = to.position - p_[0] - p_[1] - p_[2], rate = size * to.forward - p_[1] - 2.0 * p_[2],
                bend = size * size * to.curvature - 2.0 * p_[2];
    p_[3] = 10.0 * place - 4.0 * rate + 0.5 * bend;
    p_[4] = -15.0 * place + 7.0 * rate - bend;
    p_[5] = 6.0 * place - 3.0 * rate + 0.5 * bend;
  }
  dvec3 at(double u) const { return p_[0] + u * (p_[1] + u * (p_[2] + u * (p_[3] + u * (p_[4] + u * p_[5])))); }
  dvec3 rate(double u) const {
    return p_[1] + u * (2.0 * p_[2] + u * (3.0 * p_[3] + u * (4.0 * p_[4] + u * 5.0 * p_[5])));
  }
  dvec3 second(double u) const { return 2.0 * p_[2] + u * (6.0 * p_[3] + u * (12.0 * p_[4] + u * 20.0 * p_[5])); }

 private:
  std::array<dvec3, 6> p_;
};

// A cubic roll by arc length against the frame of least rotation: angle and spin at both ends.
struct CubicRoll {
  double length, first, last, twist;  // m, rad/m, rad/m, rad
  double square() const { return (3 * twist / length - 2 * first - last) / length; }
  double cube() const { return (first + last - 2 * twist / length) / (length * length); }
  double angle(double s) const { return s * (first + s * (square() + s * cube())); }
  double spin(double s) const { return first + s * (2 * square() + s * 3 * cube()); }
  double slope(double s) const { return 2 * square() + s * 6 * cube(); }
};

// A place of the curve: the train there, what a program that leads along it wants, and where that is on the keys' axis.
struct Place {
  ForceState state;
  dvec3 curvature{0};
  std::array<double, 3> has{};  // of what a program wants
  double at = 0;                // m or s
};

// Returns places half a metre apart with frames of least rotation; none where the curve has a cusp.
std::vector<Place> places_of(const Quintic& curve, const TrackEnd& from, double size) {
  constexpr double kStep = 0.5;  // m
  const auto steps = static_cast<std::size_t>(std::ceil(size / kStep)) + 1;
  std::vector<Place> places;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(steps);
    const dvec3 rate = curve.rate(u);
    const double square = glm::dot(rate, rate);
    if (!(square > 1e-6)) return {};
    Place here;
    ForceState& state = here.state;
    state.position = curve.at(u), state.tangent = rate / std::sqrt(square);
    here.curvature = curve::across(curve.second(u), state.tangent) / square;
    state.up = curve::perpendicular(state.tangent, i == 0 ? from.up : places.back().state.up);
    if (i > 0) {
      const ForceState& before = places.back().state;
      state.length = before.length + glm::distance(before.position, state.position);
    }
    places.push_back(here);
  }
  return places;
}

// Rolls the frames and rides along; false where the train is too slow.
bool ride(const ForceTask& task, const ForceLaw& law, const CubicRoll& roll, std::vector<Place>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    ForceState& state = places[i].state;
    const ForceState& before = i > 0 ? places[i - 1].state : state;
    const double s = state.length, step = s - before.length;
    state.square = i > 0 ? before.square + 2 * step * law.along(before) : law.start().square;
    state.braking = i > 0 ? before.braking : law.start().braking;
    law.settle(before, state);
    if (law.too_slow(state)) return false;
    state.time = before.time + step / std::sqrt(std::max(state.square, 1e-6));
    state.up = curve::rotate(state.up, state.tangent, roll.angle(s));
    ForceRates track{places[i].curvature, roll.spin(s), roll.slope(s)};
    track.along = law.along(state);
    places[i].has = law.has(state, track);
    places[i].at = task.program.over == world::ForceOver::distance ? s : state.time;
  }
  return true;
}

// Returns about how long a curve between the ends is, as an arc of a circle; nothing for none.
std::optional<double> size_between(const TrackEnd& from, const TrackEnd& to) {
  const double chord = glm::distance(from.position, to.position), cos = glm::dot(from.forward, to.forward);
  if (!(chord > 1) || !(cos > -0.9)) return std::nullopt;
  const double half = base::arc_tangent(std::sqrt(std::max(0.0, (1 - cos) / 2)), std::sqrt((1 + cos) / 2));
  return half > 1e-6 ? chord * half / base::sin_cos(half).sin : chord;
}

}  // namespace

std::optional<ForceBridge> force_bridge(const ForceTask& task, std::size_t parts) {
  const TrackEnd& to = *task.held;
  const std::optional<double> size = size_between(task.end, to);
  if (!size) return std::nullopt;
  std::vector<Place> places = places_of(Quintic(task.end, to, *size), task.end, *size);
  if (places.empty()) return std::nullopt;
  const ForceState& last = places.back().state;
  const double twist = curve::signed_angle(last.up, curve::perpendicular(last.tangent, to.up), last.tangent);
  const ForceLaw law(task);
  if (!ride(task, law, {last.length, task.end.spin, to.spin, twist}, places)) return std::nullopt;
  ForceBridge bridge{places.back().at, {}};
  std::size_t k = 0;
  for (std::size_t i = 0; i <= parts; ++i) {
    const double at = bridge.length * static_cast<double>(i) / static_cast<double>(parts);
    while (k + 2 < places.size() && places[k + 1].at < at) ++k;
    const double share = (at - places[k].at) / (places[k + 1].at - places[k].at);
    const ForceWanted wanted = law.wanted(at);
    const std::array<double, 3> keys{wanted.up.value, wanted.side.value, wanted.roll.value};
    std::array<double, 3>& more = bridge.more.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) more[c] = std::lerp(places[k].has[c], places[k + 1].has[c], share) - keys[c];
  }
  return bridge;
}

}  // namespace coaster::sim
