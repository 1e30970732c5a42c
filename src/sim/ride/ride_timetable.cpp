// Trains that follow timetables. Where laps repeat, those of one kind and energy share the table of one lap, each at
// its own time.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/ride/ride_detail.h"

namespace coaster::sim {
namespace {

// Trains that move alike.
struct AlikeTrains {
  TrainStart start;
  world::Entity first;
  world::TimetablePlace place;  // where the first train joined
  double energy = 0;            // J/kg
};

bool of_one_kind(const TrainStart& a, const TrainStart& b) {
  return a.cars == b.cars && a.spacing == b.spacing && a.length == b.length && a.mass == b.mass;
}

// Returns the energy (J/kg, as of a cart) above which a train passes every top within the time of a timetable.
double energy_of_laps(const RideInput& input) {
  double top = -world::kMaxCoordinate;
  for (std::size_t i = 0; i < input.derived.order.size(); ++i) {
    const SegmentShape& shape = input.derived.shape_at(i);
    const curve::Cubic& c = shape.key.cubic;
    top = std::max(top, double{std::max({c.p0.y, c.p1.y, c.p2.y, c.p3.y})} + std::abs(shape.key.rails));
  }
  const double slowest = input.derived.length / (0.99 * RideLimits{}.seconds);
  return world::kGravity * (top - input.document.datum) + 0.5 * slowest * slowest;
}

constexpr std::size_t kLapBlock = 64;  // trains whose data stay in the first-level cache

// What trains on a table accumulate tick by tick, member by member.
struct TrainTotals {
  std::array<double, kLapBlock> travelled, furthest, peak_kinetic;
};

void add_tick(std::size_t count, double length, const double* __restrict before_along,
              const double* __restrict before_laps, const LapTrains& on, TrainTotals& accounts) {
  const double *const along = on.along.data(), *const laps = on.laps.data(), *const speed = on.speed.data();
  for (std::size_t i = 0; i < count; ++i) {
    accounts.travelled[i] += (laps[i] - before_laps[i]) * length + (along[i] - before_along[i]);
    accounts.furthest[i] = std::max(accounts.furthest[i], accounts.travelled[i]);
    accounts.peak_kinetic[i] = std::max(accounts.peak_kinetic[i], 0.5 * speed[i] * speed[i]);
  }
}

// Runs all ticks of at most kLapBlock trains on one table. `on` is kept for its capacity.
void follow_block(const RideInput& input, const LapTable& table, std::span<const std::size_t> trains, int ticks,
                  std::vector<world::TrainMotion>& carts, LapTrains& on) {
  const std::size_t count = trains.size();
  const double length = table.length();
  TrainTotals accounts;
  std::array<double, kLapBlock> before_along, before_laps, rounds;
  for (std::vector<double>* column : {&on.phase, &on.along, &on.speed, &on.laps}) column->clear();
  for (std::size_t i = 0; i < count; ++i) {
    const world::TrainMotion& cart = carts[trains[i]];
    const LapTrain start = lap_cart(table, cart.timetable.phase);
    on.add(start);
    rounds[i] = std::floor((cart.timetable.front + start.along) / length);
    accounts.travelled[i] = cart.travelled, accounts.furthest[i] = cart.furthest;
    accounts.peak_kinetic[i] = cart.peak_kinetic;
  }
  for (int tick = 0; tick < ticks; ++tick) {
    std::copy_n(on.along.begin(), count, before_along.begin());
    std::copy_n(on.laps.begin(), count, before_laps.begin());
    advance(table, on);
    add_tick(count, length, before_along.data(), before_laps.data(), on, accounts);
  }
  for (std::size_t i = 0; i < count; ++i) {
    world::TrainMotion& cart = carts[trains[i]];
    const double at = cart.timetable.front + on.along[i];
    cart.travelled = accounts.travelled[i], cart.furthest = accounts.furthest[i];
    cart.peak_kinetic = accounts.peak_kinetic[i];
    if (ticks > 0) cart.speed = on.speed[i];
    cart.laps += static_cast<std::int64_t>(on.laps[i] + std::floor(at / length) - rounds[i]);
    cart.timetable.phase = on.phase[i], cart.timetable.tick += ticks;
    settle_on(input.derived, place_at(input.derived, at), cart);
  }
}

// Returns the start of a train's timetable at its present motion.
world::TimetablePlace timetable_from(const world::TrainMotion& cart) {
  return {true, cart.track_distance, cart.speed, cart.dwell, cart.braking, 0, 0};
}

TrainStart start_of(const RideInput& input, world::Entity entity, const world::TimetablePlace& table) {
  return start_at(input.derived, input.document.entities.get<world::Train>(entity), table.front, table.speed,
                  {table.dwell, table.braking});
}

// The tables of one lap for many trains, each looked up in the cache once.
class LapTables {
 public:
  LapTables(const RideInput& input, RideCache& cache) : input_(input), cache_(cache) {}
  const LapTable& of(world::Entity entity, const world::TimetablePlace& place) {
    const TrainStart start = start_of(input_, entity, place);
    for (const auto& [known, table] : tables_)
      if (known == start) return *table;
    tables_.emplace_back(start, &cache_.lap(input_.document, input_.derived, start));
    return *tables_.back().second;
  }
  // Returns that of each train, in the order of the items.
  std::vector<const LapTable*> of(const world::Pool<world::TrainMotion>& carts) {
    std::vector<const LapTable*> tables(carts.size());
    for (std::size_t i = 0; i < carts.size(); ++i) tables[i] = &of(carts.entities()[i], carts.items()[i].timetable);
    return tables;
  }

