// Jolts of rides, compared with finely sampled ones: the rider's path in closed form, its second differences over 1e-5
// s in long double, and the low-pass as a differential equation. None of it shares code with the ride.
#include "sim/study/jolt.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "sim/study/ratings.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace jolt_test {

using Vec = glm::tvec3<long double>;

constexpr double kG = world::kGravity, kHeart = 1.1, kCutoff = 5;

struct Rail {
  Vec at, along, up;
};
// A curve by its arc length, with a joint at 0.
using Curve = std::function<Rail(long double)>;

struct FineRide {
  Jolt jolt;        // of the joint at 0
  glm::dvec3 most;  // g, largest filtered felt g forwards, left and up
};

// A Butterworth low-pass of four poles: two oscillators y'' = w^2 (x - y) - w/q y', poles at 22.5 and 67.5 degrees.
class Filter {
 public:
  explicit Filter(glm::dvec3 start) : y_{start, start} {}
  glm::dvec3 next(glm::dvec3 x, double dt) {
    const double w = 2 * M_PI * kCutoff;
    for (int i = 0; i < 2; ++i) {
      const double damping = 2 * std::cos(i == 0 ? 3 * M_PI / 8 : M_PI / 8);
      rate_[i] += dt * (w * w * (x - y_[i]) - w * damping * rate_[i]);
      y_[i] += dt * rate_[i];
      x = y_[i];
    }
    return x;
  }

 private:
  glm::dvec3 y_[2], rate_[2]{glm::dvec3(0), glm::dvec3(0)};
};

// Rides a curve at constant speed, from 0.3 s before its joint to 0.7 s after it.
FineRide fine_ride(const Curve& curve, double speed) {
  const long double dt = 1e-5L;
  const int before = 30'000, after = 70'000;
  const auto rail = [&](int i) { return curve((static_cast<long double>(i) + 0.5L) * dt * speed); };
  const auto heart = [&](int i) {
    const Rail r = rail(i);
    return r.at + static_cast<long double>(kHeart) * r.up;
  };
  // The difference of entries -1 and 0 spans the joint.
  std::vector<glm::dvec3> felt, without;
  for (int i = -before; i < after; ++i) {
    const Rail r = rail(i);
    const Vec a = (heart(i + 1) - 2.0L * heart(i) + heart(i - 1)) / (dt * dt) + Vec(0, kG, 0);
    felt.emplace_back(glm::dot(a, r.along) / kG, glm::dot(a, glm::cross(r.up, r.along)) / kG, glm::dot(a, r.up) / kG);
  }
  const std::size_t joint = before;  // the first entry after it
  without = felt;
  const glm::dvec3 step = felt[joint + 1] - felt[joint - 2];
  without[joint - 1] = without[joint] = felt[joint - 2];
  for (std::size_t i = joint + 1; i < without.size(); ++i) without[i] -= step;
  FineRide ride{{}, felt[0]};
  Filter with_it(felt[0]), without_it(felt[0]);
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const glm::dvec3 here = with_it.next(felt[i], 1e-5), more = glm::abs(here - without_it.next(without[i], 1e-5));
    ride.jolt.forward = std::max(ride.jolt.forward, more.x), ride.jolt.left = std::max(ride.jolt.left, more.y);
    ride.jolt.up = std::max(ride.jolt.up, more.z), ride.jolt.total = std::max(ride.jolt.total, glm::length(more));
    ride.most = glm::max(ride.most, here);
  }
  return ride;
}

// Knots on a curve from `from` to `to` m, the joint among them, with the handles of arcs.
world::Document fitted(const Curve& curve, double from, double to, double step) {
  world::Document d;
  const auto handle = [&](double s) {
    const double turn = std::acos(std::min(1.0, static_cast<double>(glm::dot(curve(s).along, curve(s + step).along))));
    return static_cast<float>(turn < 1e-6 ? step / 3 : step * 4 / 3 * std::tan(turn / 4) / turn);
  };
  for (int i = 0; i <= static_cast<int>((to - from) / step + 0.5); ++i) {
    const double s = from + step * i;
    const Rail rail = curve(s);
    world::append_knot(d, test::skew_knot(glm::vec3(rail.at), glm::vec3(rail.along), handle(s - step), handle(s)));
    world::Knot& knot = d.entities.get<world::Knot>(d.track.knots.back());
    knot.up = glm::vec3(rail.up);
    world::orthonormalise(knot);
  }
  return d;
}

