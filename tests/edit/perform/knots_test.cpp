#include <limits>

#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace perform_knots_test {

using world::JointKind;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

class ShapingKnots : public test::SessionTest {};

TEST_F(ShapingKnots, move_puts_the_knot_there_and_keeps_its_shape) {
  world::Knot expected = knot(2);
  expected.position = {130.1f, 20.2f, -35.3f};
  good("move @k2 to 130.1 20.2 -35.3");
  EXPECT_EQ(knot(2), expected);
}

TEST_F(ShapingKnots, move_beyond_the_limit_is_clamped_with_a_notice) {
  clamped("move @k2 to 250000 1 -3", "Reduced position.x from 250000 to the limit of 100000 m");
  EXPECT_EQ(knot(2).position, glm::vec3(100'000, 1, -3));
  clamped("move @k2 to 1 -3e9 -3", "limit of -100000 m");
}

TEST_F(ShapingKnots, a_handle_goes_where_it_was_dragged) {
  good("handle @k2.out to 137.3 22.9 -31.1");  // k2 is aligned: its other length stays
  EXPECT_NEAR(glm::distance(world::out_handle(knot(2)), glm::vec3(137.3f, 22.9f, -31.1f)), 0.0f, 3e-5f);
  EXPECT_EQ(knot(2).in_length, 6.3f);
  good("handle @k2.in to 125.3 17.1 -40.7");
  EXPECT_NEAR(glm::distance(world::in_handle(knot(2)), glm::vec3(125.3f, 17.1f, -40.7f)), 0.0f, 3e-5f);
}

TEST_F(ShapingKnots, a_smooth_joint_keeps_both_handles_equal) {
  good("handle @k1.in to 97.3 11.1 -43.7");
  EXPECT_EQ(knot(1).joint, JointKind::smooth);
  EXPECT_EQ(knot(1).in_length, knot(1).out_length);
  EXPECT_NEAR(glm::distance(world::in_handle(knot(1)), glm::vec3(97.3f, 11.1f, -43.7f)), 0.0f, 3e-5f);
}

TEST_F(ShapingKnots, shaping_an_automatic_joint_makes_it_aligned) {
  for (const char* line :
       {"handle @k4.out to 140.1 18.7 17.3", "direct @k4 to 1 0.2 0.3", "lengths @k4 in 3.3 out 4.4"}) {
    good("joint @k4 to automatic");
    good(line);
    EXPECT_EQ(knot(4).joint, JointKind::aligned) << line;
  }
}

TEST_F(ShapingKnots, a_handle_on_its_knot_keeps_the_direction_at_the_shortest_length) {
  const glm::vec3 tangent = knot(2).tangent;
  clamped("handle @k2.out to 131.3 19.7 -37.1", "Raised handle length from 0 to the limit of 0.01 m.");
  EXPECT_EQ(knot(2).tangent, tangent);
  EXPECT_EQ(knot(2).out_length, world::kMinHandle);
  clamped("handle @k2.out to 90000 19.7 -37.1", "limit of 10000 m");
  EXPECT_EQ(knot(2).out_length, world::kMaxHandle);
}

TEST_F(ShapingKnots, direct_turns_the_tangent_and_needs_a_length) {
  good("direct @k2 to 0 0 -7");
  EXPECT_EQ(knot(2).tangent, glm::vec3(0, 0, -1));
  refused("direct @k2 to 0 0 0", "expected a direction longer than 0");
}

TEST_F(ShapingKnots, different_lengths_make_a_smooth_joint_aligned) {
  good("lengths @k1 in 4.5 out 4.5");
  EXPECT_EQ(knot(1).joint, JointKind::smooth);
  good("lengths @k1 in 4.5 out 5.5");
  EXPECT_EQ(knot(1).joint, JointKind::aligned);
  clamped("lengths @k1 in 0 out 5", "limit of 0.01 m");
  clamped("lengths @k1 in 1e30 out 5", "limit of 10000 m");
}

TEST_F(ShapingKnots, roll_wraps) {
  good("roll @k2 to 33.25");
  const world::Knot once = knot(2);
  good("roll @k2 to 753.25");
  EXPECT_EQ(knot(2), once);
  EXPECT_NEAR(world::roll_deg(once), 33.25, 1e-4);
}

TEST_F(ShapingKnots, a_joint_made_smooth_takes_the_mean_length) {
  good("joint @k2 to smooth");  // 6.3 and 9.7
  EXPECT_FLOAT_EQ(knot(2).in_length, 8.0f);
  EXPECT_EQ(knot(2).in_length, knot(2).out_length);
}

TEST_F(ShapingKnots, turns_are_clamped) {
  good("turns @s1 to 2");
  EXPECT_EQ(world::segment(session.document, entity("s1")).turns, 2);
  clamped("turns @s1 to 99", "Reduced turns from 99 to the limit of 16.");
  clamped("turns @s1 to -99", "limit of -16");
}

TEST_F(ShapingKnots, numbers_that_are_not_finite_are_refused) {
  const Target k{{world::EntityKind::knot, 2}};
  for (const float bad : {kNan, kInf, -kInf}) {
    refused(MoveKnot{k, {1, bad, 3}}, "finite");
    refused(MoveHandle{{k.name, HandleEnd::in}, {bad, 2, 3}}, "finite");
    refused(SetDirection{k, {1, 2, bad}}, "finite");
    refused(SetHandleLengths{k, bad, 5}, "finite");
    refused(SetHandleLengths{k, 5, bad}, "finite");
    refused(SetRoll{k, bad}, "finite");
  }
}

TEST_F(ShapingKnots, names_that_are_not_there_are_refused) {
  for (const std::string name : {"@k9", "@s1", "@c1", "none"})
    for (const std::string rest :
         {"move # to 1 2 3", "direct # to 1 2 3", "lengths # in 1 out 2", "roll # to 3", "joint # to smooth"}) {
      std::string line = rest;
      refused(line.replace(line.find('#'), 1, name),
              name == "@k9" ? "there is no knot @k9" : "expected a knot, found " + name);
    }
  refused("handle @k9.in to 1 2 3", "there is no knot @k9");
  refused("turns @s9 to 1", "there is no segment @s9");
  refused("turns @k1 to 1", "expected a segment, found @k1");
}

}  // namespace perform_knots_test
}  // namespace coaster::edit
