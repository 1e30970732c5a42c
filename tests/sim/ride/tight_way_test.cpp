// Rides through bends far sharper than a tick, compared with a ride in fine steps: the heading of a plane cubic in
// closed form, the path of a rider above it, and the low-pass as a differential equation. None of it shares code with
// the ride.
#include "sim/ride/simulated_ride_detail.h"

#include <gtest/gtest.h>

#include <random>

#include "curve/tight_places.h"
#include "sim/study/jolt.h"
#include "sim/study/ratings.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace tight_way_test {

constexpr double kG = world::kGravity, kCutoff = 5;
using glm::dvec3;

// A plane cubic that is `width` m wide and turns back in its middle with a given radius, about the axis of its plane.
// Riders lean by `roll` about the tangent against the plane's axis.
struct Bend {
  dvec3 along{1, 0, 0}, aside{0, 0, 1};  // of the plane
  double width = 20, radius = 1, roll = 0, heart = 1.1;
  bool loops = false;  // its ends cross: it turns by more than half a turn
  dvec3 axis() const { return glm::cross(aside, along); }
  // With handles (a, b) and (-a, b) from the ends the middle has B' = 1.5 (width - a), B'' = -6 b.
  double a() const { return width + (loops ? 1 : -1) * std::sqrt(6 * width * radius / 2.25); }
  dvec3 derivative(double t) const {
    const double x = 3 * ((1 - t) * (1 - t) * a() + 2 * t * (1 - t) * (width - 2 * a()) + t * t * a()),
                 y = 3 * width * ((1 - t) * (1 - t) - t * t);
    return x * along + y * aside;
  }
  dvec3 second(double t) const {
    return 6 * ((1 - t) * (width - 3 * a()) - t * (width - 3 * a())) * along - 6 * width * aside;
  }
  dvec3 third() const { return -12 * (width - 3 * a()) * along; }
};

world::Document document_of(const Bend& bend, double speed) {
  world::Document d;
  const dvec3 start(0, 50, 0);
  const auto add = [&](dvec3 place, dvec3 tangent, double out) {
    world::Knot knot =
        test::skew_knot(glm::vec3(place), glm::vec3(tangent), static_cast<float>(out), static_cast<float>(out));
    const dvec3 forward = glm::normalize(tangent), left = glm::cross(bend.axis(), forward);
    knot.up = glm::vec3(std::cos(bend.roll) * bend.axis() + std::sin(bend.roll) * left);
    world::append_knot(d, knot);
  };
  const dvec3 handle = bend.a() * bend.along + bend.width * bend.aside;
  add(start, handle, glm::length(handle));
  add(start + bend.width * bend.along, bend.a() * bend.along - bend.width * bend.aside, glm::length(handle));
  d.heartline = static_cast<float>(bend.heart);
  d.start_speed = speed;
  return d;
}

