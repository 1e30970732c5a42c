// Poses of very many cars for a picture.
#include "sim/ride/ride.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/tracks.h"

namespace coaster::sim {
namespace shown_cars_test {

constexpr std::size_t kExact = 200;

// 300 trains of 4 cars anywhere on a circuit, at rest.
struct Crowd {
  world::Document document = test::sample_document();
  DerivedTrack derived;
  world::Motion motion;
  Crowd() {
    std::mt19937 bits(9);
    for (int i = 0; i < 300; ++i) {
      const std::size_t segment = bits() % document.track.segments.size();
      const auto fraction = static_cast<float>(bits() / 4294967296.0);
      const world::Entity train = world::add_cart(document, document.track.segments[segment], fraction);
      world::Train& design = document.entities.get<world::Train>(train);
      design.cars = 4, design.length = 1.5f + static_cast<float>(i % 3);
    }
    derived = test::derived_of(document);
    reset(document, derived, motion);
  }
  std::vector<Pose> exact(world::FrameMethod method) const {
    std::vector<Pose> all;
    for (std::size_t i = 0; i < motion.carts.size(); ++i)
      for (const Pose& car : car_poses(document, derived, motion.carts.entities()[i], motion.carts.items()[i], method))
        all.push_back(car);
    return all;
  }
  double bend() const {  // m, the largest |B''|
    double most = 0;
    for (const world::Entity segment : derived.order)
      for (const double t : {0.0, 1.0})
        most = std::max(most, glm::length(curve::second_derivative(derived.shape(segment).key.cubic, t)));
    return most;
  }
};

TEST(shown_cars, the_nearest_are_exact_and_the_others_nearly) {
  const Crowd crowd;
  const std::vector<Pose> exact = crowd.exact(world::FrameMethod::knots);
  const glm::dvec3 eye = exact[7].position + glm::dvec3(0, 9, 0);
  const std::vector<Pose> shown =
      shown_cars(crowd.document, crowd.derived, crowd.motion, world::FrameMethod::knots, eye, kExact);
  ASSERT_EQ(shown.size(), exact.size());
  ASSERT_GT(shown.size(), 4 * kExact);
  const double off = crowd.bend() / 8192;
  std::vector<double> away;
  for (const Pose& car : exact) away.push_back(glm::distance(car.position, eye));
  std::vector<double> sorted = away;
  std::sort(sorted.begin(), sorted.end());
  std::size_t others = 0, different = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i].leads, exact[i].leads) << i;
    EXPECT_EQ(shown[i].length, exact[i].length) << i;
    EXPECT_LT(glm::distance(shown[i].position, exact[i].position), off + 1e-9) << i;
    EXPECT_LT(glm::distance(shown[i].frame.forward, exact[i].frame.forward), 0.01) << i;
    EXPECT_LT(glm::distance(shown[i].frame.up, exact[i].frame.up), 0.1) << i;
    EXPECT_NEAR(glm::dot(shown[i].frame.up, shown[i].frame.forward), 0, 1e-9) << i;
    const bool bitwise = shown[i].position == exact[i].position && shown[i].frame.up == exact[i].frame.up;
    if (away[i] < sorted[kExact - 1] - 2 * off) {
      EXPECT_TRUE(bitwise) << i;
    } else if (away[i] > sorted[kExact - 1] + 2 * off) {
      ++others, different += bitwise ? 0 : 1;
    }
  }
  EXPECT_GT(others, 4 * kExact);
  EXPECT_GT(4 * different, 3 * others) << "on an even straight both ways have the same bits";
}

TEST(shown_cars, few_cars_and_other_frames_are_exact) {
  const Crowd crowd;
  for (const world::FrameMethod method : {world::FrameMethod::knots, world::FrameMethod::world_up}) {
    const std::size_t limit = method == world::FrameMethod::knots ? 100'000 : kExact;
    const std::vector<Pose> exact = crowd.exact(method),
                            shown = shown_cars(crowd.document, crowd.derived, crowd.motion, method, {}, limit);
    ASSERT_EQ(shown.size(), exact.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
      EXPECT_EQ(shown[i].position, exact[i].position) << i;
      EXPECT_EQ(shown[i].frame.up, exact[i].frame.up) << i;
      EXPECT_EQ(shown[i].defined, exact[i].defined) << i;
      EXPECT_EQ(shown[i].leads, exact[i].leads) << i;
    }
  }
  EXPECT_TRUE(shown_cars({}, {}, {}, world::FrameMethod::knots, {}, kExact).empty());
}

}  // namespace shown_cars_test
}  // namespace coaster::sim
