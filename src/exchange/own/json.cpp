// Parses JSON text into a tree by events: of a scan of plain JSON or, where that stops, of the library's parser, which
// does not recurse. A million brackets are rejected at the 33rd.
#include "exchange/own/json.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/cancellable_job.h"
#include "base/text.h"
#include "exchange/own/json_output.h"
#include "exchange/own/json_scan.h"

namespace coaster::exchange {
namespace {

constexpr std::size_t kClip = 60;  // bytes of file contents in a message

// Returns file contents for a message: printable ASCII, truncated.
std::string clipped(std::string text, std::size_t most) {
  const bool long_text = text.size() > most;
  if (long_text) text.resize(most);
  for (char& c : text)
    if (c < 0x20 || c > 0x7e) c = '?';
  return long_text ? text + "..." : text;
}

// Formats the line and column of a byte.
std::string at_byte(std::string_view text, std::size_t offset, std::string_view name, std::string_view message) {
  offset = std::min(offset, text.size());
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = newline == std::string_view::npos ? offset + 1 : offset - newline;
  return base::at_place(name, static_cast<int>(line), static_cast<int>(column), message);
}

// Receives the parser's events and builds the tree. Every function returns whether to continue.
class JsonTreeBuilder {
 public:
  JsonTreeBuilder(std::string_view text, std::string_view name, const TakeElement& take, std::size_t most_values)
      : text_(text), name_(name), take_(take), most_values_(most_values) {}

  Json root;
  std::string error;

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }  // does not occur in text
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() {
    if (take_ && open_.size() == 3 && root.is_object() && open_[1].node->is_array()) offer();
    return close();
  }
  bool end_array() { return close(); }
  bool key(std::string& key) {
    const Members& members = members_of(*open_.back().node);
    if (members.size() == kMaxMembers)
      return fail(fmt::format("an object with more than the limit of {} members", kMaxMembers));
    if (is_taken(members, key)) return fail("member \"" + clipped(key, kClip) + "\" appears twice");
    open_.back().key = std::move(key);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& e) {
    constexpr int kNumberOverflow = 406;
    std::string message = e.what();  // "[json.exception...] parse error at line 1, column 2: the wanted part"
    if (e.id == kNumberOverflow) {
      message = "number " + clipped(token, kClip) + " is out of range";
    } else if (const std::size_t colon = message.find(": "); colon != std::string::npos) {
      message.erase(0, colon + 2);
    }
    error = at_byte(text_, position > 0 ? position - 1 : 0, name_, clipped(message, 200));
    return false;
  }

 private:
  using Members = Json::object_t::Container;
  struct OpenContainer {
    Json* node;
    std::set<std::string> keys;  // keys of a large object so far
    std::string key;             // key of the next value
  };
  static Members& members_of(Json& object) { return object.get_ref<Json::object_t&>(); }

  bool is_taken(const Members& members, const std::string& key) {
    constexpr std::size_t kFew = 16;  // up to here a search is faster than a set
    if (members.size() < kFew)
      return std::any_of(members.begin(), members.end(), [&](const auto& member) { return member.first == key; });
    std::set<std::string>& keys = open_.back().keys;
    if (keys.empty())
      for (const auto& member : members) keys.insert(member.first);
    return !keys.insert(key).second;
  }

  // Appends at the end; searching for an equal key again would make large objects quadratic.
  Json* append(Json value) {
    if (open_.empty()) return root = std::move(value), &root;
    Json& parent = *open_.back().node;
    if (parent.is_array()) {
      Json::array_t& items = parent.get_ref<Json::array_t&>();
      if (items.empty()) items.reserve(kUsualItems);
      return items.push_back(std::move(value)), &items.back();
    }
    Members& members = members_of(parent);
    if (members.empty()) members.reserve(kUsualMembers);
    members.emplace_back(std::move(open_.back().key), std::move(value));
    return &members.back().second;
  }
  bool counts() {
    if (values_ % 4096 == 0 && base::interrupted()) return fail("the reading was stopped");
    return ++values_ <= most_values_ || fail(fmt::format("more than the limit of {} values", most_values_));
  }
  bool add(Json value) {
    if (!counts()) return false;
    return append(std::move(value)), true;
  }
  bool open(Json value) {
    if (!counts()) return false;
    if (open_.size() == kMaxNesting) return fail(fmt::format("nesting deeper than the limit of {}", kMaxNesting));
    // The pointer stays valid: nothing is appended to the parent before this one closes.
    Json* const node = append(std::move(value));
    open_.push_back({node, {}, {}});
    return true;
  }
  bool close() { return open_.pop_back(), true; }
  void offer() {
    const std::size_t index = open_[1].node->size() - 1;
    Json& element = *open_[2].node;
    if (take_(root, members_of(root).back().first, index, element)) element = nullptr;
  }

