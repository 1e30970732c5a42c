// A thin layer over fmt and fast_float, because not every standard library has std::to_chars and std::from_chars for
// floating point. fmt prints the same shortest digits but chooses between fixed and scientific notation differently;
// fast_float reads the same numbers, but some versions return infinity or zero without an error for numbers out of
// range.
#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "base/text.h"

namespace coaster::base {
namespace {

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = fast_float::from_chars(text.data(), end, value);
  if (code != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  if (value == 0 && digits.find_first_of("123456789") != std::string_view::npos) return std::nullopt;
  return value;
}

// A number other than zero, without its sign, as d.ddd * 10^power.
struct Decimal {
  std::string digits;  // without leading and trailing zeros
  int power = 0;
};

// `text` is in fixed or scientific form.
Decimal decimal(std::string_view text) {
  Decimal result;
  const std::size_t mark = std::min(text.find('e'), text.size());
  const std::size_t point = std::min(text.find('.'), mark);
  const std::size_t first = text.find_first_of("123456789");
  if (mark < text.size()) result.power = std::atoi(text.data() + mark + 1);
  result.power += static_cast<int>(point) - static_cast<int>(first) - (first < point ? 1 : 0);
  for (const char c : text.substr(first, mark - first))
    if (c != '.') result.digits += c;
  result.digits.erase(result.digits.find_last_not_of('0') + 1);
  return result;
}

template <class T>
std::string print_number(T value) {
  std::string text = fmt::format("{}", value);
  if (!std::isfinite(value) || value == 0) return text;
  const auto [digits, power] = decimal(text);
  const int count = static_cast<int>(digits.size()), whole = power + 1;  // all digits, and those before the point
  const int fixed_size = whole >= count ? whole : whole > 0 ? count + 1 : count + 2 - whole;
  const int scientific_size = count + (count > 1 ? 1 : 0) + (std::abs(power) < 100 ? 4 : 5);
  const std::string_view sign = value < 0 ? "-" : "";
  if (fixed_size > scientific_size)
    return fmt::format("{}{}{}{}e{:+03}", sign, digits[0], count > 1 ? "." : "", std::string_view(digits).substr(1),
                       power);
  if (whole >= count) return fmt::format("{:.0f}", value);
  if (text.find('e') == std::string::npos) return text;
  if (whole > 0) return fmt::format("{}{}.{}", sign, digits.substr(0, whole), digits.substr(whole));
  return fmt::format("{}0.{:0>{}}", sign, digits, count - whole);
}

}  // namespace

std::optional<double> parse_double(std::string_view text) { return parse_number<double>(text); }
std::optional<float> parse_float(std::string_view text) { return parse_number<float>(text); }

std::optional<std::int64_t> parse_int(std::string_view text) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = std::from_chars(text.data(), end, value);
  if (code != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

bool is_number(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, code] = fast_float::from_chars(text.data(), end, value);
  return code != std::errc::invalid_argument && stopped == end;
}

std::string to_text(float value) { return print_number(value); }
std::string to_text(double value) { return print_number(value); }

}  // namespace coaster::base