struct RiddenTrain {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  const SimulatedRide* simulated;
  std::vector<Jolt> found;

  RiddenTrain(world::Document d, double speed, int cars = 1, std::size_t segment = 0, double fraction = 0.0)
      : document(std::move(d)) {
    const world::Entity cart = world::add_cart(document, document.track.segments.at(segment), fraction);
    document.entities.get<world::Train>(cart).cars = cars;
    document.start_speed = speed, document.heartline = kHeart, document.rollback_fails = false;
    derive(document, {}, {}, derived);
    simulated = cache.ride(document, derived, cart);
    found = jolts(*simulated, kCutoff);
  }
};

double bound(double value) { return std::max(0.02, 0.02 * value); }

void expect_near(const Jolt& found, const Jolt& fine) {
  EXPECT_NEAR(found.forward, fine.forward, bound(fine.forward));
  EXPECT_NEAR(found.left, fine.left, bound(fine.left));
  EXPECT_NEAR(found.up, fine.up, bound(fine.up));
  EXPECT_NEAR(found.total, fine.total, bound(fine.total));
}

// A level straight into a level turn of radius 7.5 m to the left, `up` turned by `bank` towards its centre.
Curve turn_of(double bank) {
  return [bank](long double s) -> Rail {
    const long double radius = 7.5L, a = std::max(s, 0.0L) / radius, straight = std::min(s, 0.0L);
    const Vec in(-std::sin(a), 0, -std::cos(a));
    return {Vec(3.3L + straight + radius * std::sin(a), 12.7L, -7.1L - radius * (1 - std::cos(a))),
            {std::cos(a), 0, -std::sin(a)},
            static_cast<long double>(std::sin(bank)) * in + Vec(0, std::cos(bank), 0)};
  };
}

TEST(jolt, a_step_of_curvature_is_that_of_a_finely_sampled_ride) {
  const double speed = 20, step = 0.75;
  for (const double bank : {0.0, M_PI / 2, 0.6}) {
    const FineRide fine = fine_ride(turn_of(bank), speed);
    RiddenTrain ride(fitted(turn_of(bank), -30, 15, step), speed);
    const Jolt& found = ride.found.at(40);
    expect_near(found, fine.jolt);
    EXPECT_NEAR(found.speed, speed, 1e-3);
    for (std::size_t i = 1; i < 60; ++i)
      if (i != 40) {
        EXPECT_LT(ride.found.at(i).total, 0.03) << bank << " " << i;
      }
    // Closed forms: an impulse of v d dK up to 2.93 m/s, 2.40 f dv / g after the low-pass; a step with 10.8 % more.
    const double towards_up = std::sin(bank) / 7.5;
    EXPECT_NEAR(found.left, 1.108 * speed * speed / kG * std::cos(bank) * (1 / 7.5 - kHeart * towards_up / 7.5),
                bound(found.left));
    EXPECT_NEAR(found.forward, 2.397 * kCutoff * speed * kHeart * towards_up / kG, bound(found.forward));
    // What the limits and the ratings see: 12 entries per 1 / cutoff, which take 2.3 % of an impulse's peak.
    const Ratings rated = rate(*ride.simulated, ride.cache.tables(ride.document, ride.derived), kCutoff);
    EXPECT_NEAR(rated.side_most.value, std::abs(fine.most.y), bound(fine.most.y)) << bank;
    EXPECT_NEAR(rated.up_most.value, fine.most.z, bound(fine.most.z)) << bank;
    EXPECT_NEAR(rated.back_most.value, fine.jolt.forward, 0.025 * fine.jolt.forward + 1e-3) << bank;
    EXPECT_EQ(rated.jolt_most.value, found.total);
    EXPECT_NEAR(rated.jolt_most.distance, 30, 1.01 * speed / 60);
  }
}

