// Heights of a way home over its length in plan: slopes that change smoothly from the open end's to the first knot's.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace coaster::sim {

// The slope (m per metre in plan) goes from one value to another as 35v^4 - 84v^5 + 70v^6 - 20v^7 over the length, so
// that the curvature, its rate and the slope of that are 0 at both ends, and the roll in a turn follows it smoothly.
struct HeightPiece {
  double length = 0, from = 0, to = 0;
};

struct Heights {
  double start = 0;  // m
  std::array<HeightPiece, 7> pieces{};
  std::size_t count = 0;

  // Ignores pieces of zero length.
  void add(double length, double from, double to);
  double length() const;
  std::vector<double> breaks() const;  // m from the start, ascending
  struct At {
    double height, slope, change;  // m; its derivatives by the length in plan
  };
  At at(double u) const;
};

struct HeightLimits {
  double crest = 30, valley = 30;  // m, least radii
  double steepest = 0.6;           // slope of the parts between bends
};

struct HeightEnds {
  double length;    // m in plan
  double from, to;  // m
  double slope_from, slope_to;
};

// Returns heights of one constant slope; nothing if it would be steeper than the limit or there is no space for the
// bends.
std::optional<Heights> steady_heights(const HeightEnds& ends, const HeightLimits& limits);
// Returns heights that climb or descend to a level, stay there, and go on to the end; nothing if there is no space for
// that.
std::optional<Heights> heights_by_way_of(double level, const HeightEnds& ends, const HeightLimits& limits);

}  // namespace coaster::sim
