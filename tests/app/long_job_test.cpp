#include "app/long_job.h"

#include <chrono>
#include <cmath>
#include <thread>

#include <fmt/format.h>

#include "app/frame.h"
#include "app/program_fixture.h"
#include "edit/commands/commands_session.h"
#include "edit/session_fixture.h"
#include "exchange/formats.h"
#include "world/sample_documents.h"

namespace coaster::app {
namespace long_job_test {

class LongJobs : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    build_track(*program_);
    ASSERT_TRUE(apply(*program_, edit::Save{file("rows.csv")}).ok());
    ASSERT_TRUE(apply(*program_, edit::NewTrack{}).ok());
    program_->by_hand = true;
  }
  edit::Command load(const std::string& name) { return edit::LoadTrack{file(name)}; }
  // The thread has come to its end.
  void wait() {
    while (!program_->job->work->done()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
};

TEST_F(LongJobs, begins_for_a_slow_format_by_hand_in_a_window_alone) {
  EXPECT_FALSE(begin_job(*program_, load("rows.csv"))) << "no window";
  surface(*program_).window = true;
  EXPECT_FALSE(begin_job(*program_, load("rows.json"))) << "read at once";
  EXPECT_FALSE(begin_job(*program_, edit::NewTrack{}));
  program_->by_hand = false;
  EXPECT_FALSE(begin_job(*program_, load("rows.csv"))) << "a script waits";
  program_->by_hand = true;
  EXPECT_TRUE(begin_job(*program_, load("rows.csv")));
  EXPECT_FALSE(begin_job(*program_, load("rows.csv"))) << "one at a time";
  EXPECT_TRUE(program_->session.document.track.knots.empty()) << "nothing is opened yet";
}

TEST_F(LongJobs, opens_the_same_track_as_a_load_that_waits) {
  surface(*program_).window = true;
  ASSERT_TRUE(begin_job(*program_, load("rows.csv")));
  wait();
  finish_job(*program_);
  EXPECT_FALSE(program_->job);
  const auto direct = exchange::load_track(program_->files, file("rows.csv"));
  ASSERT_TRUE(direct.ok()) << direct.status().message;
  ASSERT_FALSE(direct->document.track.knots.empty());
  EXPECT_EQ(world::hash(program_->session.document), world::hash(direct->document));
}

TEST_F(LongJobs, shows_how_far_it_is_when_it_has_taken_a_moment) {
  surface(*program_).window = true;
  EXPECT_EQ(shown_job(*program_), nullptr);
  program_->time.seconds = 100;
  ASSERT_TRUE(begin_job(*program_, load("rows.csv")));
  EXPECT_EQ(shown_job(*program_), nullptr);
  program_->time.seconds = 100.14;
  EXPECT_EQ(shown_job(*program_), nullptr);
  program_->time.seconds = 100.16;
  EXPECT_EQ(shown_job(*program_), program_->job.get());
}

TEST_F(LongJobs, a_slow_one_takes_the_frames_it_was_given) {
  program_->job_delay = 3;
  ASSERT_TRUE(begin_job(*program_, load("rows.csv")));
  EXPECT_EQ(program_->job_delay, 0) << "the next one is as quick as it is";
  EXPECT_NE(shown_job(*program_), nullptr) << "at once";
  wait();
  for (int frame = 0; frame < 3; ++frame) {
    finish_job(*program_);
    EXPECT_TRUE(program_->job) << frame;
  }
  finish_job(*program_);
  EXPECT_FALSE(program_->job);
  EXPECT_FALSE(program_->session.document.track.knots.empty());
}

TEST_F(LongJobs, a_cancelled_one_changes_nothing_however_quick_the_reader_was) {
  const std::uint64_t before = world::hash(program_->session.document);
  program_->job_delay = 5;
  ASSERT_TRUE(begin_job(*program_, load("rows.csv")));
  wait();
  program_->job->work->progress.cancelled = true;
  finish_job(*program_);
  EXPECT_FALSE(program_->job) << "it does not wait for its frames any more";
  EXPECT_EQ(world::hash(program_->session.document), before);
  EXPECT_EQ(last_notice(*program_), "Cancelled the import of " + file("rows.csv"));
}

TEST_F(LongJobs, says_why_a_file_cannot_be_read) {
  surface(*program_).window = true;
  ASSERT_TRUE(program_->files.write_atomic(file("broken.csv"), "no rows at all\n").ok());
  ASSERT_TRUE(begin_job(*program_, load("broken.csv")));
  wait();
  finish_job(*program_);
  EXPECT_FALSE(program_->job);
  EXPECT_TRUE(program_->session.document.track.knots.empty());
  EXPECT_EQ(program_->session.notices.list.back().kind, edit::NoticeKind::error);
  EXPECT_NE(last_notice(*program_).find("broken.csv"), std::string::npos) << last_notice(*program_);
}

// A circuit that the program has completed.
class CircuitJobs : public LongJobs {
 protected:
  void SetUp() override {
    LongJobs::SetUp();
    for (const char* const line :
         {"element straight length 30 equipment station", "element climb height 25 equipment lift",
          "element dive height 22", "element curve left radius 30 angle 180 bank 50",
          "element straight length 40 equipment brake speed 8", "complete 1"})
      ASSERT_TRUE(apply(*program_, command(line)).ok()) << line << last_notice(*program_);
    surface(*program_).window = true;
    before_ = world::hash(program_->session.document);
  }
  static edit::Command command(const std::string& line) { return test::command_of(line); }
  std::uint64_t hash() const { return world::hash(program_->session.document); }
  std::size_t steps() const { return program_->session.history.undo.size(); }
  // Returns the hash after the command, without a job.
  std::uint64_t hash_after(const std::string& line) {
    EXPECT_TRUE(apply(*program_, command(line)).ok());
    const std::uint64_t after = hash();
    EXPECT_TRUE(apply(*program_, edit::Undo{}).ok());
    EXPECT_EQ(hash(), before_);
    return after;
  }
  std::uint64_t before_ = 0;
};

TEST_F(CircuitJobs, a_change_of_a_circuit_waits_for_its_closing_section_and_is_one_step) {
  const std::string line = "section.change @q2 to climb height 30 equipment lift";
  const std::uint64_t wanted = hash_after(line), said = program_->session.notices.serial;
  const std::size_t steps_before = steps();
  apply_by_hand(*program_, {command(line), command("section.title @q2 to \"Hill\"")});
  ASSERT_TRUE(program_->job);
  EXPECT_EQ(hash(), before_) << "the old track shows meanwhile";
  EXPECT_EQ(steps(), steps_before);
  EXPECT_EQ(program_->session.notices.serial, said) << "nothing is refused";
  apply_by_hand(*program_, {command("section.delete @q3"), command("select @q2")});
  EXPECT_EQ(hash(), before_) << "what would lose its result is left out";
  EXPECT_EQ(world::label_of(program_->session.document, program_->session.settings.selected), "q2");
  wait();
  finish_job(*program_);
  EXPECT_FALSE(program_->job);
  EXPECT_EQ(steps(), steps_before + 2) << "and what came in the same frame";
  ASSERT_TRUE(apply(*program_, edit::Undo{}).ok());
  EXPECT_EQ(hash(), wanted);
  ASSERT_TRUE(apply(*program_, edit::Undo{}).ok());
  EXPECT_EQ(hash(), before_);
}

TEST_F(CircuitJobs, says_why_there_is_no_closing_section) {
  ASSERT_TRUE(apply(*program_, command("section.change @q1 to straight length 2000 equipment station")).ok());
  const std::uint64_t there = hash();
  apply_by_hand(*program_, {command("section.change @q3 to straight length 2000")});
  ASSERT_TRUE(program_->job);
  wait();
  finish_job(*program_);
  EXPECT_EQ(hash(), there);
  EXPECT_NE(last_notice(*program_).find("cannot take up the change"), std::string::npos) << last_notice(*program_);
}

TEST_F(CircuitJobs, a_cancelled_change_leaves_the_track) {
  apply_by_hand(*program_, {command("section.change @q2 to climb height 30 equipment lift")});
  ASSERT_TRUE(program_->job);
  program_->job->work->progress.cancelled = true;
  wait();
  finish_job(*program_);
  EXPECT_EQ(hash(), before_);
  EXPECT_EQ(last_notice(*program_), "Cancelled the change");
}

TEST_F(CircuitJobs, input_waits_until_the_way_is_found_or_the_bar_shows) {
  const platform::Events events{platform::MouseMove{3, 4}, platform::Tick{0.01}};
  EXPECT_EQ(take_input(*program_, events).size(), 2u);
  apply_by_hand(*program_, {command("section.change @q2 to climb height 30 equipment lift")});
  ASSERT_TRUE(program_->job);
  const platform::Events taken = take_input(*program_, events);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<platform::Tick>(taken.front())) << "time goes on";
  program_->time.seconds += 0.2;
  EXPECT_NE(shown_job(*program_), nullptr);
  EXPECT_EQ(take_input(*program_, events).size(), 3u) << "Cancel can be pressed";
  wait();
  finish_job(*program_);
  EXPECT_EQ(take_input(*program_, events).size(), 2u);
}

TEST_F(CircuitJobs, a_drag_is_one_step_and_waits_for_each_move_without_a_bar) {
  const auto line = [](int height) {
    return fmt::format("section.change @q2 from_start on to climb height {} equipment lift", height);
  };
  const std::uint64_t wanted = hash_after(line(29));
  const std::size_t steps_before = steps();
  apply_by_hand(*program_, {edit::BeginGesture{}, command(line(26))});
  for (int height = 27; height <= 29; ++height) {
    ASSERT_TRUE(program_->job) << height;
    program_->time.seconds += 1;
    EXPECT_EQ(shown_job(*program_), nullptr);
    EXPECT_TRUE(take_input(*program_, {platform::MouseMove{3, 4}}).empty());
    wait();
    finish_job(*program_);
    EXPECT_EQ(take_input(*program_, {}).size(), 1u);
    apply_by_hand(*program_, {command(line(height))});
  }
  wait();
  finish_job(*program_);
  apply_by_hand(*program_, {edit::EndGesture{}});
  EXPECT_EQ(hash(), wanted);
  EXPECT_EQ(steps(), steps_before + 1);
}

TEST_F(CircuitJobs, a_script_waits) {
  program_->options.script = "some.coaster";
  apply_by_hand(*program_, {command("section.change @q2 to climb height 30 equipment lift")});
  EXPECT_FALSE(program_->job);
  EXPECT_NE(hash(), before_);
}

// A track on which some commands take a second.
class SlowCommands : public LongJobs {
 protected:
  void SetUp() override {
    LongJobs::SetUp();
    restart_drawing();
    program_->by_hand = true;
    world::Document& track = program_->session.document;
    for (int i = 0; i <= 15'000; ++i)
      world::append_knot(track, test::skew_knot({static_cast<float>(i % 150) * 7.3f, 5 + 3 * std::sin(i * 0.7f),
                                                 static_cast<float>(i / 150) * 11.0f},
                                                {1, 0.1f, 0.2f}, 2.3f, 2.3f));
    ASSERT_TRUE(apply(*program_, test::command_of("resolution 4")).ok());
    run_frame(*program_, {platform::Tick{0.01}}, 0);
    surface(*program_).window = true;
    before_ = world::hash(program_->session.document);
  }
  std::uint64_t before_ = 0;
};

TEST_F(SlowCommands, show_a_card_and_do_the_same_as_without) {
  const edit::Command command = edit::MakeAllG2{};
  platform::Events& input = surface(*program_).next;
  input = {platform::KeyPress{platform::Key::d},
           platform::MouseMove{5, 6},
           platform::MouseButton{.down = false},
           platform::CloseRequest{},
           platform::Wheel{0, 1},
           platform::TextInput{"d"},
           platform::Focus{false},
           platform::Tick{3}};
  apply_by_hand(*program_, {command});
  EXPECT_GT(surface(*program_).presented, 0);
  const std::uint64_t after = world::hash(program_->session.document);
  EXPECT_NE(after, before_);
  EXPECT_EQ(program_->session.history.undo.size(), 1u);
  EXPECT_EQ(program_->time.seconds, 3.01) << "notices fade";
  EXPECT_EQ(take_input(*program_, {}).size(), 4u) << "presses are for another track";
  ASSERT_TRUE(apply(*program_, edit::Undo{}).ok());
  program_->by_hand = false;
  const int shown = surface(*program_).presented;
  ASSERT_TRUE(apply(*program_, command).ok());
  EXPECT_EQ(surface(*program_).presented, shown) << "a script waits";
  EXPECT_EQ(world::hash(program_->session.document), after);
}

TEST_F(SlowCommands, change_nothing_when_escape_cancels_them) {
  surface(*program_).next = {platform::KeyPress{platform::Key::escape}, platform::Tick{0.01}};
  const std::uint64_t commands = program_->session.history.undo.size();
  apply_by_hand(*program_, {edit::MakeAllG2{}});
  EXPECT_EQ(world::hash(program_->session.document), before_);
  EXPECT_EQ(program_->session.history.undo.size(), commands);
  EXPECT_EQ(last_notice(*program_), "Cancelled: Make every joint G2 with little movement");
  run_frame(*program_, {platform::Tick{0.01}}, 0);
}

TEST_F(SlowCommands, can_be_cancelled_in_a_window_that_has_another_size_than_its_picture) {
  surface(*program_).resize({200, 90});
  surface(*program_).next = {platform::KeyPress{platform::Key::escape}, platform::Tick{0.01}};
  const int shown = surface(*program_).presented;
  apply_by_hand(*program_, {edit::MakeAllG2{}});
  EXPECT_EQ(world::hash(program_->session.document), before_);
  EXPECT_EQ(surface(*program_).presented, shown) << "a picture of that size is missing";
}

TEST_F(SlowCommands, show_their_card_in_windows_of_any_size) {
  for (const platform::Size size : {platform::Size{1, 1}, platform::Size{3, 700}, platform::Size{640, 480}}) {
    surface(*program_).resize(size);
    program_->by_hand = false;
    run_frame(*program_, {platform::Tick{0.01}}, 0);
    surface(*program_).next = {platform::KeyPress{platform::Key::escape}, platform::Tick{0.01}};
    apply_by_hand(*program_, {edit::MakeAllG2{}});
    EXPECT_EQ(world::hash(program_->session.document), before_) << size.width;
  }
}

}  // namespace long_job_test
}  // namespace coaster::app
