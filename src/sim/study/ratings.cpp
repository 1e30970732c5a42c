#include "sim/study/ratings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/units.h"
#include "sim/solids/coaster_form.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"
#include "sim/study/jolt.h"
#include "sim/study/riders.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// --- What a ride passes on a land: tunnels, and earth, water and trees near the riders' heads

constexpr double kGroundStep = 2;  // m of the ride between two looks

// The directions in which earth is looked for, as cosine and sine over the horizon: from one side over the top to the
// other, in steps of 22.5 degrees.
constexpr double kSine[] = {0, 0.38268343236508977, 0.70710678118654752, 0.92387953251128676, 1};
constexpr int kWays = 9;
glm::dvec2 way(int i) {
  const int from_level = i < 5 ? i : 8 - i;
  return {(i < 5 ? 1 : -1) * kSine[4 - from_level], kSine[from_level]};
}

// The riders of the first car at one place.
struct HeadOnLand {
  const Ground& ground;
  dvec3 head, across;  // across: unit, level
  const Tunnel* tunnel;

  // Above an open cut is no earth; in a tunnel the tube is what one sees of it.
  bool earth_within(double reach) const {
    if (tunnel != nullptr) return reach >= ground.room().tube;
    for (int i = 0; i < kWays; ++i) {
      const dvec3 to = way(i).x * across + dvec3(0, way(i).y, 0);
      for (const double part : {1.0 / 3, 2.0 / 3, 1.0}) {
        const dvec3 p = head + part * reach * to;
        if (p.y < ground.height(p.x, p.z)) return true;
      }
    }
    return false;
  }
  bool water_within(double reach) const {
    if (tunnel != nullptr || !(ground.height(head.x, head.z) < ground.water())) return false;
    return head.y < ground.water() + reach;
  }
};

Ring ring_along(const DerivedTrack& derived, double distance) {
  const TrackPlace place = place_at(derived, distance);
  return ring_at(derived.shape_at(place.index), place.s);
}

// Calls visit(sample, distance along the track) for samples of the first lap, `step` m or a little more apart.
void each_look(const SimulatedRide& simulated, const DerivedTrack& derived, double step, const auto& visit) {
  double next = 0;
  for (std::size_t i = 0; i < simulated.samples.size() && !base::interrupted(); ++i) {
    const RideSample& sample = simulated.samples[i];
    if (sample.travelled < next) continue;
    if (simulated.closed && sample.travelled > derived.length) break;
    next = sample.travelled + step;
    visit(sample, simulated.distance(i));
  }
}

HeadOnLand head_at(const DerivedTrack& derived, const Ground& ground, double distance) {
  const Ring ring = ring_along(derived, distance);
  return {ground, ring.place(0, form_of(derived.made.kind).head), level_side(ring.frame), ground.tunnel_at(distance)};
}

constexpr double kStep = 2;               // m, of chords and samples
constexpr double kLeastCell = 8;          // m, of cells; as wide as longer chords
constexpr double kMostChordsInAll = 2e5;  // longer tracks have longer chords
constexpr double kSpineDrop = 0.3;        // m below the rails

// A chord of track or a bar of a support.
struct NearMissObject {
  dvec3 from, to;
  double reach;       // m, from its axis to a head that it nearly misses
  double begin, end;  // m along the track; of a bar: of the segment that it holds
  bool support;
};

