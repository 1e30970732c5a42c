// No challenge is passed on its start track by one press of a button that it does not lock.
#include <filesystem>

#include <fmt/format.h>

#include "base/tries.h"
#include "edit/commands/commands_ride.h"
#include "edit/session_fixture.h"
#include "query/challenge_rules.h"

namespace coaster::query {
namespace challenge_presses_test {

namespace fs = std::filesystem;

class ChallengePresses : public test::SessionTest {
 protected:
  void SetUp() override { session.game.referee = referee(); }

  static std::vector<fs::path> challenges() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(COASTER_SOURCE_DIR) / "challenges"))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
  }
  void begin(const fs::path& file) { ASSERT_TRUE(apply(edit::StartChallenge{file.string()})); }

  // What buttons and actions send with nothing or everything selected, and with one segment.
  std::vector<std::string> presses() const {
    std::vector<std::string> lines{"auto_bank",
                                   "smooth all",
                                   "smooth all by uniform",
                                   "equalise all",
                                   "make_all_g2",
                                   "straighten all",
                                   "drop all",
                                   "radius all to 20",
                                   "reverse",
                                   "joint all to smooth",
                                   "joint all to aligned",
                                   "joint all to automatic",
                                   "auto_spin all",
                                   "closed off",
                                   "add_curve",
                                   "close",
                                   "complete 1",
                                   "losses.set frictionless",
                                   "losses.set openfvd",
                                   "losses.set kexedit",
                                   "curve heartline keep rails",
                                   "curve heartline keep numbers",
                                   "rollback_fails off",
                                   "remove @c1",
                                   "section.mirror @q1",
                                   "section.delete @q1"};
    const auto equips = [&](std::string_view command, const std::string& name) {
      for (const char* const kind : {"station", "lift", "launch"})
        lines.push_back(fmt::format("{} @{} as {}", command, name, kind));
    };
    equips("section.equip", "q1");
    if (session.game.challenge->file.judged == exchange::JudgedWhen::lap)
      for (const world::Entity segment : session.document.track.segments)
        equips("equip", world::label_of(session.document, segment));
    return lines;
  }
  // The medal after a press, ridden if everything is met.
  int medal_after(const std::string& press) {
    const edit::ActiveChallenge& challenge = *session.game.challenge;
    if (!apply(press) || challenge.file.judged == exchange::JudgedWhen::build) return challenge.medal;
    const auto rules = read_rules(challenge.file, challenge.path);
    for (const ParsedRule& rule : *rules)
      if (must_hold(rule) && !look_at(session, rule).holds) return 0;
    (void)apply("ride.start");
    edit::advance(session, 120 * 120);
    return challenge.medal;
  }
};

TEST_F(ChallengePresses, none_that_is_not_locked_passes) {
  int i = 0;
  for (const fs::path& file : challenges()) {
    begin(file);
    for (const std::string& press : presses()) {
      if (!test::tried(i++)) continue;
      begin(file);
      EXPECT_EQ(medal_after(press), 0) << file.filename() << ": " << press;
    }
  }
}

TEST_F(ChallengePresses, locks_hold_back_presses_that_would_pass) {
  const struct {
    const char *challenge, *press;
    int medal;
  } kCases[] = {{"02_smooth_joints.json", "equalise all", 1},
                {"06_loop.json", "losses.set openfvd", 1},
                {"06_loop.json", "equip @s12 as station", 1}};
  for (const auto& one : kCases) {
    begin(fs::path(COASTER_SOURCE_DIR) / "challenges" / one.challenge);
    ASSERT_FALSE(session.game.challenge->file.locks.empty());
    EXPECT_FALSE(apply(one.press)) << one.press;
    EXPECT_NE(session.notices.list.back().text.find("Locked in this challenge"), std::string::npos);
    session.game.challenge->file.locks.clear();
    const int medal = medal_after(one.press);
    EXPECT_GE(medal, one.medal) << one.challenge << ": " << one.press;
  }
}

}  // namespace challenge_presses_test
}  // namespace coaster::query
