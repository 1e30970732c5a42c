// What follows the name of a query: one word, whose parts have separators between them, such as @q3.vertical/40.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.h"
#include "base/text.h"
#include "world/entity.h"

namespace coaster::query {

// An entity, a word, or a number; any text if none of these is set.
struct ArgumentPart {
  std::string_view usage = {};                    // in help; empty: all words
  std::optional<world::EntityKind> kind = {};     // the name of an entity of this kind
  std::vector<std::string> (*words)() = nullptr;  // one of these words
  int most = 0;                                   // or a whole number from 1 to this one
  bool number = false;                            // any number
  char before = 0;                                // separates it from the part before it
  bool optional = false;
};
using Argument = std::span<const ArgumentPart>;

inline constexpr ArgumentPart kKnot[]{{.usage = "@knot", .kind = world::EntityKind::knot}};
inline constexpr ArgumentPart kSegment[]{{.usage = "@segment", .kind = world::EntityKind::segment}};
inline constexpr ArgumentPart kCart[]{{.usage = "@cart", .kind = world::EntityKind::cart}};
inline constexpr ArgumentPart kSection[]{{.usage = "@section", .kind = world::EntityKind::section}};
template <base::Named E>
inline constexpr ArgumentPart kWordOf[]{{.words = base::names_of<E>}};

// Returns "@section.CHANNEL/PLACE", "document|motion" and so on.
std::string usage_of(Argument argument);

// Returns why the argument does not accept the word, with the column of the wrong part in it, from 1. Nothing if it
// does; the entity may still not exist.
std::optional<base::TextError> wrong_argument(Argument argument, std::string_view word);

}  // namespace coaster::query
