#include "exchange/own/challenge_progress_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace coaster::exchange {
namespace challenge_progress_file_test {

PlayerProgress sample() {
  PlayerProgress progress;
  progress.challenges = {{"01_first_hill", 2, {{"ride.lap_time", 31.25, true}, {"ride.drop_max", 1.0 / 3, false}}},
                         {"odd \"name\"", 0, {}}};
  return progress;
}

TEST(progress_file, printing_and_parsing_give_the_same_back) {
  for (const PlayerProgress& progress : {sample(), PlayerProgress{}}) {
    const auto again = parse_progress(print_progress(progress), "p.json");
    ASSERT_TRUE(again.ok()) << again.status().message;
    EXPECT_TRUE(*again == progress);
  }
}

TEST(progress_file, no_cut_at_any_byte_and_no_wrong_type_is_read) {
  const std::string text = print_progress(sample());
  for (std::size_t length = 0; length + 2 < text.size(); ++length)
    ASSERT_FALSE(parse_progress(text.substr(0, length), "p.json").ok()) << length;
  const auto error = [&](const std::string& from, const std::string& to) {
    std::string wrong = text;
    wrong.replace(wrong.find(from), from.size(), to);
    const auto loaded = parse_progress(wrong, "p.json");
    return loaded ? std::string("read") : loaded.status().message;
  };
  EXPECT_NE(
      error("\"medal\": 2", "\"medal\": 4").find("challenges[0].medal: expected a whole number from 0 to 3, found 4"),
      std::string::npos);
  EXPECT_NE(error("\"medal\": 2", "\"medal\": \"gold\"").find("challenges[0].medal"), std::string::npos);
  EXPECT_NE(error("\"better\": \"more\"", "\"better\": \"most\"")
                .find("challenges[0].best[1].better: expected \"less\" or \"more\""),
            std::string::npos);
  EXPECT_NE(error("odd \\\"name\\\"", "01_first_hill").find("challenges[1].challenge"), std::string::npos)
      << "no name twice";
  EXPECT_NE(error("\"version\": 1", "\"version\": 2").find("newer"), std::string::npos);
}

TEST(progress_file, the_better_of_each_stays) {
  PlayerProgress progress = sample();
  EXPECT_FALSE(merge(progress, {"01_first_hill", 1, {{"ride.lap_time", 40, true}, {"ride.drop_max", 0.1, false}}}))
      << "nothing is better";
  EXPECT_TRUE(progress == sample());
  EXPECT_TRUE(
      merge(progress,
            {"01_first_hill", 1, {{"ride.lap_time", 30, true}, {"ride.drop_max", 0.1, false}, {"knots", 7, true}}}));
  const ChallengeProgress* const found = find(progress, "01_first_hill");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->medal, 2) << "a medal is never lost";
  EXPECT_EQ(found->best[0].value, 30);
  EXPECT_EQ(found->best[1].value, 1.0 / 3);
  ASSERT_EQ(found->best.size(), 3u);
  EXPECT_TRUE(merge(progress, {"new", 3, {}}));
  EXPECT_EQ(find(progress, "new")->medal, 3);
  EXPECT_EQ(find(progress, "none"), nullptr);
}

RC_GTEST_PROP(progress_file, the_order_of_successes_does_not_matter, (std::vector<std::pair<int, int>> successes)) {
  PlayerProgress forth, back;
  int medal = 0, least = std::numeric_limits<int>::max();
  const auto of = [](const std::pair<int, int>& s) {
    return ChallengeProgress{"c", std::abs(s.first % 4), {{"knots", double(s.second), true}}};
  };
  for (const auto& s : successes)
    (void)merge(forth, of(s)), medal = std::max(medal, std::abs(s.first % 4)), least = std::min(least, s.second);
  for (auto s = successes.rbegin(); s != successes.rend(); ++s) (void)merge(back, of(*s));
  RC_ASSERT(forth == back);
  if (!successes.empty()) RC_ASSERT(forth.challenges[0].medal == medal && forth.challenges[0].best[0].value == least);
}

}  // namespace challenge_progress_file_test
}  // namespace coaster::exchange
