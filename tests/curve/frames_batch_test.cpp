// Chains side by side have the bits of chains alone, on every processor path, also where single chains need
// transport()'s branches.
#include "curve/frames_batch.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "curve/random_cubics.h"

namespace coaster::curve {
namespace frames_batch_test {

struct Chains {
  int count;
  std::vector<glm::dvec3> points, tangents, ups;
};

Chains along(const std::vector<Cubic>& cubics, int count) {
  Chains all{count, {}, {}, {}};
  for (const Cubic& c : cubics)
    for (int i = 0; i < count; ++i) {
      const double t = count == 1 ? 0 : static_cast<double>(i) / (count - 1);
      all.points.push_back(point(c, t));
      all.tangents.push_back(unit_tangent(c, t));
      all.ups.push_back(i == 0 ? perpendicular(all.tangents.back(), {0.3, 0.8, -0.1}) : glm::dvec3(-7));
    }
  return all;
}

std::vector<glm::dvec3> one_by_one(const Chains& chains) {
  std::vector<glm::dvec3> ups = chains.ups;
  for (std::size_t i = 0; i < ups.size(); ++i)
    if (i % static_cast<std::size_t>(chains.count) != 0)
      ups[i] =
          transport({chains.tangents[i - 1], ups[i - 1]}, chains.points[i - 1], chains.points[i], chains.tangents[i])
              .up;
  return ups;
}

void expect_the_same_bits(const Chains& chains) {
  const auto expected = one_by_one(chains);
  for (const Processor on : available_processors()) {
    auto ups = chains.ups;
    transport_chains(chains.count, chains.points, chains.tangents, ups, on);
    for (std::size_t i = 0; i < ups.size(); ++i)
      for (int a = 0; a < 3; ++a)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(ups[i][a]), std::bit_cast<std::uint64_t>(expected[i][a]))
            << "place " << i << " axis " << a;
  }
}

TEST(frames_batch, chains_side_by_side_have_the_bits_of_chains_alone) {
  for (const int segments : {0, 1, 7, 8, 9, 16, 83})
    for (const int count : {1, 2, 33}) expect_the_same_bits(along(random_cubics(segments, 51), count));
}

TEST(frames_batch, cusps_straights_and_coincident_points_among_the_chains_change_no_bit) {
  auto cubics = random_cubics(3, 52);
  for (const Cubic& c : degenerate_cubics()) {
    cubics.push_back(c);
    cubics.push_back(random_cubics(1, static_cast<unsigned>(cubics.size()))[0]);
  }
  expect_the_same_bits(along(cubics, 33));
}

TEST(frames_batch, an_up_that_turns_parallel_changes_no_bit) {
  Chains chains = along(random_cubics(8, 53), 5);
  chains.ups[5] = chains.tangents[5];
  expect_the_same_bits(chains);
}

TEST(frames_batch, frames_stay_unit_and_perpendicular) {
  const Chains chains = along(random_cubics(64, 54), 33);
  auto ups = chains.ups;
  transport_chains(chains.count, chains.points, chains.tangents, ups);
  for (std::size_t i = 0; i < ups.size(); ++i) {
    EXPECT_NEAR(glm::length(ups[i]), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(ups[i], chains.tangents[i]), 0.0, 1e-12);
  }
}

}  // namespace frames_batch_test
}  // namespace coaster::curve
