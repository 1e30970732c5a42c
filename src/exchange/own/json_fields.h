// Checked getters for the members of a JSON object. They never throw; the first error is kept with its position.
// Private to this room.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/files.h"
#include "exchange/own/json_reader.h"

namespace coaster::exchange {

// The object within the file: "" is the file itself, otherwise entry `index` of a list: "knots[3]".
struct Place {
  std::string_view list;
  std::size_t index = 0;
  std::string text() const;
};

// Every getter fills `value` and returns true, or sets `error` to "PLACE.MEMBER: expected ..., found ..." and returns
// false. Members are required: test optional ones with has() first. Members that are never read are the unknown ones.
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
  // Reads the first two members of each of the program's files: "format", which must match, and "version", 1 to
  // `newest`, which it returns in `version`.
  bool head(std::string_view format, std::int32_t newest, int* version = nullptr);
  // Returns the object of that name, or null after a failure.
  const Json* object(std::string_view member);
  // Returns the array of that name, or null after a failure; more than `most` entries are a failure.
  const Json* list(std::string_view member, std::size_t most = std::numeric_limits<std::size_t>::max());

  bool fail(std::string_view member, std::string_view message);
  // Fails with "expected WHAT, found ..." for a member that was read.
  bool reject(std::string_view member, std::string_view expected);

  // Returns the unknown members as the text of a JSON object, "" if there are none, and adds a line for each to
  // `warnings`.
  std::string unknown(std::vector<std::string>& warnings) const;

 private:
  using Kind = bool (Json::*)() const noexcept;  // &Json::is_string
  const Json* member(std::string_view member, std::string_view expected, Kind kind);
  const Json* look(std::string_view member);  // null if it is missing
  // Fails for a member that is missing (null) or has the wrong type. Builds the error text only in that case.
  bool expect(std::string_view member, const Json* found, std::string_view expected);

  const Json* object_ = nullptr;  // null if the value is not an object: every getter fails
  Place place_;
  std::string& error_;
  std::vector<std::string_view> known_;
};

// Returns Code::bad_file with "NAME: error: MESSAGE".
base::Status bad_file(std::string_view name, std::string_view message);

// Puts "NAME: warning: " before each warning, for files that are never written again, so that their unknown members are
// lost.
void name_ignored(std::vector<std::string>& warnings, std::string_view name);

// Reads a file with the extension ".json".
base::Result<std::string> read_json_file(base::Files& files, const std::filesystem::path& path);

}  // namespace coaster::exchange
