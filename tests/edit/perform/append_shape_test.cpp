// The shape of appended knots: src/edit/perform/knot_runs.
#include "edit/perform/knot_runs.h"

#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"
#include "sim/solids/conflict_types.h"

namespace coaster::edit {
namespace append_shape_test {

class ClickingPoints : public test::SessionTest {
 protected:
  ClickingPoints() : SessionTest(world::Document{}) {}
  void expect_direction(std::uint32_t number, glm::vec3 from, glm::vec3 to) {
    EXPECT_NEAR(glm::dot(knot(number).tangent, glm::normalize(to - from)), 1.0f, 1e-6f) << number;
  }
  const glm::vec3 a_{1.1f, 2.2f, 3.3f}, b_{21.3f, 2.9f, 8.7f}, c_{33.7f, 5.1f, 29.9f}, d_{13.9f, 4.7f, 40.3f};
  void append(glm::vec3 p) {
    ASSERT_TRUE(apply(AppendKnot{p}));
    EXPECT_EQ(world::broken_invariant(session.document), std::nullopt);
  }
};

TEST_F(ClickingPoints, points_become_a_flowing_curve) {
  append(a_);
  EXPECT_EQ(knot(1).tangent, glm::vec3(1, 0, 0));
  append(b_);
  expect_direction(1, a_, b_);
  expect_direction(2, a_, b_);
  EXPECT_FLOAT_EQ(knot(2).in_length, glm::distance(a_, b_) / 3);
  append(c_);
  expect_direction(1, a_, b_);
  expect_direction(2, a_, c_);
  expect_direction(3, b_, c_);
  append(d_);
  expect_direction(3, b_, d_);
}

TEST_F(ClickingPoints, closing_lets_both_ends_flow) {
  append(a_), append(b_), append(c_), append(d_);
  good("closed on");
  expect_direction(1, d_, b_);
  expect_direction(4, c_, a_);
}

TEST_F(ClickingPoints, what_was_shaped_by_hand_stays) {
  append(a_), append(b_);
  good("direct @k2 to 0.3 0.9 0.1");
  good("spin @k2 to 0");
  const world::Knot shaped = knot(2);
  append(c_);
  EXPECT_EQ(knot(2), shaped);
  good("lengths @k3 in 2.5 out 2.5");
  const world::Knot shorter = knot(3);
  good("closed on");
  EXPECT_EQ(knot(3), shorter);
}

TEST_F(ClickingPoints, a_point_on_the_last_one_goes_on_level) {
  append(a_), append(b_), append(b_);
  EXPECT_EQ(knot(3).tangent.y, 0.0f);
  EXPECT_GT(glm::dot(knot(3).tangent, knot(2).tangent), 0.9f);
}

TEST_F(ClickingPoints, a_point_straight_above_has_a_level_up) {
  append(a_), append(a_ + glm::vec3(0, 17.3f, 0));
  EXPECT_NEAR(knot(2).up.y, 0.0f, 1e-6f);
}

TEST_F(ClickingPoints, a_gap_shorter_than_the_ends_handles_is_closed_without_folding_back) {
  for (const char* line :
       {"element straight length 40", "element curve left radius 15 angle 180", "element straight length 90",
        "element curve left radius 15 angle 180", "element straight length 40"})
    good(line);
  const double open = session.derived.length;
  const world::Knot& end = world::knot(session.document, session.document.track.knots.back());
  const float gap = glm::distance(end.position, knot(1).position);
  ASSERT_NEAR(gap, 10, 0.1);
  ASSERT_GT(end.out_length, gap);
  ASSERT_GT(knot(1).in_length, gap);
  good("closed on");
  EXPECT_NEAR(session.derived.length, open + double{gap}, 0.01);
  EXPECT_TRUE(edit::SessionFindings(session).conflicts().empty());
  const double length = session.derived.length;
  good("closed off"), good("closed on");
  EXPECT_EQ(session.derived.length, length);
}

TEST_F(ClickingPoints, handles_that_suit_the_gap_stay_as_they_are) {
  for (const char* line :
       {"element straight length 40", "element curve left radius 15 angle 180", "element straight length 40"})
    good(line);
  const world::Entity last = session.document.track.knots.back();
  good("lengths @k1 in 19 out 13"), good("lengths @" + world::label_of(session.document, last) + " in 13 out 17");
  good("closed on");
  EXPECT_EQ(knot(1).in_length, 19);
  EXPECT_EQ(world::knot(session.document, last).out_length, 17);
}

}  // namespace append_shape_test
}  // namespace coaster::edit
