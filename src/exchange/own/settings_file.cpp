// A user's settings from and to JSON: one row for each member, each with its own default where the file has something
// else.
#include "exchange/own/settings_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/json_reader.h"

namespace coaster::exchange {
namespace {

bool read(const Json& value, bool& to) {
  if (!value.is_boolean()) return false;
  to = value.get<bool>();
  return true;
}
bool read(const Json& value, double low, double high, double& to) {
  if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) return false;
  to = value.get<double>();
  return true;
}
bool read(const Json& value, std::vector<std::string>& to, std::size_t most) {
  if (!value.is_array() || value.size() > most) return false;
  std::vector<std::string> texts;
  for (const Json& item : value) {
    if (!item.is_string()) return false;
    texts.push_back(item.get<std::string>());
  }
  to = std::move(texts);
  return true;
}
Json numbers(double value) {
  return value == std::floor(value) && std::abs(value) < 1e9 ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

// Members in the order of the file. Each reads its value and leaves the settings alone where it is no such thing, and
// says what it expects.
struct Member {
  std::string_view name, expected;
  bool (*read)(const Json& value, UserSettings& to);
  Json (*print)(const UserSettings& settings);
};
template <bool UserSettings::*flag>
constexpr Member flag_row(std::string_view name) {
  return {name, "true or false", [](const Json& v, UserSettings& to) { return read(v, to.*flag); },
          [](const UserSettings& s) { return Json(s.*flag); }};
}

bool read_scale(const Json& value, UserSettings& to) {
  double scale = 0;
  if (!read(value, kMinUiScale, kMaxUiScale, scale)) return false;
  to.ui_scale = static_cast<float>(scale);
  return true;
}
Json print_scale(const UserSettings& s) { return numbers(std::round(double{s.ui_scale} * 1e4) / 1e4); }

// By the names of an enumeration.
template <auto member>
bool read_name(const Json& value, UserSettings& to) {
  if (!value.is_string()) return false;
  const auto found = base::value_named<std::remove_reference_t<decltype(to.*member)>>(value.get<std::string>());
  if (found) to.*member = *found;
  return found.has_value();
}
template <auto member>
Json print_name(const UserSettings& s) {
  return std::string(base::name_of(s.*member));
}
template <auto member>
constexpr Member name_row(std::string_view name, std::string_view expected) {
  return {name, expected, read_name<member>, print_name<member>};
}

bool read_sound(const Json& value, UserSettings& to) {
  double loudness = 0;
  if (!read(value, 0, 1, loudness)) return false;
  to.sound = static_cast<float>(loudness);
  return true;
}
Json print_sound(const UserSettings& s) { return numbers(std::round(double{s.sound} * 1e4) / 1e4); }

bool read_autosave(const Json& value, UserSettings& to) {
  return read(value, kMinAutosave, kMaxAutosave, to.autosave_seconds);
}
Json print_autosave(const UserSettings& s) { return numbers(s.autosave_seconds); }

bool read_window(const Json& value, UserSettings& to) {
  constexpr double kFarthest = 1e6, kLargest = 65536;
  if (value.is_null()) return true;
  if (!value.is_object()) return false;
  const std::array<std::string_view, 4> names{"x", "y", "width", "height"};
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = value.find(std::string(names[i]));
    if (found == value.end() || !read(*found, i < 2 ? -kFarthest : 1, i < 2 ? kFarthest : kLargest, numbers[i]))
      return false;
  }
  WindowPlace place{static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2]),
                    static_cast<int>(numbers[3])};
  if (const auto found = value.find("maximised"); found != value.end() && !read(*found, place.maximised)) return false;
  to.window = place;
  return true;
}
Json print_window(const UserSettings& s) {
  if (!s.window) return nullptr;
  return {{"x", s.window->x},
          {"y", s.window->y},
          {"width", s.window->width},
          {"height", s.window->height},
          {"maximised", s.window->maximised}};
}

