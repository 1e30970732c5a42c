// Simulated rides and their cache.
#include "sim/ride/simulated_ride.h"

#include <cmath>
#include <functional>

#include "base/cancellable_job.h"
#include "sim/ride/simulated_ride_detail.h"
#include "sim/ride/train.h"
#include "world/evaluation_settings.h"

namespace coaster::sim {
namespace {

// The train of a simulated ride: its motion over tables of the rails, tick by tick.
class SimulatedTrain {
 public:
  // Refers to its arguments.
  SimulatedTrain(const RailTables& tables, std::span<const SegmentTable* const> segments,
                 std::span<const EquipmentSpan> equipment, const world::Losses& resistance, const TrainStart& start)
      : equipment_(equipment),
        resistance_(resistance),
        landscape_(tables, segments, start.cars, start.spacing),
        rails_{tables.length(), tables.closed()},
        control_(start.control),
        place_{start.front, start.cars, start.spacing, start.length},
        moving_{start.front, start.speed, 0},
        losses_(!(resistance == world::Losses{})) {
    settle();
  }

  const TrainState& state() const { return moving_; }   // x: m from the track's start, unwrapped
  double in_lap() const { return moving_.x - round_; }  // m from the start of the lap, of the first car
  bool held() const { return drive_.held; }
  // Returns the acceleration along the rails, m/s^2.
  double acceleration() const {
    if (drive_.net) return drive_.acceleration;
    return gravity_here_ + (drive_.acceleration - direction() * loss(resistance_, moving_.speed));
  }
  // Returns those of the last tick; `travelled` is state().x, `sample` 0.
  std::span<const RideSwitch> switches() const { return switches_; }

  // Advances by a tick, in parts that end where equipment switches. Returns false at an open end.
  bool advance() {
    constexpr int kMostParts = 64;
    double dt = world::kTick;
    bool on_track = true;
    if (equipment_.empty()) return advance(dt);
    count_down(true, control_);
    switches_.clear(), switched_ = 0;
    for (int part = 0; dt > 0 && part < kMostParts && on_track; ++part) {
      place_.front = in_lap();
      contacts_ = &near_.update(equipment_, rails_, place_, moving_.x, moving_.speed < 0);
      const Drive next = drive_at(moving_, control_);
      if (!(next == drive_)) {
        switches_.push_back({0, moving_.x, moving_.speed, acceleration(), 0});
        drive_ = next;
        switches_.back().acceleration_after = acceleration();
      }
      if (drive_.held) {
        moving_.work -= 0.5 * moving_.speed * moving_.speed;
        moving_.speed = 0;
        break;
      }
      on_track = advance(dt);
    }
    return on_track;
  }

 private:
  double gravity(double at) { return -world::kGravity * landscape_.slope(at - round_); }
  // Updates the gravity after each move, which is used several times, and the start of the train's lap.
  void settle() {
    if (rails_.closed && !(moving_.x >= round_ && moving_.x < round_ + rails_.length))
      round_ = rails_.length * std::floor(moving_.x / rails_.length);
    gravity_here_ = gravity(moving_.x);
  }
  double direction() const {
    return direction_of(moving_.speed, resistance_, [&] { return gravity_here_ + drive_.acceleration; });
  }

  // Returns the drive from a moment on. Updates `control`.
  Drive drive_at(const TrainState& at, ControlState& control) {
    const std::function<double()> free = [&] { return free_acceleration(gravity(at.x), at.speed, resistance_); };
    return drive_of(*contacts_, place_, {at.x - round_, at.speed, free}, true, control);
  }

  // Advances by at most `dt`, which is the time left afterwards. Returns false at an open end.
  bool advance(double& dt) {
    double used = dt;
    const double sign = drive_.net ? 0.0 : direction(), drive = drive_.acceleration;
    dt = 0;
    if (!drive_.net && moving_.speed == 0 && sign == 0 && resistance_.rolling > 0) return true;  // held by friction
    const auto rates = [&](const TrainState& m, double pull) {
      if (drive_.net) return TrainRates{m.speed, drive, (drive - pull) * m.speed};
      const double others = drive - sign * loss(resistance_, m.speed);
      return TrainRates{m.speed, pull + others, others * m.speed};
    };
    const auto after = [&](double time) {
      return runge_kutta(moving_, rates(moving_, gravity_here_), time,
                         [&](const TrainState& m) { return rates(m, gravity(m.x)); });
    };
    TrainState next = after(used);
    const double left = used;
    const auto cut = [&](const auto& value, double within = 1e-15) {
      used = time_of(moving_, used, after, value, within), next = after(used);
    };
    if (!equipment_.empty()) cut_at_switches(next, cut);
    dt = left - used;
    if (losses_ && sign != 0 && next.speed * sign < 0) {  // friction stops it and does not reverse it
      const double part = moving_.speed / (moving_.speed - next.speed);
      next = {moving_.x + part * (next.x - moving_.x), 0.0, moving_.work + part * (next.work - moving_.work)};
    }
    const bool on_track = rails_.closed || (next.x >= 0 && next.x <= rails_.length);
    if (!on_track) {
      const bool back = next.x < 0;
      const double end = back ? 0.0 : rails_.length;
      cut([&](const TrainState& at) { return back ? end - at.x : at.x - end; });
      next.x = end;
    }
    moving_ = next;
    settle();
    return on_track;
  }

