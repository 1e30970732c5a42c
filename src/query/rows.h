// The parts of the table of queries, and helpers of their rows.
#pragma once

#include "curve/continuity.h"
#include "query/query.h"
#include "world/topology.h"

namespace coaster::query {

std::span<const Query> document_rows();
std::span<const Query> ride_rows();
std::span<const Query> ghost_rows();
std::span<const Query> session_rows();
std::span<const Query> setting_rows();
std::span<const Query> joint_rows();
std::span<const Query> lab_rows();
std::span<const Query> element_rows();
std::span<const Query> game_rows();
std::span<const Query> draw_rows();
std::span<const Query> frame_rows();
std::span<const Query> evaluation_rows();

// Returns the entity of that kind named `argument` ("@k3" or "k3"), or a Status with the error and a suggestion.
base::Result<world::Entity> entity_of(const Context& context, std::string_view argument, world::Kind kind);

// The result of a row, and its argument.
using Answer = base::Result<Value>;
using View = std::string_view;

inline Value yes_no(bool on) { return Ranked{on ? 1 : 0, on ? "on" : "off"}; }
template <class Number>
Value number(Number n) {
  return static_cast<double>(n);
}
inline Value text(std::string_view t) { return std::string(t); }

// Returns `function` of the joint at a knot; `at_an_end` for an end of an open track, which has no joint.
template <class Function>
Answer of_joint(const Context& context, View argument, const Value& at_an_end, Function function) {
  const auto entity = entity_of(context, argument, world::Kind::knot);
  if (!entity) return entity.status();
  const world::Document& document = context.session.document;
  const world::Neighbours at = world::neighbours(document, *entity);
  if (!at.before.valid() || !at.after.valid()) return at_an_end;
  return function(curve::joint(world::cubic_of(document, at.before), world::cubic_of(document, at.after)));
}

}  // namespace coaster::query