// The low-pass of four poles: two oscillators y'' = w^2 (x - y) - w/q y'.
class Filter {
 public:
  explicit Filter(dvec3 start) : y_{start, start} {}
  dvec3 next(dvec3 x, double dt) {
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
  dvec3 y_[2], rate_[2]{dvec3(0), dvec3(0)};
};

struct Most {
  dvec3 most{-1e300}, least{1e300};  // g, filtered: forwards, left, up
};

// Rides one car from `front` m on the segment. The speed follows from the energy.
Most fine_ride(const Bend& bend, double front, double speed) {
  constexpr int kSteps = 400'000;
  constexpr double kBin = 1e-4;  // s
  const auto speed_at = [&](double height) { return std::sqrt(speed * speed - 2 * kG * height); };
  std::vector<dvec3> bins;
  double s = 0, time = 0, height = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps;
    const dvec3 r1 = bend.derivative(t), r2 = bend.second(t), forward = glm::normalize(r1);
    const double ds = glm::length(r1) / kSteps;
    s += ds;
    if (s < front) continue;
    const double v = speed_at(height), dt = ds / v;
    height += r1.y / kSteps;
    const dvec3 side = glm::cross(bend.axis(), forward);
    const dvec3 up = std::cos(bend.roll) * bend.axis() + std::sin(bend.roll) * side, left = glm::cross(up, forward);
    // The rider is on r + h up, with up' = -k_up forward: of the plane's curvature k, sin(roll) k is towards up.
    const double q = glm::length(r1), k = glm::dot(glm::cross(r1, r2), bend.axis()) / (q * q * q);
    const double k_slope =
        (glm::dot(glm::cross(r1, bend.third()), bend.axis()) / (q * q * q) - 3 * k * glm::dot(r1, r2) / (q * q)) / q;
    const double to_up = k * glm::dot(side, up), to_left = k * glm::dot(side, left), h = bend.heart;
    const double slowing = -kG * forward.y;
    const dvec3 felt = dvec3(slowing * (1 - h * to_up) - v * v * h * k_slope * glm::dot(side, up),
                             v * v * (to_left - h * to_left * to_up), v * v * (to_up - h * to_up * to_up)) /
                           kG +
                       dvec3(forward.y, left.y, up.y);
    const auto bin = static_cast<std::size_t>(time / kBin);
    if (bins.size() <= bin) bins.resize(bin + 1, dvec3(0));
    // Split at the border of two bins, so that what a step spans counts for both.
    const double first = std::min(dt, static_cast<double>(bin + 1) * kBin - time);
    bins[bin] += first / kBin * felt;
    if (dt > first) bins.push_back((dt - first) / kBin * felt);
    time += dt;
  }
  bins.pop_back();  // not whole
  Most most;
  Filter filter(bins.front());
  for (const dvec3& felt : bins) {
    const dvec3 here = filter.next(felt, kBin);
    most.most = glm::max(most.most, here), most.least = glm::min(most.least, here);
  }
  return most;
}

struct RiddenTrain {
  Ratings ratings;
  SimulatedRide simulated;
};
RiddenTrain ride(world::Document d, double front, int cars, float spacing = 1) {
  world::add_cart(d, d.track.segments[0], 0);
  const world::Entity cart = world::first_cart(d);
  const DerivedTrack derived = test::derived_of(d);
  world::Train& design = d.entities.get<world::Train>(cart);
  design.fraction = front / derived.length, design.cars = cars, design.spacing = spacing;
  RideCache cache;
  const SimulatedRide& simulated = *cache.ride(d, derived, cart);
  return {rate(simulated, cache.tables(d, derived), kCutoff), simulated};
}

// Within 2 %, or 0.4 % of what half a turn is felt as: what is left where parts of a bend cancel each other.
void expect_near(double found, double right, double speed, const char* what) {
  const double half_turn = 2.40 * kCutoff * M_PI * speed / kG;
  EXPECT_NEAR(found, right, std::max(0.02 * std::abs(right), 0.004 * half_turn)) << what;
}

TEST(TightBendMotion, FeelsLevelAndBankedBends) {
  std::mt19937 random(20);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < 24; ++i) {
    Bend bend;
    bend.radius = 2e-4 * std::pow(5000, draw(0, 1)), bend.loops = i % 2 == 0;
    bend.roll = i % 3 == 0 ? draw(-0.6, 0.6) : 0;
    if (bend.roll != 0) bend.heart = i % 2 == 0 ? 0 : 0.2;
    const double speed = 2 * std::pow(15, draw(0, 1)), front = draw(8, 9);
    SCOPED_TRACE(testing::Message() << "radius " << bend.radius << ", speed " << speed << ", roll " << bend.roll
                                    << ", front " << front);
    const Most right = fine_ride(bend, front, speed);
    const int cars = i % 4 == 0 ? 8 : 1;
    const Ratings r = ride(document_of(bend, speed), front, cars).ratings;
    expect_near(r.side_most.value, std::max(right.most.y, -right.least.y), speed, "side");
    if (cars > 1) continue;
    expect_near(r.up_most.value, right.most.z, speed, "most up"),
        expect_near(r.up_least.value, right.least.z, speed, "least up");
    expect_near(r.forward_most.value, right.most.x, speed, "forward");
  }
}

