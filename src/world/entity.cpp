// Names of entities as text. Numbers have no leading zeros, so that every name has one spelling.
#include "world/entity.h"

#include <charconv>

namespace coaster::world {
namespace {

constexpr std::string_view kLetters = "kscq";  // in the order of EntityKind

}  // namespace

std::string to_text(EntityName name) {
  return kLetters[static_cast<std::size_t>(name.kind)] + std::to_string(name.number);
}

std::optional<EntityName> parse_name(std::string_view text) {
  if (text.size() < 2 || text[1] < '1' || text[1] > '9') return std::nullopt;
  const std::size_t kind = kLetters.find(text[0]);
  if (kind == std::string_view::npos) return std::nullopt;
  EntityName name{static_cast<EntityKind>(kind), 0};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, name.number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return name;
}

}  // namespace coaster::world
