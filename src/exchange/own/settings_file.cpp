// Reads and prints a user's settings as JSON: one row for each member, each with a default for invalid values. The rows
// of session settings are made from the tables of the settings.
#include "exchange/own/settings_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/json.h"
#include "world/settings_groups.h"

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
// Returns the shortest number that reads back the same. Readers parse to double: if rounding twice would miss a float,
// its exact value is written.
template <class T>
Json exact(T value) {
  if (value == std::floor(value) && std::abs(value) < 1e9) return static_cast<std::int64_t>(value);
  const auto shortest = base::parse_double(base::to_text(value));
  return shortest && static_cast<T>(*shortest) == value ? *shortest : double{value};
}

// Members in the order of the file. Each reads its value, or leaves the settings unchanged if it is invalid, and
// describes what it expects.
struct Member {
  std::string_view name;
  std::string expected;
  bool (*read)(const Json& value, UserSettings& to);
  Json (*print)(const UserSettings& settings);
};
constexpr std::string_view kSwitch = "true or false";

template <auto Setting>
Member kept_member() {
  using T = world::ValueOf<Setting>;
  static constexpr world::SettingRow kRow = world::setting_row<Setting>();
  Member member{kRow.kept_as, {}, {}, {}};
  if constexpr (std::is_enum_v<T>) {
    member.expected = base::alternatives_of<T>();
    member.read = [](const Json& value, UserSettings& to) {
      const auto named = value.is_string() ? base::value_named<T>(value.get<std::string>()) : std::nullopt;
      if (named) world::value_in<Setting>(to.session) = *named;
      return named.has_value();
    };
    member.print = [](const UserSettings& s) {
      return Json(std::string(base::name_of(world::value_in<Setting>(s.session))));
    };
  } else if constexpr (std::is_same_v<T, bool>) {
    member.expected = kSwitch;
    member.read = [](const Json& value, UserSettings& to) { return read(value, world::value_in<Setting>(to.session)); };
    member.print = [](const UserSettings& s) { return Json(world::value_in<Setting>(s.session)); };
  } else {
    member.expected = fmt::format("a number from {} to {}", base::to_text(kRow.low), base::to_text(kRow.high));
    member.read = [](const Json& value, UserSettings& to) {
      double number = 0;
      if (!read(value, kRow.low, kRow.high, number)) return false;
      world::value_in<Setting>(to.session) = static_cast<T>(number);
      return true;
    };
    member.print = [](const UserSettings& s) { return exact(world::value_in<Setting>(s.session)); };
  }
  return member;
}

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
  std::vector<KeyBinding> keys;
  for (const auto& [action, chosen] : value.items()) {
    KeyBinding choice{action, {}};
    if (chosen.is_string()) {
      choice.keys.push_back(chosen.get<std::string>());
    } else if (!read(chosen, choice.keys, 2)) {
      return false;
    }
    std::erase(choice.keys, "");  // "" is no key
    keys.push_back(std::move(choice));
  }
  to.keys = std::move(keys);
  return true;
}
Json print_keys(const UserSettings& s) {
  Json keys = Json::object();
  for (const KeyBinding& choice : s.keys)
    keys[choice.action] = choice.keys.size() == 1 ? Json(choice.keys[0])
                          : choice.keys.empty()   ? Json("")
                                                  : Json(choice.keys);
  return keys;
}

// Members outside the session keep their former positions.
const std::vector<Member>& members() {
  static const std::vector<Member> all = [] {
    std::vector<Member> made;
    const auto add_group = [&]<class Group>(std::type_identity<Group>) {
      if constexpr (std::is_same_v<Group, world::EditingAids>) {
        made.push_back({"autosave_seconds", "a number from 5 to 3600",
                        [](const Json& value, UserSettings& to) {
                          return read(value, kMinAutosave, kMaxAutosave, to.autosave_seconds);
                        },
                        [](const UserSettings& s) { return exact(s.autosave_seconds); }});
        made.push_back({"window", "x, y, width and height", read_window, print_window});
        made.push_back({"recent", "a list of at most 10 files",
                        [](const Json& value, UserSettings& to) { return read(value, to.recent, kMaxRecent); },
                        [](const UserSettings& s) { return Json(s.recent); }});
      }
      world::for_each_setting_of<Group>([&]<auto Setting>() {
        if constexpr (!world::setting_row<Setting>().kept_as.empty()) made.push_back(kept_member<Setting>());
      });
    };
    [&]<class... Groups>(world::GroupList<Groups...>) {
      (add_group(std::type_identity<Groups>()), ...);
    }(world::SettingGroups());
    made.push_back({"start_screen", std::string(kSwitch),
                    [](const Json& value, UserSettings& to) { return read(value, to.start_screen); },
                    [](const UserSettings& s) { return Json(s.start_screen); }});
    made.push_back({"keys", "names of actions with a key, or a list of two", read_keys, print_keys});
    return made;
  }();
  return all;
}