// Things by the cells that they touch: chords in space, since track may be as high as it is long; bars, which are as
// high as the track that they hold, in plan.
class NearMissGrid {
 public:
  explicit NearMissGrid(double width) : width_(width) {}
  void add(const NearMissObject& thing) {
    const dvec3 low = glm::min(thing.from, thing.to) - thing.reach, high = glm::max(thing.from, thing.to) + thing.reach;
    const int bottom = thing.support ? kAllHeights : cell(low.y), top = thing.support ? kAllHeights : cell(high.y);
    for (int x = cell(low.x); x <= cell(high.x); ++x)
      for (int z = cell(low.z); z <= cell(high.z); ++z)
        for (int y = bottom; y <= top; ++y) entries_.emplace_back(x, z, y, things_.size());
    things_.push_back(thing);
  }
  void sort() { std::sort(entries_.begin(), entries_.end()); }
  template <class Visit>
  void visit(dvec3 place, const Visit& visit) const {
    const int x = cell(place.x), z = cell(place.z);
    for (const int y : {kAllHeights, cell(place.y)})
      for (auto i = std::lower_bound(entries_.begin(), entries_.end(), Entry(x, z, y, 0));
           i != entries_.end() && std::tie(std::get<0>(*i), std::get<1>(*i), std::get<2>(*i)) == std::tie(x, z, y); ++i)
        visit(things_[std::get<3>(*i)]);
  }

 private:
  using Entry = std::tuple<int, int, int, std::size_t>;  // x, z, y, index of the thing
  static constexpr int kAllHeights = std::numeric_limits<int>::min();
  int cell(double v) const { return static_cast<int>(std::floor(v / width_)); }
  double width_;  // m
  std::vector<NearMissObject> things_;
  std::vector<Entry> entries_;
};

NearMissGrid cells_of(const DerivedTrack& derived, const Supports* supports, double step) {
  NearMissGrid cells(std::max(kLeastCell, step));
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    const double length = shape.arc.length();
    const int chords = std::max(1, static_cast<int>(std::ceil(length / step)));
    dvec3 before(0);
    for (int k = 0; k <= chords && !base::interrupted(); ++k) {
      const dvec3 here = ring_at(shape, length * k / chords).place(0, -kSpineDrop);
      if (k > 0)
        cells.add({before, here, kNearTrack, derived.starts[i] + length * (k - 1) / chords,
                   derived.starts[i] + length * k / chords, false});
      before = here;
    }
    const SegmentSupports* const held = supports != nullptr ? supports->of(derived.order[i]) : nullptr;
    if (held == nullptr) continue;
    for (const Bar& bar : held->bars)
      cells.add({dvec3(bar.from), dvec3(bar.to), kNearBar + double{std::max(bar.from_radius, bar.to_radius)},
                 derived.starts[i], derived.starts[i + 1], true});
  }
  cells.sort();
  return cells;
}

void take(Extreme& extreme, double value, bool first, bool larger, std::size_t sample, int car,
          const SimulatedRide& simulated) {
  if (!first && !(larger ? value > extreme.value : value < extreme.value)) return;
  extreme = {value, SimulatedRide::time_of(sample), simulated.distance(sample, car), car};
}

// Updates `extreme` with the largest of a car's low-passed values on one axis.
void take_force(const SimulatedRide& simulated, int car, ForceAxis axis, double cutoff, double sign, Extreme& extreme) {
  const std::vector<float> values = pressed(simulated, car, axis, cutoff);
  for (std::size_t i = 0; i < values.size(); ++i)
    take(extreme, sign * values[i], car == 0 && i == 0, sign > 0, simulated.sample_of(i), car, simulated);
}

void take_forces(const SimulatedRide& simulated, double cutoff, Ratings& r) {
  for (int car = 0; car < simulated.start.cars; ++car) {
    take_force(simulated, car, ForceAxis::down, cutoff, 1, r.up_most);
    take_force(simulated, car, ForceAxis::lift, cutoff, -1, r.up_least);
    take_force(simulated, car, ForceAxis::side, cutoff, 1, r.side_most);
    take_force(simulated, car, ForceAxis::forward, cutoff, 1, r.forward_most);
    take_force(simulated, car, ForceAxis::back, cutoff, 1, r.back_most);
  }
  const std::vector<float> lifted = pressed(simulated, simulated.start.cars / 2, ForceAxis::lift, cutoff);
  r.airtime = static_cast<double>(std::count_if(lifted.begin(), lifted.end(), [](float v) { return v > 0; })) *
              kForceEvery * world::kTick;
}

