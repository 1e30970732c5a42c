// Tests the tools that a challenge locks (edit/session/session.h).
#include "edit/session/session.h"

#include <gtest/gtest.h>

namespace coaster::edit {
namespace locks_test {

TEST(locks, are_named_by_the_labels_of_buttons_each_once) {
  EXPECT_EQ(locked_text({"equip", "section.equip", "losses", "losses.set"}),
            "Locked in this challenge: Equipment, Losses.");
  EXPECT_EQ(locked_text({"make_all_g2"}), "Locked in this challenge: Make all g2.");
}

TEST(locks, hold_only_in_the_challenge_that_has_them) {
  Session session = make_session({});
  EXPECT_FALSE(is_locked(session, "smooth"));
  session.game.challenge.emplace().file.locks = {"smooth"};
  EXPECT_TRUE(is_locked(session, "smooth"));
  EXPECT_FALSE(is_locked(session, "smoot"));
  EXPECT_FALSE(is_locked(session, ""));
}

}  // namespace locks_test
}  // namespace coaster::edit
