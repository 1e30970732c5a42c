// The ride: the simulated ride during a drag (2,000 m in 100 segments, 8 cars), what riders feel in it, and 10,000
// carts on a precomputed table of one lap, compared with a walk over the same bytes.
#include <cmath>
#include <random>

#include "paired.h"
#include "sim/ride/ride.h"
#include "sim/study/riders.h"
#include "world/topology.h"

namespace coaster::bench {
namespace ride_bench {

// Returns a closed ring of `segments` segments and `length` metres (within 2 %), with six hills of 8 m and a train that
// completes the lap.
world::Document hilly_ring(int segments, double length, int cars) {
  world::Document document;
  const double turn = 6.283185307179586, radius = 0.985 * length / turn;
  for (int i = 0; i < segments; ++i) {
    const double a = turn * i / segments;
    world::Knot knot;
    knot.position = glm::vec3(radius * std::cos(a), 20 + 8 * std::sin(6 * a), radius * std::sin(a));
    knot.in_length = knot.out_length = static_cast<float>(length / segments / 3);
    world::set_tangent(knot, glm::vec3(-radius * std::sin(a), 48 * std::cos(6 * a), radius * std::cos(a)));
    world::append_knot(document, knot);
  }
  world::set_closed(document, true);
  const world::Entity cart = world::add_cart(document, document.track.segments[3], 0.3);
  document.entities.get<world::Train>(cart).cars = cars;
  document.start_speed = 9;
  return document;
}

struct Riding {
  world::Document document;
  world::Settings settings;
  sim::DerivedTrack derived;
  sim::RideCache cache;
  explicit Riding(int cars) : document(hilly_ring(100, 2000, cars)) { sim::derive(document, settings, {}, derived); }
  const sim::SimulatedRide& simulated() { return *cache.ride(document, derived, world::first_cart(document)); }
};

double checksum(const sim::SimulatedRide& simulated) {
  double sum = simulated.lap_time;
  for (const sim::RideSample& sample : simulated.samples) sum += sample.speed;
  for (const sim::FeltAcceleration& force : simulated.forces) sum += force.up;
  return sum;
}

// A frame of a drag: one knot moved, derived data updated, the tables of its two segments filled, the whole lap
// simulated. The reference does the same without tables kept from ride to ride.
void drag(benchmark::State& state) {
  Riding riding(8);
  const world::Entity knot = riding.document.track.knots[40];
  const float y = world::knot(riding.document, knot).position.y;
  int moves = 0;
  const auto move = [&] {
    riding.document.entities.get<world::Knot>(knot).position.y = y + 0.25f * static_cast<float>(++moves % 7);
    sim::derive(riding.document, riding.settings, {}, riding.derived);
  };
  double sum = 0;
  const Work lap = [&] {
    move();
    sum += riding.simulated().lap_time;
  };
  const Work fresh = [&] {
    move();
    riding.cache = {};
    sum += riding.simulated().lap_time;
  };
  paired(state, "lap", 1, lap, {{"ratio_to_fresh_tables", fresh, true}});
  const sim::SimulatedRide& simulated = riding.simulated();
  if (!simulated.lap) return state.SkipWithError("the train does not come round");
  state.counters["ms_per_lap"] = state.counters["ns_per_lap"].value * 1e-6;
  state.counters["length_m"] = riding.derived.length;
  state.counters["lap_s"] = simulated.lap_time;
  moves = 6;  // back to the knot's position, so that the sum does not depend on the iterations
  lap();
  benchmark::DoNotOptimize(sum);
  state.counters["checksum"] = checksum(riding.simulated());
}

// What the riders of one car feel besides g, for all samples of the lap; the reference is the lap's simulation itself.
void riders(benchmark::State& state) {
  Riding riding(8);
  const sim::SimulatedRide& simulated = riding.simulated();
  const sim::RailTables& tables = riding.cache.tables(riding.document, riding.derived);
  double sum = 0;
  const Work car = [&] {
    sim::Riders fresh;
    fresh.update(simulated, tables, riding.derived, 5, {4, 4});
    sum += fresh.car(4).value(100, sim::RideValue::jerk);
  };
  const Work lap = [&] { sum += sim::simulate(tables, {}, riding.document, simulated.start).lap_time; };
  paired(state, "car", 1, car, {{"ratio_to_lap", lap, true}});
  state.counters["ms_per_car"] = state.counters["ns_per_car"].value * 1e-6;
  benchmark::DoNotOptimize(sum);
}

// Returns the largest distance in mm, within a minute, between a cart on the table and one moved by Runge-Kutta along
// the exact curve.
double drift_mm(Riding& riding, const sim::LapTable& table) {
  world::Motion motion;
  sim::reset(riding.document, riding.derived, motion);
  motion.state = world::RideState::running;
  sim::LapTrain cart = sim::lap_cart(table, 0);
  double worst = 0;
  for (int tick = 0; tick < 60 * world::kTicksPerSecond; ++tick) {
    sim::advance(table, cart);
    sim::step(riding.document, riding.derived, {}, 1, riding.cache, motion);
    worst = std::max(worst, std::abs(cart.laps * table.length() + cart.along - motion.carts.items()[0].travelled));
  }
  return worst * 1e3;
}

void carts(benchmark::State& state) {
  constexpr std::size_t kCarts = 10'000;
  Riding riding(1);
  const world::Train& design = riding.document.entities.get<world::Train>(world::first_cart(riding.document));
  const sim::LapTable& table =
      riding.cache.lap(riding.document, riding.derived, sim::start_of(riding.document, riding.derived, design));
  if (!table.valid()) return state.SkipWithError("the cart does not come round");
  std::mt19937 random(11);
  std::uniform_real_distribution<double> phase(0, table.period());
  sim::LapTrains all;
  for (std::size_t i = 0; i < kCarts; ++i) all.add(sim::lap_cart(table, phase(random)));
  const sim::LapTrains start = all;
  constexpr int kTicks = 20;  // per timed run, because reading the clock costs time
  const Work work = [&] {
    for (int tick = 0; tick < kTicks; ++tick) sim::advance(table, all);
  };
  // Reads and writes the same memory as advance(), and adds.
  sim::LapTrains walked = all;
  const Work walk = [&] {
    for (int tick = 0; tick < kTicks; ++tick)
      for (std::vector<double>* column : {&walked.phase, &walked.along, &walked.speed, &walked.laps})
        for (double& value : *column) value += 0.125;
  };
  paired(state, "cart_tick", static_cast<double>(kCarts) * kTicks, work, {{"ratio_to_array_walk", walk, true}});
  state.counters["drift_mm"] = drift_mm(riding, table);
  all = start;
  work();
  double sum = 0;
  for (std::size_t i = 0; i < kCarts; ++i) sum += all.along[i] + all.speed[i] + all.laps[i];
  state.counters["checksum"] = sum;
}

// The trains of a whole session, moved by ticks: 10,000 on the timetable, and by Runge-Kutta both 10,000 and 64.
struct Crowd {
  Riding riding{1};
  world::Motion motion;
  explicit Crowd(std::size_t trains) {
    world::Document& document = riding.document;
    document.start_speed = 30;
    const world::Entity segment = document.track.segments[3];
    while (document.entities.pool<world::Train>().size() < trains) world::add_cart(document, segment, 0.3);
    sim::reset(document, riding.derived, motion);
    for (std::size_t i = 0; i < trains; ++i)
      sim::seek(document, riding.derived, motion.carts.entities()[i],
                riding.derived.length * static_cast<double>(i) / static_cast<double>(trains), motion);
  }
  void step(std::string_view integrator) {
    motion.state = world::RideState::running, motion.failure = {};  // they touch each other, and continue
    sim::step(riding.document, riding.derived, base::value_named<world::IntegratorId>(integrator).value(), 1,
              riding.cache, motion);
  }
};

void crowd(benchmark::State& state) {
  Crowd table(world::kMaxCarts), many(world::kMaxCarts), few(64);
  const Work by_table = [&] { table.step("precomputed"); };
  const Work by_rk4 = [&] { many.step("rk4"); };
  const Work few_by_rk4 = [&] {
    for (int i = 0; i < 156; ++i) few.step("rk4");  // as many trains
  };
  by_table();
  paired(state, "train_tick", static_cast<double>(world::kMaxCarts), by_table,
         {{"ratio_to_rk4", by_rk4, true}, {"ratio_to_rk4_of_64", few_by_rk4, true}});
  state.counters["simulations"] = static_cast<double>(table.riding.cache.simulations());
}

BENCHMARK(crowd)->Name("ride/ten_thousand_trains")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(drag)->Name("ride/ghost_while_dragging")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(riders)->Name("ride/riders_of_a_car")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(carts)->Name("ride/carts_by_lap_table")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace ride_bench
}  // namespace coaster::bench