// The sums over a car's wheels depend on neither the side nor the direction of the force.
void take_wheels(const SimulatedRide& simulated, double cutoff, Ratings& r) {
  const CarBody body{simulated.start.mass, simulated.start.length, simulated.heartline};
  for (int car = 0; car < simulated.start.cars; ++car) {
    const std::vector<float> up = pressed(simulated, car, ForceAxis::down, cutoff),
                             side = pressed(simulated, car, ForceAxis::side, cutoff),
                             forward = pressed(simulated, car, ForceAxis::forward, cutoff);
    for (std::size_t i = 0; i < up.size(); ++i) {
      const LoadsByWheelKind all = wheel_loads(FeltAcceleration{forward[i], side[i], up[i]}, body).of(WheelSet::car);
      const bool first = car == 0 && i == 0;
      take(r.road_most, all.road, first, true, simulated.sample_of(i), car, simulated);
      take(r.up_stop_most, all.up_stop, first, true, simulated.sample_of(i), car, simulated);
      take(r.side_load_most, all.side, first, true, simulated.sample_of(i), car, simulated);
    }
  }
}

void take_jolts(const SimulatedRide& simulated, double cutoff, Ratings& r) {
  const auto add = [&](const JointPassage& passage, const Jolt& jolt) {
    take(r.jolt_most, jolt.total, false, true, simulated.sample_of(passage.entry), passage.car, simulated);
  };
  const std::vector<Jolt> found = passage_jolts(simulated, cutoff);
  for (std::size_t i = 0; i < found.size(); ++i) add(simulated.passages[i], found[i]);
  for (const BendPassage& bend : simulated.bends) add(bend.peak, jolt_of(bend.peak, cutoff));
}

// Updates the heights under the first car: extremes, and descents from a top to the next bottom.
void take_heights(const SimulatedRide& simulated, const RailTables& tables, Ratings& r) {
  std::size_t hint = 0;
  double top = 0, bottom = 0;
  const auto end_drop = [&] {
    const double drop = top - bottom;
    if (drop < kDrop) return;
    ++r.drops;
    r.highest_drop = std::max(r.highest_drop, drop);
  };
  for (std::size_t i = 0; i < simulated.samples.size(); i += kForceEvery) {
    const double s = tables.locate(simulated.distance(i), hint), height = rail_at(tables.segment(hint), s).height;
    take(r.highest, height, i == 0, true, i, 0, simulated), take(r.lowest, height, i == 0, false, i, 0, simulated);
    take(r.top_speed, std::abs(simulated.samples[i].speed), i == 0, true, i, 0, simulated);
    if (i == 0) top = bottom = height;
    constexpr double kNoise = 0.05;  // m of rise that does not end a descent
    if (height < bottom) bottom = height;
    if (height > bottom + kNoise) {
      end_drop();
      top = bottom = height;
    }
    if (height > top) top = bottom = height;
  }
  end_drop();
}

void count_inversions(const SimulatedRide& simulated, const RailTables& tables, Ratings& r) {
  constexpr float kBelow = -0.2f,
                  kAbove = 0.2f;  // of the up vector's height, so that a rider on the side is not counted twice
  const int car = simulated.start.cars / 2;
  std::size_t hint = 0;
  bool inverted = false;
  for (std::size_t i = 0; i < simulated.samples.size(); i += kForceEvery) {
    const double s = tables.locate(simulated.distance(i, car), hint);
    const float up = felt_at(tables.segment(hint), s, 0.0f, 0.0f).z;
    if (!inverted && up < kBelow) ++r.inversions, inverted = true;
    if (up > kAbove) inverted = false;
  }
}

// Returns 0 at 0, 1/2 at `half`, and approaches 1.
double share(double value, double half) { return value > 0 ? value / (value + half) : 0.0; }

