// Numbers as text.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <type_traits>

#include "base/text.h"

namespace coaster::base {
namespace number_text_test {

template <class T>
using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

template <class T>
std::optional<T> parse(std::string_view text) {
  if constexpr (std::is_same_v<T, float>) return parse_float(text);
  else return parse_double(text);
}

TEST(number_text, the_shorter_of_fixed_and_scientific_is_printed) {
  EXPECT_EQ(to_text(0.0f), "0");
  EXPECT_EQ(to_text(-0.0), "-0");
  EXPECT_EQ(to_text(0.1f), "0.1");
  EXPECT_EQ(to_text(-61.375), "-61.375");
  EXPECT_EQ(to_text(0.001), "0.001");
  EXPECT_EQ(to_text(0.0001), "1e-04");     // one character shorter than "0.0001"
  EXPECT_EQ(to_text(0.00012), "0.00012");  // as long as "1.2e-04": fixed
  EXPECT_EQ(to_text(10000.0), "10000");    // as long as "1e+04": fixed
  EXPECT_EQ(to_text(100000.0), "1e+05");
  EXPECT_EQ(to_text(16777216.0f), "16777216");
  EXPECT_EQ(to_text(123456789012.0f),
            "123456790528");  // all digits exact, not only those that distinguish it from its neighbours
  EXPECT_EQ(to_text(1152921504606846976.0), "1152921504606846976");
  EXPECT_EQ(to_text(1.2345e-300), "1.2345e-300");
  EXPECT_EQ(to_text(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
  EXPECT_EQ(to_text(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(to_text(std::numeric_limits<float>::denorm_min()), "1e-45");
}

TEST(number_text, what_is_no_finite_number_is_refused) {
  for (const char* text :
       {"", "nan", "inf", "-inf", "1e999", "+1", " 1", "1 ", "0x10", "1,5", "--1", "1.5.2", ".", "1e", "1e-999"})
    EXPECT_FALSE(parse_double(text)) << text;
  EXPECT_FALSE(parse_float("1e39"));
  EXPECT_FALSE(parse_float("-1e-46"));
  EXPECT_EQ(parse_double("1e39"), 1e39);
  EXPECT_EQ(parse_double("-.5E1"), -5.0);
  EXPECT_EQ(parse_double("0e999"), 0.0);
  EXPECT_FALSE(parse_int("1.5"));
  EXPECT_FALSE(parse_int("9223372036854775808"));
  EXPECT_EQ(parse_int("-12"), -12);
}

RC_GTEST_PROP(number_text, every_finite_float_reads_back_to_the_same_bits, (std::uint32_t bits)) {
  const float value = std::bit_cast<float>(bits);
  RC_PRE(std::isfinite(value));
  RC_ASSERT(std::bit_cast<std::uint32_t>(parse_float(to_text(value)).value()) == bits);
}

RC_GTEST_PROP(number_text, every_finite_double_reads_back_to_the_same_bits, (std::uint64_t bits)) {
  const double value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  RC_ASSERT(std::bit_cast<std::uint64_t>(parse_double(to_text(value)).value()) == bits);
}

// The standard library's functions are the oracle where it has them.
#ifdef __cpp_lib_to_chars

// Random values of each kind; NUMBER_TEXT_TRIES in the environment sets their number: ten million take ten minutes.
int tries() {
  const char* const told = std::getenv("NUMBER_TEXT_TRIES");
  return told ? std::atoi(told) : 5'000;
}

template <class T>
void expect_same_reading(std::string_view text) {
  std::optional<T> expected{T{}};
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = std::from_chars(text.data(), end, *expected);
  if (code != std::errc{} || stopped != end || !std::isfinite(*expected)) expected.reset();
  const std::optional<T> found = parse<T>(text);
  ASSERT_EQ(found.has_value(), expected.has_value()) << text;
  ASSERT_EQ(std::bit_cast<Bits<T>>(found.value_or(T{})), std::bit_cast<Bits<T>>(expected.value_or(T{}))) << text;
}

template <class T>
void expect_same_text(T value) {
  char buffer[64];
  const std::string_view expected(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  ASSERT_EQ(to_text(value), expected);
  expect_same_reading<T>(expected);
}

// Both ends of every power of two, and their neighbours.
template <class T>
void compare_exponents() {
  constexpr int mantissa = std::numeric_limits<T>::digits - 1;
  constexpr Bits<T> sign = Bits<T>{1} << (sizeof(T) * 8 - 1), one = 1;
  for (Bits<T> exponent = 0; exponent < sign >> mantissa; ++exponent)
    for (const Bits<T> bits :
         {one * 0, one, one * 2, one << (mantissa - 1), (one << mantissa) - 2, (one << mantissa) - 1}) {
      expect_same_text(std::bit_cast<T>(exponent << mantissa | bits));
      expect_same_text(std::bit_cast<T>(sign | exponent << mantissa | bits));
    }
}

TEST(number_text, every_exponent_is_as_the_standard_library_has_it) {
  compare_exponents<float>();
  compare_exponents<double>();
}

template <class T>
void compare_random() {
  std::mt19937_64 random(5);
  constexpr int mantissa = std::numeric_limits<T>::digits - 1;
  for (int i = 0; i < tries() && !testing::Test::HasFatalFailure(); ++i) {
    expect_same_text(std::bit_cast<T>(static_cast<Bits<T>>(random())));
    expect_same_text(std::bit_cast<T>(static_cast<Bits<T>>(random()) >> (sizeof(T) * 8 - mantissa)));  // subnormal
    expect_same_text(static_cast<T>(static_cast<double>(random() % 20'000'000) / 1000 - 10'000));      // few decimals
    expect_same_text(static_cast<T>(random() >> (random() % 64)));                                     // whole
  }
}

TEST(number_text, random_numbers_are_as_the_standard_library_has_them) {
  compare_random<float>();
  compare_random<double>();
}

// Around the largest and the smallest number, many digits, and texts with a wrong character here and there.
TEST(number_text, texts_are_read_as_the_standard_library_reads_them) {
  for (int exponent = -420; exponent <= 420; ++exponent)
    for (const char* digits :
         {"1", "-9", "4.9", "2.4", "2.5", "7.0", "7.1", "17.976931348623158", "17.976931348623159", "3.4028235",
          "3.4028236", "0", "-0.0", ".5", "5.", "1234567890123456789012345678901234567890",
          "0.00000000000000000000000000000000000000000000000000000000000000000001"}) {
      const std::string text = digits + ("e" + std::to_string(exponent));
      expect_same_reading<float>(text);
      expect_same_reading<double>(text);
    }
  for (const char* text : {"1e+05",
                           "1E5",
                           "1e+",
                           "1e-",
                           "e5",
                           "1.e5",
                           ".e5",
                           "-.",
                           "-",
                           "1..2",
                           "1_0",
                           "00012",
                           "1e5.",
                           "0.1e",
                           "infinity",
                           "nan(1)",
                           "1e99999999999999999999",
                           "1e-99999999999999999999",
                           "0e99999999999999999999",
                           "2.4703282292062327e-324",
                           "2.4703282292062328e-324",
                           "7.0064923216240853e-46",
                           "7.0064923216240854e-46"}) {
    expect_same_reading<float>(text);
    expect_same_reading<double>(text);
  }
  std::mt19937_64 random(6);
  for (int i = 0; i < tries(); ++i) {
    std::string text = to_text(std::bit_cast<double>(random()));
    for (std::uint64_t wrong = random() % 3; wrong < 3; ++wrong)
      text[random() % text.size()] = "0123456789.e+-E x"[random() % 17];
    expect_same_reading<float>(text);
    expect_same_reading<double>(text);
  }
}

#endif

}  // namespace number_text_test
}  // namespace coaster::base
