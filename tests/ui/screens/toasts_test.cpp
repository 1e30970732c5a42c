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

}  // namespace toasts_test
}  // namespace coaster::ui