template <class... Values>
void add(std::string& out, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

void add_extreme(std::string& out, const ReportRow& figure) {
  const Extreme& e = figure.at;
  add(out, "  {:<22} {:>8} {:<4} at {:7.1f} m, {:6.2f} s, car {}\n", figure.name,
      base::figure_text(e.value, 2, figure.unit), figure.unit, e.distance, e.seconds, e.car + 1);
}

}  // namespace

Surroundings surroundings_of(const SimulatedRide& simulated, const DerivedTrack& derived, const Ground& ground,
                             const Plants& plants) {
  Surroundings around;
  if (ground.plain() || derived.order.empty() || simulated.samples.empty()) return around;
  std::set<const Tunnel*> passed;
  const Tunnel* before = nullptr;
  double last_miss = -std::numeric_limits<double>::infinity();
  int looks = 0, close = 0, inside = 0;
  each_look(simulated, derived, kGroundStep, [&](const RideSample& sample, double at) {
    const HeadOnLand here = head_at(derived, ground, at);
    const double tree = here.tunnel == nullptr ? plants.distance(here.head, kCloseBy) : kCloseBy;
    const bool portal = looks > 0 && here.tunnel != before;
    ++looks, before = here.tunnel;
    if (here.tunnel != nullptr) passed.insert(here.tunnel), ++inside;
    if (tree < kCloseBy || here.water_within(kCloseBy) || here.earth_within(kCloseBy)) ++close;
    if (sample.speed < kSlowestMiss) return;
    if (!portal && !(tree < kNearTree) && !here.water_within(kNearWater) && !here.earth_within(kNearEarth)) return;
    if (sample.travelled - last_miss > kMissApart) ++around.near_misses;
    last_miss = sample.travelled;
  });
  around.tunnels = static_cast<int>(passed.size()), around.in_tunnels = kGroundStep * inside;
  around.close = looks > 0 ? static_cast<double>(close) / looks : 0.0;
  return around;
}

NearMisses near_misses(const SimulatedRide& simulated, const DerivedTrack& derived, const Supports* supports) {
  NearMisses found;
  if (derived.order.empty() || simulated.samples.empty()) return found;
  const double step = std::max(kStep, derived.length / kMostChordsInAll);
  const NearMissGrid cells = cells_of(derived, supports, step);
  const auto apart = [&](const NearMissObject& thing, double at) {
    const double gap = std::max({0.0, thing.begin - at, at - thing.end});
    return derived.closed ? std::min({gap, thing.begin + derived.length - at, at + derived.length - thing.end}) : gap;
  };
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  double last_track = kNever, last_support = kNever;
  each_look(simulated, derived, kStep, [&](const RideSample& sample, double at) {
    if (sample.speed < kSlowestMiss) return;
    const dvec3 head = ring_along(derived, at).place(0, form_of(derived.made.kind).head);
    bool by_track = false, by_support = false;
    cells.visit(head, [&](const NearMissObject& thing) {
      bool& near = thing.support ? by_support : by_track;
      near =
          near || (apart(thing, at) > kMissApart && distance_between(thing.from, thing.to, head, head) < thing.reach);
    });
    if (by_track && sample.travelled - last_track > kMissApart) ++found.track;
    if (by_support && sample.travelled - last_support > kMissApart) ++found.supports;
    if (by_track) last_track = sample.travelled;
    if (by_support) last_support = sample.travelled;
  });
  return found;
}

double excitement_of(const Ratings& r) {
  constexpr double kMostUp = 5, kJoltFelt = 1, kJoltWeight = 0.25, kOverloadWeight = 2;
  const double thrill = 3.4 * share(r.highest_drop, 25) + 1.2 * share(r.top_speed.value, 25) +
                        2.2 * share(r.airtime, 3) + 1.2 * share(r.near_misses, 3) + 1.6 * share(r.inversions, 2) +
                        1.0 * share(r.drops, 5) + 1.0 * share(std::min(r.up_most.value, kMostUp) - 1, 2.5) +
                        1.2 * share(r.tunnels, 2) + 0.8 * share(r.close, 0.25);
  const double pain = kJoltWeight * std::max(0.0, r.jolt_most.value - kJoltFelt) + kOverloadWeight * r.overload;
  return std::min(10.0, thrill / (1 + pain));
}

