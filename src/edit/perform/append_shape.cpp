// Shapes of appended knots.
#include "edit/perform/append_shape.h"

#include <algorithm>

#include "curve/frames.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using world::Knot;

// Smooth between two positions, either of which may be missing: the automatic shape with the mean of its two lengths.
void shape_smooth(Knot& knot, const glm::vec3* before, const glm::vec3* after) {
  world::shape_between(knot, before, after);
  equalise(knot);
}

bool same_shape(const Knot& a, const Knot& b) {
  return a.joint == b.joint && a.tangent == b.tangent && a.in_length == b.in_length && a.out_length == b.out_length;
}

}  // namespace

void equalise(Knot& knot) {
  knot.in_length = knot.out_length = static_cast<float>((double{knot.in_length} + double{knot.out_length}) / 2);
}

Knot appended_knot(const world::Document& document, glm::vec3 position) {
  Knot knot;
  knot.position = position;
  if (document.track.knots.empty()) return knot;
  const Knot& last = world::knot(document, document.track.knots.back());
  const glm::dvec3 chord = glm::dvec3(position) - glm::dvec3(last.position);
  if (glm::length(chord) < double{world::kMinHandle}) {
    const glm::vec3 level(last.tangent.x, 0, last.tangent.z);
    world::set_tangent(knot, level);
  } else {
    shape_smooth(knot, &last.position, nullptr);
  }
  knot.up = glm::vec3(curve::perpendicular(glm::normalize(glm::dvec3(knot.tangent)), {0, 1, 0}));
  return knot;
}

void reshape_end(world::Document& document, bool last, glm::vec3 beyond) {
  const auto& order = document.track.knots;
  if (order.empty()) return;
  Knot& knot = document.entities.get<Knot>(last ? order.back() : order.front());
  Knot untouched = knot;
  untouched.joint = world::JointKind::smooth;
  const glm::vec3* beside = nullptr;
  if (order.size() == 1) {
    untouched.tangent = Knot{}.tangent;
    untouched.in_length = untouched.out_length = Knot{}.in_length;
  } else {
    beside = &world::knot(document, order[last ? order.size() - 2 : 1]).position;
    shape_smooth(untouched, last ? beside : nullptr, last ? nullptr : beside);
  }
  if (!same_shape(knot, untouched)) return;
  if (last) shape_smooth(knot, beside, &beyond);
  else shape_smooth(knot, &beyond, beside);
}

void close_by_segment(world::Document& document, double longest) {
  const world::Entity first = document.track.knots.front(), last = document.track.knots.back();
  reshape_end(document, true, world::knot(document, first).position);
  reshape_end(document, false, world::knot(document, last).position);
  world::set_closed(document, true);
  Knot &start = document.entities.get<Knot>(first), &end = document.entities.get<Knot>(last);
  const double gap = glm::distance(glm::dvec3(end.position), glm::dvec3(start.position));
  const float third = world::as_handle(gap / 3);
  for (float* const handle : {&start.in_length, &end.out_length})
    if (double{*handle} > longest * gap) *handle = third;
  for (Knot* const knot : {&start, &end})
    if (knot->in_length != knot->out_length && knot->joint == world::JointKind::smooth)
      knot->joint = world::JointKind::aligned;
}

}  // namespace coaster::edit
