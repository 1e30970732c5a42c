// The supports of very long tracks: found near the eye alone, the same there as those of the whole track.
#include "sim/solids/supports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/tries.h"
#include "sim/solids.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace supports_near_test {

constexpr std::size_t kSegments = 2'000;

class NearSupports : public testing::Test {
 protected:
  void SetUp() override { derive(document_, {}, {}, derived_); }
  glm::vec3 beside(std::size_t knot) const {
    return world::knot(document_, document_.track.knots[knot]).position + glm::vec3(3, 2, -1);
  }
  // Looks from there, and compares near supports with those of the whole track, which another object finds.
  void look(glm::vec3 eye) {
    near_.look_from({eye, 300});
    near_.update(derived_);
    ASSERT_FALSE(near_.everywhere());
    supports_.update(derived_, near_);
    Supports whole;
    whole.update(derived_);
    int count = 0;
    for (const std::size_t i : near_.indices()) {
      const world::Entity segment = derived_.order[i];
      ASSERT_TRUE(supports_.of(segment) != nullptr && whole.of(segment) != nullptr);
      EXPECT_EQ(supports_.of(segment)->bars, whole.of(segment)->bars) << i;
      count += static_cast<int>(whole.of(segment)->holds.size());
    }
    EXPECT_EQ(supports_.count(), count);
  }

