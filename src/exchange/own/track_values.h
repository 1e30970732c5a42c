// The values of a track file's members: their limits, and how they become fields of components. Private to this room.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include <glm/glm.hpp>

#include "exchange/own/json_fields.h"
#include "exchange/own/track_file.h"
#include "world/document.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"

namespace coaster::exchange {

// The state of a parse. `error` is the first error, without the file's name.
struct TrackParse {
  world::Document document;
  std::vector<std::string> warnings;
  std::string error;
  int version = kTrackVersion;
  // Knots or segments read while the file was parsed: how many, and why the next one could not be read.
  struct Taken {
    std::size_t count = 0;
    std::string error;
  };
  Taken knots, segments;
  std::array<std::unordered_map<std::uint32_t, world::Entity>, base::count_of<world::Kind>()>
      by_number;  // by world::Kind
};

// Returns "k3" in quotation marks.
std::string quoted_id(world::Kind kind, std::uint32_t number);

// Reads a member that names an entity: "k3".
bool read_id(Fields& fields, std::string_view member, world::Kind kind, std::uint32_t& number);

// Reads a unit vector: any vector with a direction is normalised before it is rounded.
bool read_direction(Fields& fields, std::string_view member, glm::vec3& value);

// Reads the value of one field, within its limits.
template <class T>
bool read_value(TrackParse& parse, Fields& fields, const world::Field& field, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return fields.flag(field.name, value);
  } else if constexpr (std::is_same_v<T, double>) {
    return fields.number(field.name, value, field.low, field.high);
  } else if constexpr (std::is_same_v<T, float>) {
    return fields.length(field.name, value, static_cast<float>(field.low), static_cast<float>(field.high));
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    std::int64_t whole = 0;
    if (!fields.whole(field.name, whole, static_cast<std::int64_t>(field.low), static_cast<std::int64_t>(field.high)))
      return false;
    value = static_cast<std::int32_t>(whole);
    return true;
  } else if constexpr (std::is_same_v<T, glm::vec3>) {
    if (field.high == 0) return read_direction(fields, field.name, value);
    glm::dvec3 v;
    if (!fields.vector(field.name, v, field.high)) return false;
    value = glm::vec3(v);
    return true;
  } else if constexpr (base::Named<T>) {
    std::string word;
    if (!fields.text(field.name, word)) return false;
    const auto named = base::value_named<T>(word);
    if (!named) return fields.reject(field.name, base::alternatives_of<T>("\""));
    value = *named;
    return true;
  } else {
    static_assert(std::is_same_v<T, world::Entity>);
    std::uint32_t number = 0;
    if (!read_id(fields, field.name, world::Kind::segment, number)) return false;
    const auto& segments = parse.by_number[static_cast<std::size_t>(world::Kind::segment)];
    const auto found = segments.find(number);
    if (found == segments.end())
      return fields.fail(field.name, "there is no segment " + quoted_id(world::Kind::segment, number));
    value = found->second;
    return true;
  }
}

// Reads the fields of a component, in order. Optional fields that are missing keep their default values.
template <class T>
bool read_component(TrackParse& parse, Fields& fields, T& component) {
  bool good = true;
  T::fields([&](const world::Field& field, auto member) {
    auto& value = component.*member;
    if constexpr (world::HasFields<std::remove_cvref_t<decltype(value)>>) {
      good = good && read_component(parse, fields, value);
    } else if (good && (field.in_file == world::InFile::required || fields.has(field.name))) {
      good = read_value(parse, fields, field, value);
    }
  });
  return good;
}

}  // namespace coaster::exchange