  // Ends a part that leads to `next` where a car comes to an end of equipment, where friction stops the train, or where
  // the drive changes.
  template <class Cut>
  void cut_at_switches(TrainState& next, const Cut& cut) {
    const double ahead = near_.ahead(), behind = near_.behind(), from = moving_.speed;
    if (next.x > ahead) cut([&](const TrainState& at) { return at.x - ahead; });
    if (next.x < behind) cut([&](const TrainState& at) { return behind - at.x; });
    if (losses_ && !drive_.net && next.speed * from < 0) {
      cut([&](const TrainState& at) { return from > 0 ? -at.speed : at.speed; });
      next.speed = 0;
    }
    const auto switches = [&](const TrainState& at) {
      ControlState then = control_;
      return drive_at(at, then) == drive_ && then == control_ ? -1.0 : 1.0;
    };
    if (!contacts_->on.empty() && switched_ < kMostSwitches && switches(next) > 0)
      ++switched_, cut(switches, kSwitchWithin);
  }

  std::span<const EquipmentSpan> equipment_;
  world::Losses resistance_;
  MeanSlopeTable landscape_;
  TrackExtent rails_;
  ControlState control_;
  TrainPlace place_;
  TrainContacts near_;
  const Contacts* contacts_ = nullptr;  // the present ones
  Drive drive_;
  std::vector<RideSwitch> switches_;
  int switched_ = 0;  // in this tick
  TrainState moving_;
  double round_ = 0, gravity_here_ = 0;  // m, m/s^2
  bool losses_;
};

std::vector<const SegmentTable*> segments_of(const RailTables& tables) {
  std::vector<const SegmentTable*> segments;
  for (std::size_t i = 0; i < tables.size(); ++i) segments.push_back(&tables.segment(i));
  return segments;
}

FeltAcceleration force_of(glm::dvec3 g) {
  return {static_cast<float>(g.x), static_cast<float>(g.y), static_cast<float>(g.z)};
}

glm::dvec3 seat_vector(const FeltAcceleration& force) { return {force.forward, force.left, force.up}; }

// Returns the passage from the end of one segment's entries to the start of the next's, or backwards.
JointPassage passage(std::span<const FeltEntry> from, std::span<const FeltEntry> to, bool back, double speed,
                     double acceleration) {
  const FeltEntry &before = back ? from.front() : from.back(), &after = back ? to.back() : to.front();
  const glm::dvec3 along(after.along - before.along), bend(after.bend - before.bend);
  const auto a = static_cast<float>(acceleration / world::kGravity),
             v2 = static_cast<float>(speed * speed / world::kGravity);
  return {.speed = speed,
          .impulse = force_of(speed / world::kGravity * along),
          .before = force_of(before.felt(a, v2)),
          .step = force_of((acceleration * along + speed * speed * bend) / world::kGravity)};
}

class Simulation {
 public:
  Simulation(const RailTables& tables, std::span<const EquipmentSpan> equipment, const world::Document& document,
             const TrainStart& start)
      : tables_(tables),
        document_(document),
        start_(start),
        segments_(segments_of(tables)),
        train_(tables, segments_, equipment, resistance_of(document, start.mass), start),
        rails_{tables.length(), tables.closed()} {
    for (int car = 0; car < start.cars; ++car) cars_.push_back({.back = car * start.spacing});
  }

