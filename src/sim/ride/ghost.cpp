#include "sim/ride/ghost.h"

#include <algorithm>
#include <cmath>

#include "base/interrupted.h"
#include "sim/ride/ghost_train.h"
#include "sim/ride/tight_way.h"

namespace coaster::sim {
namespace {

std::vector<const SegmentTable*> segments_of(const RailTables& tables) {
  std::vector<const SegmentTable*> segments;
  for (std::size_t i = 0; i < tables.size(); ++i) segments.push_back(&tables.segment(i));
  return segments;
}

Force force_of(glm::dvec3 g) { return {static_cast<float>(g.x), static_cast<float>(g.y), static_cast<float>(g.z)}; }

glm::dvec3 seat_vector(const Force& force) { return {force.forward, force.left, force.up}; }

// Returns the passage from the end of one segment's entries to the start of the next's, or backwards.
Passage passage(std::span<const FeltEntry> from, std::span<const FeltEntry> to, bool back, double speed,
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
             const GhostStart& start)
      : tables_(tables),
        document_(document),
        start_(start),
        segments_(segments_of(tables)),
        train_(tables, segments_, equipment, resistance_of(document, start.mass), start),
        rails_{tables.length(), tables.closed()} {
    for (int car = 0; car < start.cars; ++car) cars_.push_back({.back = car * start.spacing});
  }

  // Runs the simulation and reuses the memory of `ghost`.
  Ghost run(const GhostLimits& limits, Ghost ghost) {
    std::vector<GhostSample> samples = std::move(ghost.samples);
    std::vector<Force> forces = std::move(ghost.forces);
    std::vector<Passage> passages = std::move(ghost.passages);
    std::vector<BendPassage> bends = std::move(ghost.bends);
    std::vector<GhostSwitch> switches = std::move(ghost.switches);
    samples.clear(), switches.clear(), forces.clear(), passages.clear(), bends.clear();
    ghost = Ghost{start_,
                  rails_.length,
                  rails_.closed,
                  document_.heartline,
                  std::move(samples),
                  std::move(switches),
                  std::move(forces),
                  std::move(passages),
                  std::move(bends)};
    const auto most = static_cast<std::size_t>(std::max(0.0, limits.seconds) * world::kTicksPerSecond);
    const std::size_t usual = std::min<std::size_t>(most + 1, 20'000);
    ghost.samples.reserve(usual), ghost.forces.reserve(usual / kForceEvery * static_cast<std::size_t>(start_.cars));
    add_sample(ghost);
    while (ghost.samples.size() <= most && ghost.end == world::FailureKind::none && !base::interrupted()) {
      const double before = train_.state().x - start_.front;
      if (!train_.advance()) ghost.end = world::FailureKind::off_end;
      for (GhostSwitch at : train_.switches()) {
        at.sample = ghost.samples.size(), at.travelled -= start_.front;
        ghost.switches.push_back(at);
      }
      add_sample(ghost);
      if (ghost.end == world::FailureKind::none) ghost.end = failure(ghost);
      const double after = train_.state().x - start_.front;
      if (rails_.closed && !ghost.lap && after >= rails_.length) {
        const double part = after > before ? (rails_.length - before) / (after - before) : 1.0;
        ghost.lap = true;
        ghost.lap_time = (static_cast<double>(ghost.samples.size() - 2) + part) * world::kTick;
        if (limits.stop_after_lap) break;
      }
    }
    if (const std::size_t rest = (ghost.samples.size() - 1) % kForceEvery; rest > 0) add_forces(ghost, rest);
    return ghost;
  }

 private:
  world::FailureKind failure(const Ghost& ghost) {
    const double speed = train_.state().speed;
    const double travelled = ghost.samples.back().travelled;
    furthest_ = std::max(furthest_, travelled);
    if (rolls_back(document_, speed, travelled, furthest_)) return world::FailureKind::rollback;
    still_ = std::abs(speed) < kStillSpeed && !train_.held() ? still_ + 1 : 0;
    return still_ >= kStillTicks ? world::FailureKind::stall : world::FailureKind::none;
  }

  void add_sample(Ghost& ghost) {
    const TrainState& now = train_.state();
    ghost.samples.push_back({now.x - start_.front, now.speed, train_.acceleration(), now.work});
    if ((ghost.samples.size() - 1) % kForceEvery == 0) add_forces(ghost, kForceEvery);
  }

  // Adds an entry of the forces, of the last sample, `ticks` after the entry before.
  void add_forces(Ghost& ghost, std::size_t ticks) {
    const double along = ghost.samples.back().acceleration, speed = ghost.samples.back().speed;
    between_ = ticks;
    const Float4 a = four(static_cast<float>(along / world::kGravity)),
                 v2 = four(static_cast<float>(speed * speed / world::kGravity));
    const std::size_t first = ghost.forces.size();
    ghost.forces.resize(first + cars_.size());
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
      ghost.forces[first + i] = force_at(*car.table, s, a, v2);
      if (first == 0) continue;
      if (car.segment != before) add_passages(static_cast<int>(i), before, car.segment, at, ghost);
      else if (!car.table->cells.empty()) add_tight(static_cast<int>(i), before, before, at, ghost);
    }
  }