  // Returns "knots[3].tangent" from the open objects and arrays.
  std::string place() const {
    std::string path;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Json& parent = *open_[i].node;
      if (parent.is_array()) {
        path += fmt::format("[{}]", parent.size() - 1);
      } else {
        const auto& members = static_cast<const Json::object_t::Container&>(parent.get_ref<const Json::object_t&>());
        path += (path.empty() ? "" : ".") + clipped(members.back().first, kClip);
      }
    }
    return clipped(path, 2 * kClip);
  }
  bool fail(const std::string& message) {
    const std::string where = place();
    error = fmt::format("{}: error: {}{}{}", name_, where, where.empty() ? "" : ": ", message);
    return false;
  }

  static constexpr std::size_t kUsualItems = 3;    // of a vector
  static constexpr std::size_t kUsualMembers = 8;  // a larger object copies its members, as their keys are constant
  std::string_view text_, name_;
  const TakeElement& take_;
  std::size_t most_values_;
  std::vector<OpenContainer> open_;
  std::size_t values_ = 0;
};

// Prints whole limits in full: 100000, not 1e+05.
template <class T>
std::string limit_text(T limit) {
  const bool plain = std::abs(limit) < 1e9 && limit == std::trunc(limit);
  return plain ? std::to_string(static_cast<std::int64_t>(limit)) : base::to_text(limit);
}

Json tree_of(const JsonMembers& members);
Json tree_of(const JsonList& list) {
  Json tree = Json::array();
  for (const JsonMembers& members : list) tree.push_back(tree_of(members));
  return tree;
}

template <class T>
Json tree_of(const T& value) {
  return Json(value);
}
Json tree_of(const JsonMembers& members) {
  Json tree = Json::object();
  for (const auto& [name, value] : members) tree[name] = std::visit([](const auto& v) { return tree_of(v); }, value);
  return tree;
}

}  // namespace

base::Result<Json> read_json(std::string_view text, std::string_view name, const TakeElement& take,
                             std::size_t most_values) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return base::Status{base::Code::bad_file,
                        at_byte(text, text.size(), name, "the file is empty; expected a JSON object")};
  {
    JsonTreeBuilder plain(text, name, take, most_values);
    if (scan_json(text, plain)) return std::move(plain.root);
    if (!plain.error.empty()) return base::Status{base::Code::bad_file, std::move(plain.error)};
  }
  JsonTreeBuilder builder(text, name, take, most_values);
  if (!Json::sax_parse(text.begin(), text.end(), &builder))
    return base::Status{base::Code::bad_file, std::move(builder.error)};
  return std::move(builder.root);
}

std::string describe(const Json& value) {
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  if (value.is_object()) return "an object";
  return clipped(value.dump(-1, ' ', true, Json::error_handler_t::replace), kClip);
}

std::string JsonLocation::text() const {
  return index == kAnyNumber ? std::string(list) : fmt::format("{}[{}]", list, index);
}

JsonFieldReader::JsonFieldReader(const Json& value, JsonLocation place, std::string& error)
    : place_(place), error_(error) {
  constexpr std::size_t kUsual = 8;
  known_.reserve(kUsual);
  if (value.is_object()) object_ = &value;
  else fail({}, "expected an object, found " + describe(value));
}

bool JsonFieldReader::fail(std::string_view member, std::string_view message) {
  if (!error_.empty()) return false;  // only the first error is kept
  error_ = place_.text();
  if (!error_.empty() && !member.empty()) error_ += ".";
  error_ += member;
  if (!error_.empty()) error_ += ": ";
  error_ += message;
  return false;
}

bool JsonFieldReader::reject(std::string_view name, std::string_view expected) {
  const auto it = object_->find(std::string(name));
  const std::string found = it == object_->end() ? "nothing" : describe(*it);
  return fail(name, fmt::format("expected {}, found {}", expected, found));
}

bool JsonFieldReader::head(std::string_view format, std::int32_t newest, int* version_found) {
  std::string found;
  std::int64_t version = 0;
  if (!text("format", found)) return false;
  if (found != format) return reject("format", fmt::format("\"{}\"", format));
  if (!whole("version", version, 1, std::numeric_limits<std::int32_t>::max())) return false;
  if (version > newest)
    return fail("version", fmt::format("version {} is newer than this program supports ({})", version, newest));
  if (version_found != nullptr) *version_found = static_cast<int>(version);
  return true;
}

const Json* JsonFieldReader::look(std::string_view name) {
  if (!object_) return nullptr;
  known_.push_back(name);
  const auto it = object_->find(std::string(name));
  return it == object_->end() ? nullptr : &*it;
}

bool JsonFieldReader::expect(std::string_view name, const Json* found, std::string_view expected) {
  if (!object_) return false;
  return found ? reject(name, expected) : fail(name, fmt::format("missing; expected {}", expected));
}