bool read_keys(const Json& value, UserSettings& to) {
  if (!value.is_object() || value.size() > 1000) return false;
  std::vector<KeyChoice> keys;
  for (const auto& [action, chosen] : value.items()) {
    KeyChoice choice{action, {}};
    if (chosen.is_string()) {
      if (!chosen.get<std::string>().empty()) choice.keys.push_back(chosen.get<std::string>());
    } else if (!read(chosen, choice.keys, 2)) {
      return false;
    }
    keys.push_back(std::move(choice));
  }
  to.keys = std::move(keys);
  return true;
}
Json print_keys(const UserSettings& s) {
  Json keys = Json::object();
  for (const KeyChoice& choice : s.keys)
    keys[choice.action] = choice.keys.size() == 1 ? Json(choice.keys[0])
                          : choice.keys.empty()   ? Json("")
                                                  : Json(choice.keys);
  return keys;
}

constexpr std::array kMembers{
    Member{"ui_scale", "a number from 0.75 to 3", read_scale, print_scale},
    name_row<&UserSettings::theme>("theme", "dark, light or high_contrast"),
    name_row<&UserSettings::style>("style", "day, dusk or blueprint"),
    flag_row<&UserSettings::shadows>("shadows"),
    Member{"sound", "a number from 0 to 1", read_sound, print_sound},
    flag_row<&UserSettings::panels>("panels"),
    flag_row<&UserSettings::laboratory>("laboratory"),
    flag_row<&UserSettings::reduced_motion>("reduced_motion"),
    flag_row<&UserSettings::head_bob>("head_bob"),
    Member{"autosave_seconds", "a number from 5 to 3600", read_autosave, print_autosave},
    Member{"window", "x, y, width and height", read_window, print_window},
    Member{"recent", "a list of at most 10 files",
           [](const Json& v, UserSettings& to) { return read(v, to.recent, kMaxRecent); },
           [](const UserSettings& s) { return Json(s.recent); }},
    flag_row<&UserSettings::hints>("hints"),
    flag_row<&UserSettings::card>("card"),
    flag_row<&UserSettings::gizmo>("gizmo"),
    flag_row<&UserSettings::start_screen>("start_screen"),
    Member{"keys", "names of actions with a key, or a list of two", read_keys, print_keys},
};

bool is_known(std::string_view name) {
  return name == "format" || name == "version" ||
         std::any_of(kMembers.begin(), kMembers.end(), [&](const Member& m) { return m.name == name; });
}

}  // namespace

base::Result<LoadedSettings> parse_settings(std::string_view text, std::string_view name) {
  const base::Result<Json> tree = read_json(text, name);
  if (!tree) return tree.status();
  const auto bad = [&](const std::string& what) {
    return base::Status{base::Code::bad_file, fmt::format("{}: error: {}", name, what)};
  };
  if (!tree->is_object()) return bad("expected an object, found " + describe(*tree));
  if (const auto format = tree->find("format"); format == tree->end() || *format != kSettingsFormat)
    return bad(fmt::format("format: expected \"{}\", found {}", kSettingsFormat,
                           format == tree->end() ? "none" : describe(*format)));
  LoadedSettings loaded;
  for (const Member& member : kMembers) {
    const auto found = tree->find(std::string(member.name));
    if (found == tree->end() || member.read(*found, loaded.settings)) continue;
    loaded.warnings.push_back(fmt::format("{}: expected {}, found {}", member.name, member.expected, describe(*found)));
  }
  Json others = Json::object();
  for (const auto& [key, value] : tree->items())
    if (!is_known(key)) others[key] = value;
  if (!others.empty()) loaded.settings.others = json_line(others);
  return loaded;
}

std::string print_settings(const UserSettings& settings) {
  Json tree = Json::object();
  tree["format"] = kSettingsFormat;
  tree["version"] = kSettingsVersion;
  for (const Member& member : kMembers) tree[std::string(member.name)] = member.print(settings);
  if (!settings.others.empty()) {
    if (const base::Result<Json> others = read_json(settings.others, "others"); others && others->is_object())
      for (const auto& [key, value] : others->items())
        if (!is_known(key)) tree[key] = value;
  }
  return json_file(tree);
}

void remember(std::vector<std::string>& recent, std::string file) {
  recent.erase(std::remove(recent.begin(), recent.end(), file), recent.end());
  recent.insert(recent.begin(), std::move(file));
  if (recent.size() > kMaxRecent) recent.resize(kMaxRecent);
}

}  // namespace coaster::exchange