Ratings rate(const SimulatedRide& simulated, const RailTables& tables, double cutoff, const RideIncidents& marks) {
  Ratings r;
  r.complete = simulated.lap || simulated.end == world::FailureKind::off_end;
  r.seconds = simulated.lap ? simulated.lap_time : simulated.seconds();
  r.length = simulated.track_length;
  if (tables.size() == 0 || simulated.samples.empty()) return r;
  take_heights(simulated, tables, r);
  take_forces(simulated, cutoff, r);
  take_wheels(simulated, cutoff, r);
  take_jolts(simulated, cutoff, r);
  count_inversions(simulated, tables, r);
  double way = 0;
  for (std::size_t i = 1; i < simulated.samples.size(); ++i)
    way += std::abs(simulated.samples[i].travelled - simulated.samples[i - 1].travelled);
  r.mean_speed = simulated.seconds() > 0 ? way / simulated.seconds() : 0.0;
  const auto g = [](const Extreme& extreme) { return base::limited_figure(extreme.value, "g"); };
  const double p = g(r.up_most), n = g(r.up_least), l = g(r.side_most), d = r.drops, h = r.highest_drop;
  r.near_misses = marks.near_misses + marks.around.near_misses;
  r.tunnels = marks.around.tunnels, r.in_tunnels = marks.around.in_tunnels, r.close = marks.around.close;
  for (const Overload& span : marks.overloads)
    r.overload += span.allowed > 0 ? std::max(0.0, span.worst / span.allowed - 1) : 1.0;
  r.excitement = excitement_of(r);
  r.intensity = 0.8 * p + 0.8 * (1 - n) + l + 0.14 * d + 0.0098 * h;
  r.nausea = 0.26 * p + 0.22 * (1 - n) + 0.33 * l + 0.10 * d + 0.0031 * h;
  return r;
}

std::vector<ReportRow> report_figures(const Ratings& r, std::span<const Rider> riders) {
  return {{"top speed", "m/s", r.top_speed},
          {"highest", "m", r.highest},
          {"lowest", "m", r.lowest},
          {"most vertical", "g", r.up_most},
          {"least vertical", "g", r.up_least},
          {"most lateral", "g", r.side_most},
          {"most forwards", "g", r.forward_most},
          {"most backwards", "g", r.back_most},
          {"most on road wheels", "kN", r.road_most},
          {"most on up-stops", "kN", r.up_stop_most},
          {"most on side wheels", "kN", r.side_load_most},
          {"most jerk", "g/s", most_of(riders, RideValue::jerk)},
          {"most roll rate", "deg/s", most_of(riders, RideValue::roll_rate)},
          {"most roll acceleration", "deg/s^2", most_of(riders, RideValue::roll_acceleration)},
          {"largest jolt", "g", r.jolt_most}};
}

