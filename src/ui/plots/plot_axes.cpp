// Ranges, positions and ticks.
#include "ui/plots/plot_axes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace coaster::ui {
namespace {

constexpr double kLargest = 1e300;  // beyond it, spans of ranges would overflow

std::string superscript(int exponent) {
  static constexpr const char* kDigits[] = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                            "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "\u207B" : "";
  for (const char c : std::to_string(std::abs(exponent))) text += kDigits[c - '0'];
  return text;
}

// Returns mantissa x 10^exponent, for a finite value that is not zero.
std::string scientific(double value, int digits, bool pretty) {
  const std::string plain = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = plain.find('e');
  std::string mantissa = plain.substr(0, e);
  if (mantissa.find('.') != std::string::npos) {
    while (mantissa.back() == '0') mantissa.pop_back();
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  const int exponent = std::atoi(plain.c_str() + e + 1);
  if (!pretty) return fmt::format("{}e{}", mantissa, exponent);
  const std::string power = "10" + superscript(exponent);
  return mantissa == "1" ? power : mantissa == "-1" ? "-" + power : fmt::format("{}\u00B7{}", mantissa, power);
}

// Returns the smallest of 1, 2, 5 times a power of ten that is at least `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

Ticks linear_ticks(const AxisRange& axis, int most) {
  const double span = axis.high - axis.low, slack = 1e-9 * span;
  const auto multiples = [&](double step) {
    Ticks result{.step = step};
    for (double i = std::ceil((axis.low - slack) / step); i * step <= axis.high + slack; ++i)
      result.major.push_back(i == 0 ? 0 : i * step);  // no -0
    return result;
  };
  const auto count = [](const Ticks& ticks) { return static_cast<int>(ticks.major.size()); };
  // Steps below the spacing of doubles at this magnitude would repeat the same number.
  const double finest = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(axis.low), std::abs(axis.high));
  Ticks result = multiples(round_step(std::max({span / most, finest, 1e-300})));
  if (count(result) > most) result = multiples(round_step(result.step * 1.5));  // both ends are ticks
  // One number does not show the scale, so a finer step is used and its outer two ticks are labelled.
  for (double step = result.step; count(result) < 2 && step >= 2.5 * finest;)
    result = multiples(step = round_step(step / 2.5));
  if (count(result) > most) result.major = {result.major.front(), result.major.back()};
  return result;
}

Ticks logarithmic_ticks(const AxisRange& axis, int most) {
  Ticks result;
  const auto within = [&](double value) { return value >= axis.low * (1 - 1e-9) && value <= axis.high * (1 + 1e-9); };
  const int first = static_cast<int>(std::floor(std::log10(axis.low) + 1e-9)),
            last = static_cast<int>(std::ceil(std::log10(axis.high) - 1e-9));
  const auto labelled = [&](int e, int every) { return (e % every + every) % every == 0 && within(std::pow(10.0, e)); };
  const auto count = [&](int every) {
    int found = 0;
    for (int e = first; e <= last; ++e) found += labelled(e, every) ? 1 : 0;
    return found;
  };
  int every = 1;
  while (count(every) > most) ++every;
  const bool few = 3 * std::log10(axis.high / axis.low) + 1 <= most;  // space for 2 and 5 too
  for (int e = first; e <= last; ++e) {
    const double power = std::pow(10.0, e);
    for (int factor = 1; factor <= 9; ++factor) {
      const double value = factor * power;
      if (!within(value)) continue;
      const bool major = (e % every + every) % every == 0 && (factor == 1 || (few && (factor == 2 || factor == 5)));
      if (major) result.major.push_back(value);
      else if (every == 1 || factor == 1) result.minor.push_back(value);
    }
  }
  return result;
}

}  // namespace

void Extent::add(double value, AxisScale scale) {
  if (!std::isfinite(value) || (scale == AxisScale::logarithmic && value <= 0)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

AxisRange fit(const Extent& extent, AxisScale scale, double margin) {
  if (scale == AxisScale::logarithmic) {
    if (extent.empty()) return {0.1, 1, scale};
    double high = std::log10(std::clamp(extent.high, 1e-280, kLargest)),
           low = std::log10(std::clamp(extent.low, 1e-280, kLargest));
    low = std::max(low, high - kMostDecades);
    const double air = margin * (high - low) + std::max(0.0, 1 - (high - low)) * 0.5;
    return {std::pow(10.0, low - air), std::pow(10.0, high + air), scale};
  }
  if (extent.empty()) return {0, 1, scale};
  const double low = std::clamp(extent.low, -kLargest, kLargest), high = std::clamp(extent.high, -kLargest, kLargest);
  const double size = std::max(std::abs(low), std::abs(high));
  const bool flat = high - low <= 1e-12 * size || high == low;
  const double air = flat ? std::max(0.05 * size, size == 0 ? 0.5 : 0.0) : margin * (high - low);
  return {low - air, high + air, scale};
}

AxisRange widened(const AxisRange& range, double span) {
  if (range.high - range.low >= span) return range;
  const double middle = (range.low + range.high) / 2;
  return {middle - span / 2, middle + span / 2, range.scale};
}

double part_of(const AxisRange& axis, double value) {
  if (axis.scale == AxisScale::linear) return (value - axis.low) / (axis.high - axis.low);
  if (value == 0) return 0;
  return std::log(value / axis.low) / std::log(axis.high / axis.low);  // NaN for negative values
}

double value_at(const AxisRange& axis, double part) {
  part = std::clamp(part, 0.0, 1.0);
  if (part == 1) return axis.high;
  if (axis.scale == AxisScale::linear) return axis.low + part * (axis.high - axis.low);
  return axis.low * std::pow(axis.high / axis.low, part);
}

Ticks ticks(const AxisRange& axis, int most) {
  most = std::max(most, 2);
  return axis.scale == AxisScale::linear ? linear_ticks(axis, most) : logarithmic_ticks(axis, most);
}

std::string tick_text(const AxisRange& axis, const Ticks& all, double value, bool pretty) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (axis.scale == AxisScale::logarithmic)
    return size >= 0.00999 && size <= 1000.1 ? significant(value, 1, pretty) : scientific(value, 1, pretty);
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  if (largest >= 1e6 || all.step < 1e-4) {
    const int digits =
        1 +
        std::max(0, static_cast<int>(std::floor(std::log10(size) + 1e-9) - std::floor(std::log10(all.step) + 1e-9)));
    return scientific(value, std::min(digits, 17), pretty);
  }
  return fmt::format("{:.{}f}", value, std::max(0, -static_cast<int>(std::floor(std::log10(all.step) + 1e-9))));
}

std::string significant(double value, int digits, bool pretty) {
  if (std::isnan(value)) return "--";
  if (std::isinf(value)) return value < 0 ? "-\u221E" : "\u221E";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e6) return scientific(value, digits, pretty);
  const int leading = static_cast<int>(std::floor(std::log10(size)));
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - leading));
}

}  // namespace coaster::ui