bool is_known(std::string_view name) {
  return name == "format" || name == "version" ||
         std::any_of(members().begin(), members().end(), [&](const Member& m) { return m.name == name; });
}

// Keeps the unknown members, unless they are too large.
void keep_others(const Json& tree, LoadedSettings& loaded) {
  Json others = Json::object();
  auto& members = static_cast<Json::object_t::Container&>(others.get_ref<Json::object_t&>());
  for (const auto& [key, value] : tree.items())
    if (!is_known(key)) members.emplace_back(key, value);
  if (others.empty()) return;
  std::string text = json_line(others);
  if (text.size() <= kMaxOtherBytes) loaded.settings.others = std::move(text);
  else
    loaded.warnings.push_back(fmt::format("{} unknown members have {} bytes, over the limit of {}, and are not kept",
                                          others.size(), text.size(), kMaxOtherBytes));
}

}  // namespace

UserSettings::UserSettings() {
  world::for_each_setting([&]<auto Setting>() {
    constexpr int kForUser = world::setting_row<Setting>().for_user;
    if constexpr (kForUser >= 0) world::value_in<Setting>(session) = static_cast<world::ValueOf<Setting>>(kForUser);
  });
}

base::Result<LoadedSettings> parse_settings(std::string_view text, std::string_view name) {
  const base::Result<Json> tree = read_json(text, name);
  if (!tree) return tree.status();
  if (!tree->is_object()) return bad_file(name, "expected an object, found " + describe(*tree));
  if (const auto format = tree->find("format"); format == tree->end() || *format != kSettingsFormat)
    return bad_file(name, fmt::format("format: expected \"{}\", found {}", kSettingsFormat,
                                      format == tree->end() ? "none" : describe(*format)));
  LoadedSettings loaded;
  if (const auto version = tree->find("version"); version != tree->end() && version->is_number()) {
    if (version->get<double>() > kSettingsVersion)
      return bad_file(name, fmt::format("version: version {} is newer than this program supports ({})",
                                        describe(*version), kSettingsVersion));
  } else {
    loaded.warnings.push_back(fmt::format("version: expected {}, found {}", kSettingsVersion,
                                          version == tree->end() ? "none" : describe(*version)));
  }
  for (const Member& member : members()) {
    const auto found = tree->find(std::string(member.name));
    if (found == tree->end() || member.read(*found, loaded.settings)) continue;
    loaded.warnings.push_back(fmt::format("{}: expected {}, found {}", member.name, member.expected, describe(*found)));
  }
  keep_others(*tree, loaded);
  return loaded;
}

std::string print_settings(const UserSettings& settings) {
  Json tree = Json::object();
  tree["format"] = kSettingsFormat;
  tree["version"] = kSettingsVersion;
  for (const Member& member : members()) tree[std::string(member.name)] = member.print(settings);
  if (!settings.others.empty()) {
    if (const base::Result<Json> others = read_json(settings.others, "others"); others && others->is_object())
      for (const auto& [key, value] : others->items())
        if (!is_known(key)) tree[key] = value;
  }
  return json_file(tree);
}

void remember(std::vector<std::string>& recent, std::string file) {
  std::erase(recent, file);
  recent.insert(recent.begin(), std::move(file));
  if (recent.size() > kMaxRecent) recent.resize(kMaxRecent);
}

}  // namespace coaster::exchange
