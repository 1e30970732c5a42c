#include "app/user_data_keeper.h"

#include "app/program_fixture.h"
#include "base/text.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "world/appearance_settings.h"

namespace coaster::app {
namespace user_data_keeper_test {

using edit::NoticeKind;

class DocumentFileState : public ProgramTest {
 protected:
  void start(Program& program) { start_keeping(program, {folder_ / "config", folder_ / "state"}, {}, false); }
  void start() { start(*program_); }
  // The end of a frame at that time, s.
  void keep_at(Program& program, double seconds) {
    program.time.seconds = seconds;
    keep(program);
  }
  void keep_at(double seconds) { keep_at(*program_, seconds); }
  std::filesystem::path settings() const { return folder_ / "config" / "settings.json"; }
  exchange::UserSettings written() {
    const auto text = program_->files.read(settings());
    EXPECT_TRUE(text.ok());
    return text ? exchange::parse_settings(*text, "settings.json")->settings : exchange::UserSettings{};
  }
  // Autosaves a track with unsaved changes and ends as by a crash.
  void crash_with_track(const std::string& name) {
    std::unique_ptr<Program> other = make();
    start(*other);
    build_track(*other);
    ASSERT_TRUE(apply(*other, edit::SetTrackName{name}).ok());
    ASSERT_TRUE(autosave_now(*other).ok());
    stop_keeping(*other, false);
  }
  void answer(Program& program, ui::RecoveryAnswer what) {
    ui::Output output;
    output.recovery = what;
    answer_keeping(program, output);
  }
};

TEST_F(DocumentFileState, settings_are_written_a_second_after_the_last_change) {
  start();
  ASSERT_TRUE(apply(*program_, edit::Set<&world::Appearance::ui_scale>{1.25f}).ok());
  keep_at(10);
  keep_at(10.9);
  EXPECT_FALSE(std::filesystem::exists(settings()));
  keep_at(11);
  EXPECT_EQ(written().session.look->ui_scale, 1.25f);
  // A slider that is dragged is written once.
  for (double at = 20; at < 23; at += 0.5) {
    ASSERT_TRUE(
        apply(*program_, edit::Set<&world::Appearance::ui_scale>{static_cast<float>(1 + (at - 19.5) / 10)}).ok());
    keep_at(at);
    EXPECT_EQ(written().session.look->ui_scale, 1.25f) << at;
  }
  keep_at(23.6);
  EXPECT_EQ(written().session.look->ui_scale, program_->session.settings.look->ui_scale);
}

TEST_F(DocumentFileState, the_next_start_has_the_settings_of_the_last) {
  start();
  ASSERT_TRUE(apply(*program_, edit::Set<&world::Appearance::theme>{world::Theme::light}).ok());
  ASSERT_TRUE(apply(*program_, edit::Set<&world::Appearance::shadows>{false}).ok());
  surface(*program_).at = platform::WindowPlacement{31, 47, 1111, 777, false};
  stop_keeping(*program_, true);
  EXPECT_FALSE(program_->keeper);
  std::unique_ptr<Program> next = make();
  start(*next);
  EXPECT_EQ(next->session.settings.look->theme, world::Theme::light);
  EXPECT_FALSE(next->session.settings.look->shadows);
  ASSERT_TRUE(surface(*next).at);
  EXPECT_EQ(surface(*next).at->x, 31);
  EXPECT_EQ(surface(*next).at->height, 777);
}

TEST_F(DocumentFileState, a_size_on_the_command_line_replaces_that_of_the_last_window) {
  start();
  surface(*program_).at = platform::WindowPlacement{31, 47, 1111, 777, true};
  stop_keeping(*program_, true);
  std::unique_ptr<Program> next = make();
  next->options.width = 1600, next->options.height = 900;
  start(*next);
  EXPECT_EQ(surface(*next).at, (platform::WindowPlacement{31, 47, 1600, 900, false}));
}

TEST_F(DocumentFileState, a_file_that_holds_no_settings_is_set_aside) {
  std::filesystem::create_directories(folder_ / "config");
  ASSERT_TRUE(program_->files.write_atomic(settings(), "{ this is no JSON").ok());
  start();
  EXPECT_TRUE(program_->keeper->state.settings == exchange::UserSettings{});
  EXPECT_NE(last_notice(*program_).find("settings.json.bad"), std::string::npos) << last_notice(*program_);
  const auto aside = program_->files.read(settings().string() + ".bad");
  ASSERT_TRUE(aside.ok());
  EXPECT_EQ(*aside, "{ this is no JSON");
}

TEST_F(DocumentFileState, the_autosave_is_due_its_seconds_after_the_first_change) {
  start();
  program_->keeper->state.settings.autosave_seconds = 30;
  const int& autosaves = program_->stats.keeping.autosaves;
  keep_at(5);
  build_track(*program_);
  keep_at(10);
  keep_at(39.9);
  EXPECT_EQ(autosaves, 0);
  keep_at(40);
  EXPECT_EQ(autosaves, 1);
  for (const double later : {41.0, 100.0, 500.0}) keep_at(later);
  EXPECT_EQ(autosaves, 1) << "nothing has changed since";
  ASSERT_TRUE(apply(*program_, edit::SetStartSpeed{7.5}).ok());
  keep_at(510);
  keep_at(539);
  EXPECT_EQ(autosaves, 1);
  keep_at(541);
  EXPECT_EQ(autosaves, 2);
}

TEST_F(DocumentFileState, the_autosave_waits_for_the_end_of_a_gesture) {
  start();
  program_->keeper->state.settings.autosave_seconds = 30;
  ASSERT_TRUE(apply(*program_, edit::BeginGesture{}).ok());
  ASSERT_TRUE(apply(*program_, edit::SetStartSpeed{7.5}).ok());
  keep_at(10);
  keep_at(100);
  EXPECT_EQ(program_->stats.keeping.autosaves, 0);
  ASSERT_TRUE(apply(*program_, edit::EndGesture{}).ok());
  keep_at(101);
  EXPECT_EQ(program_->stats.keeping.autosaves, 1);
}

TEST_F(DocumentFileState, a_saved_track_needs_no_autosave) {
  start();
  build_track(*program_);
  ASSERT_TRUE(autosave_now(*program_).ok());
  ASSERT_TRUE(program_->keeper->autosave.exists());
  ASSERT_TRUE(apply(*program_, edit::Save{file("mine.json")}).ok());
  EXPECT_FALSE(program_->keeper->autosave.exists()) << "gone with the command";
  keep_at(1000);
  keep_at(2000);
  EXPECT_EQ(program_->stats.keeping.autosaves, 1);
}

TEST_F(DocumentFileState, what_a_crashed_program_left_is_offered_and_recovered) {
  crash_with_track("Kestrel");
  start();
  const auto& offers = program_->keeper->state.recoveries;
  ASSERT_EQ(offers.size(), 1u);
  EXPECT_EQ(offers[0].name, "Kestrel");
  EXPECT_EQ(offers[0].original, "");
  keep(*program_);
  EXPECT_EQ(program_->stats.keeping.recoverable, 1);
  answer(*program_, ui::RecoveryAnswer::recover);
  EXPECT_TRUE(offers.empty());
  EXPECT_EQ(program_->session.document.name, "Kestrel");
  EXPECT_EQ(program_->session.document.track.knots.size(), 3u);
  EXPECT_TRUE(edit::dirty(program_->session)) << "it is as unsaved as it was";
  EXPECT_TRUE(program_->keeper->autosave.exists()) << "at no time is there none";
}

TEST_F(DocumentFileState, an_offer_put_off_comes_again_and_a_discarded_one_does_not) {
  crash_with_track("Kestrel");
  start();
  ASSERT_EQ(program_->keeper->state.recoveries.size(), 1u);
  answer(*program_, ui::RecoveryAnswer::later);
  EXPECT_TRUE(program_->keeper->state.recoveries.empty());
  std::unique_ptr<Program> next = make();
  start(*next);
  ASSERT_EQ(next->keeper->state.recoveries.size(), 1u);
  answer(*next, ui::RecoveryAnswer::discard);
  std::unique_ptr<Program> last = make();
  start(*last);
  EXPECT_TRUE(last->keeper->state.recoveries.empty());
}

TEST_F(DocumentFileState, the_autosave_of_a_running_program_is_nobody_else_s) {
  start();
  build_track(*program_);
  ASSERT_TRUE(autosave_now(*program_).ok());
  std::unique_ptr<Program> other = make();
  start(*other);
  EXPECT_TRUE(other->keeper->state.recoveries.empty());
  stop_keeping(*program_, true);  // done: it leaves nothing
  std::unique_ptr<Program> next = make();
  start(*next);
  EXPECT_TRUE(next->keeper->state.recoveries.empty());
}

TEST_F(DocumentFileState, a_file_is_saved_by_the_program_that_opened_it_first) {
  start();
  build_track(*program_);
  ASSERT_TRUE(apply(*program_, edit::Save{file("shared.json")}).ok());
  const auto before = program_->files.read(file("shared.json"));
  ASSERT_TRUE(before.ok());
  std::unique_ptr<Program> other = make();
  start(*other);
  ASSERT_TRUE(apply(*other, edit::LoadTrack{file("shared.json")}).ok()) << "to look at it is free";
  EXPECT_EQ(other->keeper->state.holder, "another coaster (process " + std::to_string(::getpid()) + ")");
  ASSERT_FALSE(other->session.notices.list.empty());
  EXPECT_EQ(other->session.notices.list.back().kind, NoticeKind::warning);
  ASSERT_TRUE(apply(*other, edit::SetTrackName{"Theirs"}).ok());
  const base::Status refused = apply(*other, edit::Save{file("shared.json")});
  EXPECT_EQ(refused.code, base::Code::refused);
  EXPECT_EQ(*program_->files.read(file("shared.json")), *before);
  ASSERT_TRUE(apply(*other, edit::Save{file("other.json")}).ok());
  EXPECT_EQ(other->keeper->state.holder, "") << "its own file now";
  stop_keeping(*program_, true);
  EXPECT_TRUE(apply(*other, edit::Save{file("shared.json")}).ok()) << "nobody edits it any more";
}

// A challenge's start track has no file: that of the track before is nobody's then.
TEST_F(DocumentFileState, a_challenge_leaves_the_file_to_others) {
  const std::string challenge = std::string(COASTER_SOURCE_DIR) + "/challenges/01_first_hill.json";
  start();
  build_track(*program_);
  ASSERT_TRUE(apply(*program_, edit::Save{file("shared.json")}).ok());
  std::unique_ptr<Program> other = make();
  start(*other);
  ASSERT_TRUE(apply(*other, edit::LoadTrack{file("shared.json")}).ok());
  ASSERT_NE(other->keeper->state.holder, "");
  ASSERT_TRUE(apply(*other, edit::StartChallenge{challenge}).ok());
  EXPECT_EQ(other->keeper->state.holder, "") << "it shows that the track's file is in use elsewhere";
  ASSERT_TRUE(apply(*program_, edit::StartChallenge{challenge}).ok());
  ASSERT_TRUE(apply(*other, edit::LoadTrack{file("shared.json")}).ok());
  EXPECT_EQ(other->keeper->state.holder, "") << "the first program has left it";
  stop_keeping(*other, true);
}

TEST_F(DocumentFileState, recent_files_are_those_the_user_named_the_newest_first) {
  start();
  build_track(*program_);
  for (const char* const name : {"a.json", "b.json"}) ASSERT_TRUE(apply(*program_, edit::Save{file(name)}).ok());
  ASSERT_TRUE(apply(*program_, edit::LoadTrack{file("a.json")}).ok());
  program_->keeper->unasked = true;  // as the track that a window opens by itself
  ASSERT_TRUE(apply(*program_, edit::LoadTrack{file("b.json")}).ok());
  const std::vector<std::string>& recent = program_->keeper->state.settings.recent;
  ASSERT_EQ(recent.size(), 2u);
  EXPECT_EQ(std::filesystem::path(recent[0]).filename(), "a.json");
  EXPECT_EQ(std::filesystem::path(recent[1]).filename(), "b.json");
}

TEST_F(DocumentFileState, medals_outlive_the_program) {
  start();
  exchange::merge(program_->session.game.earned, {"03_hill", 2, {}});
  keep(*program_);
  std::unique_ptr<Program> next = make();
  start(*next);
  const auto& kept = next->keeper->state.progress.challenges;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].challenge, "03_hill");
  EXPECT_EQ(kept[0].medal, 2);
}

}  // namespace user_data_keeper_test
}  // namespace coaster::app
