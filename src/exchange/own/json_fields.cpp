// Checked getters.
#include "exchange/own/json_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::exchange {
namespace {

// Prints whole limits in full: 100000, not 1e+05.
template <class T>
std::string limit_text(T limit) {
  const bool plain = std::abs(limit) < 1e9 && limit == std::trunc(limit);
  return plain ? std::to_string(static_cast<std::int64_t>(limit)) : base::to_text(limit);
}

}  // namespace

std::string Place::text() const { return list.empty() ? std::string() : fmt::format("{}[{}]", list, index); }

Fields::Fields(const Json& value, Place place, std::string& error) : place_(place), error_(error) {
  constexpr std::size_t kUsual = 8;
  known_.reserve(kUsual);
  if (value.is_object()) object_ = &value;
  else fail({}, "expected an object, found " + describe(value));
}

bool Fields::fail(std::string_view member, std::string_view message) {
  if (!error_.empty()) return false;  // only the first error is kept
  error_ = place_.text();
  if (!error_.empty() && !member.empty()) error_ += ".";
  error_ += member;
  if (!error_.empty()) error_ += ": ";
  error_ += message;
  return false;
}

bool Fields::reject(std::string_view name, std::string_view expected) {
  const auto it = object_->find(std::string(name));
  const std::string found = it == object_->end() ? "nothing" : describe(*it);
  return fail(name, fmt::format("expected {}, found {}", expected, found));
}

bool Fields::head(std::string_view format, std::int32_t newest, int* version_found) {
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

const Json* Fields::look(std::string_view name) {
  if (!object_) return nullptr;
  known_.push_back(name);
  const auto it = object_->find(std::string(name));
  return it == object_->end() ? nullptr : &*it;
}

bool Fields::expect(std::string_view name, const Json* found, std::string_view expected) {
  if (!object_) return false;
  return found ? reject(name, expected) : fail(name, fmt::format("missing; expected {}", expected));
}

const Json* Fields::member(std::string_view name, std::string_view expected, Kind kind) {
  const Json* const m = look(name);
  if (m && (m->*kind)()) return m;
  expect(name, m, expected);
  return nullptr;
}

bool Fields::has(std::string_view name) const { return object_ && object_->contains(std::string(name)); }

bool Fields::text(std::string_view name, std::string& value) {
  const Json* const m = member(name, "a text", &Json::is_string);
  if (m) value = m->get_ref<const std::string&>();
  return m != nullptr;
}

bool Fields::flag(std::string_view name, bool& value) {
  const Json* const m = member(name, "true or false", &Json::is_boolean);
  if (m) value = m->get<bool>();
  return m != nullptr;
}

bool Fields::number(std::string_view name, double& value, double low, double high) {
  const Json* const m = look(name);
  if (m && m->is_number()) {
    value = m->get<double>();
    if (value >= low && value <= high) return true;
  }
  return expect(name, m, fmt::format("a number from {} to {}", limit_text(low), limit_text(high)));
}

bool Fields::length(std::string_view name, float& value, float low, float high) {
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

bool Fields::whole(std::string_view name, std::int64_t& value, std::int64_t low, std::int64_t high) {
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

bool Fields::vector(std::string_view name, glm::dvec3& value, double limit) {
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

const Json* Fields::object(std::string_view name) { return member(name, "an object", &Json::is_object); }

const Json* Fields::list(std::string_view name, std::size_t most) {
  const Json* const m = member(name, "an array", &Json::is_array);
  if (!m || m->size() <= most) return m;
  fail(name, fmt::format("more than the limit of {}", most));
  return nullptr;
}

std::string Fields::unknown(std::vector<std::string>& warnings) const {
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

}  // namespace coaster::exchange
