#include "sim/ride/simulated_ride.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/ride/ride.h"
#include "sim/ride/simulated_ride_detail.h"
#include "sim/study/ratings.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace simulated_ride_test {

constexpr double kG = world::kGravity;

struct Riding {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  world::Entity cart;

  Riding(world::Document d, std::size_t segment, double fraction, double speed, int cars = 1) : document(std::move(d)) {
    cart = world::add_cart(document, document.track.segments.at(segment), fraction);
    document.entities.get<world::Train>(cart).cars = cars;
    document.start_speed = speed;
    derive(document, {}, {}, derived);
  }
  const SimulatedRide& simulated() { return *cache.ride(document, derived, cart); }
};

// A helix about a vertical axis, `per_turn` segments a turn, going down by `drop` m a turn; up as near to +Y as can be.
world::Document helix_document(double radius, double drop, int turns, int per_turn = 32) {
  world::Document d;
  const double step = 2 * M_PI / per_turn, c = -drop / (2 * M_PI);
  const auto handle = static_cast<float>(4.0 / 3.0 * std::tan(step / 4) * std::hypot(radius, c));
  for (int i = 0; i <= turns * per_turn; ++i) {
    const double a = step * i;
    world::append_knot(d,
                       test::skew_knot(glm::vec3(3.3 + radius * std::cos(a), 40 + c * a, -7.9 - radius * std::sin(a)),
                                       glm::vec3(-radius * std::sin(a), c, -radius * std::cos(a)), handle, handle));
    world::Knot& k = d.entities.get<world::Knot>(d.track.knots.back());
    k.up = glm::vec3(0, 1, 0);
    world::orthonormalise(k);
  }
  return d;
}

// A train's mean slope from each car's own place on the rails, by the cubic Hermite between two points of the grid.
double mean_slope(const RailTables& tables, int cars, double spacing, double step, double at) {
  const auto mean = [&](double front) {
    RailPoint sum{0, 0};
    for (int car = 0; car < cars; ++car) {
      std::size_t index = 0;
      const double s = tables.locate(front - car * spacing, index);
      const RailPoint rail = rail_at(tables.segment(index), s);
      sum.height += rail.height / cars, sum.slope += rail.slope / cars;
    }
    return sum;
  };
  const double first = step * std::floor(at / step), u = (at - first) / step;
  const RailPoint a = mean(first), b = mean(first + step);
  const double rise = (b.height - a.height) / step;
  return a.slope + u * (6 * rise - 4 * a.slope - 2 * b.slope) + u * u * (3 * a.slope + 3 * b.slope - 6 * rise);
}

TEST(simulated_ride, slopes_are_those_of_all_cars_in_any_order_of_the_places) {
  std::mt19937 bits(3);
  for (const bool closed : {true, false})
    for (const int cars : {1, 2, 7}) {
      world::Document d = test::ring_document(150, 300, 20);
      world::set_closed(d, closed);
      RailTables tables;
      tables.update(test::derived_of(d), d.heartline);
      std::vector<const SegmentTable*> segments;
      for (std::size_t i = 0; i < tables.size(); ++i) segments.push_back(&tables.segment(i));
      constexpr double kSpacing = 3.3;
      const double step = tables.length() / std::ceil(tables.length() / tables.largest_step());
      MeanSlopeTable forwards(tables, segments, cars, kSpacing), leaping(tables, segments, cars, kSpacing);
      std::vector<double> places;
      for (double at = 0.3; at < tables.length(); at += 0.77) places.push_back(at);
      std::vector<double> slopes;
      for (const double at : places) slopes.push_back(forwards.slope(at));
      for (int i = 0; i < 3'000; ++i) {
        const std::size_t k = bits() % places.size();
        EXPECT_EQ(leaping.slope(places[k]), slopes[k]);
        if (!closed && places[k] < cars * kSpacing + step) continue;
        EXPECT_NEAR(slopes[k], mean_slope(tables, cars, kSpacing, step, places[k]), 1e-7) << places[k];
        EXPECT_NEAR(leaping.slope(places[k] - (closed ? tables.length() : 0)), slopes[k], 1e-7);
      }
    }
}

