// Single answers on a straight. Circuits that commands change are tested in tests/edit/perform/take_up_test.cpp.
#include "sim/study/way_change.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/as_job.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace way_change_test {

world::Document straight(float length, float height = 5) {
  world::Document d;
  for (const float x : {0.0f, length}) world::append_knot(d, test::skew_knot({x, height, 0}, {1, 0, 0}, 20, 20));
  return d;
}

// The change of a straight whose way home was the best one for a length of 60 m.
WayChange change_to(world::Document opened) {
  const world::Document before = straight(60);
  const Derived derived = test::derived_of(before);
  Conflicts conflicts;
  conflicts.update(derived);
  CircuitMemo memo;
  const CircuitProposal way = memo.update(before, derived, conflicts, nullptr).list.at(0);
  const std::size_t spans = way.plan.spans();
  return {.opened = std::move(opened),
          .former = way.way,
          .lengths = std::vector<double>(spans, way.plan.length / static_cast<double>(spans))};
}

ChangedWay answer(const WayChange& change) {
  OpenedTrack opened;
  return changed_way(change, opened);
}

bool equal(const ChangedWay& a, const ChangedWay& b) {
  return a.fit.knots == b.fit.knots && a.way == b.way && a.another == b.another && a.refusal == b.refusal;
}

TEST(way_change, leads_from_the_new_end_to_the_first_knot_as_before) {
  const WayChange change = change_to(straight(63));
  const ChangedWay way = answer(change);
  ASSERT_EQ(way.refusal, "");
  EXPECT_FALSE(way.another);
  EXPECT_EQ(way.fit.knots.front().position, glm::vec3(63, 5, 0));
  EXPECT_EQ(way.fit.knots.back().position, glm::vec3(0, 5, 0));
  EXPECT_NEAR(way.way.first, change.former.first, 5);
  EXPECT_NEAR(way.way.second, change.former.second, 5);
}

TEST(way_change, a_former_way_like_no_other_needs_the_search_of_all) {
  WayChange change = change_to(straight(63));
  change.former.first = 700, change.former.second = -700;
  change.whole = false;
  EXPECT_NE(answer(change).refusal, "");
  change.whole = true;
  const ChangedWay way = answer(change);
  ASSERT_EQ(way.refusal, "");
  EXPECT_TRUE(way.another);
  EXPECT_EQ(way.fit.knots.back().position, glm::vec3(0, 5, 0));
}

// m g h = m v^2 / 2
TEST(way_change, a_train_that_coasts_loses_the_speed_of_the_height) {
  WayChange change = change_to(straight(63));
  change.former.speed = 20, change.former.coasts = true, change.risen = 5;
  const ChangedWay way = answer(change);
  ASSERT_EQ(way.refusal, "");
  EXPECT_NEAR(way.way.speed, std::sqrt(20.0 * 20 - 2 * 9.81 * 5), 0.01);
  change.former.coasts = false;
  EXPECT_EQ(answer(change).way.speed, 20);
  change.former.coasts = true, change.risen = 21;
  EXPECT_NE(answer(change).refusal.find("which would begin 21.0 m higher"), std::string::npos);
}

TEST(way_change, does_not_depend_on_what_was_searched_before) {
  const WayChange change = change_to(straight(63));
  OpenedTrack opened;
  (void)changed_way(change_to(straight(80, 9)), opened);
  EXPECT_TRUE(equal(changed_way(change, opened), answer(change)));
}

TEST(way_change, tells_how_far_it_is_and_ends_when_cancelled) {
  WayChange change = change_to(straight(63));
  change.former.first = 700, change.former.second = -700;
  OpenedTrack opened;
  base::Progress progress;
  ASSERT_EQ(test::as_job(progress, [&] { return changed_way(change, opened); }).refusal, "");
  EXPECT_GT(progress.done.load(), 0);
  EXPECT_LE(progress.done.load(), 1);
  progress.cancelled = true;
  EXPECT_NE(test::as_job(progress, [&] { return changed_way(change, opened); }).refusal, "")
      << "nothing is tried any more";
}

}  // namespace way_change_test
}  // namespace coaster::sim
