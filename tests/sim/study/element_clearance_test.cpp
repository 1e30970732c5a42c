// A straight that would cross the track's beginning at a right angle: its clearance follows from the distance of the
// two lines, as for existing track (tests/sim/solids/conflicts_test.cpp).
#include "sim/study/complete_circuit.h"

#include <gtest/gtest.h>

#include "sim/plan/element_plan_cache.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace element_clearance_test {

const CoasterForm& kSteel = form_of(world::CoasterKind::steel);
const double kTrainRadius = kSteel.train.radius, kTrainLift = kSteel.train.lift, kTrackRadius = kSteel.track.radius,
             kTrackDrop = -kSteel.track.lift;

// Along x through (30, 5, 0), round, and over it by `over` metres: the open end is 40 m before the crossing.
world::Document before_a_crossing(float over, world::TrackCurve curve = world::TrackCurve::rails) {
  world::Document d;
  d.curve = curve;
  const auto add = [&](glm::vec3 at, glm::vec3 along) { world::append_knot(d, test::skew_knot(at, along, 10, 10)); };
  add({0, 5, 0}, {1, 0, 0}), add({60, 5, 0}, {1, 0, 0});
  add({90, 5 + over / 2, 60}, {0, 0, 1});
  add({60, 5 + over, 95}, {-1, 0, 0});
  add({30, 5 + over, 70}, {0, 0, -1}), add({30, 5 + over, 40}, {0, 0, -1});
  return d;
}

std::vector<LineConflict> narrow(float over, double length, world::TrackCurve curve = world::TrackCurve::rails) {
  const world::Document d = before_a_crossing(over, curve);
  const DerivedTrack derived = test::derived_of(d);
  Conflicts conflicts;
  conflicts.update(derived);
  world::Element straight = world::usual_element(world::ElementKind::straight);
  straight.values[0] = length;
  ElementCache plans;
  ElementClearance room;
  const ElementPlan& plan = plans.plan(straight, d);
  EXPECT_TRUE(plan.refusal.empty()) << plan.refusal;
  EXPECT_NEAR(world::value_of(plan.element, "length"), length, 1e-9);
  return room.update(plan, conflicts, derived, world::rails_height(d));
}

TEST(element_room, a_straight_over_track_needs_room_for_heads) {
  const double kEnough = kTrainRadius + kTrackRadius + kTrainLift + kTrackDrop;  // m from rails to rails
  for (const double over : {1.5, 2.5, kEnough - 0.05}) {
    const std::vector<LineConflict> found = narrow(static_cast<float>(over), 60);
    ASSERT_EQ(found.size(), 1u) << over;
    EXPECT_LT(found[0].from, 40);
    EXPECT_GT(found[0].to, 40);
    EXPECT_NEAR(worst(found), kTrainRadius + kTrackRadius - std::abs(over - kTrainLift - kTrackDrop), 1e-4) << over;
  }
  EXPECT_TRUE(narrow(static_cast<float>(kEnough + 0.05), 60).empty());
}

TEST(element_room, a_straight_that_ends_before_the_track_has_room) { EXPECT_TRUE(narrow(1.5f, 30).empty()); }

// Level rails below a heartline are all lower by the same height.
TEST(element_room, is_that_of_the_rails_of_a_heartline_too) {
  for (const float over : {1.5f, 2.5f}) {
    const std::vector<LineConflict> rails = narrow(over, 60), heart = narrow(over, 60, world::TrackCurve::heartline);
    ASSERT_EQ(heart.size(), 1u) << over;
    EXPECT_NEAR(worst(heart), worst(rails), 0.01) << over;
  }
}

TEST(element_room, a_plan_is_judged_again_when_the_track_has_changed) {
  world::Document d = before_a_crossing(1.5f);
  DerivedTrack derived = test::derived_of(d);
  Conflicts conflicts;
  conflicts.update(derived);
  world::Element straight = world::usual_element(world::ElementKind::straight);
  straight.values[0] = 60;
  ElementCache plans;
  ElementClearance room;
  EXPECT_FALSE(room.update(plans.plan(straight, d), conflicts, derived, 0).empty());
  for (const std::size_t knot : {0u, 1u}) d.entities.get<world::Knot>(d.track.knots[knot]).position.x += 70;
  derive(d, {}, {}, derived);
  conflicts.update(derived);
  EXPECT_TRUE(room.update(plans.plan(straight, d), conflicts, derived, 0).empty());
}

}  // namespace element_clearance_test
}  // namespace coaster::sim
