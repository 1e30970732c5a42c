// The paper's errata live: each wrong claim beside what holds, in numbers of one segment of the track at hand.
// Panels show the list; scripts ask `erratum NAME` (what holds) and `erratum_wrong NAME` (what the claim says).
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "sim/shape/derived.h"

namespace coaster::sim {

struct Erratum {
  std::string_view name;   // as scripts write it, see kErrata
  std::string_view claim;  // the paper's claim
  double wrong = 0;        // the number that follows from the claim, in wrong_unit
  std::string_view wrong_unit;
  double right = 0;  // the number that holds, in unit
  std::string_view unit;
  std::string_view explanation;  // what holds, one or two sentences
};

// gravesen: m^2 against m.  line: B(0) + i dB is off by 0 m, against the distance.  frozen: metres that a cart at rest
// on the segment's steepest place goes in kFrozenTicks, by the paper's method and by Runge-Kutta.  g_step: jump of the
// felt force at the segment's rougher joint at `speed`, 0 g for C1 and what it is.  frenet_flip: degrees that the
// normal turns within 1/32 of the segment at the sharpest place, Frenet-Serret (wrong) and rotation-minimising (right).
// pen: metres that the curve leaves the lines between its control points, 0 and what it is.
inline constexpr std::array<std::string_view, 6> kErrata{"gravesen", "line", "frozen", "g_step", "frenet_flip", "pen"};
inline constexpr int kFrozenTicks = 60;  // half a second

// The six of one segment, in the order of kErrata; under 1 ms. `speed` in m/s (the g-step), `steps` of the polyline
// (the line). The segment must be of derived.order.
std::array<Erratum, kErrata.size()> errata(const Derived& derived, world::Entity segment, double speed, int steps);

// One of them; nothing for an unknown name.
std::optional<Erratum> erratum(const Derived& derived, world::Entity segment, double speed, int steps,
                               std::string_view name);

// v^2 |dK| / g: the jump in g of the force on a rider who passes a jump of the curvature vector of `jump` 1/m at
// `speed` m/s.
double g_step(double jump, double speed);

}  // namespace coaster::sim
