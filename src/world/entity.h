// Generational entity ids and their names.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/enum_names.h"

namespace coaster::world {

// A slot and its use count; the id of a destroyed entity never becomes valid again. The default is "none".
struct Entity {
  std::uint32_t index = 0xffffffffu;
  std::uint32_t generation = 0;
  bool valid() const { return index != 0xffffffffu; }
  friend auto operator<=>(const Entity&, const Entity&) = default;
};
inline constexpr Entity kNone{};

enum class EntityKind : std::uint8_t { knot, segment, cart, section };
inline constexpr base::NameRow kKinds[] = {{"knot"}, {"segment"}, {"cart"}, {"section"}};
constexpr std::span<const base::NameRow> rows_of(EntityKind) { return kKinds; }

// The name of an entity: k3, s2, c1, q4. Numbers start at 1, are unique within a kind and are never reused within a
// document, so undo restores the same name.
struct EntityName {
  EntityKind kind = EntityKind::knot;
  std::uint32_t number = 0;
  friend auto operator<=>(const EntityName&, const EntityName&) = default;
};

std::string to_text(EntityName name);                         // "k3"
std::optional<EntityName> parse_name(std::string_view text);  // "k3", without the @ of scripts

}  // namespace coaster::world
