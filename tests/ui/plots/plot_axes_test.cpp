#include "ui/plots/plot_axes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace coaster::ui {
namespace plot_axes_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

AxisRange linear(double low, double high) { return {low, high, AxisScale::linear}; }
AxisRange logarithmic(double low, double high) { return {low, high, AxisScale::logarithmic}; }

std::vector<std::string> texts(const AxisRange& axis, int most) {
  const Ticks all = ticks(axis, most);
  std::vector<std::string> result;
  for (const double value : all.major) result.push_back(tick_text(axis, all, value, false));
  return result;
}

// Leading digit of a positive number as text "d", or "" when more digits follow.
bool is_round_step(double step) {
  const double lead = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  return std::abs(lead - 1) < 1e-6 || std::abs(lead - 2) < 1e-6 || std::abs(lead - 5) < 1e-6;
}

TEST(plot_ticks, linear_ticks_read_as_people_write_them) {
  EXPECT_EQ(texts(linear(0, 1), 6), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(texts(linear(-0.3, 0.31), 4), (std::vector<std::string>{"-0.2", "0", "0.2"}));
  EXPECT_EQ(texts(linear(97.3, 212.9), 5), (std::vector<std::string>{"100", "150", "200"}));
  EXPECT_EQ(texts(linear(0, 4.1e-7), 4), (std::vector<std::string>{"0", "2e-7", "4e-7"}));
}

TEST(plot_ticks, there_are_two_or_more_because_one_does_not_tell_the_scale) {
  EXPECT_EQ(texts(linear(0.5, 7.5), 3), (std::vector<std::string>{"2", "4", "6"})) << "of 5 there is one multiple";
  EXPECT_EQ(texts(linear(-0.5, 4.9), 2), (std::vector<std::string>{"0", "4"})) << "no space for 2";
  EXPECT_EQ(texts(linear(0.5, 1.9), 2), (std::vector<std::string>{"0.5", "1.5"}));
}

TEST(plot_ticks, a_range_is_widened_about_its_middle_to_the_least_span_and_never_narrowed) {
  EXPECT_EQ(widened(linear(0.9998, 1.0002), 0.5), linear(0.75, 1.25));
  EXPECT_EQ(widened(linear(-3, 5), 0.5), linear(-3, 5));
  EXPECT_EQ(widened(linear(2, 3), 0), linear(2, 3));
}

TEST(plot_ticks, logarithmic_ticks_are_powers_of_ten) {
  EXPECT_EQ(texts(logarithmic(1e-12, 1e-3), 4), (std::vector<std::string>{"1e-12", "1e-9", "1e-6", "1e-3"}));
  EXPECT_EQ(texts(logarithmic(0.5, 200), 12),
            (std::vector<std::string>{"0.5", "1", "2", "5", "10", "20", "50", "100", "200"}));
  EXPECT_EQ(texts(logarithmic(0.02, 900), 6), (std::vector<std::string>{"0.1", "1", "10", "100"}));
}

TEST(plot_ticks, powers_are_superscripts_where_the_font_has_them) {
  const AxisRange axis = logarithmic(1e-15, 1);
  const Ticks all = ticks(axis, 4);
  EXPECT_EQ(tick_text(axis, all, 1e-15, true), "10\u207B\u00B9\u2075");
  EXPECT_EQ(significant(-2.5e-9, 3), "-2.5\u00B710\u207B\u2079");
}

RC_GTEST_PROP(plot_ticks, ticks_lie_within_and_are_no_more_than_asked, ()) {
  const double low = *rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int v) { return v * 1.37e-3; });
  const double exponent = *rc::gen::map(rc::gen::inRange(-900, 900), [](int v) { return v * 0.01; });
  const int most = *rc::gen::inRange(2, 20);
  const AxisRange axis = linear(low, low + std::pow(10.0, exponent));
  RC_PRE(axis.high > axis.low);
  const Ticks all = ticks(axis, most);
  const double slack = 1e-6 * (axis.high - axis.low) + 1e-15 * std::abs(low);  // and the rounding of `low` itself
  RC_ASSERT(static_cast<int>(all.major.size()) <= most && all.major.size() >= 2);
  RC_ASSERT(is_round_step(all.step));
  for (const double value : all.major) RC_ASSERT(value >= axis.low - slack && value <= axis.high + slack);
  for (std::size_t i = 1; i < all.major.size(); ++i) RC_ASSERT(all.major[i] > all.major[i - 1]);
  // Never too few: the next finer round step would have exceeded the limit.
  const double span = axis.high - axis.low;
  RC_ASSERT(all.step <= 5.0 * span / most + 8 * 2.3e-16 * std::abs(axis.high) * 10);
}

RC_GTEST_PROP(plot_ticks, place_and_value_are_inverse, ()) {
  const bool log = *rc::gen::arbitrary<bool>();
  const double a = *rc::gen::map(rc::gen::inRange(1, 1000000), [](int v) { return v * 7.3e-5; });
  const double part = *rc::gen::map(rc::gen::inRange(0, 1001), [](int v) { return v * 1e-3; });
  const AxisRange axis = log ? logarithmic(a, a * 731.7) : linear(a - 3.3, a + 91.7);
  RC_ASSERT(std::abs(part_of(axis, value_at(axis, part)) - part) < 1e-12);
}