  // Runs the simulation and reuses the memory of `simulated`.
  SimulatedRide run(const RideLimits& limits, SimulatedRide simulated) {
    simulated.samples.clear(), simulated.switches.clear(), simulated.forces.clear(), simulated.passages.clear(),
        simulated.bends.clear();
    simulated = {.start = start_,
                 .track_length = rails_.length,
                 .closed = rails_.closed,
                 .heartline = document_.heartline,
                 .samples = std::move(simulated.samples),
                 .switches = std::move(simulated.switches),
                 .forces = std::move(simulated.forces),
                 .passages = std::move(simulated.passages),
                 .bends = std::move(simulated.bends)};
    const auto most = static_cast<std::size_t>(std::max(0.0, limits.seconds) * world::kTicksPerSecond);
    const std::size_t usual = std::min<std::size_t>(most + 1, 20'000);
    simulated.samples.reserve(usual),
        simulated.forces.reserve(usual / kForceEvery * static_cast<std::size_t>(start_.cars));
    add_sample(simulated);
    while (simulated.samples.size() <= most && simulated.end == world::FailureKind::none && !base::interrupted()) {
      const double before = train_.state().x - start_.front;
      if (!train_.advance()) simulated.end = world::FailureKind::off_end;
      for (RideSwitch at : train_.switches()) {
        at.sample = simulated.samples.size(), at.travelled -= start_.front;
        simulated.switches.push_back(at);
      }
      add_sample(simulated);
      if (simulated.end == world::FailureKind::none)
        simulated.end = end_of_ride(document_, train_.state().speed, simulated.samples.back().travelled, train_.held(),
                                    furthest_, still_);
      const double after = train_.state().x - start_.front;
      if (rails_.closed && !simulated.lap && after >= rails_.length) {
        const double part = after > before ? (rails_.length - before) / (after - before) : 1.0;
        simulated.lap = true;
        simulated.lap_time = (static_cast<double>(simulated.samples.size() - 2) + part) * world::kTick;
        if (limits.stop_after_lap) break;
      }
    }
    if (const std::size_t ticks_left = (simulated.samples.size() - 1) % kForceEvery; ticks_left > 0)
      add_forces(simulated, ticks_left);
    return simulated;
  }

 private:
  void add_sample(SimulatedRide& simulated) {
    const TrainState& now = train_.state();
    simulated.samples.push_back({now.x - start_.front, now.speed, train_.acceleration(), now.work});
    if ((simulated.samples.size() - 1) % kForceEvery == 0) add_forces(simulated, kForceEvery);
  }

  // Adds an entry of the forces, of the last sample, `ticks` after the entry before.
  void add_forces(SimulatedRide& simulated, std::size_t ticks) {
    const double along = simulated.samples.back().acceleration, speed = simulated.samples.back().speed;
    between_ = ticks;
    const Float4 a = four(static_cast<float>(along / world::kGravity)),
                 v2 = four(static_cast<float>(speed * speed / world::kGravity));
    const std::size_t first = simulated.forces.size();
    simulated.forces.resize(first + cars_.size());
    for (std::size_t i = 0; i < cars_.size(); ++i) {
      CarPlace& car = cars_[i];
      double at = train_.in_lap() - car.back;
      if (rails_.closed && at < 0) at += rails_.length;
      double s = at - car.from;
      const std::size_t before = car.segment;
      if (!(at >= car.from && at <= car.to)) {
        s = tables_.locate(at, car.segment);
        car.table = segments_[car.segment];
        car.from = tables_.start(car.segment), car.to = tables_.start(car.segment + 1);
      }
      simulated.forces[first + i] = force_at(*car.table, s, a, v2);
      if (first == 0) continue;
      if (car.segment != before) add_passages(static_cast<int>(i), before, car.segment, at, simulated);
      else if (!car.table->cells.empty()) add_tight(static_cast<int>(i), before, before, at, simulated);
    }
  }

  // Adds a car's passages since the last entry of the forces, from one segment to another, where it is at `at` m.
  void add_passages(int car, std::size_t from, std::size_t to, double at, SimulatedRide& simulated) const {
    const std::size_t first = from;
    bool tight = !segments_[from]->cells.empty();
    const RideSample &now = simulated.samples.back(),
                     &then = simulated.samples[simulated.samples.size() - 1 - between_];
    const double moved = now.travelled - then.travelled, time = static_cast<double>(between_) * world::kTick;
    const std::size_t count = segments_.size(), entry = simulated.forces.size() / cars_.size() - 1;
    const auto speed = [&](double share) { return std::lerp(then.speed, now.speed, share); };
    const auto acceleration = [&](double share) { return std::lerp(then.acceleration, now.acceleration, share); };
    const FeltAcceleration* const felt = &simulated.forces[entry * cars_.size() + static_cast<std::size_t>(car)];
    glm::dvec3 missed = -0.5 * time * (seat_vector(felt[0]) + seat_vector(*(felt - cars_.size())));
    double done = 0;  // of the way between the entries
    // Adds the integral of felt g on one segment's part of the way, from `done` on, by Simpson's rule.
    const auto ride_to = [&](double share, std::size_t segment) {
      glm::dvec3 sum(0);
      for (int k = 0; k <= 2; ++k) {
        const double here = std::lerp(done, share, 0.5 * k), v = speed(here);
        double s = at - (1 - here) * moved - tables_.start(segment);
        if (rails_.closed) s -= rails_.length * std::round((s - 0.5 * length_of(segment)) / rails_.length);
        sum += (k == 1 ? 4.0 : 1.0) / 6 *
               glm::dvec3(felt_at(*segments_[segment], s, static_cast<float>(acceleration(here) / world::kGravity),
                                  static_cast<float>(v * v / world::kGravity)));
      }
      missed += time * (share - done) * sum;
      done = share;
    };
    while (from != to && moved != 0) {
      const bool back = moved < 0;
      const std::size_t next = (from + (back ? count - 1 : 1)) % count, knot = back ? from : next;
      const double share = share_to(knot, at, moved);
      simulated.passages.push_back(
          passage(segments_[from]->felt, segments_[next]->felt, back, speed(share), acceleration(share)));
      JointPassage& passed = simulated.passages.back();
      passed.knot = knot, passed.car = car, passed.entry = entry;
      passed.time = (static_cast<double>(entry) - 1) * kForceEvery * world::kTick + share * time;
      ride_to(share, from);
      from = next, tight = tight || !segments_[from]->cells.empty();
      if (from != to) continue;
      ride_to(1, to);
      passed.missed = force_of(missed);
    }
    if (tight) add_tight(car, first, to, at, simulated);
  }
  // Returns the share of a car's way of `moved` m to `at` that it had behind it at a knot.
  double share_to(std::size_t knot, double at, double moved) const {
    double past = moved < 0 ? tables_.start(knot) - at : at - tables_.start(knot);
    if (rails_.closed && past < 0) past += rails_.length;
    return std::clamp(1 - past / std::abs(moved), 0.0, 1.0);
  }

  // Adds the passage inside segments on the same way, if there are cells on it that the entries do not resolve.
  void add_tight(int car, std::size_t from, std::size_t to, double at, SimulatedRide& simulated) const {
    const RideSample &now = simulated.samples.back(),
                     &then = simulated.samples[simulated.samples.size() - 1 - between_];
    const double moved = now.travelled - then.travelled;
    const std::size_t count = segments_.size(), entry = simulated.forces.size() / cars_.size() - 1;
    TightBendMotion way{then, now, static_cast<double>(between_) * world::kTick};
    const bool joint = from != to;
    for (double done = 0; moved != 0;) {
      const std::size_t next = (from + (moved < 0 ? count - 1 : 1)) % count;
      const double share = from == to ? 1 : share_to(moved < 0 ? from : next, at, moved);
      double s = at - (1 - share) * moved - tables_.start(from);
      if (rails_.closed) s -= rails_.length * std::round((s - 0.5 * length_of(from)) / rails_.length);
      way.add(*segments_[from], s - (share - done) * moved, s, done, share);
      done = share;
      if (from == to) break;
      from = next;
    }
    const FeltAcceleration* const felt = &simulated.forces[entry * cars_.size() + static_cast<std::size_t>(car)];
    if (!way.is_needed(seat_vector(*(felt - cars_.size())), seat_vector(felt[0]), joint)) return;
    for (auto it = simulated.passages.rbegin(); it != simulated.passages.rend() && it->car == car && it->entry == entry;
         ++it)
      it->missed = {0, 0, 0};  // the integrals are whole
    simulated.bends.push_back(way.passage());
    JointPassage& passed = simulated.bends.back().peak;
    passed.car = car, passed.entry = entry;
    passed.time += (static_cast<double>(entry) - 1) * kForceEvery * world::kTick;
  }
  double length_of(std::size_t segment) const { return tables_.start(segment + 1) - tables_.start(segment); }

  const RailTables& tables_;
  const world::Document& document_;
  TrainStart start_;
  std::vector<const SegmentTable*> segments_;
  SimulatedTrain train_;
  TrackExtent rails_;
  double furthest_ = 0;
  std::int32_t still_ = 0;
  std::size_t between_ = kForceEvery;  // ticks, of the last two entries of the forces
  struct CarPlace {
    double back;                          // m behind the first car
    std::size_t segment = 0;              // its last segment
    const SegmentTable* table = nullptr;  // of that segment, and the segment's ends in m from the track's start
    double from = 1, to = 0;
  };
  std::vector<CarPlace> cars_;
};

constexpr double kSpare = 1;  // m/s more than the least that completes the ride

bool completes(const SimulatedRide& simulated) {
  return simulated.lap || (simulated.end == world::FailureKind::off_end && simulated.samples.back().speed > 0);
}

}  // namespace

SimulatedRide simulate(const RailTables& tables, std::span<const EquipmentSpan> equipment,
                       const world::Document& document, const TrainStart& start, const RideLimits& limits,
                       SimulatedRide memory) {
  if (tables.size() == 0 || !(tables.length() > 0) || base::interrupted()) {
    SimulatedRide simulated;
    simulated.start = start;
    simulated.samples.push_back({0, start.speed, 0, 0});
    simulated.forces.resize(static_cast<std::size_t>(start.cars));
    return simulated;
  }
  return Simulation(tables, equipment, document, start).run(limits, std::move(memory));
}

TrainStart start_at(const DerivedTrack& derived, const world::Train& design, double front, double speed,
                    ControlState control) {
  return {front, speed, cars_on(derived, design), design.spacing, control, design.body(), design.mass};
}

TrainStart start_of(const world::Document& document, const DerivedTrack& derived, const world::Train& design) {
  TrainStart start = start_at(derived, design, 0, document.start_speed, {});
  if (const auto index = world::index_of(derived.order, design.segment))
    start.front = derived.starts[*index] + design.fraction * derived.shape(design.segment).arc.length();
  return start;
}

const RailTables& RideCache::tables(const world::Document& document, const DerivedTrack& derived) {
  tables_.update(derived, world::riders_height(document));
  return tables_;
}

RideCache::Entry& RideCache::find(const world::Document& document, const DerivedTrack& derived,
                                  const TrainStart& start) {
  tables(document, derived);
  Key key{tables_.serial(), start, document.resistance, document.rollback_fails, equipment_spans(document, derived)};
  ++clock_;
  for (Entry& entry : entries_)
    if (entry.key == key) {
      entry.used = clock_;
      return entry;
    }
  if (entries_.size() < most_) entries_.emplace_back();  // used 0: the oldest
  Entry& entry = *std::min_element(entries_.begin(), entries_.end(),
                                   [](const Entry& a, const Entry& b) { return a.used < b.used; });
  SimulatedRide simulated = simulate(tables_, key.equipment, document, start, {}, std::move(entry.simulated));
  simulated.serial = ++simulations_;
  entry = {std::move(key), std::move(simulated), clock_, false, {}};
  return entry;
}

const SimulatedRide* RideCache::ride(const world::Document& document, const DerivedTrack& derived, world::Entity cart) {
  const world::Train* const design = document.entities.find<world::Train>(cart);
  if (!design || derived.order.empty()) return nullptr;
  return &find(document, derived, start_of(document, derived, *design)).simulated;
}

const SimulatedRide& RideCache::from(const world::Document& document, const DerivedTrack& derived,
                                     const TrainStart& start) {
  return find(document, derived, start).simulated;
}

const LapTable& RideCache::lap(const world::Document& document, const DerivedTrack& derived, const TrainStart& start) {
  Entry& entry = find(document, derived, start);
  if (!entry.has_lap) {
    const bool repeats = entry.key.resistance == world::Losses{} && entry.key.equipment.empty();
    entry.lap = repeats ? LapTable(entry.simulated) : LapTable();
    entry.has_lap = true;
  }
  return entry.lap;
}

void RideCache::keep(std::size_t rides) { most_ = std::clamp(rides, most_, kMostEntries * 16); }

std::optional<double> completing_speed(world::Document document) {
  const world::Entity cart = world::first_cart(document);
  if (!cart.valid()) return std::nullopt;
  world::Settings settings;
  settings.evaluation->steps = 1;  // polylines are not needed
  DerivedTrack derived;
  derive(document, settings, {}, derived);
  RideCache cache;
  const auto enough = [&](int speed) {
    document.start_speed = speed;
    const SimulatedRide* const simulated = cache.ride(document, derived, cart);
    return simulated != nullptr && completes(*simulated);
  };
  int low = 0, high = static_cast<int>(world::kMaxSpeed);  // too slow, fast enough
  if (!enough(high)) return std::nullopt;
  while (high > low + 1) {
    const int middle = (low + high) / 2;
    (enough(middle) ? high : low) = middle;
  }
  return std::min(high + kSpare, world::kMaxSpeed);
}

}  // namespace coaster::sim