// A level straight that rolls to the right about the rails.
Curve rolling(const std::function<long double(long double)>& angle) {
  return [angle](long double s) -> Rail {
    const long double a = angle(s);
    return {Vec(3.3L + s, 12.7L, -7.1L), {1, 0, 0}, {0, std::cos(a), std::sin(a)}};
  };
}

// 90 degrees in 20 m at 15 m/s, evenly: the rider is thrown sideways by d v w = 1.30 m/s, 1.58 g.
TEST(jolt, a_step_of_the_roll_rate_throws_riders_sideways) {
  const double speed = 15, spin = M_PI / 2 / 20;
  const FineRide fine = fine_ride(rolling([&](long double s) { return spin * std::max(s, 0.0L); }), speed);
  EXPECT_NEAR(fine.jolt.left, 1.58, 0.01);
  JointPassage passage;
  passage.impulse.left = static_cast<float>(-kHeart * speed * spin / kG);
  passage.step.up = static_cast<float>(-kHeart * speed * speed * spin * spin / kG);
  expect_near(jolt_of(passage, kCutoff), fine.jolt);
}

// Two knots 20 m apart whose spin is 0: the roll between them begins with 6 angle / length^2 rad/m^2.
TEST(jolt, a_step_of_the_rolls_second_derivative_is_a_step_of_lateral_g) {
  const double speed = 15, length = 20;
  const auto angle = [&](long double s) {
    const long double u = std::max(s, 0.0L) / length;
    return static_cast<long double>(M_PI / 2) * u * u * (3 - 2 * u);
  };
  world::Document d = fitted(rolling([](long double) { return 0.0L; }), -20, 20, 20);
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[2]), 90);
  RiddenTrain ride(std::move(d), speed);
  const FineRide fine = fine_ride(rolling(angle), speed);
  EXPECT_NEAR(fine.jolt.left, 1.108 * kHeart * speed * speed * 6 * M_PI / 2 / (length * length) / kG, 0.01);
  expect_near(ride.found.at(1), fine.jolt);
}

// A roll to the left that begins within 2 a metres, as in imports: each joint steps by what the other takes back, and
// riders feel the impulse of the sudden roll.
TEST(jolt, a_roll_that_begins_within_a_short_stretch_jolts_as_a_sudden_one) {
  for (const auto& [speed, spin, a] : {std::tuple(15.0, -0.0785, 0.45), {31.5, -0.157, 0.25}, {31.5, -0.209, 0.17}}) {
    SCOPED_TRACE(spin);
    const auto angle = [w = spin, a = a](long double s) {
      return s < -a ? 0 : s > a ? w * s : w * (s + a) * (s + a) / (4 * a);
    };
    const FineRide sudden = fine_ride(rolling([w = spin](long double s) { return w * std::max(s, 0.0L); }), speed);
    const FineRide spread = fine_ride(rolling(angle), speed);
    world::Document d;
    for (const double s : {-0.3 * speed, -a, a, 0.35 * speed, 0.7 * speed}) {
      const Rail rail = rolling(angle)(s);
      world::append_knot(d, test::skew_knot(glm::vec3(rail.at), {1, 0, 0}, 0.1f, 0.1f));
      world::Knot& knot = d.entities.get<world::Knot>(d.track.knots.back());
      knot.up = glm::vec3(rail.up), knot.spin = static_cast<float>(s < 0 ? 0 : spin);
      knot.spin_kind = world::SpinKind::set;
      world::orthonormalise(knot);
    }
    RiddenTrain ride(std::move(d), speed);
    for (const std::size_t joint : {1, 2})
      EXPECT_NEAR(ride.found.at(joint).left, sudden.jolt.left, 0.12 * sudden.jolt.left) << joint;
    const Ratings rated = rate(*ride.simulated, ride.cache.tables(ride.document, ride.derived), kCutoff);
    EXPECT_NEAR(rated.side_most.value, spread.most.y, 0.03 * spread.most.y);
    EXPECT_EQ(rated.jolt_most.value, std::max(ride.found.at(1).total, ride.found.at(2).total));
  }
}