 private:
  const RideInput& input_;
  RideCache& cache_;
  std::vector<std::pair<TrainStart, const LapTable*>> tables_;  // at most kMostTimetables
};

// If a train is without a timetable, gives each the one of its kind and energy. Returns false if there are too many, or
// if a train may not complete a lap.
bool share_timetables(const RideInput& input, RideCache& cache, world::Motion& motion) {
  constexpr double kSame = 1e-8;  // of the energy
  if (!input.derived.closed || !input.equipment.empty() || input.document.resistance != world::Losses{}) return false;
  auto& carts = motion.carts;
  if (std::ranges::all_of(carts.items(), [](const world::TrainMotion& cart) { return cart.timetable.valid; }))
    return true;
  const double least = energy_of_laps(input);
  std::vector<AlikeTrains> families;
  std::vector<std::size_t> family_of(carts.size());
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const world::TrainMotion& cart = carts.items()[i];
    const world::Entity entity = carts.entities()[i];
    AlikeTrains own{{}, entity, {}, energy(input.document, input.derived, entity, cart)};
    own.place = timetable_from(cart);
    own.start = start_of(input, entity, own.place);
    const auto same = std::ranges::find_if(families, [&](const AlikeTrains& f) {
      return of_one_kind(f.start, own.start) &&
             std::abs(f.energy - own.energy) <= kSame * std::max(1.0, std::abs(own.energy));
    });
    family_of[i] = static_cast<std::size_t>(same - families.begin());
    if (same == families.end()) families.push_back(own);
    if (families.size() > kMostTimetables || !(cart.speed > 0) || !(own.energy > least)) return false;
  }
  LapTables tables(input, cache);
  for (std::size_t i = 0; i < carts.size(); ++i) {
    world::TrainMotion& cart = carts.items()[i];
    const AlikeTrains& family = families[family_of[i]];
    const LapTable& table = tables.of(family.first, family.place);
    if (!table.valid()) return false;
    cart.timetable = family.place;
    cart.timetable.phase = table.phase_at(within_lap(cart.track_distance - family.place.front, table.length(), true));
  }
  return true;
}

// Runs all ticks of those `trains` (indices of `carts` and of their tables) whose laps repeat.
void follow_laps(const RideInput& input, std::span<const LapTable* const> table_of, std::span<const std::size_t> trains,
                 int ticks, std::vector<world::TrainMotion>& carts) {
  LapTrains on;
  for (std::size_t from = 0, to = 0; from < trains.size(); from = to) {
    const LapTable& table = *table_of[trains[from]];
    while (to < trains.size() && to - from < kLapBlock && table_of[trains[to]] == &table) ++to;
    follow_block(input, table, trains.subspan(from, to - from), ticks, carts, on);
  }
}

// Applies the next tick's entry. Returns false if the timetable ends the ride.
bool follow_timetable(const RideInput& input, RideCache& cache, world::Entity entity, world::TrainMotion& cart,
                      world::FailureKind& failure) {
  const SimulatedRide* simulated = &cache.from(input.document, input.derived, start_of(input, entity, cart.timetable));
  const auto last = static_cast<std::int64_t>(simulated->samples.size()) - 1;
  if (cart.timetable.tick >= last) {
    if (simulated->end != world::FailureKind::none || last == 0) {
      failure = simulated->end;
      return false;
    }
    cart.timetable = timetable_from(cart);
    simulated = &cache.from(input.document, input.derived, start_of(input, entity, cart.timetable));
    if (simulated->samples.size() < 2) return false;
  }
  const auto now = static_cast<std::size_t>(cart.timetable.tick), next = now + 1;
  const RideSample &before = simulated->samples[now], &after = simulated->samples[next];
  const double from = simulated->start.front + before.travelled, to = simulated->start.front + after.travelled;
  if (input.derived.closed)
    cart.laps += static_cast<std::int64_t>(std::floor(to / simulated->track_length) -
                                           std::floor(from / simulated->track_length));
  cart.travelled += after.travelled - before.travelled;
  cart.work += after.work - before.work;
  cart.speed = after.speed;
  cart.furthest = std::max(cart.furthest, cart.travelled);
  cart.peak_kinetic = std::max(cart.peak_kinetic, 0.5 * cart.speed * cart.speed);
  settle_on(input.derived, place_at(input.derived, simulated->distance(next)), cart);
  cart.timetable.tick = static_cast<std::int64_t>(next);
  return true;
}

bool begin_timetables(world::Motion& motion) {
  for (world::TrainMotion& cart : motion.carts.items())
    if (!cart.timetable.valid) cart.timetable = timetable_from(cart);
  return true;
}

}  // namespace

