// The paper's errata on the track: each wrong claim next to the correct value, for one segment. Panels show the list;
// the queries `erratum NAME` (correct) and `erratum_wrong NAME` (claimed) read it. The claims about single curves are
// computed in curve/paper_errata.h.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "sim/shape/derived_track.h"

namespace coaster::sim {

struct Erratum {
  std::string_view name;   // as in scripts, see kErrata
  std::string_view claim;  // the paper's claim
  double wrong = 0;        // the claimed value, in wrong_unit
  std::string_view wrong_unit;
  double right = 0;  // the correct value, in unit
  std::string_view unit;
  std::string_view explanation;  // the correct statement, one or two sentences
};

// gravesen: m^2 against m.  line: B(0) + i dB is off by 0 m, against the distance.  frozen: metres that a cart at rest
// on the segment's steepest place moves in kFrozenTicks, by the paper's method and by Runge-Kutta.  g_step: jump of the
// felt force at the segment's rougher joint at `speed`, 0 g for C1 and the actual one.  frenet_flip: degrees that the
// Frenet-Serret normal (wrong) turns within 1/32 of the segment at the sharpest place; 0, by definition, for a
// rotation-minimising one (right). pen: metres that the curve leaves the lines between its control points, 0 and the
// actual distance.
inline constexpr std::array<std::string_view, 6> kErrata{"gravesen", "line", "frozen", "g_step", "frenet_flip", "pen"};
inline constexpr int kFrozenTicks = 60;  // half a second

// Returns the six errata of one segment, in the order of kErrata; takes under 1 ms. `speed` in m/s (for g_step),
// `steps` of the polyline (for line). The segment must be in derived.order.
std::array<Erratum, kErrata.size()> errata(const DerivedTrack& derived, world::Entity segment, double speed, int steps);

// Returns one erratum; nothing for an unknown name.
std::optional<Erratum> erratum(const DerivedTrack& derived, world::Entity segment, double speed, int steps,
                               std::string_view name);

// Returns v^2 |dK| / g: the jump in g of the force on a rider who passes a jump of the curvature vector of `jump` 1/m
// at `speed` m/s.
double g_step(double jump, double speed);

}  // namespace coaster::sim
