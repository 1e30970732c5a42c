// The arithmetic of a plot's axes: ranges that fit data, values to places and back, round ticks and their texts. No
// drawing.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace coaster::ui {

enum class AxisScale : unsigned char { linear, logarithmic };

// low < high, both finite; a logarithmic axis has low > 0.
struct AxisRange {
  double low = 0, high = 1;
  AxisScale scale = AxisScale::linear;
  friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

// What is finite (and on a logarithmic axis positive) of the values seen so far.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value, AxisScale scale);
  void add(std::span<const double> values, AxisScale scale);
  bool empty() const { return !(low <= high); }
};

// A valid range that holds the extent, with `margin` (a part of the span) of air on both sides. A linear range of one
// value is widened about it; a logarithmic one spans at least a decade and at most kMostDecades below its top. An empty
// extent gives 0..1, or 0.1..1.
AxisRange fit(const Extent& extent, AxisScale scale, double margin = 0);
inline constexpr double kMostDecades = 24;

// 0 at `low`, 1 at `high`, linear or in the logarithm; beyond the ends below 0 and above 1. On a logarithmic axis zero
// is at 0 (the lower edge); negative values and NaN have no place: NaN.
double part_of(const AxisRange& axis, double value);
// The inverse of part_of() within [0,1]; parts outside are clamped.
double value_at(const AxisRange& axis, double part);

struct Ticks {
  std::vector<double> major;  // with a text; ascending, within the range
  std::vector<double> minor;  // grid only: 2..9 times each power of ten
  double step = 0;            // between linear majors; 0 on a logarithmic axis
};
// At most max(2, most) majors: multiples of 1, 2 or 5 times a power of ten; on a logarithmic axis powers of ten (every
// k-th where there are many; with 2 and 5 times them where there are few).
Ticks ticks(const AxisRange& axis, int most);

// The text of a tick: as many decimals as the step asks for; very large and very small numbers, and powers of ten
// beyond 0.01..1000 on a logarithmic axis, as 10 to a power, in superscripts when `pretty`, else as 1e-7.
std::string tick_text(const AxisRange& axis, const Ticks& ticks, double value, bool pretty);

// A number with `digits` significant digits, without an exponent from 1e-4 to 1e6; "--" for NaN, "0" for zero.
std::string significant(double value, int digits, bool pretty = true);

}  // namespace coaster::ui
