#include "sim/study/riders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/portable_math.h"
#include "sim/ride/simulated_ride.h"
#include "sim/solids/track_mesh.h"
#include "sim/study/force_limits.h"
#include "world/laboratory.h"

namespace coaster::sim {
namespace {

constexpr double kDegrees = 180.0 / base::kPi;

double magnitude(const FeltAcceleration& force) {
  const double up = force.up, left = force.left, forward = force.forward;
  return std::sqrt(up * up + left * left + forward * forward);
}

void fill_jerk(const SimulatedRide& simulated, int car, float FeltAcceleration::*axis, double cutoff,
               std::vector<RiderSample>& samples) {
  const std::vector<float> felt = low_passed_g(simulated, car, axis, cutoff);
  for (std::size_t k = 0; k < felt.size(); ++k) {
    const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, felt.size() - 1);
    if (after == before) continue;
    samples[k].jerk.*axis =
        (felt[after] - felt[before]) * static_cast<float>(kForceRate / static_cast<double>(after - before));
  }
}

void fill_roll_and_height(const SimulatedRide& simulated, int car, const RailTables& tables,
                          const DerivedTrack& derived, std::vector<RiderSample>& samples) {
  std::size_t hint = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const RideSample& moving = simulated.samples[simulated.sample_of(k)];
    const double distance = simulated.distance(simulated.sample_of(k), car), s = tables.locate(distance, hint);
    samples[k].height = static_cast<float>(rail_at(tables.segment(hint), s).height);
    if (!simulated.closed && !(distance >= 0 && distance <= simulated.track_length))
      continue;  // on the straight continuation
    const SegmentShape& shape = derived.shape_at(hint);
    const double spin = shape.roll.spin(s), v = moving.speed;
    samples[k].roll_rate = static_cast<float>(kDegrees * spin * v);
    samples[k].roll_acceleration =
        static_cast<float>(kDegrees * (shape.roll.slope(s) * v * v + spin * moving.acceleration));
  }
}

// The entries at which a car is farther along than ever before, by position.
class Passages {
 public:
  explicit Passages(const Rider& rider) : rider_(rider) {
    const bool backwards = runs_backwards(*rider.simulated);
    for (std::size_t k = 0; k < rider.entries(); ++k) {
      const double place = rider.place(k);
      if (places_.empty() || (backwards ? place < places_.back() : place > places_.back()))
        places_.push_back(place), entries_.push_back(k);
    }
    if (backwards) std::reverse(places_.begin(), places_.end()), std::reverse(entries_.begin(), entries_.end());
  }
  const std::vector<double>& places() const { return places_; }
  const std::vector<std::size_t>& entries() const { return entries_; }

  // A position between two entries.
  struct Between {
    std::size_t from, to;
    double part;
  };
  std::optional<Between> find(double place) const {
    if (const auto here = within(place)) return here;
    if (!rider_.simulated->closed) return std::nullopt;
    const double length = rider_.simulated->track_length;
    if (const auto later = within(place + length)) return later;
    return within(place - length);
  }
  double value(const Between& at, RideValue value) const {
    const double from = rider_.value(at.from, value);
    return at.part == 0 ? from : from + at.part * (rider_.value(at.to, value) - from);
  }

 private:
  std::optional<Between> within(double place) const {
    if (places_.empty() || !(place >= places_.front() && place <= places_.back())) return std::nullopt;
    const auto above = std::upper_bound(places_.begin(), places_.end(), place);
    const auto i = static_cast<std::size_t>(above - places_.begin()) - 1;
    if (above == places_.end()) return Between{entries_[i], entries_[i], 0};
    return Between{entries_[i], entries_[i + 1], (place - places_[i]) / (places_[i + 1] - places_[i])};
  }

  Rider rider_;
  std::vector<double> places_;
  std::vector<std::size_t> entries_;
};

double time_of(const SimulatedRide& simulated, std::size_t entry) {
  return SimulatedRide::time_of(simulated.sample_of(entry));
}