TEST(plot_ticks, zero_lies_on_the_lower_edge_of_a_logarithmic_axis_and_negatives_nowhere) {
  const AxisRange axis = logarithmic(1e-9, 1e2);
  EXPECT_EQ(part_of(axis, 0), 0);
  EXPECT_TRUE(std::isnan(part_of(axis, -1e-3)));
  EXPECT_TRUE(std::isnan(part_of(axis, kNan)));
  EXPECT_TRUE(std::isnan(part_of(linear(-1, 1), kNan)));
  EXPECT_NEAR(part_of(axis, 1e-9), 0, 1e-15);
  EXPECT_NEAR(part_of(axis, std::sqrt(1e-9 * 1e2)), 0.5, 1e-12);
}

TEST(plot_ticks, any_data_gives_a_valid_range_and_few_ticks) {
  const std::vector<std::vector<double>> sets{{},
                                              {kNan, kNan},
                                              {0},
                                              {-7.25},
                                              {1e-300, 3e-300},
                                              {-1e308, 1e308},
                                              {kInfinity, -kInfinity, 3},
                                              {1e15, 1e15 + 0.125},
                                              {0, 0, 0},
                                              {1e-320, 1e308},
                                              {-5, -2}};
  for (const auto& set : sets) {
    for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
      Extent extent;
      for (const double value : set) extent.add(value, scale);
      const AxisRange range = fit(extent, scale, 0.05);
      ASSERT_TRUE(std::isfinite(range.low) && std::isfinite(range.high));
      ASSERT_LT(range.low, range.high);
      if (scale == AxisScale::logarithmic) {
        ASSERT_GT(range.low, 0);
        EXPECT_LT(std::log10(range.high) - std::log10(range.low), kMostDecades * 1.2);
      }
      const Ticks all = ticks(range, 7);
      EXPECT_LE(all.major.size(), 7u);
      for (const double value : all.major) {
        EXPECT_TRUE(std::isfinite(value));
        EXPECT_LT(tick_text(range, all, value, false).size(), 26u);
      }
      for (const double value : set)
        if (std::isfinite(value) && std::abs(value) < 1e300 && scale == AxisScale::linear) {
          EXPECT_GE(part_of(range, value), -1e-9);
          EXPECT_LE(part_of(range, value), 1 + 1e-9);
        }
    }
  }
}

TEST(plot_ticks, significant_digits_are_as_many_as_asked) {
  EXPECT_EQ(significant(0, 3), "0");
  EXPECT_EQ(significant(kNan, 3), "--");
  EXPECT_EQ(significant(kInfinity, 3), "\u221E");
  EXPECT_EQ(significant(123.456, 4), "123.5");
  EXPECT_EQ(significant(0.0123456, 3), "0.0123");
  EXPECT_EQ(significant(999999.4, 3), "999999");
  EXPECT_EQ(significant(1.5e-7, 3, false), "1.5e-7");
}

TEST(plot_ticks, negative_numbers_read_as_their_opposites_with_a_minus) {
  for (const double value : {123.456, 0.0123456, 999999.4, 1e6, 1.5e-7, 1e-4, 0.99e-4, 1.0, 2e9})
    for (const int digits : {1, 3, 6})
      for (const bool pretty : {true, false})
        EXPECT_EQ(significant(-value, digits, pretty), "-" + significant(value, digits, pretty)) << value;
  EXPECT_EQ(significant(-kInfinity, 3), "-\u221E");
  for (const auto& [low, high] : {std::pair{0.0, 1.0}, {97.3, 212.9}, {0.0, 4.1e-7}, {1e6, 9e6}, {0.5, 7.5}}) {
    std::vector<std::string> mirrored = texts(linear(-high, -low), 5);
    std::reverse(mirrored.begin(), mirrored.end());
    for (std::string& text : mirrored)
      if (text != "0") text = text.substr(text[0] == '-' ? 1 : 0);
    EXPECT_EQ(mirrored, texts(linear(low, high), 5));
  }
}

TEST(plot_ticks, limits_between_the_ways_to_write_a_number) {
  EXPECT_EQ(significant(1e-4, 3, false), "0.000100");
  EXPECT_EQ(significant(0.99e-4, 3, false), "9.9e-5");
  EXPECT_EQ(significant(1e6, 3, false), "1e6");
  EXPECT_EQ(significant(999'999, 3, false), "999999");
  EXPECT_EQ(texts(logarithmic(0.01, 1000), 6), (std::vector<std::string>{"0.01", "0.1", "1", "10", "100", "1000"}));
  EXPECT_EQ(texts(logarithmic(0.001, 1e4), 8),
            (std::vector<std::string>{"1e-3", "0.01", "0.1", "1", "10", "100", "1000", "1e4"}));
  EXPECT_EQ(texts(linear(0, 8e5), 4).back(), "500000");
  EXPECT_EQ(texts(linear(0, 2e6), 4).back(), "2e6");
}

}  // namespace plot_axes_test
}  // namespace coaster::ui
