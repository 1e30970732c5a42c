// The solids of supports.

#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr int kSides = 10;

// Adds a concrete footing slightly above the ground, and the plate that the bar is bolted to.
void add_footing(dvec3 at, double radius, Mesh& mesh) {
  constexpr double kHeight = 0.22, kPlate = 0.05;
  const double wide = 1.7 * radius + 0.16, plate = 1.25 * radius + 0.06;
  const dvec3 top = at + dvec3(0, kHeight, 0);
  add_bar(at, top, 1.06 * wide, wide, kSides, Part::concrete, 0, false, mesh);
  add_bar(top, top + dvec3(0, kPlate, 0), plate, plate, kSides, Part::support, 0, false, mesh);
}

void add_collar(const Ring& hold, Mesh& mesh) {
  constexpr double kHalf = 0.10, kThick = 0.05;
  Ring ends[2] = {hold, hold};
  ends[0].position -= kHalf * hold.frame.forward, ends[1].position += kHalf * hold.frame.forward;
  add_tube(ends, {{0, -kSpineDrop}, kSpineRadius + kThick, kSpineSides, kSpineSides / 3, Part::tie}, mesh);
}

}  // namespace

void build_support_mesh(const SegmentSupports& supports, Mesh& mesh) {
  mesh.clear();
  for (const Bar& bar : supports.bars) {
    const dvec3 from(bar.from), to(bar.to);
    const auto from_radius = static_cast<double>(bar.from_radius), to_radius = static_cast<double>(bar.to_radius);
    // At another bar it ends slightly farther on, so that there is no notch. A leaning leg ends inside its footing.
    const double length = glm::length(to - from), over = bar.grounded ? -0.15 : 0.5 * to_radius;
    add_bar(from, length > 0.2 ? to + over / length * (to - from) : to, from_radius, to_radius, kSides, Part::support,
            0, true, mesh);
    if (bar.grounded) add_footing(to, to_radius, mesh);
  }
  for (const Ring& hold : supports.holds) add_collar(hold, mesh);
}

}  // namespace coaster::sim