  world::Document document_ = test::ring_document(kSegments, 3'000);  // 18.8 km
  DerivedTrack derived_;
  NearSegments near_;
  Supports supports_;
};

TEST_F(NearSupports, are_those_of_the_whole_track_wherever_the_eye_goes) {
  look(beside(0));
  EXPECT_GT(supports_.count(), 20);
  const int first = supports_.rebuilds();
  EXPECT_LE(first, static_cast<int>(near_.indices().size())) << "none is found far away";
  look(beside(0));
  EXPECT_EQ(supports_.rebuilds(), 0);
  look(beside(10));
  EXPECT_GT(supports_.rebuilds(), 0);
  EXPECT_LT(supports_.rebuilds(), first) << "some were near before";
  look(beside(kSegments / 2));
  EXPECT_LT(supports_.order().size(), kSegments / 8) << "nothing is held for far track";
  look(beside(0));
  EXPECT_EQ(supports_.rebuilds(), first);
  look({0, 500, 0});
  EXPECT_EQ(supports_.count(), 0);
  EXPECT_TRUE(supports_.order().empty());
}

TEST_F(NearSupports, follow_track_that_moves_near_and_far) {
  look(beside(0));
  for (const std::size_t knot : {std::size_t{3}, kSegments / 2}) {
    document_.entities.get<world::Knot>(document_.track.knots[knot]).position.y += 6;
    derive(document_, {}, {}, derived_);
    look(beside(0));
    EXPECT_EQ(supports_.rebuilds() > 0, knot == 3) << "far away nothing is found";
  }
  look(beside(kSegments / 2));
  EXPECT_GT(supports_.rebuilds(), 0);
}

// Track comes below segments at the border of what is near, while some of them are not near but close to it.
TEST_F(NearSupports, are_found_again_where_track_came_while_nobody_was_near) {
  for (std::size_t k = 24; k < 37; ++k) {
    if (!test::tried(static_cast<int>(k))) continue;
    look(beside(0));
    look(beside(kSegments - 4));
    glm::vec3& moved = document_.entities.get<world::Knot>(document_.track.knots[k + 2]).position;
    const glm::vec3 before = moved, above = world::knot(document_, document_.track.knots[k]).position;
    moved = above + glm::vec3(1, -0.6f * above.y, 1);
    derive(document_, {}, {}, derived_);
    look(beside(kSegments - 4));
    look(beside(0));
    moved = before;
    derive(document_, {}, {}, derived_);
  }
}

// Track from a quarter of the ring away comes beside segments that have just gone out of near: it is outside of what is
// watched for near ones, and still when the eye returns.
TEST_F(NearSupports, are_found_again_where_far_track_came_beside_what_is_no_longer_near) {
  const std::vector<world::Entity>& knots = document_.track.knots;
  glm::vec3& moved = document_.entities.get<world::Knot>(knots[kSegments / 4]).position;
  const glm::vec3 before = moved;
  for (std::size_t k = 30; k < 33; ++k)
    for (const float along : {0.0f, 0.5f}) {
      if (test::kSanitized && (k > 30 || along > 0)) continue;
      look(beside(0));
      look(beside(kSegments - 3));
      const glm::vec3 here = world::knot(document_, knots[k]).position,
                      next = world::knot(document_, knots[k + 1]).position;
      moved = glm::mix(here, next, along);
      moved.y *= 0.4f;
      derive(document_, {}, {}, derived_);
      look(beside(kSegments - 3));
      look(beside(0));
      moved = before;
      derive(document_, {}, {}, derived_);
    }
}

// A track of 20 km that crosses itself everywhere, with an eye that jumps and knots that move in its sight and out of
// it.
TEST_F(NearSupports, follow_from_the_track_alone_whatever_moved_before) {
  std::mt19937 bits(20);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  document_ = {};
  double heading = 0.3;
  glm::dvec3 at(3.1, 8, -2.7);
  for (std::size_t i = 0; i <= kSegments; ++i) {
    const glm::dvec3 way(std::cos(heading), uniform(-0.3, 0.3), -std::sin(heading));
    at += uniform(8, 13) * way;
    at.y = std::clamp(at.y, 2.0, 25.0);
    for (const int k : {0, 2})
      if (std::abs(at[k]) > 900) heading += 2.1;  // back
    heading += uniform(-0.5, 0.5);
    const auto handle = static_cast<float>(uniform(3, 4));
    world::append_knot(document_, test::skew_knot(glm::vec3(at), glm::vec3(way), handle, handle));
  }
  derived_ = {};
  derive(document_, {}, {}, derived_);
  ASSERT_GT(derived_.length, kMaxNearLength);
  const std::vector<world::Entity>& knots = document_.track.knots;
  std::size_t eye = 1000;
  // Each count of moves with and without a new eye; with the sanitizers the first three.
  for (int step = 0; step < test::tries(12); ++step) {
    if (step % 3 == 0) eye = step % 2 == 0 ? bits() % knots.size() : std::min(eye + 2, knots.size() - 1);
    for (int moves = step % 4; moves > 0; --moves) {
      glm::vec3& place = document_.entities.get<world::Knot>(knots[bits() % knots.size()]).position;
      place = beside(moves == 1 ? eye : bits() % knots.size()) + glm::vec3(uniform(-40, 40), 4, uniform(-40, 40));
    }
    world::settle_joints(document_);
    derive(document_, {}, {}, derived_);
    near_.look_from({beside(eye), 40});
    near_.update(derived_);
    ASSERT_FALSE(near_.everywhere());
    supports_.update(derived_, near_);
    Supports anew;
    anew.update(derived_, near_);
    for (const std::size_t i : near_.indices())
      ASSERT_EQ(supports_.of(derived_.order[i])->bars, anew.of(derived_.order[i])->bars) << step << " " << i;
  }
}

TEST_F(NearSupports, stand_near_the_eye_on_a_track_of_any_length) {
  document_ = test::ring_document(kSegments, 60'000);  // 377 km
  derive(document_, {}, {}, derived_);
  near_.look_from({beside(700), 300});
  near_.update(derived_);
  supports_.update(derived_, near_);
  EXPECT_GT(supports_.count(), 30) << "on 600 m";
  EXPECT_LT(supports_.count(), 150);
}

TEST_F(NearSupports, are_all_found_when_the_track_becomes_short_enough) {
  look(beside(0));
  document_ = test::ring_document(200, 300);
  derived_ = {};
  derive(document_, {}, {}, derived_);
  near_.update(derived_);
  ASSERT_TRUE(near_.everywhere());
  supports_.update(derived_, near_);
  Supports whole;
  whole.update(derived_);
  EXPECT_EQ(supports_.count(), whole.count());
  EXPECT_GT(whole.count(), 100);
}

}  // namespace supports_near_test
}  // namespace coaster::sim