// What a car feels by consecutive passages, 0 before them: their steps and impulses, and how felt g changes between.
Jolt filtered(const std::vector<const JointPassage*>& run) {
  const auto vector = [](const FeltAcceleration& f) { return glm::dvec3(f.forward, f.left, f.up); };
  constexpr double kDt = 4e-5;
  Filter filter(glm::dvec3(0));
  Jolt most;
  std::size_t passed = 0;  // passages
  glm::dvec3 at_last(0), slope(0);
  double last = 0;
  for (double t = run.front()->time; t < run.back()->time + 0.3; t += kDt) {
    glm::dvec3 hit(0);
    for (; passed < run.size() && run[passed]->time <= t + kDt / 2; ++passed) {
      const JointPassage& here = *run[passed];
      at_last += slope * (here.time - last) + vector(here.step), last = here.time, slope = glm::dvec3(0);
      hit += vector(here.impulse) / kDt;
      if (passed + 1 < run.size())
        slope = (vector(run[passed + 1]->before) - vector(here.before) - vector(here.step)) /
                (run[passed + 1]->time - here.time);
    }
    const glm::dvec3 felt = glm::abs(filter.next(at_last + slope * (t - last) + hit, kDt));
    most.forward = std::max(most.forward, felt.x), most.left = std::max(most.left, felt.y);
    most.up = std::max(most.up, felt.z), most.total = std::max(most.total, glm::length(felt));
  }
  return most;
}

// Random passages of two cars 10 to 33 ms apart, with steps to and fro. All runs of passages around each are tried.
TEST(jolt, joints_close_together_count_as_the_run_that_jolts_least) {
  std::mt19937 bits(29);
  const auto number = [&](double low, double high) { return static_cast<float>(low + (high - low) * bits() / 0x1p32); };
  int together = 0;
  for (int round = 0; round < 8; ++round) {
    // Impulses and steps are an entry apart, 4 ms, at the most.
    const float pushed = round % 2 == 0 ? 0.0f : 0.02f;
    const double slack = pushed > 0 ? 0.04 : 0.01;
    SimulatedRide simulated;
    simulated.start.cars = 2;
    for (int car = 0; car < 2; ++car) {
      double time = 1 + 0.005 * car;
      FeltAcceleration felt{0, 0, 1};
      for (int k = 0; k < 4; ++k, time += number(0.01, 0.033)) {
        JointPassage p;
        const float way = k % 2 == 0 ? 1.0f : -1.0f;
        p.car = car, p.time = time, p.before = felt, p.speed = 10 + k;
        p.step = {way * number(0.1, 0.3), way * number(0.3, 1.5), way * number(0.1, 0.8)};
        p.impulse = {pushed * number(-0.5, 0.5), pushed * number(-1, 1), 0};
        felt = {felt.forward + p.step.forward + number(-0.2, 0.2), felt.left + p.step.left + number(-1, 1),
                felt.up + p.step.up + number(-0.5, 0.5)};
        simulated.passages.push_back(p);
      }
    }
    std::stable_sort(simulated.passages.begin(), simulated.passages.end(),
                     [](const JointPassage& a, const JointPassage& b) { return a.time < b.time; });
    const std::vector<Jolt> found = passage_jolts(simulated, kCutoff);
    for (int car = 0; car < 2; ++car) {
      std::vector<const JointPassage*> passed;
      std::vector<std::size_t> places;  // among all
      for (std::size_t n = 0; n < found.size(); ++n)
        if (simulated.passages[n].car == car) passed.push_back(&simulated.passages[n]), places.push_back(n);
      std::vector<Jolt> least(passed.size());
      std::vector<double> alone(passed.size());
      for (std::size_t i = 0; i < passed.size(); ++i) least[i] = filtered({passed[i]}), alone[i] = least[i].total;
      for (std::size_t first = 0; first < passed.size(); ++first)
        for (std::size_t last = first + 1; last < passed.size(); ++last) {
          const Jolt all = filtered({passed.begin() + first, passed.begin() + last + 1});
          for (std::size_t i = first; i <= last; ++i)
            if (all.total < least[i].total) least[i] = all;
        }
      for (std::size_t i = 0; i < passed.size(); ++i) {
        const Jolt& one = found[places[i]];
        together += least[i].total < alone[i];
        SCOPED_TRACE(testing::Message() << round << ": car " << car << ", passage " << i);
        EXPECT_NEAR(one.total, least[i].total, slack + 0.01 * least[i].total);
        EXPECT_EQ(one.car, car);
        EXPECT_EQ(one.speed, passed[i]->speed);
      }
    }
  }
  EXPECT_GT(together, 30);
}

