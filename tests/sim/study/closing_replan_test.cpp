// Single answers on a straight. Circuits that commands change are tested in tests/edit/perform/take_up_test.cpp.
#include "sim/study/closing_replan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/as_job.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace closing_replan_test {

world::Document straight(float length, float height = 5) {
  world::Document d;
  for (const float x : {0.0f, length}) world::append_knot(d, test::skew_knot({x, height, 0}, {1, 0, 0}, 20, 20));
  return d;
}

// The change of a straight whose closing section was the best one for a length of 60 m.
ClosingReplanTask change_to(world::Document opened) {
  const world::Document before = straight(60);
  const DerivedTrack derived = test::derived_of(before);
  Conflicts conflicts;
  conflicts.update(derived);
  ProposalCache cache;
  const CircuitProposal closing = cache.update(before, derived, conflicts, nullptr).list.at(0);
  const std::size_t spans = closing.plan.spans();
  return {.opened = std::move(opened),
          .former = closing.closing,
          .lengths = std::vector<double>(spans, closing.plan.length / static_cast<double>(spans))};
}

ClosingReplanResult answer(const ClosingReplanTask& change) {
  OpenedTrack opened;
  return changed_closing(change, opened);
}

bool equal(const ClosingReplanResult& a, const ClosingReplanResult& b) {
  return a.fit.knots == b.fit.knots && a.closing == b.closing && a.another == b.another && a.refusal == b.refusal;
}

TEST(closing_change, leads_from_the_new_end_to_the_first_knot_as_before) {
  const ClosingReplanTask change = change_to(straight(63));
  const ClosingReplanResult closing = answer(change);
  ASSERT_EQ(closing.refusal, "");
  EXPECT_FALSE(closing.another);
  EXPECT_EQ(closing.fit.knots.front().position, glm::vec3(63, 5, 0));
  EXPECT_EQ(closing.fit.knots.back().position, glm::vec3(0, 5, 0));
  EXPECT_NEAR(closing.closing.first, change.former.first, 5);
  EXPECT_NEAR(closing.closing.second, change.former.second, 5);
}

TEST(closing_change, a_former_way_like_no_other_needs_the_search_of_all) {
  ClosingReplanTask change = change_to(straight(63));
  change.former.first = 700, change.former.second = -700;
  change.whole = false;
  EXPECT_NE(answer(change).refusal, "");
  change.whole = true;
  const ClosingReplanResult closing = answer(change);
  ASSERT_EQ(closing.refusal, "");
  EXPECT_TRUE(closing.another);
  EXPECT_EQ(closing.fit.knots.back().position, glm::vec3(0, 5, 0));
}

// m g h = m v^2 / 2
TEST(closing_change, a_train_that_coasts_loses_the_speed_of_the_height) {
  ClosingReplanTask change = change_to(straight(63));
  change.former.speed = 20, change.former.coasts = true, change.risen = 5;
  const ClosingReplanResult closing = answer(change);
  ASSERT_EQ(closing.refusal, "");
  EXPECT_NEAR(closing.closing.speed, std::sqrt(20.0 * 20 - 2 * 9.81 * 5), 0.01);
  change.former.coasts = false;
  EXPECT_EQ(answer(change).closing.speed, 20);
  change.former.coasts = true, change.risen = 21;
  EXPECT_NE(answer(change).refusal.find("which would begin 21.0 m higher"), std::string::npos);
}

TEST(closing_change, does_not_depend_on_what_was_searched_before) {
  const ClosingReplanTask change = change_to(straight(63));
  OpenedTrack opened;
  (void)changed_closing(change_to(straight(80, 9)), opened);
  EXPECT_TRUE(equal(changed_closing(change, opened), answer(change)));
}

TEST(closing_change, tells_how_far_it_is_and_ends_when_cancelled) {
  ClosingReplanTask change = change_to(straight(63));
  change.former.first = 700, change.former.second = -700;
  OpenedTrack opened;
  base::JobProgress progress;
  ASSERT_EQ(test::as_job(progress, [&] { return changed_closing(change, opened); }).refusal, "");
  EXPECT_GT(progress.done.load(), 0);
  EXPECT_LE(progress.done.load(), 1);
  progress.cancelled = true;
  EXPECT_NE(test::as_job(progress, [&] { return changed_closing(change, opened); }).refusal, "")
      << "nothing is tried any more";
}

}  // namespace closing_replan_test
}  // namespace coaster::sim