bool step_by_timetable(const RideInput& input, int ticks, RideCache& cache, world::Motion& motion) {
  cache.keep(std::min(motion.carts.size(), kMostTimetables) + 4);
  const bool shared = motion.carts.size() > kMostTimetables;
  if (!(shared ? share_timetables(input, cache, motion) : begin_timetables(motion))) return false;
  std::vector<std::size_t> rounds, others;  // trains whose laps repeat, and the others
  std::vector<const LapTable*> table_of = LapTables(input, cache).of(motion.carts);
  for (std::size_t i = 0; i < motion.carts.size(); ++i) (table_of[i]->valid() ? rounds : others).push_back(i);
  if (shared && !others.empty()) return false;
  int done = 0;  // ticks, including the one in which the ride failed, which is the last for all trains
  for (; done < ticks && motion.state == world::RideState::running && (done == 0 || !others.empty()); ++done) {
    bool any = !rounds.empty();
    for (const std::size_t i : others) {
      world::TrainMotion& cart = motion.carts.items()[i];
      world::FailureKind failure = world::FailureKind::none;
      const double arrival = cart.speed;
      if (motion.state != world::RideState::running ||
          follow_timetable(input, cache, motion.carts.entities()[i], cart, failure)) {
        any = true;
        continue;
      }
      halt(cart);
      if (failure == world::FailureKind::none) continue;
      if (motion.failure.kind == world::FailureKind::none)
        motion.failure = {failure, motion.carts.entities()[i], cart.track_distance, arrival};
      if (failure != world::FailureKind::off_end) motion.state = world::RideState::failed;
    }
    if (!any && motion.state == world::RideState::running) motion.state = world::RideState::ended;
  }
  if (others.empty()) done = ticks;
  else table_of = LapTables(input, cache).of(motion.carts);  // the others may have evicted tables
  follow_laps(input, table_of, rounds, done, motion.carts.items());
  return true;
}

}  // namespace coaster::sim
