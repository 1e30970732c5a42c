// Prints a document as a track file. The same document always gives the same bytes.
#include "exchange/own/track_file.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/json.h"
#include "exchange/own/park_member.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/sections.h"

namespace coaster::exchange {
namespace {

using world::Document;
using world::Entity;

// -0 is read back as the whole number 0, so it is written as 0; otherwise printing twice would differ.
std::string number(double value) { return value == 0 ? "0" : base::to_text(value); }

// Returns `"segments": 3, "kind": "loop", "side": "left", "height": 16, ...`.
std::string section_members(const world::Section& section, std::size_t segments) {
  std::string text = fmt::format("\"segments\": {}, \"kind\": \"{}\"", segments, world::kind_name(section));
  if (section.kind == world::SectionKind::element) {
    const world::ElementRow& row = base::row_of(section.element.kind);
    if (row.sided) text += fmt::format(", \"side\": \"{}\"", section.element.right ? "right" : "left");
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
      const double value = section.element.values[i];
      const world::ElementParameter& parameter = row.parameters[i];
      const std::string shown =
          !parameter.names.empty() ? json_string(world::choice_of(parameter, value).name) : number(value);
      text += fmt::format(", \"{}\": {}", parameter.name, shown);
    }
  }
  if (!section.title.empty()) text += ", \"title\": " + json_string(section.title);
  return text;
}

std::string key_text(const world::ForceKey& key) {
  const bool shaped = key.slope != 0 || key.before != 0 || key.after != 0;
  std::string text = fmt::format("[{}, {}", number(key.at), number(key.value));
  if (shaped) text += fmt::format(", {}, {}, {}", number(key.slope), number(key.before), number(key.after));
  return text + "]";
}

std::string list_text(const std::vector<world::ForceKey>& keys) {
  std::string text = "[";
  for (const world::ForceKey& key : keys) text += (text.size() == 1 ? "" : ", ") + key_text(key);
  return text + "]";
}

// Returns `, "vertical": [[0, 1], [20, 3.5, 0.1, 5, 8]], "roll": [...]`: the position, the value and, if not 0, the
// slope and the lengths of the handles of each key. Channels without keys are left out.
std::string force_keys(const world::ForceProgram& force) {
  std::string text;
  for (std::size_t c = 0; c < force.channels.size(); ++c) {
    if (force.channels[c].empty()) continue;
    text +=
        fmt::format(", \"{}\": {}", base::name_of(static_cast<world::ForceChannel>(c)), list_text(force.channels[c]));
  }
  return text;
}

// Readers parse to double. If rounding twice would miss the float, its exact value in double is written.
std::string number(float value) {
  if (value == 0) return "0";
  std::string text = base::to_text(value);
  const auto wide = base::parse_double(text);
  return wide && static_cast<float>(*wide) == value ? text : base::to_text(static_cast<double>(value));
}

std::string vector(glm::vec3 v) { return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z)); }
std::string id(const Document& document, Entity e) { return json_string(world::label_of(document, e)); }

// Returns the unknown members that were kept, each after `separator`.
std::string extra_members(const world::UnknownMembers& extra, std::string_view separator) {
  std::string text;
  if (extra.json.empty()) return text;
  const auto tree = read_json(extra.json, "extra");
  COASTER_CHECK(tree && tree->is_object(), "kept members are the text of a JSON object");
  for (const auto& [key, value] : tree->items())
    text += fmt::format("{}{}: {}", separator, json_string(key), json_line(value));
  return text;
}

std::string value_text(const Document&, glm::vec3 v) { return vector(v); }
std::string value_text(const Document& document, Entity e) { return id(document, e); }
std::string value_text(const Document&, world::Colour colour) { return json_string(world::to_text(colour)); }
std::string value_text(const Document&, bool value) { return value ? "true" : "false"; }
template <class T>
std::string value_text(const Document&, T value) {
  if constexpr (base::Named<T>) return fmt::format("\"{}\"", base::name_of(value));
  else if constexpr (std::is_integral_v<T>) return std::to_string(value);
  else return number(value);
}

