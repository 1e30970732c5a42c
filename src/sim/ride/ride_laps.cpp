// Trains whose laps repeat, many at once: those of one kind and energy share the table of one lap, each at its own
// time.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/ride/ride_parts.h"

namespace coaster::sim {
namespace {

// Trains that move alike.
struct Family {
  GhostStart start;
  world::Entity first;
  world::TimetablePlace place;  // where the first train joined
  double energy = 0;            // J/kg
};

bool of_one_kind(const GhostStart& a, const GhostStart& b) {
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
  const double slowest = input.derived.length / (0.99 * GhostLimits{}.seconds);
  return world::kGravity * (top - input.document.datum) + 0.5 * slowest * slowest;
}

constexpr std::size_t kBlock = 64;  // trains whose data stay in the first-level cache

// What trains on a table accumulate tick by tick, member by member.
struct Accounts {
  std::array<double, kBlock> travelled, furthest, peak_kinetic;
};

void add_tick(std::size_t count, double length, const double* __restrict before_along,
              const double* __restrict before_laps, const LapCarts& on, Accounts& accounts) {
  const double *const along = on.along.data(), *const laps = on.laps.data(), *const speed = on.speed.data();
  for (std::size_t i = 0; i < count; ++i) {
    accounts.travelled[i] += (laps[i] - before_laps[i]) * length + (along[i] - before_along[i]);
    accounts.furthest[i] = std::max(accounts.furthest[i], accounts.travelled[i]);
    accounts.peak_kinetic[i] = std::max(accounts.peak_kinetic[i], 0.5 * speed[i] * speed[i]);
  }
}

// Runs all ticks of at most kBlock trains on one table. `on` is kept for its capacity.
void follow_block(const RideInput& input, const LapTable& table, std::span<const std::size_t> trains, int ticks,
                  std::vector<world::CartMotion>& carts, LapCarts& on) {
  const std::size_t count = trains.size();
  const double length = table.length();
  Accounts accounts;
  std::array<double, kBlock> before_along, before_laps, rounds;
  for (std::vector<double>* column : {&on.phase, &on.along, &on.speed, &on.laps}) column->clear();
  for (std::size_t i = 0; i < count; ++i) {
    const world::CartMotion& cart = carts[trains[i]];
    const LapCart start = lap_cart(table, cart.timetable.phase);
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
    world::CartMotion& cart = carts[trains[i]];
    const double at = cart.timetable.front + on.along[i];
    cart.travelled = accounts.travelled[i], cart.furthest = accounts.furthest[i];
    cart.peak_kinetic = accounts.peak_kinetic[i];
    if (ticks > 0) cart.speed = on.speed[i];
    cart.laps += static_cast<std::int64_t>(on.laps[i] + std::floor(at / length) - rounds[i]);
    cart.timetable.phase = on.phase[i], cart.timetable.tick += ticks;
    settle_on(input.derived, place_at(input.derived, at), cart);
  }
}

}  // namespace

world::TimetablePlace timetable_from(const world::CartMotion& cart) {
  return {true, cart.track_distance, cart.speed, cart.dwell, cart.braking, 0, 0};
}

GhostStart start_of(const RideInput& input, world::Entity entity, const world::TimetablePlace& table) {
  return start_at(input.derived, input.document.entities.get<world::Cart>(entity), table.front, table.speed,
                  {table.dwell, table.braking});
}

const LapTable& LapTables::of(world::Entity entity, const world::TimetablePlace& place) {
  const GhostStart start = start_of(input_, entity, place);
  for (const auto& [known, table] : tables_)
    if (known == start) return *table;
  tables_.emplace_back(start, &memo_.lap(input_.document, input_.derived, start));
  return *tables_.back().second;
}

std::vector<const LapTable*> LapTables::of(const world::Pool<world::CartMotion>& carts) {
  std::vector<const LapTable*> tables(carts.size());
  for (std::size_t i = 0; i < carts.size(); ++i) tables[i] = &of(carts.entities()[i], carts.items()[i].timetable);
  return tables;
}

bool share_timetables(const RideInput& input, GhostMemo& memo, world::Motion& motion) {
  constexpr double kSame = 1e-8;  // of the energy
  if (!input.derived.closed || !input.equipment.empty() || input.document.resistance != world::Resistance{})
    return false;
  auto& carts = motion.carts;
  if (std::all_of(carts.items().begin(), carts.items().end(),
                  [](const world::CartMotion& cart) { return cart.timetable.valid; }))
    return true;
  const double least = energy_of_laps(input);
  std::vector<Family> families;
  std::vector<std::size_t> family_of(carts.size());
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const world::CartMotion& cart = carts.items()[i];
    const world::Entity entity = carts.entities()[i];
    Family own{{}, entity, {}, energy(input.document, input.derived, entity, cart)};
    own.place = timetable_from(cart);
    own.start = start_of(input, entity, own.place);
    const auto same = std::find_if(families.begin(), families.end(), [&](const Family& f) {
      return of_one_kind(f.start, own.start) &&
             std::abs(f.energy - own.energy) <= kSame * std::max(1.0, std::abs(own.energy));
    });
    family_of[i] = static_cast<std::size_t>(same - families.begin());
    if (same == families.end()) families.push_back(own);
    if (families.size() > kMostTimetables || !(cart.speed > 0) || !(own.energy > least)) return false;
  }
  LapTables tables(input, memo);
  for (std::size_t i = 0; i < carts.size(); ++i) {
    world::CartMotion& cart = carts.items()[i];
    const Family& family = families[family_of[i]];
    const LapTable& table = tables.of(family.first, family.place);
    if (!table.valid()) return false;
    cart.timetable = family.place;
    cart.timetable.phase = table.phase_at(within_lap(cart.track_distance - family.place.front, table.length(), true));
  }
  return true;
}

void follow_laps(const RideInput& input, std::span<const LapTable* const> table_of, std::span<const std::size_t> trains,
                 int ticks, std::vector<world::CartMotion>& carts) {
  LapCarts on;
  for (std::size_t from = 0, to = 0; from < trains.size(); from = to) {
    const LapTable& table = *table_of[trains[from]];
    while (to < trains.size() && to - from < kBlock && table_of[trains[to]] == &table) ++to;
    follow_block(input, table, trains.subspan(from, to - from), ticks, carts, on);
  }
}

}  // namespace coaster::sim
