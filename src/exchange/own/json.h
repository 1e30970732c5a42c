// JSON of the project's own files: parsed into a tree with checks that the parser leaves out by default (duplicate
// members, deep nesting, numbers out of range), read member by member, and printed. Private to this room.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "base/enum_names.h"
#include "base/files.h"
#include "base/status.h"

namespace coaster::exchange {

using Json = nlohmann::ordered_json;  // members keep their order

// Returns the text of a file: each member on its own line, `indent` blanks per level, a line feed at the end. Here and
// below, bytes that are not UTF-8 become U+FFFD.
inline std::string json_file(const Json& tree, int indent = 2) {
  return tree.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Returns a value on one line, without blanks.
inline std::string json_line(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

// Returns a text in quotation marks, escaped for JSON.
inline std::string json_string(std::string_view text) { return json_line(Json(std::string(text))); }

inline constexpr std::size_t kMaxNesting = 32;
// A tree of this many values takes at most 0.6 GB while it grows. A file of 64 MiB of knots has half as many.
inline constexpr std::size_t kMaxValues = 8'000'000;
inline constexpr std::size_t kMaxMembers = 200'000;  // of one object

// Receives each object in an array of the root as soon as it is complete: element `index` of the root's member `list`.
// Returns true if it has read the object: the tree then holds null instead of it, so the tree of a large file stays
// small. If the text turns out not to be plain JSON (json_scan.h), the objects are offered again from the first one on.
using TakeElement =
    std::function<bool(const Json& root, std::string_view list, std::size_t index, const Json& element)>;

// Returns the tree of a whole text. Code::bad_file with "NAME:LINE:COLUMN: error: ..." if the text is not JSON (columns
// count bytes from 1; for a word, its last byte), "NAME: error: PLACE: ..." for duplicate members, nesting and more
// than `most_values` or kMaxMembers. Skips a leading byte-order mark.
base::Result<Json> read_json(std::string_view text, std::string_view name, const TakeElement& take = {},
                             std::size_t most_values = kMaxValues);

// Describes a value for messages: null, true, 1.5, "text", an array of 2, an object.
std::string describe(const Json& value);

inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();  // of entries of a list

// The object within the file: "" is the file itself, otherwise entry `index` of a list, "knots[3]", or without an index
// a member, "park".
struct JsonLocation {
  std::string_view list;
  std::size_t index = kAnyNumber;
  std::string text() const;
};

// Every getter fills `value` and returns true, or sets `error` to "PLACE.MEMBER: expected ..., found ..." and returns
// false. Members are required: test optional ones with has() first. Members that are never read are the unknown ones.
class JsonFieldReader {
 public:
  JsonFieldReader(const Json& value, JsonLocation place, std::string& error);

  bool has(std::string_view member) const;
  bool has_object(std::string_view member) const { return has(member) && (*object_)[std::string(member)].is_object(); }
  bool text(std::string_view member, std::string& value);
  bool flag(std::string_view member, bool& value);
  bool number(std::string_view member, double& value, double low, double high);
  bool length(std::string_view member, float& value, float low, float high);
  bool whole(std::string_view member, std::int64_t& value, std::int64_t low, std::int64_t high);
  bool vector(std::string_view member, glm::dvec3& value, double limit);  // |component| <= limit
  // Reads the first two members of each of the program's files: "format", which must match, and "version", 1 to
  // `newest`, which it returns in `version`.
  bool head(std::string_view format, std::int32_t newest, int* version = nullptr);
  // Reads one of an enumeration's names; `quote` surrounds those in the error.
  template <base::Named E>
  bool named(std::string_view member, E& value, std::string_view quote = "\"") {
    std::string name;
    if (!text(member, name)) return false;
    const std::optional<E> found = base::value_named<E>(name);
    if (found) value = *found;
    return found || reject(member, base::alternatives_of<E>(quote));
  }
  // Calls read(JsonFieldReader& entry, index) for each object of a list, until one returns false; then returns false.
  template <class Read>
  bool each(std::string_view member, std::size_t most, Read read) {
    const Json* const entries = list(member, most);
    const std::string at = place_.list.empty() ? std::string(member) : fmt::format("{}.{}", place_.text(), member);
    for (std::size_t i = 0; entries && i < entries->size(); ++i)
      if (JsonFieldReader entry((*entries)[i], {at, i}, error_); !entry.object_ || !read(entry, i)) return false;
    return entries != nullptr;
  }
  // Returns the object of that name, or null after a failure.
  const Json* object(std::string_view member);
  void leave(std::string_view member) { std::erase(known_, member); }  // counts it as unknown, although it was read
  // Returns the array of that name, or null after a failure; more than `most` entries are a failure.
  const Json* list(std::string_view member, std::size_t most = kAnyNumber);

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
  JsonLocation place_;
  std::string& error_;
  std::vector<std::string_view> known_;
};

// Returns Code::bad_file with "NAME: error: MESSAGE".
base::Status bad_file(std::string_view name, std::string_view message);

// Returns what read(fields, value) reads of a whole text that is one object. Code::bad_file with the first error.
template <class Value, class Read>
base::Result<Value> read_object(std::string_view text, std::string_view name, Read read) {
  const base::Result<Json> tree = read_json(text, name);
  if (!tree) return tree.status();
  Value value;
  std::string error;
  if (JsonFieldReader fields(*tree, {}, error); error.empty()) (void)read(fields, value);
  if (!error.empty()) return bad_file(name, error);
  return value;
}

// Puts "NAME: warning: " before each warning, for files that are never written again, so that their unknown members are
// lost.
void name_ignored(std::vector<std::string>& warnings, std::string_view name);

// Reads a file with the extension ".json".
base::Result<std::string> read_json_file(base::Files& files, const std::filesystem::path& path);

}  // namespace coaster::exchange
