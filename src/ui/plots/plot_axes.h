// Arithmetic of plot axes: ranges that fit data, conversion between values and positions, round ticks and their labels.
// Draws nothing.
#pragma once

#include <limits>
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

// Range of the values added so far that are finite (and positive on a logarithmic axis).
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value, AxisScale scale);
  bool empty() const { return !(low <= high); }
};

// Returns a valid range that contains the extent, plus `margin` (a fraction of the span) on both sides. A linear range
// of a single value is widened around it; a logarithmic one spans at least a decade and at most kMostDecades. An empty
// extent gives 0..1, or 0.1..1 on a logarithmic axis.
AxisRange fit(const Extent& extent, AxisScale scale, double margin = 0);
inline constexpr double kMostDecades = 24;
// Returns a linear range with the same middle that spans at least `span`.
AxisRange widened(const AxisRange& range, double span);

// Returns the position of a value: 0 at `low`, 1 at `high`, linear or logarithmic; outside the range below 0 or
// above 1. On a logarithmic axis zero is at 0 (the lower edge). NaN for negative values and NaN.
double part_of(const AxisRange& axis, double value);
// The inverse of part_of() within [0,1]; parts outside are clamped.
double value_at(const AxisRange& axis, double part);

struct Ticks {
  std::vector<double> major;  // with labels; ascending, within the range
  std::vector<double> minor;  // grid only: 2..9 times each power of ten
  double step = 0;            // between linear majors; 0 on a logarithmic axis
};
// Returns 2 to max(2, most) majors: multiples of 1, 2 or 5 times a power of ten; on a logarithmic axis powers of ten
// (every k-th if there are many; with 2 and 5 times them if there are few).
Ticks ticks(const AxisRange& axis, int most);

// Returns the label of a tick: as many decimals as the step needs; very large and very small numbers, and powers of ten
// beyond 0.01..1000 on a logarithmic axis, as 10 to a power, in superscripts if `pretty`, else as 1e-7.
std::string tick_text(const AxisRange& axis, const Ticks& ticks, double value, bool pretty);

// Returns a number with `digits` significant digits, without an exponent from 1e-4 to 1e6; "--" for NaN, "0" for zero.
std::string significant(double value, int digits, bool pretty = true);

}  // namespace coaster::ui
