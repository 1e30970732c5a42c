#include "sim/ghost.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "sim/ride_rules.h"
#include "sim/train.h"

namespace coaster::sim {
namespace {

// The train's mean height and slope over the place of its first car, on a uniform grid: a train is a point in this landscape.
class Landscape {
 public:
  Landscape(const RailTables& tables, const GhostStart& start) : closed_(tables.closed()), length_(tables.length()) {
    const auto n = static_cast<std::size_t>(std::max(4.0, std::ceil(length_ / kTableStep)));
    step_ = length_ / static_cast<double>(n);
    height_.assign(n + 1, 0.0), slope_.assign(n + 1, 0.0);
    for (int car = 0; car < start.cars; ++car) add_car(tables, car * start.spacing);
    const double share = 1.0 / start.cars;
    for (std::size_t i = 0; i <= n; ++i) height_[i] *= share, slope_[i] *= share * step_;
  }

  double height(double at) const {
    const Cell c = cell(at);
    return c.y0 + c.u * (c.m0 + c.u * (c.b + c.u * c.a));
  }
  double slope(double at) const {
    const Cell c = cell(at);
    return (c.m0 + c.u * (2.0 * c.b + c.u * 3.0 * c.a)) / step_;
  }

 private:
  struct Cell {
    double u, y0, m0, a, b;
  };
  Cell cell(double at) const {
    if (closed_) at -= length_ * std::floor(at / length_);
    const std::size_t last = height_.size() - 2;
    const double place = at / step_;
    const std::size_t i = place > 0 ? std::min(static_cast<std::size_t>(place), last) : 0;
    const double u = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
    const double y0 = height_[i], y1 = height_[i + 1], m0 = slope_[i], m1 = slope_[i + 1];
    return {u, y0, m0, 2.0 * (y0 - y1) + m0 + m1, 3.0 * (y1 - y0) - 2.0 * m0 - m1};
  }
  void add_car(const RailTables& tables, double back) {
    std::size_t hint = 0;
    for (std::size_t i = 0; i < height_.size(); ++i) {
      const double s = tables.locate(step_ * static_cast<double>(i) - back, hint);
      const TableRail rail = rail_at(tables.segment(hint), s);
      height_[i] += rail.height, slope_[i] += rail.slope;
    }
  }

  bool closed_;
  double length_, step_ = 0;
  std::vector<double> height_, slope_;  // the slope in m a step
};

struct Moving {
  double at, speed, work;  // m from the track's start (unwrapped), m/s, J/kg
};

class Simulation {
 public:
  Simulation(const RailTables& tables, std::span<const EquipmentSpan> equipment, const world::Document& document, const GhostStart& start)
      : tables_(tables), equipment_(equipment), document_(document), start_(start), landscape_(tables, start),
        rails_{tables.length(), tables.closed()}, control_(start.control), moving_{start.front, start.speed, 0} {}

