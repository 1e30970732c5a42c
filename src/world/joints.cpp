// Maintains joints: equal handle lengths if smooth, the shape given by the neighbours if automatic.
#include "world/topology.h"

namespace coaster::world {
namespace {

double chord(glm::vec3 a, glm::vec3 b) { return glm::length(glm::dvec3(b) - glm::dvec3(a)); }

float third(double length) { return as_handle(length / 3.0); }

}  // namespace

void shape_between(Knot& knot, const glm::vec3* before, const glm::vec3* after) {
  if (!before && !after) return;
  // In double: float differences of distant positions would lose the direction of short chords.
  const glm::dvec3 start(before ? *before : knot.position), end(after ? *after : knot.position);
  set_tangent(knot, glm::vec3(end - start));
  knot.in_length = third(before ? chord(*before, knot.position) : chord(knot.position, *after));
  knot.out_length = third(after ? chord(knot.position, *after) : chord(*before, knot.position));
}

void settle_joints(Document& document) {
  const Track& track = document.track;
  const std::size_t count = track.knots.size();
  auto& knots = document.entities.pool<Knot>();
  bool any_automatic = false;
  for (Knot& k : knots.items()) {
    any_automatic = any_automatic || k.joint == JointKind::automatic;
    if (k.joint == JointKind::smooth && k.in_length != k.out_length) k.in_length = k.out_length;
  }
  if (!any_automatic) return;
  const auto position = [&](std::size_t i) { return &knots.get(track.knots[i]).position; };
  for (std::size_t i = 0; i < count; ++i) {
    Knot& k = knots.get(track.knots[i]);
    if (k.joint != JointKind::automatic) continue;
    const glm::vec3* const before = i > 0 ? position(i - 1) : track.closed ? position(count - 1) : nullptr;
    const glm::vec3* const after = i + 1 < count ? position(i + 1) : track.closed ? position(0) : nullptr;
    shape_between(k, before, after);
  }
}

}  // namespace coaster::world