TEST(TightBendMotion, FeelsCrestsAndValleys) {
  std::mt19937 random(21);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < 20; ++i) {
    Bend bend{.aside = {0, i % 2 == 0 ? 1 : -1, 0}, .width = 8};
    bend.radius = 2e-4 * std::pow(2000, draw(0, 1)), bend.loops = i % 3 == 0;
    bend.roll = i % 2 == 0 ? -M_PI / 2 : M_PI / 2, bend.heart = i % 4 < 2 ? 0 : 0.3;
    const double speed = draw(14, 30), front = draw(0.5, 1);
    SCOPED_TRACE(testing::Message() << i << ": radius " << bend.radius << ", speed " << speed << ", front " << front);
    const Most right = fine_ride(bend, front, speed);
    const Ratings r = ride(document_of(bend, speed), front, 1).ratings;
    expect_near(r.up_most.value, right.most.z, speed, "most up"),
        expect_near(r.up_least.value, right.least.z, speed, "least up");
    EXPECT_LT(r.side_most.value, 0.02);
    EXPECT_GT(std::max(right.most.z, -right.least.z), 5);  // the bend counts
  }
}

// A straight that doubles back twice within its only segment, in any direction and size.
world::Document reversing(double speed, glm::vec3 direction, float size) {
  world::Document d;
  direction = glm::normalize(direction);
  world::append_knot(d, test::skew_knot({13.7f, 21.3f, -7.9f}, direction, size / 2, size / 2));
  world::append_knot(
      d, test::skew_knot(glm::vec3{13.7f, 21.3f, -7.9f} + size * direction, direction, 1.5f * size, size / 2));
  d.start_speed = speed;
  return d;
}

TEST(TightBendMotion, FeelsReversalsWhereverTheSamplesFall) {
  std::mt19937 random(22);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < 60; ++i) {
    const double speed = draw(2, 30), right = 2.40 * kCutoff * 2 * speed / kG;
    const glm::vec3 level(draw(-1, 1), 0, draw(-1, 1));
    const world::Document d =
        reversing(speed, i == 0 ? glm::vec3(1, 0, 0) : level, static_cast<float>(draw(20, 25) * speed));
    ASSERT_EQ(curve::tight_places(test::derived_of(d).shape_at(0).key.cubic, 0.5).size(), 2u) << i;
    const Ratings r = ride(d, 0.001 * i, i % 5 == 0 ? 8 : 1).ratings;
    EXPECT_NEAR(r.forward_most.value, right, 0.02 * right) << speed;
    EXPECT_NEAR(r.jolt_most.value, right, 0.02 * right) << speed;
    EXPECT_LT(r.side_most.value, 0.02 * right);  // control points are rounded: the turn is not quite half a one
  }
}

// Felt in the axes of the track between them, one pushes forwards and the next backwards.
TEST(TightBendMotion, FeelsReversalsThatFollowSoonToAndFro) {
  for (const double speed : {5.0, 10.0, 20.0}) {
    const double size = 20, apart = size * (5.0 / 32 - 1.0 / 8) / speed;  // s: B(1/4) and B(1/2) are at these shares
    constexpr double kBin = 1e-5;
    Filter filter{dvec3(0)};
    double right = 0, back = 0;
    for (int i = 0; i < 100'000; ++i) {
      const int push = i == 1000 ? 1 : i == 1000 + static_cast<int>(apart / kBin) ? -1 : 0;
      const double felt = filter.next(dvec3(push * 2 * speed / kG / kBin, 0, 0), kBin).x;
      right = std::max(right, felt), back = std::min(back, felt);
    }
    const Ratings r = ride(reversing(speed, {0.3f, 0, 1}, static_cast<float>(size)), 0.01, 1).ratings;
    EXPECT_NEAR(r.forward_most.value, right, 0.02 * right) << speed;
    EXPECT_NEAR(r.back_most.value, -back, 0.02 * right) << speed;
    EXPECT_NEAR(r.jolt_most.value, 2.40 * kCutoff * 2 * speed / kG, 0.02 * right) << speed;
  }
}

TEST(TightBendMotion, DependsLittleOnWhereTheSamplesFall) {
  for (const double radius : {2e-4, 0.019, 0.1, 0.43, 1.0, 1.9})
    for (const double speed : {3.0, 10.0, 28.0}) {
      const Bend bend{.radius = radius};
      double least = 1e300, most = 0, least_jolt = 1e300, most_jolt = 0;
      for (int i = 0; i < 60; ++i) {
        const Ratings r = ride(document_of(bend, speed), 8 + 0.01 * speed / 60 * i, 1).ratings;
        least = std::min(least, r.side_most.value), most = std::max(most, r.side_most.value);
        least_jolt = std::min(least_jolt, r.jolt_most.value), most_jolt = std::max(most_jolt, r.jolt_most.value);
      }
      EXPECT_LT(most, 1.02 * least) << radius << " " << speed;
      EXPECT_LT(most_jolt, 1.02 * least_jolt + 0.01) << radius << " " << speed;
    }
}

