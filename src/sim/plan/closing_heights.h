// Heights and roll along a closing section in plan: heights rise and fall by slopes without a step of curvature, and
// roll that an end has and the way itself does not fades.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace coaster::sim {

// The first cubic of a fade takes this length, at most a sixth of the whole, to change from the end's roll to the
// fade's own.
inline constexpr double kFadeTaper = 2.0;  // m

// An angle, its rate and the slope of its rate, all of which are 0 after a length. Three cubics whose second
// derivatives join: one span for each represents it (sim/shape/roll.h).
class RollFade {
 public:
  // Begins with an angle (rad), a spin (rad/m) and a slope (rad/m^2). `length`: m, positive.
  RollFade(double length, double angle, double spin, double slope);
  double angle(double s) const;  // rad at s in [0, length()] m
  double spin(double s) const;   // rad/m, its derivative by s
  double slope(double s) const;  // rad/m^2, its second derivative: linear between the joints
  double length() const { return nodes_.back().s; }
  double first_joint() const { return nodes_[1].s; }  // m, where its cubics join
  double second_joint() const { return nodes_[2].s; }

 private:
  struct Node {
    double s, angle, spin, slope;
  };
  struct Part {
    const Node& from;
    double u, change;  // m from there; rad/m^3, derivative of the slope
  };
  Part part_at(double s) const;
  std::array<Node, 4> nodes_;
};

// Returns the length in m of a fade at a squared speed (m^2/s^2): it rolls by at most about 1 rad/s, with an angular
// acceleration of at most about 3 rad/s^2, not counting that of the end's own slope over the first cubic. At least 12
// m.
double fade_length(double angle, double slope, double square);
// Returns the slope in rad/m^2 for which fade_length() returns that length.
double fade_slope(double length, double square);

// The slope (m per metre in plan) goes from one value to another as 35v^4 - 84v^5 + 70v^6 - 20v^7 over the length, so
// that the curvature, its rate and the slope of that are 0 at both ends, and the roll in a turn follows it smoothly.
struct HeightPiece {
  double length = 0, from = 0, to = 0;
};

struct HeightProfile {
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
std::optional<HeightProfile> steady_heights(const HeightEnds& ends, const HeightLimits& limits);
// Returns heights that climb or descend to a level, stay there, and go on to the end; nothing if there is no space for
// that.
std::optional<HeightProfile> heights_by_way_of(double level, const HeightEnds& ends, const HeightLimits& limits);

}  // namespace coaster::sim
