#include "exchange/own/track_values.h"

#include <cmath>

#include <fmt/format.h>

namespace coaster::exchange {
namespace {

constexpr std::uint32_t kMaxIdNumber = 1'000'000'000;  // leaves room for the numbers of new entities
constexpr double kShortVector = 1e-9;

// Unit vectors keep their bits; others are normalised before they are rounded to float.
glm::vec3 direction(glm::dvec3 v) {
  const double square = glm::dot(v, v);
  return glm::vec3(std::abs(square - 1.0) <= 1e-6 ? v : v / std::sqrt(square));
}

}  // namespace

std::string quoted_id(world::Kind kind, std::uint32_t number) {
  return fmt::format("\"{}\"", world::to_text(world::Name{kind, number}));
}

bool read_id(Fields& fields, std::string_view member, world::Kind kind, std::uint32_t& number) {
  std::string text;
  if (!fields.text(member, text)) return false;
  const auto name = world::parse_name(text);
  if (!name || name->kind != kind || name->number > kMaxIdNumber)
    return fields.reject(member, "an id such as " + quoted_id(kind, 3));
  number = name->number;
  return true;
}

bool read_direction(Fields& fields, std::string_view member, glm::vec3& value) {
  constexpr double kAny = 1e30;  // squares stay finite
  glm::dvec3 v;
  if (!fields.vector(member, v, kAny)) return false;
  if (!(glm::length(v) >= kShortVector)) return fields.reject(member, "a vector with a direction");
  value = direction(v);
  return true;
}

}  // namespace coaster::exchange
