#include "ui/lab/force_axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "sim/plan/force_quantity.h"

namespace coaster::ui {

using world::ForceChannel;
using world::ForceKey;
using world::ForceOver;

namespace {

// Beyond the end of a path that stopped early: metres per unit of the axis.
double rate_beyond(const sim::ForcePlan& plan) {
  return plan.task.program.over == ForceOver::distance ? 1.0 : std::max(1.0, plan.end_speed);
}

}  // namespace

double ForceAxes::x_of(double at) const {
  const double last = plan_.path.points.back().at;
  const auto length = [&](std::size_t i) { return plan_.path.curve.points[i].s; };
  return start_ + sim::between_points(plan_, at, length) + std::max(0.0, at - last) * rate_beyond(plan_);
}

double ForceAxes::at_of(double x) const {
  const std::vector<sim::ElementPoint>& curve = plan_.path.curve.points;
  const std::vector<sim::ForcePoint>& points = plan_.path.points;
  const double s = x - start_;
  if (s >= curve.back().s) return points.back().at + (s - curve.back().s) / rate_beyond(plan_);
  const auto next = std::upper_bound(curve.begin(), curve.end(), s,
                                     [](double one, const sim::ElementPoint& point) { return one < point.s; });
  if (next == curve.begin()) return 0;
  const auto i = static_cast<std::size_t>(next - curve.begin()) - 1;
  const double gap = curve[i + 1].s - curve[i].s, part = gap > 0 ? (s - curve[i].s) / gap : 0.0;
  return points[i].at + part * (points[i + 1].at - points[i].at);
}

double ForceAxes::reach(ForceChannel channel, std::size_t key, int side) const {
  const std::vector<ForceKey>& keys = program().keys(channel);
  if (side < 0 ? key == 0 : key + 1 >= keys.size()) return 0;
  const double gap = std::abs(keys[side < 0 ? key - 1 : key + 1].at - keys[key].at);
  const double own = side < 0 ? keys[key].before : keys[key].after;
  return own > 0 ? own : gap / 3;
}

double ForceAxes::asked(std::size_t point) const { return plan_.path.points[point].asked(channel_); }

void fill_curves(const sim::Derived& derived, const ForceAxes& axes, ForceKeys& state) {
  state.place.clear(), state.asked.clear(), state.actual.clear();
  const sim::ForcePlan& plan = axes.plan();
  const auto channel = static_cast<std::size_t>(axes.channel());
  for (std::size_t i = 0; i < plan.path.points.size(); ++i) {
    state.place.push_back(axes.start() + plan.path.curve.points[i].s);
    state.asked.push_back(axes.asked(i));
    if (axes.of_curvature()) {
      state.actual.push_back(sim::curvature_at(derived, axes.first(), state.place.back())[channel]);
      continue;
    }
    if (axes.channel() != ForceChannel::roll) continue;
    const sim::TrackPlace place = sim::place_at(derived, state.place.back());
    const double spin = base::degrees(derived.shape_at(place.index).roll.spin(place.s));
    const bool metres = axes.program().over == ForceOver::distance;
    state.actual.push_back(metres ? spin : spin * std::sqrt(std::max(0.0, plan.path.points[i].square)));
  }
}

std::optional<sim::RideValue> ForceAxes::felt() const {
  if (channel_ == ForceChannel::roll) return std::nullopt;
  return channel_ == ForceChannel::vertical ? sim::RideValue::vertical : sim::RideValue::lateral;
}

namespace {

// A range that grows by values, and ends at whole steps beyond them.
struct Range {
  double low, high, step;
  void take(double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  double bottom() const { return std::floor(low / step) * step - step; }
  double top() const { return std::ceil(high / step) * step + step; }
};

Range least_range(const ForceAxes& axes) {
  if (!axes.felt()) return axes.of_curvature() ? Range{-10, 10, 10} : Range{-5, 5, 5};
  return axes.of_curvature() ? Range{-0.01, 0.01, 0.01} : Range{-0.5, 2, 0.5};
}

}  // namespace

ForceEnds shown_ends(const ForceAxes& axes, const std::optional<RidePlots>& ride, const ForceKeys& state) {
  constexpr double kMargin = 0.05;
  const double from = axes.start(), to = axes.x_of(axes.end()), margin = kMargin * (to - from);
  Range own = least_range(axes), felt{-0.5, 2, 0.5};
  for (const double value : state.asked) own.take(value);
  for (const double value : state.actual) own.take(value);
  for (const ForceKey& key : axes.program().keys(axes.channel())) own.take(key.value);
  if (ride && axes.felt()) {
    const sim::SeatCurves& curves = ride->study().curves;
    const auto v = static_cast<std::size_t>(*axes.felt());
    for (std::size_t i = 0; i < curves.place.size(); ++i)
      if (curves.place[i] > from && curves.place[i] < to) (axes.of_curvature() ? felt : own).take(curves.least[v][i]);
  }
  return {from - margin, to + margin, own.bottom(), own.top(), felt.bottom(), felt.top()};
}

std::vector<Level> shown_limits(const sim::Envelope& envelope, const ForceAxes& axes, const ForceEnds& ends) {
  using sim::ForceAxis;
  constexpr double kLasting = 10;  // s
  std::vector<Level> levels;
  const auto add = [&](ForceAxis axis, double sign) {
    for (const double seconds : {envelope.shortest, kLasting}) {
      double y = sign * sim::limit(envelope.curves[static_cast<std::size_t>(axis)], seconds);
      if (axes.of_curvature())
        y = ends.low + (y - ends.felt_low) / (ends.felt_high - ends.felt_low) * (ends.high - ends.low);
      if (y >= ends.low && y <= ends.high)
        levels.push_back({fmt::format("limit, {} s", base::to_text(seconds)), y, 0xE5534B});
    }
  };
  if (axes.channel() == ForceChannel::vertical) add(ForceAxis::down, 1), add(ForceAxis::lift, -1);
  if (axes.channel() == ForceChannel::lateral) add(ForceAxis::side, 1), add(ForceAxis::side, -1);
  return levels;
}

double to_step(double value, double step) {
  const double per_one = std::round(1 / step);
  return per_one >= 1 ? std::round(value * per_one) / per_one : std::round(value / step) * step;
}

}  // namespace coaster::ui
