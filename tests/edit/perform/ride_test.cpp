// Commands of the ride: src/edit/perform/settings.
#include <limits>

#include "edit/commands/commands_ride.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace perform_ride_test {

using world::RideState;

class Riding : public test::SessionTest {
 protected:
  void SetUp() override { good("closed on"); }
  const world::TrainMotion& cart() const { return session.motion.carts.get(entity("c1")); }
};

TEST_F(Riding, start_pause_step_and_stop) {
  const world::Motion start = session.motion;
  good("ride.start");
  EXPECT_EQ(session.motion.state, RideState::running);
  refused("ride.step 1", "pause it first");
  advance(session, 60);
  EXPECT_EQ(session.tick, 60u);
  EXPECT_NE(cart().travelled, 0);
  good("ride.pause");
  const double travelled = cart().travelled;
  advance(session, 60);
  EXPECT_EQ(cart().travelled, travelled);
  good("ride.step 5");
  EXPECT_NE(cart().travelled, travelled);
  EXPECT_EQ(session.motion.state, RideState::paused);
  good("ride.stop");
  EXPECT_TRUE(session.motion == start);
  refused("ride.pause", "not running");
}

TEST_F(Riding, steps_equal_running_ticks) {
  good("ride.start");
  advance(session, 77);
  good("ride.pause");
  const std::uint64_t run = world::hash(session.document, session.motion);
  good("ride.stop");
  good("ride.step 70");
  good("ride.step 7");
  EXPECT_EQ(world::hash(session.document, session.motion), run);
  clamped("ride.step 0", "limit of 1");
  EXPECT_NE(world::hash(session.document, session.motion), run);
}

TEST_F(Riding, seek_puts_the_first_cart_there) {
  good("ride.seek 31.7");
  const std::size_t i = *world::index_of(session.derived.order, cart().segment);
  EXPECT_NEAR(session.derived.starts[i] + cart().s, 31.7, 1e-6);
  EXPECT_EQ(session.motion.state, RideState::paused);
  refused(RideSeek{std::numeric_limits<double>::infinity()}, "finite");
  good("closed off");
  refused("ride.seek 1e6", "expected a distance along the track from 0 to 127.126 m, found 1000000");
  refused("ride.seek -0.5", "from 0 to 127.126 m, found -0.5");
  EXPECT_TRUE(apply(RideSeek{static_cast<float>(session.derived.length)}).ok());  // the panels' slider is of floats
}

TEST_F(Riding, an_ended_ride_starts_again_from_the_start) {
  session.motion.state = RideState::ended;
  refused("ride.step 1", "has ended");
  good("ride.start");
  EXPECT_EQ(session.motion.state, RideState::running);
  EXPECT_EQ(cart().travelled, 0);
}

TEST_F(Riding, without_carts_or_segments_there_is_no_ride) {
  good("remove @c1");
  good("remove @c2");
  for (const char* line : {"ride.start", "ride.pause", "ride.stop", "ride.step 1", "ride.seek 3"})
    refused(line, "there is no train");
  good("new");
  for (const char* line : {"ride.start", "ride.pause", "ride.stop", "ride.step 1", "ride.seek 3"})
    refused(line, "no segments");
}

TEST_F(Riding, removing_the_last_cart_stops_the_ride) {
  good("ride.start");
  good("remove @c1");
  EXPECT_EQ(session.motion.state, RideState::running);
  good("remove @c2");
  EXPECT_EQ(session.motion.state, RideState::stopped);
  EXPECT_EQ(session.motion.carts.size(), 0u);
}

TEST_F(Riding, undo_never_rewinds_the_ride) {
  good("datum 2.5");
  good("ride.start");
  advance(session, 100);
  const world::TrainMotion before = cart();
  good("undo");
  EXPECT_EQ(cart().s, before.s);
  EXPECT_EQ(cart().speed, before.speed);
  EXPECT_EQ(cart().segment, before.segment);
}

TEST_F(Riding, the_selected_cart_is_the_one_that_is_spoken_of_else_the_first) {
  const sim::SimulatedRide* const first = SessionFindings(session).ride();
  ASSERT_TRUE(first);
  const double front = first->start.front;
  good("select @c2");
  EXPECT_EQ(chosen_cart(session), entity("c2"));
  const sim::SimulatedRide* const second = SessionFindings(session).ride();
  ASSERT_TRUE(second);
  EXPECT_NE(second->start.front, front);
  const world::TrainMotion before = cart();
  good("ride.seek 31.7");
  EXPECT_TRUE(cart() == before);
  EXPECT_NEAR(session.motion.carts.get(entity("c2")).track_distance, 31.7, 1e-6);
  good("select @k1");
  EXPECT_EQ(chosen_cart(session), entity("c1"));
}

}  // namespace perform_ride_test
}  // namespace coaster::edit
