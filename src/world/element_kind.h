// The kinds of elements of the palette. Their names, parameters and limits: world/element_rows.h.
#pragma once

#include <cstddef>
#include <cstdint>

namespace coaster::world {

// Rows of elements(), in its order, then of force_elements().
enum class ElementKind : std::uint8_t {
  straight,
  curve,
  helix,
  climb,
  dive,
  camelback,
  loop,
  corkscrew,
  s_bend,
  overbanked_turn,
  bunny_hops,
  zero_g_roll,
  immelmann,
  dive_loop,
  cobra_roll,
  brake_run,
  force_hill,
  force_valley,
  force_turn,
  force_roll,
  force_heartline,
  force_loop,
  force_brakes
};
// True for a force element, which is placed as a force section: what riders feel shapes it, and its keys can be edited.
constexpr bool is_of_forces(ElementKind kind) { return kind >= ElementKind::force_hill; }

inline constexpr std::size_t kElementKinds = 1 + static_cast<std::size_t>(ElementKind::force_brakes);
inline constexpr std::size_t kMaxElementParameters = 5;

}  // namespace coaster::world