// Fills the curves at `count` points; of(rider, point, value) returns nothing for a car that does not count there.
template <class Of>
void fill(std::size_t riders, std::size_t count, const Of& of, SeatCurves& curves) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < kRideValueCount; ++v) {
    std::vector<double>&least = curves.least[v], &most = curves.most[v];
    least.assign(count, kNone);
    if (riders > 1) most.assign(count, -kNone);
    for (std::size_t i = 0; i < riders; ++i)
      for (std::size_t k = 0; k < count; ++k) {
        const std::optional<double> value = of(i, k, static_cast<RideValue>(v));
        if (!value) continue;
        least[k] = std::min(least[k], *value);
        if (riders > 1) most[k] = std::max(most[k], *value);
      }
  }
}

// --- Figures of each section of the track: length, heights, and of a ride the speeds and g

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

double Rider::value(std::size_t k, RideValue value) const {
  const FeltAcceleration& force = simulated->felt(k, car);
  switch (value) {
    case RideValue::vertical: return force.up;
    case RideValue::lateral: return force.left;
    case RideValue::longitudinal: return force.forward;
    case RideValue::jerk: return magnitude(samples[k].jerk);
    case RideValue::jerk_up: return samples[k].jerk.up;
    case RideValue::jerk_side: return samples[k].jerk.left;
    case RideValue::jerk_forward: return samples[k].jerk.forward;
    case RideValue::roll_rate: return samples[k].roll_rate;
    case RideValue::roll_acceleration: return samples[k].roll_acceleration;
    case RideValue::speed: return simulated->samples[simulated->sample_of(k)].speed;
    case RideValue::height: return samples[k].height;
  }
  return 0;
}

void Riders::update(const SimulatedRide& simulated, const RailTables& tables, const DerivedTrack& derived,
                    double cutoff, CarRange cars) {
  if (serial_ != simulated.serial || cutoff_ != cutoff) samples_.clear();
  simulated_ = &simulated, serial_ = simulated.serial, cutoff_ = cutoff;
  samples_.resize(static_cast<std::size_t>(simulated.start.cars));
  for (int car = cars.first; car <= cars.last; ++car) {
    std::vector<RiderSample>& samples = samples_[static_cast<std::size_t>(car)];
    if (!samples.empty()) continue;
    samples.resize(Rider{&simulated}.entries());
    for (float FeltAcceleration::*const axis :
         {&FeltAcceleration::up, &FeltAcceleration::left, &FeltAcceleration::forward})
      fill_jerk(simulated, car, axis, cutoff, samples);
    fill_roll_and_height(simulated, car, tables, derived, samples);
  }
}

Rider Riders::car(int index) const {
  COASTER_CHECK(simulated_ != nullptr && index >= 0 && static_cast<std::size_t>(index) < samples_.size(),
                "the train has this car");
  return {simulated_, index, samples_[static_cast<std::size_t>(index)], cutoff_};
}

std::vector<Rider> Riders::cars(CarRange range) const {
  std::vector<Rider> riders;
  for (int i = range.first; i <= range.last; ++i) riders.push_back(car(i));
  return riders;
}

CarRange cars_of(world::Seat seat, int own, int cars) {
  const int last = std::max(0, cars - 1), chosen = std::clamp(own - 1, 0, last);
  switch (seat) {
    case world::Seat::front: return {0, 0};
    case world::Seat::middle: return {cars / 2, cars / 2};
    case world::Seat::back: return {last, last};
    case world::Seat::all: return {0, last};
    case world::Seat::car: return {chosen, chosen};
  }
  return {};
}

SeatCurves curves_by_place(std::span<const Rider> riders) {
  std::vector<Passages> passages;
  for (const Rider& rider : riders) passages.emplace_back(rider);
  const Passages& grid = passages[riders.size() / 2];
  const std::size_t count = grid.places().size();
  SeatCurves curves;
  curves.place = grid.places();
  for (const std::size_t entry : grid.entries()) curves.time.push_back(time_of(*riders.front().simulated, entry));
  std::vector<std::optional<Passages::Between>> at(riders.size() * count);
  for (std::size_t i = 0; i < riders.size(); ++i)
    for (std::size_t k = 0; k < count; ++k) at[i * count + k] = passages[i].find(curves.place[k]);
  fill(
      riders.size(), count,
      [&](std::size_t i, std::size_t k, RideValue value) {
        const auto& between = at[i * count + k];
        return between ? std::optional(passages[i].value(*between, value)) : std::nullopt;
      },
      curves);
  return curves;
}