// Without losses on the level the sharpest place is passed at its distance over the speed.
TEST(TightBendMotion, IsPassedWhenTheTrainIsThere) {
  for (const double speed : {3.0, 10.0, 28.0})
    for (const double start : {2.0, 8.0, 15.0}) {
      const world::Document document = document_of({.radius = 0.1}, speed);
      const RiddenTrain found = ride(document, start, 1);
      const auto bend = std::ranges::find_if(found.simulated.bends, [](const BendPassage& b) {
        return b.peak.impulse.left != 0 || b.peak.impulse.up != 0;
      });
      ASSERT_NE(bend, found.simulated.bends.end());
      const double way = 0.5 * world::exact_length(document) - start;  // the bend is in the middle of the track
      EXPECT_NEAR(bend->peak.time, way / speed, 0.2 / speed) << speed << " from " << start;
    }
}

world::Document closed_of(const std::vector<curve::Cubic>& cubics, double speed) {
  world::Document d;
  d.start_speed = speed;
  for (std::size_t i = 0; i < cubics.size(); ++i) {
    const curve::Cubic &before = cubics[(i + cubics.size() - 1) % cubics.size()], &c = cubics[i];
    world::Knot knot;
    knot.position = c.p0, knot.tangent = glm::normalize(c.p1 - c.p0), knot.up = {0, 1, 0};
    knot.in_length = glm::distance(before.p2, before.p3), knot.out_length = glm::distance(c.p0, c.p1);
    knot.joint = world::JointKind::aligned;
    world::append_knot(d, knot);
  }
  world::set_closed(d, true);
  return d;
}

// A level drop of two long segments with its sharp end where one leads to the other, and of the same curve in sixteen.
TEST(TightBendMotion, IsTheSameHoweverAClosedTrackIsDivided) {
  for (const float near : {0.1f, 0.3f})
    for (const double speed : {3.0, 8.0}) {
      std::vector<curve::Cubic> cubics{{{0, 5, 0}, {0, 5, -3}, {2, 5, -near}, {2, 5, 0}},
                                       {{2, 5, 0}, {2, 5, near}, {0, 5, 3}, {0, 5, 0}}};
      const Ratings whole = ride(closed_of(cubics, speed), 0.3, 1).ratings;
      for (int halving = 0; halving < 3; ++halving) {
        std::vector<curve::Cubic> halves;
        for (const curve::Cubic& c : cubics) {
          const curve::SplitCubic two = curve::split(c, 0.5);
          halves.push_back(two.left), halves.push_back(two.right);
        }
        cubics = halves;
      }
      const Ratings parts = ride(closed_of(cubics, speed), 0.3, 1).ratings;
      SCOPED_TRACE(testing::Message() << "handles of " << near << " m, " << speed << " m/s");
      EXPECT_NEAR(parts.side_most.value, whole.side_most.value, 0.03 * whole.side_most.value);
      EXPECT_NEAR(parts.forward_most.value, whole.forward_most.value, 0.03 * whole.side_most.value);
      EXPECT_NEAR(parts.back_most.value, whole.back_most.value, 0.03 * whole.side_most.value);
      EXPECT_GT(whole.side_most.value, 0.5);
    }
}

TEST(TightBendMotion, EndsWhereTheTableIsFineEnough) {
  const double radius = 1.01 * kTightRadius;
  for (const double speed : {2.0, 10.0, 30.0}) {
    const Bend bend{.radius = radius};
    const RiddenTrain found = ride(document_of(bend, speed), 8, 1);
    EXPECT_TRUE(found.simulated.bends.empty());
    const Most right = fine_ride(bend, 8, speed);
    expect_near(found.ratings.side_most.value, std::max(right.most.y, -right.least.y), speed, "side");
  }
}

}  // namespace tight_way_test
}  // namespace coaster::sim
