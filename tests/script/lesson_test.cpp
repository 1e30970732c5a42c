// Lessons: done by the player if there is one, else by their own lines.
#include <gtest/gtest.h>

#include <algorithm>

#include "edit/commands/commands_document.h"
#include "script/fake_host.h"

namespace coaster::script {
namespace lesson_test {

const char* const kLesson =
    "lesson \"Add a knot\" at \"Track/Add curve\" until knots == 1\n  append at 1 2 3\nend\n"
    "lesson \"And one more\" until knots == 2\n  append at 9 2 3\nend\n";

// A player with given answers, who acts before some frames.
struct Class {
  FakeHost fake;
  std::vector<query::LessonCard> cards;  // as they were shown; an empty one where a card was taken away
  std::vector<query::LessonAnswer> answers;
  int watched = 0, acts_at = -1;
  bool interrupted = false, key_down = false;  // of a key that adds a knot

  base::Status take(const std::string& lines) {
    base::Files files;
    const ParsedScript parsed = parse_script("coaster-script 1\n" + lines, "test.coaster", ".", files);
    EXPECT_TRUE(parsed.errors.empty()) << (parsed.errors.empty() ? "" : parsed.errors.front());
    Host host = fake.host();
    host.teach = [this](const query::LessonCard* card) { cards.push_back(card ? *card : query::LessonCard{}); };
    host.frame = [this](const platform::Events& events, int ticks) {
      for (const platform::Event& event : events)
        if (const auto* const key = std::get_if<platform::KeyPress>(&event); key && (key_down = key->down))
          (void)fake.apply(edit::AppendKnot{{0, 1, 0}});
      return fake.frame(events, ticks);
    };
    host.answer = [this] {
      if (watched == acts_at) (void)fake.apply(edit::AppendKnot{{0, 1, 0}});
      const auto now = static_cast<std::size_t>(watched++);
      return now < answers.size() ? answers[now] : query::LessonAnswer::none;
    };
    host.interrupted = [this] { return interrupted || watched > 1000; };
    RunOptions options;
    options.out = *base::FileRoot().open(std::filesystem::path(testing::TempDir()) / "lesson");
    return run_script(parsed.script, host, options);
  }
  std::size_t knots() const { return fake.session.document.track.knots.size(); }
};

TEST(lesson, without_a_player_its_own_lines_do_it) {
  FakeHost fake;
  const base::Status status = run_lines(fake, std::string(kLesson) + "expect knots == 2\n");
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST(lesson, lines_that_do_not_lead_where_it_says_fail_in_time) {
  FakeHost fake;
  const base::Status status = run_lines(fake, "lesson \"Add two\" until knots == 2\n  append at 1 2 3\nend\n");
  EXPECT_EQ(status.code, base::Code::timeout);
  EXPECT_NE(status.message.find("did not reach knots == 2, found 1"), std::string::npos) << status.message;
}

TEST(lesson, what_is_so_already_is_no_lesson_where_nobody_plays) {
  FakeHost fake;
  EXPECT_EQ(run_lines(fake, "lesson \"Nothing\" until knots == 0\nend\n").code, base::Code::expectation);
}

TEST(lesson, waits_for_the_players_own_hand_and_leaves_its_lines_alone) {
  Class pupils;
  pupils.acts_at = 5;
  pupils.answers.assign(9, query::LessonAnswer::none);
  pupils.answers.push_back(query::LessonAnswer::leave);
  EXPECT_TRUE(pupils.take(kLesson).ok());
  EXPECT_EQ(pupils.knots(), 1u);
  ASSERT_EQ(pupils.cards.size(), 4u);
  EXPECT_EQ(pupils.cards[0].text, "Add a knot");
  EXPECT_EQ(pupils.cards[0].widget, "Track/Add curve");
  EXPECT_EQ(pupils.cards[0].number, 1);
  EXPECT_EQ(pupils.cards[0].count, 2);
  EXPECT_EQ(pupils.cards[1].text, "") << "the card goes when the lesson is learnt";
  EXPECT_EQ(pupils.cards[2].number, 2);
}

TEST(lesson, shows_how_when_asked) {
  Class pupils;
  pupils.answers = {query::LessonAnswer::none, query::LessonAnswer::show, query::LessonAnswer::none,
                    query::LessonAnswer::show};
  EXPECT_TRUE(pupils.take(kLesson).ok());
  EXPECT_EQ(pupils.knots(), 2u);
}

// A key that takes effect at once leaves its release to the next frame: the player must not wait for that.
TEST(lesson, hands_over_with_all_keys_and_buttons_up) {
  Class pupils;
  pupils.answers = {query::LessonAnswer::show, query::LessonAnswer::none, query::LessonAnswer::leave};
  EXPECT_TRUE(pupils.take("lesson \"Press\" until knots == 1\n  key Enter\nend\n" + std::string(kLesson)).ok());
  EXPECT_EQ(pupils.knots(), 1u);
  EXPECT_FALSE(pupils.key_down);
}

TEST(lesson, leaving_ends_the_script_without_an_error) {
  Class pupils;
  pupils.answers = {query::LessonAnswer::leave};
  EXPECT_TRUE(pupils.take(std::string("repeat 2\n") + "append at 5 5 5\n" + kLesson + "end\nappend at 7 7 7\n").ok());
  EXPECT_EQ(pupils.knots(), 1u) << "only what came before the first lesson";
}

TEST(lesson, needs_a_text_and_an_until) {
  base::Files files;
  for (const char* line : {"lesson", "lesson \"a\"", "lesson \"a\" at", "lesson \"a\" at \"b\"", "lesson \"a\" until",
                           "lesson \"a\" until nothing == 3"}) {
    const ParsedScript parsed = parse_script(std::string("coaster-script 1\n") + line + "\nend\n", "t", ".", files);
    EXPECT_FALSE(parsed.errors.empty()) << line;
  }
}

TEST(lesson, says_at_once_that_a_ride_that_does_not_move_leads_nowhere) {
  FakeHost fake;
  const base::Status status = run_lines(fake,
                                        "append at 0 5 0\nappend at 9 4 0\nlesson \"Ride\" until ride.lap == 1\n"
                                        "  start_speed 3\nend\n");
  EXPECT_EQ(status.code, base::Code::timeout);
  EXPECT_NE(status.message.find("did not reach ride.lap == 1, found 0; the ride was never started"), std::string::npos)
      << status.message;
  EXPECT_LT(fake.session.tick, 20u);
}

}  // namespace lesson_test
}  // namespace coaster::script
