// Joints: settling and automatic shapes.
#include <gtest/gtest.h>

#include "world/sample_documents.h"

namespace coaster::world {
namespace joints_test {

Knot& at(Document& d, std::size_t i) { return d.entities.get<Knot>(d.track.knots[i]); }

TEST(joints, an_automatic_knot_runs_along_the_chord_of_its_neighbours) {
  Document d = test::sample_document();
  const Knot &before = at(d, 2), &k = at(d, 3), &after = at(d, 4);
  EXPECT_NEAR(glm::dot(k.tangent, glm::normalize(after.position - before.position)), 1.0f, 1e-6f);
  EXPECT_NEAR(k.in_length, glm::distance(before.position, k.position) / 3, 1e-5);
  EXPECT_NEAR(k.out_length, glm::distance(after.position, k.position) / 3, 1e-5);
}

TEST(joints, an_automatic_knot_follows_its_neighbour) {
  Document d = test::sample_document();
  at(d, 4).position += glm::vec3(3.1f, -7.7f, 20.9f);
  const Knot before = at(d, 3);
  settle_joints(d);
  EXPECT_NE(at(d, 3), before);
  EXPECT_NEAR(glm::dot(at(d, 3).tangent, glm::normalize(at(d, 4).position - at(d, 2).position)), 1.0f, 1e-6f);
}

TEST(joints, automatic_ends_run_to_their_only_neighbour_and_wrap_when_closed) {
  Document d = test::sample_document();
  at(d, 0).joint = JointKind::automatic;
  settle_joints(d);
  EXPECT_NEAR(glm::dot(at(d, 0).tangent, glm::normalize(at(d, 1).position - at(d, 0).position)), 1.0f, 1e-6f);
  set_closed(d, true);
  settle_joints(d);
  EXPECT_NEAR(glm::dot(at(d, 0).tangent, glm::normalize(at(d, 1).position - at(d, 4).position)), 1.0f, 1e-6f);
}

TEST(joints, smooth_lengths_are_equal_and_the_outgoing_one_wins) {
  Document d = test::sample_document();
  at(d, 0).out_length = 3.3f;
  settle_joints(d);
  EXPECT_EQ(at(d, 0).in_length, 3.3f);
}

TEST(joints, settling_twice_changes_nothing) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Document d = test::random_document(seed);
    settle_joints(d);
    const Document once = d;
    settle_joints(d);
    ASSERT_TRUE(d == once) << seed;
  }
}

TEST(joints, coincident_neighbours_keep_the_direction) {
  Document d = test::sample_document();
  at(d, 2).position = at(d, 4).position = at(d, 3).position;
  const glm::vec3 tangent = at(d, 3).tangent;
  settle_joints(d);
  EXPECT_EQ(at(d, 3).tangent, tangent);
  EXPECT_EQ(at(d, 3).in_length, kMinHandle);
  EXPECT_FALSE(broken_invariant(d));
}

}  // namespace joints_test
}  // namespace coaster::world
