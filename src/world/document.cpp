// Reads a document: names, control points, neighbours, length. topology.cpp changes it.
#include "world/document.h"

#include <algorithm>

#include "curve/arc_length.h"

namespace coaster::world {

Entity first_cart(const Document& document) {
  Entity first = kNone;
  EntityName least;
  for (const Entity cart : document.entities.pool<Train>().entities()) {
    const EntityName name = name_of(document, cart);
    if (!first.valid() || name < least) first = cart, least = name;
    if (least.number == 1) break;  // there is no lower one
  }
  return first;
}

Entity find(const Document& document, EntityName name) {
  const Pool<EntityName>& names = document.entities.pool<EntityName>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names.items()[i] == name) return names.entities()[i];
  return kNone;
}

EntityName name_of(const Document& document, Entity entity) { return document.entities.get<EntityName>(entity); }

std::string label_of(const Document& document, Entity entity) {
  const EntityName* const name = document.entities.find<EntityName>(entity);
  return name ? to_text(*name) : "-";
}

const Knot& knot(const Document& document, Entity e) { return document.entities.get<Knot>(e); }
const Segment& segment(const Document& document, Entity e) { return document.entities.get<Segment>(e); }

curve::Cubic cubic_of(const Document& document, Entity segment_entity) {
  const Segment& s = segment(document, segment_entity);
  const Knot &from = knot(document, s.from), &to = knot(document, s.to);
  return {from.position, out_handle(from), in_handle(to), to.position};
}

glm::vec3 in_handle(const Knot& k) { return k.position - k.tangent * k.in_length; }
glm::vec3 out_handle(const Knot& k) { return k.position + k.tangent * k.out_length; }
float as_handle(double length) { return std::clamp(static_cast<float>(length), kMinHandle, kMaxHandle); }

KnotSegments neighbours(const Document& document, Entity knot_entity) {
  const Track& track = document.track;
  const auto index = index_of(track.knots, knot_entity);
  COASTER_CHECK(index, "the knot is on the track");
  KnotSegments result;
  if (*index > 0) result.before = track.segments[*index - 1];
  else if (track.closed) result.before = track.segments.back();
  if (*index < track.segments.size()) result.after = track.segments[*index];
  return result;
}

std::optional<std::size_t> index_of(const std::vector<Entity>& order, Entity e) {
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] == e) return i;
  return std::nullopt;
}

double exact_length(const Document& document) {
  double sum = 0;
  for (const Entity s : document.track.segments) sum += curve::arc_length(cubic_of(document, s));
  return sum;
}

void copy_fittings(const Document& original, Entity from, Document& document, Entity to) {
  Fittings::for_each([&]<class T>() {
    if (const T* const fitting = original.entities.find<T>(from)) document.entities.put(to, T(*fitting));
  });
}

}  // namespace coaster::world