std::string report_text(const SimulatedRide& simulated, const Ratings& r, std::span<const Rider> riders,
                        std::span<const Overload> red, const std::string& track_name) {
  std::string out = track_name + "\n";
  add(out, "  {:<22} {:8.2f} m\n", "length", r.length);
  add(out, "  {:<22} {:8.2f} s{}\n", simulated.lap ? "lap" : "time", r.seconds,
      simulated.lap ? "" : " (no complete lap)");
  if (simulated.end != world::FailureKind::none)
    add(out, "  {:<22} {} at {:.1f} m\n", "end", base::name_of(simulated.end),
        simulated.distance(simulated.samples.size() - 1));
  add(out, "  {:<22} {:8}, {} m apart\n", "cars", simulated.start.cars,
      static_cast<int>(std::lround(simulated.start.spacing)));
  for (const ReportRow& figure : report_figures(r, riders)) {
    const std::string_view name = figure.name;
    if (name == "most vertical" && !riders.empty())
      add(out, "  {:<22} low-passed at {:.3g} Hz, of all cars\n", "felt g", riders.front().cutoff);
    add_extreme(out, figure);
    if (name == "top speed") add(out, "  {:<22} {:8.2f} m/s\n", "mean speed", r.mean_speed);
  }
  add(out, "  {:<22} {:8.2f} s\n", "airtime", r.airtime);
  add(out, "  {:<22} {:8}, highest {:.2f} m\n", "drops", r.drops, r.highest_drop);
  add(out, "  {:<22} {:8}\n", "inversions", r.inversions);
  if (r.tunnels > 0) add(out, "  {:<22} {:8}, {:.0f} m in all\n", "tunnels", r.tunnels, r.in_tunnels);
  if (r.close > 0)
    add(out, "  {:<22} {:8.0f} % of the way near earth, water or trees\n", "surroundings", 100 * r.close);
  add(out, "  {:<22} {:8.2f}, intensity {:.2f}, nausea {:.2f} (docs/ride.md)\n", "excitement", r.excitement,
      r.intensity, r.nausea);
  add(out, "  {:<22} {:8} (force limits by duration; not a compliance check)\n", "overloads", red.size());
  for (const Overload& span : red)
    add(out, "    car {:2}, {:<22} {:>6} g, limit {:.2f} g, {:.2f}..{:.2f} s, {:.1f}..{:.1f} m\n", span.car + 1,
        base::row_of(span.axis).label, base::figure_text(signed_g(span.axis, span.worst), 2, "g"),
        signed_g(span.axis, span.allowed), span.from, span.to, span.from_distance, span.to_distance);
  return out;
}

std::string report_csv(const SimulatedRide& simulated, std::span<const Rider> riders) {
  std::string out = "time_s,distance_m,speed_m_s,height_m,acceleration_m_s2";
  for (int car = 1; car <= simulated.start.cars; ++car)
    add(out,
        ",up_{0}_g,left_{0}_g,forward_{0}_g,road_front_{0}_kN,road_rear_{0}_kN,up_stop_front_{0}_kN,"
        "up_stop_rear_{0}_kN,side_left_{0}_kN,side_right_{0}_kN",
        car);
  for (int car = 1; car <= simulated.start.cars; ++car)
    add(out, ",jerk_up_{0}_g_s,jerk_left_{0}_g_s,jerk_forward_{0}_g_s,roll_rate_{0}_deg_s,roll_acceleration_{0}_deg_s2",
        car);
  out += '\n';
  for (std::size_t k = 0; k < simulated.entries(); ++k) {
    const std::size_t sample = simulated.sample_of(k);
    add(out, "{:.6f},{:.4f},{:.4f},{:.4f},{:.4f}", SimulatedRide::time_of(sample), simulated.distance(sample),
        simulated.samples[sample].speed, riders[0].samples[k].height, simulated.samples[sample].acceleration);
    for (int car = 0; car < simulated.start.cars; ++car) {
      const FeltAcceleration& f = simulated.felt(k, car);
      const WheelLoads loads = wheel_loads(simulated, k, car);
      const LoadsByWheelKind front = loads.of(WheelSet::front), rear = loads.of(WheelSet::rear);
      for (const double g : {f.up, f.left, f.forward}) add(out, ",{:.4f}", base::limited_figure(g, "g"));
      for (const double load : {front.road, rear.road, front.up_stop, rear.up_stop, loads.of(WheelSet::left).side,
                                loads.of(WheelSet::right).side})
        add(out, ",{:.4f}", base::limited_figure(load, "kN"));
    }
    for (const Rider& rider : riders) {
      const RiderSample& s = rider.samples[k];
      for (const double jerk : {s.jerk.up, s.jerk.left, s.jerk.forward})
        add(out, ",{:.4f}", base::limited_figure(jerk, "g/s"));
      add(out, ",{:.4f},{:.4f}", s.roll_rate, s.roll_acceleration);
    }
    out += '\n';
  }
  return out;
}

}  // namespace coaster::sim
