#include "ui/screens/toasts.h"

#include <gtest/gtest.h>

namespace coaster::ui {
namespace toasts_test {

TEST(toasts, information_lasts_four_seconds_and_warnings_six) {
  for (const auto& [kind, seconds] : {std::pair{edit::NoticeKind::info, 4.0}, {edit::NoticeKind::warning, 6.0}}) {
    edit::Session session = edit::make_session({});
    Toasts toasts;
    edit::notify(session, kind, "mind the gap");
    toasts.update(session, 100, false);
    toasts.update(session, 100 + seconds - 0.1, false);
    EXPECT_EQ(toasts.shown, "mind the gap");
    toasts.update(session, 100 + seconds + 0.1, false);
    EXPECT_EQ(toasts.shown, "");
  }
}

TEST(toasts, under_a_dialog_their_time_does_not_run) {
  edit::Session session = edit::make_session({});
  Toasts toasts;
  edit::notify(session, edit::NoticeKind::warning, "rows too far apart");
  toasts.update(session, 100, false);
  for (int second = 101; second <= 130; ++second) toasts.update(session, second, false, true);
  EXPECT_EQ(toasts.shown, "rows too far apart");
  toasts.update(session, 135.9, false);
  EXPECT_EQ(toasts.shown, "rows too far apart");
  toasts.update(session, 136.1, false);
  EXPECT_EQ(toasts.shown, "");
}

TEST(toasts, stay_until_the_next_one_in_scripts) {
  edit::Session session = edit::make_session({});
  Toasts toasts;
  edit::notify(session, edit::NoticeKind::info, "first");
  toasts.update(session, 0, true);
  toasts.update(session, 1e6, true);
  EXPECT_EQ(toasts.shown, "first");
  edit::notify(session, edit::NoticeKind::error, "second");
  toasts.update(session, 1e6, true);
  EXPECT_EQ(toasts.shown, "second");
}

TEST(toasts, warnings_stay_above_the_note_that_came_with_them) {
  edit::Session session = edit::make_session({});
  Toasts toasts;
  edit::notify(session, edit::NoticeKind::warning, "seen before");
  toasts.update(session, 100, false);
  edit::notify(session, edit::NoticeKind::info, "on the way");
  for (const char* line : {"one", "two", "three", "four", "five"})
    edit::notify(session, edit::NoticeKind::warning, line);
  edit::notify(session, edit::NoticeKind::info, "done");
  toasts.update(session, 200, false);
  EXPECT_EQ(toasts.shown, "one\ntwo\nthree\nand 2 more\ndone");
  EXPECT_EQ(toasts.kind, edit::NoticeKind::warning);
  toasts.update(session, 211.9, false);
  EXPECT_EQ(toasts.shown, "one\ntwo\nthree\nand 2 more\ndone");
  toasts.update(session, 212.1, false);
  EXPECT_EQ(toasts.shown, "");
  edit::notify(session, edit::NoticeKind::warning, "of another command");
  session.notices.before = session.notices.serial;
  edit::notify(session, edit::NoticeKind::info, "next");
  toasts.update(session, 300, false);
  EXPECT_EQ(toasts.shown, "next");
}

}  // namespace toasts_test
}  // namespace coaster::ui
