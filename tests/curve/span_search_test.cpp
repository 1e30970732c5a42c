#include "curve/span_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coaster::curve {
namespace span_search_test {

TEST(span_search, the_longest_span_is_the_last_that_holds_from_any_guess_by_any_steps) {
  for (const SpanSteps steps : {SpanSteps{}, SpanSteps{.growth = 3, .more = 1, .by_quarters = true}})
    for (std::size_t most = 1; most <= 70; most += 3)
      for (std::size_t last = 1; last <= most; ++last)
        for (std::size_t guess = 1; guess <= most; guess += 5) {
          int tried = 0;
          const std::size_t found = longest_span(1, most, guess, steps, [&](std::size_t length) {
            EXPECT_GE(length, 2u);
            EXPECT_LE(length, most);
            ++tried;
            return length <= last;
          });
          ASSERT_EQ(found, last) << most << ' ' << guess;
          ASSERT_LE(tried, 24) << most << ' ' << guess << ": neither walks";
        }
}

TEST(span_search, a_coarse_search_is_within_its_fraction) {
  for (std::size_t last = 1; last < 5000; last = last * 5 / 4 + 1) {
    const std::size_t found =
        longest_span(1, 5000, 32, {.coarseness = 64}, [&](std::size_t length) { return length <= last; });
    EXPECT_LE(found, last);
    EXPECT_GE(found + 1 + found / 64, last) << found;
  }
}

TEST(span_search, even_ends_share_the_difficulty) {
  const std::vector<std::size_t> ends{0, 100, 200};
  EXPECT_EQ(even_ends(ends, std::vector<double>{1, 1}, 4), (std::vector<std::size_t>{0, 50, 100, 150, 200}));
  EXPECT_EQ(even_ends(ends, std::vector<double>{3, 1}, 2), (std::vector<std::size_t>{0, 67, 200}));
  // Three points have room for two spans.
  EXPECT_EQ(even_ends(std::vector<std::size_t>{0, 2}, std::vector<double>{1}, 5), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(span_search, halves_each_span_once) {
  const std::vector<std::size_t> ends{0, 10, 11, 31};
  EXPECT_EQ(halved(ends, std::vector<std::size_t>{2, 0, 2, 1}), (std::vector<std::size_t>{0, 5, 10, 11, 21, 31}));
}

// Spans of a path whose error grows with the square of their length: the fewest hold evenly.
TEST(span_search, removes_spans_until_even_ones_fail) {
  const auto attempt = [](std::vector<std::size_t> ends) {
    SpanTrial trial{.ends = std::move(ends)};
    for (std::size_t k = 0; k + 1 < trial.ends.size(); ++k) {
      const double length = static_cast<double>(trial.ends[k + 1] - trial.ends[k]);
      trial.difficulties.push_back(length);
      trial.strain = std::max(trial.strain, length * length / 2500);
    }
    trial.holds = trial.strain <= 1;
    return trial;
  };
  SpanTrial trial = attempt({0, 20, 70, 90, 110, 140, 190, 200});
  ASSERT_TRUE(trial.holds);
  int mended = 0;
  remove_spans(trial, 3, attempt, [&](SpanTrial& least) {
    EXPECT_GT(least.strain, 1);
    ++mended;
    return false;
  });
  EXPECT_TRUE(trial.holds);
  EXPECT_EQ(trial.ends, (std::vector<std::size_t>{0, 50, 100, 150, 200}));
  EXPECT_EQ(mended, 1);
}

}  // namespace span_search_test
}  // namespace coaster::curve