TEST(jolt, a_joint_with_continuous_curvature_has_none) {
  world::Document d = test::straight_document({1.1f, 12.3f, 2.7f}, {25.1f, 12.3f, 2.7f});
  const curve::Cubic bent{{25.1f, 12.3f, 2.7f}, {33.1f, 12.3f, 2.7f}, {41.1f, 14.9f, 2.7f}, {45.3f, 21.3f, 2.7f}};
  const curve::SplitCubic halves = curve::split(bent, 0.37);
  d.entities.get<world::Knot>(d.track.knots[1]).out_length = glm::distance(bent.p0, halves.left.p1);
  const auto add = [&](glm::vec3 in, glm::vec3 at, glm::vec3 out) {
    world::append_knot(d, test::skew_knot(at, at - in, glm::distance(in, at), glm::distance(at, out)));
  };
  add(halves.left.p2, halves.left.p3, halves.right.p1);
  add(halves.right.p2, halves.right.p3, halves.right.p3 + glm::vec3(1, 1, 0));
  const RiddenTrain ride(std::move(d), 23);
  EXPECT_LT(ride.found.at(2).total, 0.02);
  EXPECT_GT(ride.found.at(1).total, 0.2);  // the straight meets the bend
}

TEST(jolt, every_car_passes_every_joint_of_a_lap_once_and_the_worst_one_counts) {
  const RiddenTrain ride(test::ring_document(12, 40.3, 7.7), 17.3, 3, 2, 0.4);
  ASSERT_TRUE(ride.simulated->lap);
  std::vector<int> passed(12, 0);
  std::vector<Jolt> worst(12);
  std::size_t entry = 0;
  for (const JointPassage& passage : ride.simulated->passages) {
    ++passed.at(passage.knot);
    EXPECT_GE(passage.entry, entry);
    entry = passage.entry;
    const double distance = ride.simulated->distance(entry * kForceEvery, passage.car),
                 joint = ride.derived.starts.at(passage.knot);
    EXPECT_LE(within_lap(distance - joint, ride.derived.length, true), passage.speed / 60 + 0.02);
    EXPECT_NEAR(passage.speed, ride.simulated->samples[entry * kForceEvery].speed, 0.2);
    if (const Jolt one = jolt_of(passage, kCutoff); one.total > worst.at(passage.knot).total)
      worst.at(passage.knot) = one;
  }
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(passed[i], 3) << i;
    EXPECT_EQ(ride.found[i].total, worst[i].total) << i;
    EXPECT_EQ(ride.found[i].car, worst[i].car) << i;
    EXPECT_GT(ride.found[i].total, 0) << i;
  }
}

// The ends of an open track join nothing, and a ride backwards is jolted like one forwards where impulse and step are
// on different axes.
TEST(jolt, a_ride_backwards_has_the_same_jolts) {
  const double speed = 20;
  const world::Document d = fitted(turn_of(M_PI / 2), -30, 15, 0.75);
  const RiddenTrain on(d, speed), back(d, -speed, 1, d.track.segments.size() - 1, 0.9);
  EXPECT_EQ(on.found.front().total, 0);
  EXPECT_EQ(on.found.size(), on.document.track.knots.size() - 1) << "the list ends with the last knot passed";
  EXPECT_NEAR(back.found.at(40).speed, -speed, 1e-3);
  EXPECT_NEAR(back.found.at(40).forward, on.found.at(40).forward, 1e-3);
  EXPECT_NEAR(back.found.at(40).up, on.found.at(40).up, 1e-3);
}

}  // namespace jolt_test
}  // namespace coaster::sim
