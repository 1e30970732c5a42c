#include "sim/study/section_figures.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "sim/ride/simulated_ride.h"

namespace coaster::sim {
namespace {

// Returns the largest height of a cubic: at an end, or where its derivative is level.
double top_of(const curve::Cubic& cubic) {
  const curve::CoefficientsD c = curve::coefficients_d(cubic);
  double top = std::max(double{cubic.p0.y}, double{cubic.p3.y});
  const auto consider = [&](double t) {
    if (t > 0 && t < 1) top = std::max(top, curve::point(cubic, t).y);
  };
  const double a = 3 * c.c3.y, b = 2 * c.c2.y, d = c.c1.y;  // a t^2 + b t + d = 0
  if (std::abs(a) < 1e-12) {
    if (b != 0) consider(-d / b);
    return top;
  }
  const double inside = b * b - 4 * a * d;
  if (inside < 0) return top;
  const double q = -0.5 * (b + std::copysign(std::sqrt(inside), b));
  consider(q / a);
  if (q != 0) consider(d / q);
  return top;
}

// The curves of a ride, looked up by position. Positions one lap apart on a closed track are equal.
class AlongRide {
 public:
  AlongRide(const SeatCurves& curves, double lap) : curves_(curves), lap_(lap) {}

  // Returns the index of the first point at or after a position, and the position as the curves count it; nothing if
  // the riders do not reach it.
  struct CurvePosition {
    std::size_t index;
    double place;
  };
  std::optional<CurvePosition> find(double place) const {
    const std::vector<double>& places = curves_.place;
    for (const double here : {place, place + lap_, place - lap_})
      if (!places.empty() && here >= places.front() && here <= places.back())
        return CurvePosition{
            static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), here) - places.begin()), here};
    return std::nullopt;
  }
  // Returns a curve's value there, linear between points.
  double value(const std::vector<double>& curve, const CurvePosition& at) const {
    if (at.index == 0) return curve[0];
    const double from = curves_.place[at.index - 1], to = curves_.place[at.index];
    return curve[at.index - 1] + (at.place - from) / (to - from) * (curve[at.index] - curve[at.index - 1]);
  }
  const std::vector<double>& least(RideValue value) const { return curves_.least[static_cast<std::size_t>(value)]; }
  const std::vector<double>& most(RideValue value) const {
    const std::vector<double>& most = curves_.most[static_cast<std::size_t>(value)];
    return most.empty() ? least(value) : most;
  }
  const std::vector<double>& places() const { return curves_.place; }

 private:
  const SeatCurves& curves_;
  double lap_;
};

// Returns the largest speed of the riders' cars where they pass a position, m/s.
std::optional<double> speed_of(std::span<const Rider> riders, const PassingLookup& passings, double distance) {
  std::optional<double> most;
  for (const Rider& rider : riders)
    if (const auto passing = passings.at(distance, rider.car * rider.simulated->start.spacing))
      most = std::max(most.value_or(passing->speed), passing->speed);
  return most;
}

void add_ride(const AlongRide& ride, double from, double to, SectionFigures& of) {
  const auto in = ride.find(from), out = ride.find(to);
  const auto consider = [&](double up_least, double up_most, double side_least, double side_most) {
    of.g_least = std::min(of.g_least.value_or(up_least), up_least);
    of.g_most = std::max(of.g_most.value_or(up_most), up_most);
    of.g_side = std::max({of.g_side.value_or(0), std::abs(side_least), std::abs(side_most)});
  };
  const auto &up_least = ride.least(RideValue::vertical), &up_most = ride.most(RideValue::vertical),
             &side_least = ride.least(RideValue::lateral), &side_most = ride.most(RideValue::lateral);
  for (const auto& end : {in, out})
    if (end)
      consider(ride.value(up_least, *end), ride.value(up_most, *end), ride.value(side_least, *end),
               ride.value(side_most, *end));
  const auto points = [&](std::size_t k, double place_to) {
    for (; k < ride.places().size() && ride.places()[k] < place_to; ++k)
      consider(up_least[k], up_most[k], side_least[k], side_most[k]);
  };
  if (in) points(in->index, in->place + (to - from));
  // The riders start on it, or arrived over the joint of a closed track.
  if (out && (!in || in->place > out->place)) {
    const double place_from = out->place - (to - from);
    const auto k = std::lower_bound(ride.places().begin(), ride.places().end(), place_from) - ride.places().begin();
    points(static_cast<std::size_t>(k), out->place);
  }
}

}  // namespace

const SectionFigures& SectionTable::of(const world::SectionRun& run) const {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const SectionFigures& row) { return row.run.section == run.section; });
  COASTER_CHECK(found != rows.end(), "every section has its figures");
  return *found;
}

std::vector<SectionFigures> section_figures(const world::Document& document, const DerivedTrack& derived,
                                            std::span<const Rider> riders) {
  std::vector<SectionFigures> all;
  std::optional<SeatCurves> curves;
  std::optional<PassingLookup> passings;
  if (!riders.empty()) curves = curves_by_place(riders), passings.emplace(*riders.front().simulated);
  const std::vector<world::Entity>& knots = document.track.knots;
  const auto height = [&](std::size_t i) { return double{world::knot(document, knots[i % knots.size()]).position.y}; };
  for (const world::SectionRun& run : world::sections_of(document)) {
    SectionFigures of{.run = run};
    const double from = derived.starts[run.first], to = derived.starts[run.end()];
    of.length = to - from, of.start = height(run.first), of.end = height(run.end());
    of.top = std::max(of.start, of.end);
    for (std::size_t i = run.first; i < run.end(); ++i)
      of.top = std::max(of.top, top_of(derived.shape_at(i).key.cubic));
    if (curves) {
      of.speed_in = speed_of(riders, *passings, from), of.speed_out = speed_of(riders, *passings, to);
      add_ride(AlongRide(*curves, derived.closed ? derived.length : 0), from, to, of);
    }
    all.push_back(of);
  }
  return all;
}

}  // namespace coaster::sim