TEST(simulated_ride, the_felt_acceleration_in_a_vertical_circle_is_that_of_the_textbook) {
  const double radius = 7.5, bottom_speed = 20.3;
  world::Document d = test::circle_document(radius, {3.3, 1.7, -2.9}, {0.6, 0, 0.8});
  d.heartline = 1.1;
  Riding setup(d, 0, 0.0, bottom_speed);
  const SimulatedRide& simulated = setup.simulated();
  ASSERT_TRUE(simulated.lap);
  // Riders inside the loop go (R - d)/R as fast as the rails: felt = v^2 (R - d)/R^2 + g at the bottom, less g at the
  // top.
  const auto felt = [&](double v2, double weight) { return v2 * (radius - 1.1) / (radius * radius) / kG + weight; };
  const double top_v2 = bottom_speed * bottom_speed - 4 * kG * radius;
  EXPECT_NEAR(simulated.forces.front().up, felt(bottom_speed * bottom_speed, 1), 0.02);
  std::size_t top = 0;
  for (std::size_t i = 0; i < simulated.samples.size(); ++i)
    if (simulated.samples[i].speed < simulated.samples[top].speed) top = i;
  EXPECT_NEAR(simulated.samples[top].speed, std::sqrt(top_v2), 2e-3);
  EXPECT_NEAR(simulated.forces[top / kForceEvery].up, felt(top_v2, -1), 0.02);
}

TEST(simulated_ride, a_helix_presses_sideways_by_v2_over_r) {
  const double radius = 12.3, drop = 4.1, c = drop / (2 * M_PI);
  world::Document d = helix_document(radius, drop, 3);
  d.heartline = 0;
  Riding setup(d, 4, 0.0, 9.7);
  const SimulatedRide& simulated = setup.simulated();
  const double curvature = radius / (radius * radius + c * c);
  for (std::size_t k = 20; k + 20 < simulated.forces.size(); k += 7) {
    const double speed = simulated.samples[k * kForceEvery].speed;
    EXPECT_NEAR(std::abs(simulated.forces[k].left), speed * speed * curvature / kG,
                0.01 * speed * speed * curvature / kG)
        << k;
  }
}

TEST(simulated_ride, a_straight_ramp_takes_the_time_of_uniform_acceleration) {
  Riding setup(test::straight_document({1.1f, 29.3f, 2.7f}, {31.1f, 6.3f, 12.7f}, 5), 0, 0.0, 0.5);
  const SimulatedRide& simulated = setup.simulated();
  const double length = std::sqrt(30.0 * 30 + 23.0 * 23 + 10.0 * 10), a = kG * 23.0 / length;
  const double time = (std::sqrt(0.25 + 2 * a * length) - 0.5) / a;
  EXPECT_EQ(simulated.end, world::FailureKind::off_end);
  EXPECT_NEAR(simulated.seconds(), time, world::kTick);
  const RideSample& middle = simulated.samples[simulated.samples.size() / 2];
  const double t = static_cast<double>(simulated.samples.size() / 2) * world::kTick;
  EXPECT_NEAR(middle.travelled, 0.5 * t + 0.5 * a * t * t, 1e-4);
}

TEST(simulated_ride, keeps_the_energy_and_agrees_with_runge_kutta_on_the_exact_curve) {
  for (const int cars : {1, 8}) {
    Riding setup(test::ring_document(12, 40.3, 7.7), 4, 0.37, 17.3, cars);
    const SimulatedRide& simulated = setup.simulated();
    ASSERT_TRUE(simulated.lap);
    world::Motion motion;
    reset(setup.document, setup.derived, motion);
    motion.state = world::RideState::running;
    double worst = 0;
    for (std::size_t tick = 0; tick < simulated.samples.size(); ++tick) {
      const world::TrainMotion& cart = motion.carts.items()[0];
      worst = std::max(worst, std::abs(cart.travelled - simulated.samples[tick].travelled));
      step(setup.document, setup.derived, {}, 1, setup.cache, motion);
    }
    EXPECT_LT(worst, 2e-3) << cars;  // m
    // The lap's time, by the speed at the end of it.
    const world::TrainMotion& cart = motion.carts.items()[0];
    const double exact = static_cast<double>(simulated.samples.size()) * world::kTick -
                         (cart.travelled - setup.derived.length) / cart.speed;
    EXPECT_NEAR(simulated.lap_time / exact, 1.0, 1e-5) << cars;
  }
}