  Ghost run(const GhostLimits& limits) {
    Ghost ghost;
    ghost.start = start_, ghost.track_length = rails_.length, ghost.closed = rails_.closed;
    const auto most = static_cast<std::size_t>(std::max(0.0, limits.seconds) * world::kTicksPerSecond);
    ghost.samples.reserve(std::min<std::size_t>(most + 1, 20'000));
    add_sample(ghost, acceleration(0));
    while (ghost.samples.size() <= most && ghost.end == world::FailureKind::none) {
      const double before = moving_.at - start_.front;
      double drive = 0;
      const bool held = control(drive);
      if (!held) advance(drive, ghost);
      add_sample(ghost, held ? 0.0 : acceleration(drive));
      if (ghost.end == world::FailureKind::none) ghost.end = failure(held, ghost);
      const double after = moving_.at - start_.front;
      if (rails_.closed && !ghost.lap && after >= rails_.length) {
        const double part = after > before ? (rails_.length - before) / (after - before) : 1.0;
        ghost.lap = true;
        ghost.lap_time = (static_cast<double>(ghost.samples.size() - 2) + part) * world::kTick;
        if (limits.stop_after_lap) break;
      }
    }
    return ghost;
  }

 private:
  double others(double speed, double direction, double drive) const {
    return drive - direction * (world::kGravity * document_.resistance.rolling + document_.resistance.drag * speed * speed);
  }
  double gravity(double at) const { return -world::kGravity * landscape_.slope(at); }
  double direction(double drive) const {
    if (moving_.speed != 0) return moving_.speed > 0 ? 1.0 : -1.0;
    const double pull = gravity(moving_.at) + drive;
    if (std::abs(pull) <= world::kGravity * document_.resistance.rolling) return 0.0;
    return pull > 0 ? 1.0 : -1.0;
  }
  double acceleration(double drive) const { return gravity(moving_.at) + others(moving_.speed, direction(drive), drive); }

  bool control(double& drive) {
    if (equipment_.empty()) return false;
    const double free = acceleration(0);
    const Drive now = drive_of(equipment_, rails_, {moving_.at, start_.cars, start_.spacing}, moving_.speed, free, true, world::kTick, control_);
    drive = now.acceleration;
    if (now.held) {
      moving_.work -= 0.5 * moving_.speed * moving_.speed;
      moving_.speed = 0;
    }
    return now.held;
  }

  void advance(double drive, Ghost& ghost) {
    const double sign = direction(drive), dt = world::kTick;
    if (moving_.speed == 0 && sign == 0 && document_.resistance.rolling > 0) return;  // at rest, and friction holds it
    const auto slope = [&](const Moving& m) {
      const double by_others = others(m.speed, sign, drive);
      return Moving{m.speed, gravity(m.at) + by_others, by_others * m.speed};
    };
    const auto moved = [&](const Moving& k, double h) {
      return Moving{moving_.at + h * k.at, moving_.speed + h * k.speed, moving_.work + h * k.work};
    };
    const Moving k1 = slope(moving_), k2 = slope(moved(k1, 0.5 * dt)), k3 = slope(moved(k2, 0.5 * dt)), k4 = slope(moved(k3, dt));
    const auto mean = [](double a, double b, double c, double d) { return (a + 2.0 * b + 2.0 * c + d) / 6.0; };
    Moving next = moved({mean(k1.at, k2.at, k3.at, k4.at), mean(k1.speed, k2.speed, k3.speed, k4.speed), mean(k1.work, k2.work, k3.work, k4.work)}, dt);
    const bool losses = !(document_.resistance == world::Resistance{});
    if (losses && sign != 0 && next.speed * sign < 0) {  // friction brings it to rest, not beyond
      const double part = moving_.speed / (moving_.speed - next.speed);
      next = {moving_.at + part * (next.at - moving_.at), 0.0, moving_.work + part * (next.work - moving_.work)};
    }
    moving_ = next;
    if (rails_.closed || (next.at >= 0 && next.at <= rails_.length)) return;
    moving_.at = std::clamp(next.at, 0.0, rails_.length);
    ghost.end = world::FailureKind::off_end;
  }

  world::FailureKind failure(bool held, const Ghost& ghost) {
    const double travelled = ghost.samples.back().travelled;
    furthest_ = std::max(furthest_, travelled);
    if (document_.rollback_fails && furthest_ > kRollback && moving_.speed < 0 && travelled < furthest_ - kRollback) return world::FailureKind::rollback;
    still_ = std::abs(moving_.speed) < kStillSpeed && !held ? still_ + 1 : 0;
    return still_ >= kStillTicks ? world::FailureKind::stall : world::FailureKind::none;
  }

  void add_sample(Ghost& ghost, double along) {
    const double speed = moving_.speed;
    ghost.samples.push_back({moving_.at - start_.front, speed, along, moving_.work});
    if ((ghost.samples.size() - 1) % kForceEvery != 0) return;
    const auto a = static_cast<float>(along / world::kGravity), v2 = static_cast<float>(speed * speed / world::kGravity);
    hints_.resize(static_cast<std::size_t>(start_.cars), 0);
    for (int car = 0; car < start_.cars; ++car) {
      std::size_t& hint = hints_[static_cast<std::size_t>(car)];
      const double s = tables_.locate(moving_.at - car * start_.spacing, hint);
      const FeltEntry f = felt_at(tables_.segment(hint), s);
      const glm::vec3 g = a * f.along + v2 * f.bend + f.weight;
      ghost.forces.push_back({g.x, g.y, g.z});
    }
  }

  const RailTables& tables_;
  std::span<const EquipmentSpan> equipment_;
  const world::Document& document_;
  GhostStart start_;
  Landscape landscape_;
  Rails rails_;
  ControlState control_;
  Moving moving_;
  double furthest_ = 0;
  int still_ = 0;
  std::vector<std::size_t> hints_;
};

}  // namespace

double Ghost::distance(std::size_t sample) const {
  const double at = start.front + samples[sample].travelled;
  if (!closed || !(track_length > 0)) return at;
  return at - track_length * std::floor(at / track_length);
}

Ghost simulate(const RailTables& tables, std::span<const EquipmentSpan> equipment, const world::Document& document, const GhostStart& start,
               const GhostLimits& limits) {
  if (tables.size() == 0 || !(tables.length() > 0)) {
    Ghost ghost;
    ghost.start = start;
    ghost.samples.push_back({0, start.speed, 0, 0});
    ghost.forces.resize(static_cast<std::size_t>(start.cars));
    return ghost;
  }
  return Simulation(tables, equipment, document, start).run(limits);
}

GhostStart start_of(const world::Document& document, const Derived& derived, const world::Cart& design) {
  GhostStart start;
  for (std::size_t i = 0; i < derived.order.size(); ++i)
    if (derived.order[i] == design.segment) start.front = derived.starts[i] + design.fraction * derived.shape(design.segment).arc.length();
  start.speed = document.start_speed;
  start.cars = cars_on(derived, design);
  start.spacing = design.spacing;
  return start;
}

const RailTables& GhostMemo::tables(const world::Document& document, const Derived& derived) {
  tables_.update(derived, document.heartline);
  return tables_;
}

GhostMemo::Entry& GhostMemo::find(const world::Document& document, const Derived& derived, const GhostStart& start, const GhostLimits& limits) {
  tables(document, derived);
  equipment_ = equipment_spans(document, derived);
  base::Hasher hasher;
  hasher.add(tables_.serial()), hasher.add(limits.seconds), hasher.add(limits.stop_after_lap);
  hasher.add(start.front), hasher.add(start.speed), hasher.add(start.cars), hasher.add(start.spacing), hasher.add(start.control.dwell), hasher.add(start.control.braking);
  hasher.add(document.resistance.rolling), hasher.add(document.resistance.drag), hasher.add(document.rollback_fails);
  for (const EquipmentSpan& span : equipment_) {
    hasher.add(span.from), hasher.add(span.to), hasher.add(span.equipment.kind), hasher.add(span.equipment.speed);
    hasher.add(span.equipment.acceleration), hasher.add(span.equipment.hysteresis), hasher.add(span.equipment.seconds);
  }
  const std::uint64_t key = hasher.digest();
  ++clock_;
  for (Entry& entry : entries_)
    if (entry.key == key) {
      entry.used = clock_;
      return entry;
    }
  if (entries_.size() < most_) entries_.emplace_back();  // used 0: the oldest
  Entry& entry = *std::min_element(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
  ++simulations_;
  entry = {key, simulate(tables_, equipment_, document, start, limits), clock_, false, {}};
  entry.ghost.serial = simulations_;
  return entry;
}

const Ghost* GhostMemo::ride(const world::Document& document, const Derived& derived, world::Entity cart) {
  const world::Cart* const design = document.entities.find<world::Cart>(cart);
  if (!design || derived.order.empty()) return nullptr;
  return &find(document, derived, start_of(document, derived, *design), {}).ghost;
}

const Ghost& GhostMemo::from(const world::Document& document, const Derived& derived, const GhostStart& start) {
  return find(document, derived, start, {}).ghost;
}

const LapTable& GhostMemo::lap(const world::Document& document, const Derived& derived, const GhostStart& start) {
  Entry& entry = find(document, derived, start, {});
  if (!entry.has_lap) {
    const bool repeats = document.resistance == world::Resistance{} && equipment_.empty();
    entry.lap = repeats ? LapTable(entry.ghost) : LapTable();
    entry.has_lap = true;
  }
  return entry.lap;
}

void GhostMemo::keep(std::size_t rides) { most_ = std::clamp(rides, most_, kMostEntries * 16); }

}  // namespace coaster::sim
