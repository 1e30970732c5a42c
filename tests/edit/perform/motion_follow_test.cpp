// Tests how trains stay on their rails while segments come and go (edit/perform/change_propagation.h).
#include "edit/perform/change_propagation.h"

#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace motion_follow_test {

class EditingUnderCarts : public test::SessionTest {
 protected:
  void SetUp() override {
    good("closed on");
    good("ride.start");
    advance(session, 100);
    good("ride.pause");
  }
  const world::TrainMotion& cart(const char* name) const { return session.motion.carts.get(entity(name)); }
  glm::dvec3 place(const char* name) const {
    return sim::pose(session.derived, cart(name), world::FrameMethod::knots).position;
  }
};

TEST_F(EditingUnderCarts, a_split_and_its_undo_leave_carts_where_they_are) {
  for (const char* at : {"0.15", "0.5", "0.9"})
    for (const char* segment : {"@s1", "@s2", "@s3", "@s4", "@s5"}) {
      const glm::dvec3 one = place("c1"), two = place("c2");
      const double speed = cart("c1").speed;
      good(std::string("split ") + segment + " at " + at);
      EXPECT_NEAR(glm::distance(place("c1"), one), 0, 2e-3) << segment << at;
      EXPECT_NEAR(glm::distance(place("c2"), two), 0, 2e-3) << segment << at;
      EXPECT_EQ(cart("c1").speed, speed);
      good("undo");
      EXPECT_NEAR(glm::distance(place("c1"), one), 0, 4e-3) << segment << at;
      EXPECT_NEAR(glm::distance(place("c2"), two), 0, 4e-3) << segment << at;
    }
}

TEST_F(EditingUnderCarts, carts_go_on_running_over_a_split) {
  good("ride.start");
  good("split @s2 at 0.5");
  EXPECT_EQ(session.motion.state, world::RideState::running);
  const double travelled = cart("c1").travelled;
  advance(session, 120);
  EXPECT_NE(cart("c1").travelled, travelled);
}

TEST_F(EditingUnderCarts, removing_a_knot_hands_carts_to_the_survivor_at_the_same_part_of_the_way) {
  const auto& old = session.derived;
  const world::TrainMotion before = cart("c1");
  const std::size_t i = *world::index_of(old.order, before.segment);
  const std::size_t previous = (i + old.order.size() - 1) % old.order.size();
  const world::Entity survivor = old.order[previous];
  const double first = old.shape(survivor).arc.length(), second = old.shape(before.segment).arc.length();
  const world::Entity knot = world::segment(session.document, before.segment).from;
  ASSERT_TRUE(apply(RemoveKnotOrTrain{{world::name_of(session.document, knot)}}));
  EXPECT_EQ(cart("c1").segment, survivor);
  EXPECT_NEAR(cart("c1").s / session.derived.shape(survivor).arc.length(), (first + before.s) / (first + second), 1e-9);
}

TEST_F(EditingUnderCarts, undo_of_a_removal_takes_carts_back_to_their_distance) {
  good("undo");  // opens the track
  const double distance =
      session.derived.starts[*world::index_of(session.derived.order, cart("c1").segment)] + cart("c1").s;
  good("remove @k5");
  good("undo");
  EXPECT_NEAR(session.derived.starts[*world::index_of(session.derived.order, cart("c1").segment)] + cart("c1").s,
              distance, 1e-6);
}

TEST_F(EditingUnderCarts, a_reversed_track_leaves_carts_on_their_way_through_space) {
  const auto velocity = [&](const char* name) {
    return cart(name).speed * sim::pose(session.derived, cart(name), world::FrameMethod::knots).frame.forward;
  };
  for (int turn = 0; turn < 2; ++turn) {
    const glm::dvec3 one = place("c1"), two = place("c2"), one_goes = velocity("c1"), two_goes = velocity("c2");
    ASSERT_GT(glm::length(one_goes), 1);
    good("reverse");
    EXPECT_NEAR(glm::distance(place("c1"), one), 0, 1e-3) << turn;
    EXPECT_NEAR(glm::distance(place("c2"), two), 0, 1e-3) << turn;
    EXPECT_NEAR(glm::distance(velocity("c1"), one_goes), 0, 1e-3) << turn;
    EXPECT_NEAR(glm::distance(velocity("c2"), two_goes), 0, 1e-3) << turn;
  }
}

TEST_F(EditingUnderCarts, a_stopped_ride_shows_carts_as_designed) {
  good("ride.stop");
  good("start_speed 7.7");
  EXPECT_EQ(cart("c1").speed, 7.7);
  good("move @k2 to 129.3 25.7 -36.1");
  EXPECT_NEAR(cart("c1").s, 0.37 * session.derived.shape(cart("c1").segment).arc.length(), 1e-9);
}

}  // namespace motion_follow_test
}  // namespace coaster::edit
