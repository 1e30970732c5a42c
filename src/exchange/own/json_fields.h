// Checked getters for the members of a JSON object. They never throw; the first thing that is wrong is kept with its
// place. Private to this room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "exchange/own/json_reader.h"

namespace coaster::exchange {

// Which object of the file: "" is the file itself, otherwise entry `index` of a list: "knots[3]".
struct Place {
  std::string_view list;
  std::size_t index = 0;
  std::string text() const;
};

// Every getter fills `value` and returns true, or keeps "PLACE.MEMBER: expected ..., found ..." in `error` and returns
// false. Members are required: ask has() first for those that are not. Members never asked for are the unknown ones.
class Fields {
 public:
  Fields(const Json& value, Place place, std::string& error);

  bool has(std::string_view member) const;
  bool text(std::string_view member, std::string& value);
  bool flag(std::string_view member, bool& value);
  bool number(std::string_view member, double& value, double low, double high);
  bool length(std::string_view member, float& value, float low, float high);
  bool whole(std::string_view member, std::int64_t& value, std::int64_t low, std::int64_t high);
  bool vector(std::string_view member, glm::dvec3& value, double limit);  // |component| <= limit
  // The first two members of every file of ours: "format", which must be that one, and "version", 1 to `newest`.
  bool head(std::string_view format, std::int32_t newest);
  // Any value of that name, or null after a failure.
  const Json* value(std::string_view member);
  // The array of that name, or null after a failure.
  const Json* list(std::string_view member);

  bool fail(std::string_view member, std::string_view message);
  // Fails with "expected WHAT, found ..." about a member that was read.
  bool reject(std::string_view member, std::string_view expected);

  // The unknown members as the text of a JSON object, "" when there are none; a line about each in `warnings`.
  std::string unknown(std::vector<std::string>& warnings) const;

 private:
  const Json* member(std::string_view member, std::string_view expected);

  const Json* object_ = nullptr;  // null when the value is no object: every getter fails
  Place place_;
  std::string& error_;
  std::vector<std::string_view> known_;
};

}  // namespace coaster::exchange
