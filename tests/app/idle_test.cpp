// A window draws while something changes, and otherwise waits for events.

#include <vector>

#include "app/frame.h"
#include "app/program_fixture.h"
#include "edit/commands/commands_ride.h"
#include "edit/session/session.h"
#include "sim/tracks.h"

namespace coaster::app {
namespace idle_test {

class Idle : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    restart_drawing();
    build_track(*program_);
    surface(*program_).window = true;
  }
  // Plays that many seconds, 60 frames a second, and returns how many of them were drawn.
  std::uint64_t play(double seconds) {
    const std::uint64_t before = program_->stats.frame;
    for (int i = 0; i < seconds * 60; ++i) {
      surface(*program_).now += 1.0 / 60;
      surface(*program_).next.push_back(platform::Tick{1.0 / 60});
      play_frame(*program_);
    }
    return program_->stats.frame - before;
  }
};

TEST_F(Idle, a_still_window_draws_nothing) {
  EXPECT_GT(play(10), 30u);  // a second after the start
  EXPECT_EQ(play(60), 0u);
  EXPECT_EQ(surface(*program_).longest_wait, kIdleWait);
}

TEST_F(Idle, the_picture_follows_an_event_at_once) {
  play(10);
  surface(*program_).next = {platform::MouseMove{30, 20}};
  EXPECT_EQ(play(1.0 / 60), 1u);
  EXPECT_GT(play(1), 30u);  // until a tooltip would show
  play(2);
  EXPECT_EQ(play(5), 0u);
  surface(*program_).next = {platform::Expose{}};
  EXPECT_EQ(play(1.0 / 60), 1u);
}

TEST_F(Idle, a_ride_is_drawn_in_every_frame) {
  play(10);
  ASSERT_TRUE(apply(*program_, edit::RideStart{}).ok());
  surface(*program_).next = {platform::Expose{}};
  EXPECT_EQ(play(1), 60u);
}

TEST_F(Idle, a_notice_is_drawn_until_it_is_gone) {
  play(10);
  edit::notify(program_->session, edit::NoticeKind::info, "Something happened.");
  surface(*program_).next = {platform::Expose{}};
  play(3);
  EXPECT_NE(program_->ui->toast(), "");
  EXPECT_GT(play(2), 15u);  // fades
  EXPECT_EQ(program_->ui->toast(), "");
  EXPECT_EQ(play(5), 0u);
}

TEST_F(Idle, time_goes_on_but_an_idle_rest_is_no_long_frame) {
  play(10);
  const double before = program_->time.seconds;
  play(20);
  EXPECT_NEAR(program_->time.seconds - before, 20, 1e-9);
  surface(*program_).next = {platform::Expose{}};
  const std::uint64_t tick = program_->session.tick;
  play(1.0 / 60);
  EXPECT_LE(program_->session.tick - tick, 2u);
}

TEST_F(Idle, the_rate_of_frames_is_that_of_drawn_frames) {
  play(10);
  const double before = program_->stats.fps;
  EXPECT_NEAR(before, 60, 1);
  surface(*program_).now += 0.9;  // a mouse that moves at the end of a wait
  surface(*program_).next = {platform::MouseMove{30, 20}};
  play_frame(*program_);
  EXPECT_GE(program_->stats.fps, before);
}

TEST_F(Idle, frames_that_are_counted_are_drawn) {
  play(10);
  program_->options.frames = 1000;
  EXPECT_EQ(play(1), 60u);
  program_->options.frames.reset();
  surface(*program_).window = false;
  EXPECT_EQ(play(1), 60u);
}

// Four pictures a second find the conflicts of at most a few thousand segments before the window would be idle.
TEST_F(Idle, a_search_for_conflicts_is_finished_first) {
  play(10);
  edit::Session& session = program_->session;
  session.document = test::ring_document(20'000, 32'000);
  sim::derive(session.document, session.settings, {}, session.derived);
  sim::reset(session.document, session.derived, session.motion);
  surface(*program_).next = {platform::Expose{}};
  const auto play_slowly = [&](int pictures) {
    for (int i = 0; i < pictures; ++i) {
      surface(*program_).now += 0.25;
      surface(*program_).next.push_back(platform::Tick{0.25});
      play_frame(*program_);
    }
  };
  play_slowly(2);
  EXPECT_FALSE(edit::SessionFindings(session).all_conflicts());
  play_slowly(40);
  EXPECT_TRUE(edit::SessionFindings(session).all_conflicts());
  EXPECT_EQ(play(5), 0u);
}

}  // namespace idle_test
}  // namespace coaster::app
