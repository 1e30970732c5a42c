#include "app/long_job.h"

#include <chrono>
#include <thread>

#include "app/program_fixture.h"
#include "edit/commands/commands_session.h"
#include "exchange/formats.h"

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
  edit::Command load(const std::string& name) { return edit::Load{file(name)}; }
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
  EXPECT_FALSE(program_->session.file.read_ahead) << "it has been taken";
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

}  // namespace long_job_test
}  // namespace coaster::app