SeatCurves curves_by_time(std::span<const Rider> riders) {
  const Rider& middle = riders[riders.size() / 2];
  SeatCurves curves;
  for (std::size_t k = 0; k < middle.entries(); ++k)
    curves.place.push_back(middle.place(k)), curves.time.push_back(time_of(*middle.simulated, k));
  fill(
      riders.size(), middle.entries(),
      [&](std::size_t i, std::size_t k, RideValue value) { return std::optional(riders[i].value(k, value)); }, curves);
  return curves;
}

std::optional<double> value_at(const Rider& rider, double distance, RideValue value) {
  if (value == RideValue::speed) {
    const auto passing = PassingLookup(*rider.simulated).at(distance, rider.car * rider.simulated->start.spacing);
    return passing ? std::optional(passing->speed) : std::nullopt;
  }
  const Passages passages(rider);
  const auto at = passages.find(distance);
  return at ? std::optional(passages.value(*at, value)) : std::nullopt;
}

Extreme most_of(std::span<const Rider> riders, RideValue value) {
  Extreme most;
  for (const Rider& rider : riders)
    for (std::size_t k = 0; k < rider.entries(); ++k)
      if (const double here = rider.value(k, value); std::abs(here) > std::abs(most.value))
        most = {here, time_of(*rider.simulated, k), rider.simulated->distance(rider.simulated->sample_of(k), rider.car),
                rider.car};
  return most;
}

// --- Loads of a car's wheels

LoadsByWheelKind WheelLoads::of(WheelSet set) const {
  constexpr std::array<unsigned, base::count_of<WheelSet>()> kMembers{0b1111, 0b0011, 0b1100, 0b0101, 0b1010,
                                                                      0b0001, 0b0010, 0b0100, 0b1000};
  LoadsByWheelKind sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if ((kMembers[static_cast<std::size_t>(set)] >> i & 1u) == 0) continue;
    sum.road += corners[i].road, sum.up_stop += corners[i].up_stop, sum.side += corners[i].side;
  }
  return sum;
}

WheelLoads wheel_loads(const FeltAcceleration& felt, const CarBody& car) {
  const double weight = 1e-3 * car.mass * world::kGravity;                      // kN per g
  const double pitch = felt.forward * car.height / (kBogieShare * car.length),  // g from front to rear,
      roll = felt.left * car.height / kGauge;                                   // from left to right
  WheelLoads loads;
  for (std::size_t i = 0; i < loads.corners.size(); ++i) {
    const double ahead = i < 2 ? 1 : -1, left = i % 2 == 0 ? 1 : -1;
    const double up = weight * (0.25 * felt.up - 0.5 * ahead * pitch - 0.5 * left * roll);
    loads.corners[i] = {std::max(up, 0.0), std::max(-up, 0.0), std::max(0.5 * left * weight * felt.left, 0.0)};
  }
  return loads;
}

WheelLoads wheel_loads(const world::Document& document, const DerivedTrack& derived, world::Entity train,
                       const world::TrainMotion& motion) {
  const world::Train& design = document.entities.get<world::Train>(train);
  return wheel_loads(felt(document, derived, train, motion), {design.mass, design.body(), document.heartline});
}

WheelLoads wheel_loads(const SimulatedRide& simulated, std::size_t entry, int car) {
  return wheel_loads(simulated.felt(entry, car), {simulated.start.mass, simulated.start.length, simulated.heartline});
}

const SectionFigures& SectionTable::of(const world::SectionRun& run) const {
  const auto found = std::ranges::find(rows, run.section, [](const SectionFigures& row) { return row.run.section; });
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