// Eight cars over a hill: s'' = -(g/8) sum of T_y, by tiny steps over a polyline of 400,000 chords.
TEST(simulated_ride, a_long_train_moves_as_its_lagrangian_says) {
  world::Document d;
  const glm::vec3 at[] = {{0.3f, 2, 0.7f}, {30, 2, 4}, {60, 24, 8}, {90, 3, 3}, {140, 2, 0.1f}, {190, 2.5f, 0}};
  const glm::vec3 along[] = {{1, 0, 0}, {1, 0.1f, 0.1f}, {1, 0, 0}, {1, -0.2f, 0}, {1, 0, 0}, {1, 0, 0}};
  for (int i = 0; i < 6; ++i) world::append_knot(d, test::skew_knot(at[i], along[i], 11.3f, 11.3f));
  Riding setup(d, 0, 0.99, 22.7, 8);
  std::vector<double> height, distance;
  double sum = 0;
  glm::dvec3 last(0);
  for (std::size_t i = 0; i < setup.derived.order.size(); ++i) {
    const curve::Cubic c = world::cubic_of(setup.document, setup.derived.order[i]);
    for (int k = i == 0 ? 0 : 1; k <= 80'000; ++k) {
      const glm::dvec3 p = curve::point_long_double(c, k / 80'000.0);
      if (!distance.empty()) sum += glm::length(p - last);
      distance.push_back(sum), height.push_back(p.y);
      last = p;
    }
  }
  const auto slope = [&](double s) {
    const auto above =
        std::clamp<std::ptrdiff_t>(std::upper_bound(distance.begin(), distance.end(), s) - distance.begin(), 1,
                                   static_cast<std::ptrdiff_t>(distance.size()) - 1);
    const auto k = static_cast<std::size_t>(above);
    return (height[k] - height[k - 1]) / (distance[k] - distance[k - 1]);
  };
  double s = setup.simulated().start.front, v = 22.7;
  const double from = s, dt = 1e-4;
  const auto pull = [&](double x) {
    double a = 0;
    for (int car = 0; car < 8; ++car) a -= kG / 8 * slope(x - 3.0 * car);
    return a;
  };
  double a = pull(s);
  for (int i = 0; i < 50'000; ++i) {  // 5 s
    s += v * dt + 0.5 * a * dt * dt;
    const double next = pull(s);
    v += 0.5 * (a + next) * dt;
    a = next;
  }
  const RideSample& sample = setup.simulated().samples.at(600);
  EXPECT_NEAR(sample.travelled, s - from, 5e-3);
  EXPECT_NEAR(sample.speed, v, 1e-3);
}

TEST(simulated_ride, is_simulated_again_when_its_ride_changes_and_not_otherwise) {
  Riding setup(test::ring_document(12, 20.3), 4, 0.37, 14.3, 3);
  setup.simulated();
  EXPECT_EQ(setup.cache.simulations(), 1u);
  setup.simulated();
  EXPECT_EQ(setup.cache.simulations(), 1u);
  setup.document.entities.get<world::Knot>(setup.document.track.knots[2]).position.y += 0.5f;
  derive(setup.document, {}, {}, setup.derived);
  setup.simulated();
  setup.document.resistance.rolling = 0.02f;
  setup.simulated();
  EXPECT_EQ(setup.cache.simulations(), 3u);
}

TEST(simulated_ride, equipment_carries_a_train_round) {
  world::Document d = test::ring_document(16, 30.7, 0.0);
  d.entities.put(d.track.segments[0], world::Equipment{world::EquipmentKind::station, 4.0f, 3.0f, 0, 2});
  d.entities.put(d.track.segments[1], world::Equipment{world::EquipmentKind::launch, 15.0f, 9.0f, 0, 0});
  d.resistance = {0.01f, 1e-4f};
  Riding setup(d, 0, 0.2, 1.0, 4);
  const SimulatedRide& simulated = setup.simulated();
  EXPECT_TRUE(simulated.lap);
  const auto fastest = std::max_element(simulated.samples.begin(), simulated.samples.end(),
                                        [](const auto& a, const auto& b) { return a.speed < b.speed; });
  EXPECT_GT(fastest->speed, 10);
  EXPECT_LE(fastest->speed, 15.01);
}

TEST(simulated_ride, the_timetable_is_the_simulated_ride_tick_by_tick_and_goes_on_after_a_lap) {
  Riding setup(test::ring_document(12, 20.3), 4, 0.37, 14.3, 2);
  world::Motion motion;
  reset(setup.document, setup.derived, motion);
  motion.state = world::RideState::running;
  const world::IntegratorId row = base::value_named<world::IntegratorId>("precomputed").value();
  const SimulatedRide simulated = setup.simulated();
  for (std::size_t tick = 1; tick + 1 < simulated.samples.size(); ++tick) {  // in the last tick the next lap begins
    step(setup.document, setup.derived, row, 1, setup.cache, motion);
    ASSERT_EQ(motion.carts.items()[0].speed, simulated.samples[tick].speed) << tick;
    ASSERT_NEAR(motion.carts.items()[0].travelled, simulated.samples[tick].travelled, 1e-9);
  }
  step(setup.document, setup.derived, row, 120 * 60, setup.cache, motion);
  EXPECT_GT(motion.carts.items()[0].laps, 3);
  EXPECT_LT(energy_drift(setup.document, setup.derived, setup.cart, motion.carts.items()[0]), 1e-5);
}

TEST(simulated_ride, no_track_and_no_length_give_a_simulated_ride_that_stands) {
  world::Document d;
  RideCache cache;
  EXPECT_EQ(cache.ride(d, {}, world::kNone), nullptr);
  EXPECT_EQ(cache.from(d, {}, {}).samples.size(), 1u);
}

// At rest at the open end where the train starts: on level track it stalls after two seconds, live and as a simulated
// ride; on rising track it is pulled off the end; on falling track it moves on.
TEST(simulated_ride, a_train_that_stands_at_its_start_ends_as_it_does_live) {
  const struct {
    float rise;
    world::FailureKind end;
  } cases[]{{0, world::FailureKind::stall}, {3, world::FailureKind::off_end}, {-3, world::FailureKind::none}};
  for (const auto& [rise, end] : cases) {
    Riding setup(test::straight_document({1.1f, 12.3f, 2.7f}, {31.1f, 12.3f + rise, 2.7f}, 3), 0, 0, 0);
    world::Motion motion;
    reset(setup.document, setup.derived, motion);
    motion.state = world::RideState::running;
    const auto step_live = [&](int ticks) {
      step(setup.document, setup.derived, base::value_named<world::IntegratorId>("rk4").value(), ticks, setup.cache,
           motion);
    };
    step_live(200);
    EXPECT_EQ(motion.state == world::RideState::running, end != world::FailureKind::off_end) << rise;
    step_live(41);
    EXPECT_EQ(motion.failure.kind, end) << rise;
    EXPECT_EQ(motion.state == world::RideState::running, end == world::FailureKind::none) << rise;
    if (end != world::FailureKind::none) EXPECT_EQ(setup.simulated().end, end) << rise;
    else EXPECT_GT(motion.carts.items()[0].travelled, 0);
  }
}

}  // namespace simulated_ride_test
}  // namespace coaster::sim
