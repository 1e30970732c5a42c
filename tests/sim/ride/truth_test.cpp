// Rides on curves in closed form, compared with the motion and forces of mechanics, by both simulations: step() on the
// exact curve and the simulated ride over tables. tools/plot_ride_truth draws the same numbers for docs/ride.md.
#include <gtest/gtest.h>

#include <functional>

#include "sim/ride/comparison.h"
#include "sim/ride/ride.h"
#include "sim/ride/simulated_ride.h"
#include "sim/tracks.h"
#include "world/loss_presets.h"

namespace coaster::sim {
namespace truth_test {

using glm::dvec3;
using test::Comparison;

constexpr double kG = world::kGravity;

// A curve by its arc length: a point of the rails, their direction and `up`.
struct Place {
  dvec3 at, along, up;
};
using Curve = std::function<Place(double)>;

// Knots at equal arc lengths. The handles are those of a circular arc of the same length and turn, (4/3) tan(turn/4) /
// turn of the length, which leaves the curvature within 2e-3 turn^4 of itself; turns here are at most 0.25. Rounding
// the knots to float (2e-6 m below 64 m) over segments of 2 m adds 6 * 2e-6 / 2^2 = 3e-6 /m.
world::Document fitted(const Curve& curve, double length, int segments) {
  world::Document d;
  const double step = length / segments;
  const auto handle = [&](int i) {  // of segment i
    if (i < 0 || i >= segments) return static_cast<float>(step / 3);
    const dvec3 from = curve(step * i).along, to = curve(step * (i + 1)).along;
    const double turn = 2 * std::asin(std::min(1.0, 0.5 * glm::length(to - from)));
    return static_cast<float>(turn < 1e-6 ? step / 3 : step * 4 / 3 * std::tan(turn / 4) / turn);
  };
  for (int i = 0; i <= segments; ++i) {
    const Place place = curve(step * i);
    world::append_knot(d, test::skew_knot(glm::vec3(place.at), glm::vec3(place.along), handle(i - 1), handle(i)));
    world::Knot& knot = d.entities.get<world::Knot>(d.track.knots.back());
    knot.up = glm::vec3(place.up);
    world::orthonormalise(knot);
    const Place before = curve(step * i - 1e-4), after = curve(step * i + 1e-4);
    const curve::Frame carried = curve::transport({before.along, before.up}, before.at, after.at, after.along);
    knot.spin = static_cast<float>(curve::signed_angle(carried.up, after.up, after.along) / 2e-4);
  }
  return d;
}

// Puts the train's first car `distance` m along a track of equally long segments.
world::Document with_train(world::Document d, double distance, double speed, int cars = 1, float spacing = 3) {
  const DerivedTrack derived = test::derived_of(d);
  const TrackPlace place = place_at(derived, distance);
  const double length = derived.shape(derived.order[place.index]).arc.length();
  const world::Entity cart = world::add_cart(d, derived.order[place.index], place.s / length);
  d.entities.get<world::Train>(cart).cars = cars;
  d.entities.get<world::Train>(cart).spacing = spacing;
  d.start_speed = speed, d.rollback_fails = false;
  return d;
}

struct Moment {
  double time, travelled, speed;
  std::vector<FeltAcceleration> felt;  // of each car, first to last
};
// Moments of a ride, 60 a second, up to `seconds` or the end of the track.
using Simulate = std::vector<Moment> (*)(const world::Document& document, double seconds);

std::vector<Moment> on_the_curve(const world::Document& document, double seconds) {
  const DerivedTrack derived = test::derived_of(document);
  world::Motion motion;
  RideCache cache;
  reset(document, derived, motion);
  motion.state = world::RideState::running;
  const world::Entity entity = motion.carts.entities()[0];
  const int cars = document.entities.get<world::Train>(entity).cars;
  std::vector<Moment> moments;
  for (int tick = 0; tick < seconds * world::kTicksPerSecond; tick += kForceEvery) {
    const world::TrainMotion& cart = motion.carts.items()[0];
    moments.push_back({tick * world::kTick, cart.travelled, cart.speed, {}});
    for (int car = 0; car < cars; ++car) moments.back().felt.push_back(felt(document, derived, entity, cart, car));
    step(document, derived, {}, kForceEvery, cache, motion);
    if (motion.state != world::RideState::running || motion.failure.kind != world::FailureKind::none) break;
  }
  return moments;
}

std::vector<Moment> over_tables(const world::Document& document, double seconds) {
  const DerivedTrack derived = test::derived_of(document);
  RideCache cache;
  const world::Entity entity = document.entities.pool<world::Train>().entities()[0];
  const SimulatedRide& simulated = *cache.ride(document, derived, entity);
  const auto cars = static_cast<std::size_t>(simulated.start.cars);
  std::vector<Moment> moments;
  const auto most = static_cast<std::size_t>(seconds * world::kTicksPerSecond);
  for (std::size_t tick = 0; tick < most && tick + 1 < simulated.samples.size();
       tick += kForceEvery) {  // not at the end
    const RideSample& sample = simulated.samples[tick];
    moments.push_back({static_cast<double>(tick) * world::kTick, sample.travelled, sample.speed, {}});
    for (std::size_t car = 0; car < cars; ++car) {
      const FeltAcceleration& force = simulated.forces[tick / kForceEvery * cars + car];
      moments.back().felt.push_back(force);
    }
  }
  return moments;
}

struct Method {
  const char* name;
  Simulate simulate;
};
constexpr Method kMethods[] = {{"curve", on_the_curve}, {"tables", over_tables}};

// Pendrill, "Student investigations of forces in a roller coaster loop", Eur. J. Phys. 34 (2013) 1379: all cars share
// the speed that the height of the train's centre of mass gives, and differences between them go with the train's
// length over the radius. For n cars, an angle q apart, the centre of mass is S = sin(n q/2) / (n sin(q/2)) of the
// radius from the loop's centre. The rider sits inside the rails by the height of the heartline.
TEST(truth, a_train_in_a_loop) {
  const double radius = 10, lap = 2 * M_PI * radius, before = lap * 11 / 32, heart = radius - 1.1;
  const Curve loop = [&](double s) -> Place {
    const double a = std::clamp((s - before) / radius, 0.0, 2 * M_PI), past = s - before - a * radius;
    const dvec3 along(std::cos(a), std::sin(a), 0), up(-std::sin(a), std::cos(a), 0);
    return {dvec3(3.3 + past, 2 + radius, -7.1) - radius * up + dvec3(before, 0, 0), along, up};
  };
  // Rounding the knots changes the curvature by 3e-6 /m, or 2e-4 g, and within a segment of 2 m, which riders 1.1 m
  // above it feel forwards as 4e-4 g. The tables are linear over 0.25 m: (0.25 / R)^2 / 8 of what changes, 2 g.
  Comparison speed("loop_speed", "m/s", 2e-5), up("loop_up", "g", 4e-4), forward("loop_forward", "g", 8e-4);
  for (const float spacing : {3.0f, 1.5f})
    for (const Method& method : kMethods) {
      const int cars = 7;
      const double q = spacing / radius, half = 0.5 * (cars - 1) * q, v0 = 24;
      const double share = std::sin(cars * q / 2) / (cars * std::sin(q / 2));
      const world::Document d = with_train(fitted(loop, 54 * lap / 32, 54), 18.5, v0, cars, spacing);
      ASSERT_EQ(d.heartline, 1.1);
      for (const Moment& moment : method.simulate(d, 10)) {
        const double front = (18.5 + moment.travelled - before) / radius, middle = front - half;
        if (middle - half < 0 || front > 2 * M_PI) continue;
        const double v2 = v0 * v0 - 2 * kG * radius * (1 - share * std::cos(middle));
        const std::string length = spacing == 3 ? "" : " (half as long)";
        speed.add(method.name, "train" + length, middle, moment.speed, std::sqrt(v2));
        for (const auto& [car, name] : {std::pair(0, "front"), std::pair(3, "middle"), std::pair(6, "back")}) {
          const double a = front - car * q;
          const FeltAcceleration& felt = moment.felt.at(static_cast<std::size_t>(car));
          up.add(method.name, name + length, middle, felt.up, v2 * heart / (radius * radius) / kG + std::cos(a));
          forward.add(method.name, name + length, middle, felt.forward,
                      std::sin(a) - share * heart / radius * std::sin(middle));
        }
      }
    }
}

// A clothoid's curvature is c s, so at speed v the force grows by v^3 c / g every second: Pendrill and Eager,
// "Velocity, acceleration, jerk, snap and vibration: forces in our bodies during a roller coaster ride", Phys. Educ. 55
// (2020) 065012, on constant jerk; Levien, "The Euler spiral: a mathematical history", UCB/EECS-2008-111, on the curve.
TEST(truth, a_clothoid_at_constant_speed_has_constant_jerk) {
  const double length = 60, c = 1.0 / 1200, v = 18;
  const Curve clothoid = [&](double s) -> Place {
    dvec3 at(3.3, 12, 9.7);
    const int n = 200;  // midpoints, to 1e-5 of the last place that matters
    for (int i = 0; i < n; ++i) {
      const double u = s * (i + 0.5) / n;
      at += s / n * dvec3(std::cos(c * u * u / 2), 0, -std::sin(c * u * u / 2));
    }
    return {at, {std::cos(c * s * s / 2), 0, -std::sin(c * s * s / 2)}, {0, 1, 0}};
  };
  // A cubic's curvature is not linear: within 2 m it strays by 9e-4 g; the jerk is a difference of two forces over half
  // a second.
  Comparison side("clothoid_side", "g", 1e-3), jerk("clothoid_jerk", "g/s", 4e-3);
  for (const Method& method : kMethods) {
    const std::vector<Moment> ride = method.simulate(with_train(fitted(clothoid, length, 30), 0.5, v), 10);
    for (std::size_t i = 0; i < ride.size(); ++i) {
      side.add(method.name, "lateral", ride[i].time, ride[i].felt[0].left, v * v * c * (0.5 + v * ride[i].time) / kG);
      if (i < 30) continue;
      const double rise = ride[i].felt[0].left - ride[i - 30].felt[0].left;
      jerk.add(method.name, "lateral", ride[i].time, rise / (ride[i].time - ride[i - 30].time), v * v * v * c / kG);
    }
  }
}

// A level straight that rolls evenly about the rails: the rider, h above the axis, moves on a circle at the rate w = v
// k and is drawn to the axis by w^2 h (any mechanics; Taylor, "Classical Mechanics", University Science Books 2005,
// section 1.7). Where the rails wind round the rider's straight line instead, the rider feels gravity alone.
TEST(truth, a_roll_about_the_rails_and_a_heartline_roll) {
  const double k = 2 * M_PI / 40, h = 1.1, v = 15, length = 120;  // one turn in 40 m
  const auto up_at = [](double roll) { return dvec3(0, std::cos(roll), std::sin(roll)); };
  const double wide = std::sqrt(1 + h * h * k * k);  // m of rail per m of heartline
  const Curve about_rails = [&](double s) -> Place { return {{3.3 + s, 12, 9.7}, {1, 0, 0}, up_at(k * s)}; };
  const Curve about_heart = [&](double s) -> Place {
    const double x = s / wide;
    const dvec3 across = up_at(k * x + M_PI / 2);
    return {dvec3(3.3 + x, 12, 9.7) - h * up_at(k * x), (dvec3(1, 0, 0) - h * k * across) / wide, up_at(k * x)};
  };
  // Within 1 m a cubic follows the winding rails' curvature along its chord, (k 1 m)^2 / 8 of v^2 h k^2 aside: 2e-3 g.
  Comparison up("roll_up", "g", 2e-3), side("roll_side", "g", 8e-4);
  for (const Method& method : kMethods) {
    // Not in the first and last 8 m, where the roll starts and ends.
    for (const Moment& m : method.simulate(with_train(fitted(about_rails, length, 30), 8, v), 6.8)) {
      const double roll = k * (8 + m.travelled);
      const FeltAcceleration& felt = m.felt[0];
      up.add(method.name, "about the rails", 8 + m.travelled, felt.up, std::cos(roll) - v * v * k * k * h / kG);
      side.add(method.name, "about the rails", 8 + m.travelled, felt.left, std::sin(roll));
    }
    for (const Moment& m : method.simulate(with_train(fitted(about_heart, length * wide, 120), 8 * wide, v), 6.8)) {
      const double x = 8 + m.travelled / wide, roll = k * x, lead = h * k / wide;  // sine of rails to heartline
      const FeltAcceleration& felt = m.felt[0];
      up.add(method.name, "about the rider", x, felt.up, std::cos(roll));
      // The rails point off the rider's line, and the train follows gravity along them: -g lead sin(roll).
      side.add(method.name, "about the rider", x, felt.left, std::sin(roll) / wide * (1 + lead * lead));
    }
  }
}

// v^2 after s metres of constant acceleration a against drag c v^2: v dv/ds = a - c v^2 (Taylor 2005, section 2.4).
double squared_speed(double v0, double a, double c, double s) {
  return c == 0 ? v0 * v0 + 2 * a * s : a / c + (v0 * v0 - a / c) * std::exp(-2 * c * s);
}

TEST(truth, a_launch) {
  Comparison speed("launch_speed", "m/s", 1e-8);  // the force along the track has no error but RK4's, (c v dt)^5
  const std::pair<const char*, world::Losses> losses[] = {
      {"frictionless", base::row_of(world::LossSet::frictionless).losses},
      {"openFVD", base::row_of(world::LossSet::openfvd).losses},
      {"drag 0.004 /m", {0.03f, 4e-3f}}};
  for (const auto& [name, resistance] : losses)
    for (const Method& method : kMethods) {
      world::Document d = test::straight_document({3, 12, 9}, {203, 12, 9}, 5);
      d.resistance = resistance;
      for (const world::Entity segment : d.track.segments)
        d.entities.put(segment, world::Equipment{world::EquipmentKind::launch, 150, 12.5f});
      const double v0 = 4, a = 12.5 - kG * resistance.rolling;
      for (const Moment& m : method.simulate(with_train(d, 1, v0), 20))
        speed.add(method.name, name, m.travelled, m.speed,
                  std::sqrt(squared_speed(v0, a, resistance.drag, m.travelled)));
    }
}

// The same law on a slope of 3 in 5: towards the terminal speed sqrt(g (sin a - rolling) / drag), from below and above.
// (Rolling friction is of the whole weight here, not of its part across the slope.) Drag is given for 500 kg.
TEST(truth, the_terminal_speed_on_a_slope) {
  Comparison speed("slope_speed", "m/s", 1e-4);  // knots rounded to 6e-5 m on 50 m change the slope by 1e-6
  for (const auto& [name, v0, mass] : {std::tuple("from rest", 0.0, 500.0), std::tuple("from 60 m/s", 60.0, 500.0),
                                       std::tuple("1000 kg from rest", 0.0, 1000.0)})
    for (const Method& method : kMethods) {
      world::Document d = with_train(test::straight_document({3, 903, 9}, {1203, 3, 9}, 30), 1, v0);
      d.resistance = {0.021f, 4e-3f};
      d.entities.get<world::Train>(d.entities.pool<world::Train>().entities()[0]).mass = static_cast<float>(mass);
      const double drag = d.resistance.drag * 500 / mass, pull = kG * (0.6 - d.resistance.rolling);
      const std::vector<Moment> ride = method.simulate(d, 120);
      for (const Moment& m : ride)
        speed.add(method.name, name, m.travelled, m.speed, std::sqrt(squared_speed(v0, pull, drag, m.travelled)));
      EXPECT_NEAR(ride.back().speed, std::sqrt(pull / drag), mass > 500 ? 0.3 : 0.01) << name;  // exp(-2 c s) is left
    }
}

// On a cycloid the slope is s / 4R from the lowest point, so every train is a harmonic oscillator and reaches it after
// pi sqrt(R/g), wherever it starts: Huygens, "Horologium oscillatorium" (1673), part 2, proposition 25. A train's mean
// slope is that of its middle.
TEST(truth, a_cycloid_takes_the_same_time_from_everywhere) {
  const double r = 10, half = 4 * r * std::sin(1.3), period = M_PI * std::sqrt(r / kG);
  const Curve cycloid = [&](double s) -> Place {
    const double p = 2 * std::asin((s - half) / (4 * r));
    return {dvec3(33.3 + r * (p + std::sin(p)), 2 + r * (1 - std::cos(p)), 9.7),
            {std::cos(p / 2), std::sin(p / 2), 0},
            {-std::sin(p / 2), std::cos(p / 2), 0}};
  };
  const world::Document track = fitted(cycloid, 2 * half, 40);
  // Rounding turns segments by 2e-6: the lowest point moves by 4R of that, 8e-5 m, which the slowest train passes at 2
  // m/s.
  Comparison distance("cycloid_distance", "m", 2e-4), time("cycloid_time", "s", 4e-5);
  for (const auto& [name, from, cars] : {std::tuple("from 36 m", -36.0, 1), std::tuple("from 20 m", -20.0, 1),
                                         std::tuple("5 cars from 12 m", -12.0, 5), std::tuple("from 4 m", -4.0, 1)})
    for (const Method& method : kMethods) {
      const world::Document d = with_train(track, half + from + 1.5 * (cars - 1), 0, cars);
      double last = from, last_time = 0;
      for (const Moment& m : method.simulate(d, 1.5 * period)) {
        const double s = from + m.travelled;
        distance.add(method.name, name, m.time, s, from * std::cos(M_PI / 2 * m.time / period));
        if (last < 0 && s >= 0)
          time.add(method.name, name, -from, last_time + (m.time - last_time) * last / (last - s), period);
        last = s, last_time = m.time;
      }
    }
}

}  // namespace truth_test
}  // namespace coaster::sim
