// The parts of the table of queries, and what their rows share.
#pragma once

#include "query/query.h"

namespace coaster::query {

std::span<const Query> document_rows();
std::span<const Query> ride_rows();
std::span<const Query> ghost_rows();
std::span<const Query> session_rows();
std::span<const Query> joint_rows();
std::span<const Query> lab_rows();
std::span<const Query> element_rows();
std::span<const Query> game_rows();

// The entity of that kind called `argument` ("@k3" or "k3"), or a Status that says what is wrong and what may be meant.
base::Result<world::Entity> entity_of(const Context& context, std::string_view argument, world::Kind kind);

inline Value yes_no(bool on) { return Ranked{on ? 1 : 0, on ? "on" : "off"}; }
template <class Number>
Value number(Number n) {
  return static_cast<double>(n);
}
inline Value text(std::string_view t) { return std::string(t); }

}  // namespace coaster::query