const Json* JsonFieldReader::member(std::string_view name, std::string_view expected, Kind kind) {
  const Json* const m = look(name);
  if (m && (m->*kind)()) return m;
  expect(name, m, expected);
  return nullptr;
}

bool JsonFieldReader::has(std::string_view name) const { return object_ && object_->contains(std::string(name)); }

bool JsonFieldReader::text(std::string_view name, std::string& value) {
  const Json* const m = member(name, "a text", &Json::is_string);
  if (m) value = m->get_ref<const std::string&>();
  return m != nullptr;
}

bool JsonFieldReader::flag(std::string_view name, bool& value) {
  const Json* const m = member(name, "true or false", &Json::is_boolean);
  if (m) value = m->get<bool>();
  return m != nullptr;
}

bool JsonFieldReader::number(std::string_view name, double& value, double low, double high) {
  const Json* const m = look(name);
  if (m && m->is_number()) {
    value = m->get<double>();
    if (value >= low && value <= high) return true;
  }
  return expect(name, m, fmt::format("a number from {} to {}", limit_text(low), limit_text(high)));
}

bool JsonFieldReader::length(std::string_view name, float& value, float low, float high) {
  const Json* const m = look(name);
  if (m && m->is_number()) {
    // Compared as float: 0.01 in the file means the value of 0.01f.
    const double wide = m->get<double>();
    if (wide >= std::min(0.0, 2 * double{low}) && wide <= 2 * double{high}) {
      value = static_cast<float>(wide);
      if (value >= low && value <= high) return true;
    }
  }
  return expect(name, m,
                low < 0 ? fmt::format("a number from {} to {}", limit_text(low), limit_text(high))
                        : fmt::format("a length from {} to {} m", limit_text(low), limit_text(high)));
}

bool JsonFieldReader::whole(std::string_view name, std::int64_t& value, std::int64_t low, std::int64_t high) {
  const Json* const m = look(name);
  // Unsigned values beyond the signed range would become negative.
  const bool fits = m && m->is_number_integer() &&
                    !(m->is_number_unsigned() && m->get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX));
  if (fits) {
    value = m->get<std::int64_t>();
    if (value >= low && value <= high) return true;
  }
  return expect(name, m, fmt::format("a whole number from {} to {}", low, high));
}

bool JsonFieldReader::vector(std::string_view name, glm::dvec3& value, double limit) {
  const Json* const m = member(name, "3 finite numbers", &Json::is_array);
  if (!m) return false;
  if (m->size() != 3) return reject(name, "3 finite numbers");
  for (int axis = 0; axis < 3; ++axis) {
    const Json& component = (*m)[static_cast<std::size_t>(axis)];
    const auto wrong = [&](const std::string& expected) {
      return fail(fmt::format("{}[{}]", name, axis), "expected " + expected + ", found " + describe(component));
    };
    if (!component.is_number()) return wrong("a finite number");
    value[axis] = component.get<double>();
    if (!(std::abs(value[axis]) <= limit))
      return wrong(fmt::format("a number from {} to {}", limit_text(-limit), limit_text(limit)));
  }
  return true;
}

const Json* JsonFieldReader::object(std::string_view name) { return member(name, "an object", &Json::is_object); }

const Json* JsonFieldReader::list(std::string_view name, std::size_t most) {
  const Json* const m = member(name, "an array", &Json::is_array);
  if (!m || m->size() <= most) return m;
  fail(name, fmt::format("more than the limit of {}", most));
  return nullptr;
}

std::string JsonFieldReader::unknown(std::vector<std::string>& warnings) const {
  if (!object_) return {};
  Json extra = Json::object();
  auto& members = static_cast<Json::object_t::Container&>(extra.get_ref<Json::object_t&>());
  for (const auto& [key, value] : object_->items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    members.emplace_back(key, value);
    const std::string where = place_.text();
    warnings.push_back(
        fmt::format("{}{}unknown member {} is kept", where, where.empty() ? "" : ": ", describe(Json(key))));
  }
  return members.empty() ? std::string() : json_line(extra);
}

base::Status bad_file(std::string_view name, std::string_view message) {
  return {base::Code::bad_file, fmt::format("{}: error: {}", name, message)};
}

void name_ignored(std::vector<std::string>& warnings, std::string_view name) {
  constexpr std::string_view kKept = " is kept";
  for (std::string& warning : warnings) {
    if (warning.ends_with(kKept)) warning.replace(warning.size() - kKept.size(), kKept.size(), " is ignored");
    warning = fmt::format("{}: warning: {}", name, warning);
  }
}

base::Result<std::string> read_json_file(base::Files& files, const std::filesystem::path& path) {
  if (path.extension() != ".json") return bad_file(path.string(), "expected a file ending in .json");
  return files.read(path);
}

std::string json_members(const JsonMembers& members) { return json_file(tree_of(members)); }

}  // namespace coaster::exchange