  // Adds a car's passages since the last entry of the forces, from one segment to another, where it is at `at` m.
  void add_passages(int car, std::size_t from, std::size_t to, double at, Ghost& ghost) const {
    const std::size_t first = from;
    bool tight = !segments_[from]->cells.empty();
    const GhostSample &now = ghost.samples.back(), &then = ghost.samples[ghost.samples.size() - 1 - between_];
    const double moved = now.travelled - then.travelled, time = static_cast<double>(between_) * world::kTick;
    const std::size_t count = segments_.size(), entry = ghost.forces.size() / cars_.size() - 1;
    const auto speed = [&](double share) { return std::lerp(then.speed, now.speed, share); };
    const auto acceleration = [&](double share) { return std::lerp(then.acceleration, now.acceleration, share); };
    const Force* const felt = &ghost.forces[entry * cars_.size() + static_cast<std::size_t>(car)];
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
      ghost.passages.push_back(
          passage(segments_[from]->felt, segments_[next]->felt, back, speed(share), acceleration(share)));
      Passage& passed = ghost.passages.back();
      passed.knot = knot, passed.car = car, passed.entry = entry;
      passed.time = (static_cast<double>(entry) - 1) * kForceEvery * world::kTick + share * time;
      ride_to(share, from);
      from = next, tight = tight || !segments_[from]->cells.empty();
      if (from != to) continue;
      ride_to(1, to);
      passed.missed = force_of(missed);
    }
    if (tight) add_tight(car, first, to, at, ghost);
  }
  // Returns the share of a car's way of `moved` m to `at` that it had behind it at a knot.
  double share_to(std::size_t knot, double at, double moved) const {
    double past = moved < 0 ? tables_.start(knot) - at : at - tables_.start(knot);
    if (rails_.closed && past < 0) past += rails_.length;
    return std::clamp(1 - past / std::abs(moved), 0.0, 1.0);
  }

  // Adds the passage inside segments on the same way, if there are cells on it that the entries do not resolve.
  void add_tight(int car, std::size_t from, std::size_t to, double at, Ghost& ghost) const {
    const GhostSample &now = ghost.samples.back(), &then = ghost.samples[ghost.samples.size() - 1 - between_];
    const double moved = now.travelled - then.travelled;
    const std::size_t count = segments_.size(), entry = ghost.forces.size() / cars_.size() - 1;
    TightWay way{then, now, static_cast<double>(between_) * world::kTick};
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
    const Force* const felt = &ghost.forces[entry * cars_.size() + static_cast<std::size_t>(car)];
    if (!way.is_needed(seat_vector(*(felt - cars_.size())), seat_vector(felt[0]), joint)) return;
    for (auto it = ghost.passages.rbegin(); it != ghost.passages.rend() && it->car == car && it->entry == entry; ++it)
      it->missed = {0, 0, 0};  // the integrals are whole
    ghost.bends.push_back(way.passage());
    Passage& passed = ghost.bends.back().peak;
    passed.car = car, passed.entry = entry;
    passed.time += (static_cast<double>(entry) - 1) * kForceEvery * world::kTick;
  }
  double length_of(std::size_t segment) const { return tables_.start(segment + 1) - tables_.start(segment); }

  const RailTables& tables_;
  const world::Document& document_;
  GhostStart start_;
  std::vector<const SegmentTable*> segments_;
  GhostTrain train_;
  Rails rails_;
  double furthest_ = 0;
  int still_ = 0;
  std::size_t between_ = kForceEvery;  // ticks, of the last two entries of the forces
  struct CarPlace {
    double back;                          // m behind the first car
    std::size_t segment = 0;              // its last segment
    const SegmentTable* table = nullptr;  // of that segment, and the segment's ends in m from the track's start
    double from = 1, to = 0;
  };
  std::vector<CarPlace> cars_;
};

}  // namespace

Ghost simulate(const RailTables& tables, std::span<const EquipmentSpan> equipment, const world::Document& document,
               const GhostStart& start, const GhostLimits& limits, Ghost memory) {
  if (tables.size() == 0 || !(tables.length() > 0) || base::interrupted()) {
    Ghost ghost;
    ghost.start = start;
    ghost.samples.push_back({0, start.speed, 0, 0});
    ghost.forces.resize(static_cast<std::size_t>(start.cars));
    return ghost;
  }
  return Simulation(tables, equipment, document, start).run(limits, std::move(memory));
}

GhostStart start_at(const Derived& derived, const world::Cart& design, double front, double speed,
                    ControlState control) {
  return {front, speed, cars_on(derived, design), design.spacing, control, design.body(), design.mass};
}

GhostStart start_of(const world::Document& document, const Derived& derived, const world::Cart& design) {
  GhostStart start = start_at(derived, design, 0, document.start_speed, {});
  if (const auto index = world::index_of(derived.order, design.segment))
    start.front = derived.starts[*index] + design.fraction * derived.shape(design.segment).arc.length();
  return start;
}

}  // namespace coaster::sim