// Returns the members of a component, each after `separator`. Default values are omitted where files may omit them.
template <class T>
std::string members(const Document& document, const T& component, std::string_view separator = ", ") {
  const T usual;
  std::string text;
  T::fields([&](const world::Field& field, auto member) {
    const auto& value = component.*member;
    if constexpr (world::HasFields<std::remove_cvref_t<decltype(value)>>) text += members(document, value, separator);
    else if (field.in_file != world::FilePresence::unusual || !(value == usual.*member))
      text += fmt::format("{}\"{}\": {}", separator, field.name, value_text(document, value));
  });
  return text;
}

// Returns the line of an entity with its members, each after a comma and a blank.
std::string entity_line(const Document& document, Entity e, std::string text) {
  if (const auto* const extra = document.entities.find<world::UnknownMembers>(e)) text += extra_members(*extra, ", ");
  return fmt::format("{{\"id\": {}{}}}", id(document, e), text);
}

template <class Component>
std::string component_line(const Document& document, Entity e) {
  return entity_line(document, e, members(document, document.entities.get<Component>(e)));
}

std::string segment_line(const Document& document, Entity e) {
  const world::Segment& s = world::segment(document, e);
  std::string text =
      fmt::format(", \"from\": {}, \"to\": {}{}", id(document, s.from), id(document, s.to), members(document, s));
  world::Fittings::for_each([&]<class T>() {
    if (const T* const fitting = document.entities.find<T>(e)) text += members(document, *fitting);
  });
  return entity_line(document, e, std::move(text));
}

std::string section_line(const Document& document, const world::SectionRun& run) {
  const world::Section& section = world::section(document, run.section);
  std::string text = ", " + section_members(section, run.count);
  if (section.kind == world::SectionKind::complete) text += members(document, section.closing);
  if (section.kind == world::SectionKind::force) text += members(document, section.force) + force_keys(section.force);
  text += members(document, section.paint);
  if (section.earthwork != world::Earthwork{})
    text += fmt::format(", \"earthwork\": \"{}\"", base::name_of(section.earthwork));
  return entity_line(document, run.section, std::move(text));
}

// ,\n  "key": [ one line each ]
template <class Item, class Line>
void print_list(std::string& out, std::string_view key, const Document& document, const std::vector<Item>& items,
                Line line) {
  out += fmt::format(",\n  \"{}\": [", key);
  for (std::size_t i = 0; i < items.size(); ++i) out += (i == 0 ? "\n    " : ",\n    ") + line(document, items[i]);
  out += items.empty() ? "]" : "\n  ]";
}

}  // namespace

std::string print_keys(const CopiedForceKeys& copied) {
  const std::string of =
      copied.of == world::ForceQuantity::forces ? "" : fmt::format("\"of\": \"{}\", ", base::name_of(copied.of));
  return fmt::format("{{\"force-keys\": \"{}\", {}\"keys\": {}}}", base::name_of(copied.over), of,
                     list_text(copied.keys));
}

int version_of(const Document& document) {
  const auto& sections = document.entities.pool<world::Section>().items();
  const bool plain = document.kind == world::CoasterKind{} && document.paint == world::Paint{} &&
                     document.park.plain() && std::ranges::all_of(sections, [](const world::Section& s) {
                       return s.paint == world::Paint{} && s.earthwork == world::Earthwork{};
                     });
  return plain ? 3 : kTrackVersion;
}

std::string print_track(const Document& document) {
  std::string out = fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"name\": {},\n  \"closed\": {}{}",
                                kTrackFormat, version_of(document), json_string(document.name), document.track.closed,
                                members(document, document, ",\n  "));
  if (!document.park.plain()) out += ",\n  \"park\": " + park_member(document.park);
  print_list(out, "knots", document, document.track.knots, component_line<world::Knot>);
  print_list(out, "segments", document, document.track.segments, segment_line);
  print_list(out, "sections", document, world::sections_of(document), section_line);
  std::vector<Entity> carts = document.entities.pool<world::Train>().entities();
  std::ranges::sort(carts, {}, [&](Entity cart) { return world::name_of(document, cart); });
  print_list(out, "carts", document, carts, component_line<world::Train>);
  return out + extra_members(document.extra, ",\n  ") + "\n}\n";
}

}  // namespace coaster::exchange
