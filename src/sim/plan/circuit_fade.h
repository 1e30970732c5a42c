// The fade of roll along a way home: roll that an end has and the way itself does not.
#pragma once

#include <array>

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

}  // namespace coaster::sim
