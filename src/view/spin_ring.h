// The ring about the selected knot whose handle sets its spin. Constant size on screen.
#pragma once

#include <optional>

#include "view/overlay.h"

namespace coaster::view {

inline constexpr float kSpinRadius = 92;     // px at UI scale 1, outside the gizmo's arrows
inline constexpr double kSpinAhead = 5;      // m: the handle is at the roll that the spin makes over this length
inline constexpr double kSpinMost_deg = 36;  // deg/m, at the ring's far side; larger spins show there

struct SpinRing {
  world::Entity knot;
  glm::dvec3 centre{0}, tangent{1, 0, 0}, up{0, 1, 0};  // m; unit
  double radius = 1;                                    // m
  double spin = 0;                                      // rad/m
  // Returns the point of the ring at an angle (rad) from `up`, positive to the rider's right.
  glm::dvec3 at(double angle) const;
  glm::dvec3 handle() const;
};

// Returns nothing unless one knot is selected and the gizmo is shown (view/gizmo.h).
std::optional<SpinRing> spin_ring_of(const world::Document& document, const world::Settings& settings,
                                     const View& view);

// Returns the spin (rad/m) whose handle is nearest to a ray; nothing if the ring is seen edge-on.
std::optional<double> spin_under(const SpinRing& ring, const Ray& ray);

// Adds the ring, and an arc from `up` to the handle.
void add_spin_ring(const SpinRing& ring, float scale, Overlay& overlay);

}  // namespace coaster::view
