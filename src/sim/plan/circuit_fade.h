// How roll that an end of a way home has, and the way itself has not, fades out along it.
#pragma once

#include <array>

namespace coaster::sim {

// Over the first of its cubics what an end's roll does changes to the fade's own, over a sixth of the length at most.
inline constexpr double kFadeTaper = 2.0;  // m

// An angle, its rate and the slope of its rate, of which all three are 0 after a length. Three cubics whose second
// derivatives join: a span for each represents it (sim/shape/roll.h).
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

// Returns the length in m of a fade at a squared speed (m^2/s^2): it rolls by at most about 1 rad/s, and pushes by at
// most about 3 rad/s^2, without what the end's own slope pushes over the first cubic. At least 12 m.
double fade_length(double angle, double slope, double square);
// Returns the slope in rad/m^2 that takes that length.
double fade_slope(double length, double square);

}  // namespace coaster::sim
