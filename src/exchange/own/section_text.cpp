#include "exchange/own/section_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "base/utf8.h"
#include "world/element_rows.h"
#include "world/sections.h"

namespace coaster::exchange {
namespace {

constexpr world::SectionKind kOwnKinds[] = {world::SectionKind::free, world::SectionKind::complete,
                                            world::SectionKind::force};
constexpr std::string_view kSides[] = {"left", "right"};

// Returns the values of "kind".
std::vector<std::string> kinds() {
  std::vector<std::string> names = base::names_in(world::elements());
  names.insert(names.begin(), std::string(base::name_of(world::SectionKind::free)));
  for (const world::SectionKind own : kOwnKinds)
    if (own != world::SectionKind::free) names.emplace_back(base::name_of(own));
  return names;
}

bool read_side(Fields& fields, world::Element& element) {
  if (!fields.has("side")) return true;
  std::string side;
  if (!fields.text("side", side)) return false;
  element.right = side == kSides[1];
  return element.right || side == kSides[0] || fields.reject("side", R"("left" or "right")");
}

bool read_choice(Fields& fields, const world::ElementParameter& parameter, double& value) {
  std::string name;
  if (!fields.text(parameter.name, name)) return false;
  const std::vector<std::string> names = base::names_in(parameter.names);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return fields.reject(parameter.name, base::alternatives(names, "\""));
  value = static_cast<double>(found - names.begin());
  return true;
}

bool read_parameters(Fields& fields, world::Element& element) {
  const std::span<const world::ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const world::ElementParameter& parameter = parameters[i];
    double& value = element.values[i];
    if (!fields.has(parameter.name)) continue;
    if (!parameter.names.empty()) {
      if (!read_choice(fields, parameter, value)) return false;
      continue;
    }
    if (!fields.number(parameter.name, value, parameter.low, parameter.high)) return false;
    if (value == 0) value = 0;  // not -0, which is printed as 0
  }
  return true;
}

bool read_kind(Fields& fields, world::Section& section) {
  std::string kind;
  if (!fields.text("kind", kind)) return false;
  for (const world::SectionKind own : kOwnKinds)
    if (kind == base::name_of(own)) return section.kind = own, true;
  const auto element = base::value_named<world::ElementKind>(kind);
  if (!element || world::is_of_forces(*element)) return fields.reject("kind", base::alternatives(kinds(), "\""));
  section.kind = world::SectionKind::element;
  section.element = world::usual_element(*element);
  if (base::row_of(*element).sided && !read_side(fields, section.element)) return false;
  return read_parameters(fields, section.element);
}

bool read_title(Fields& fields, std::string& title) {
  if (!fields.has("title")) return true;
  if (!fields.text("title", title)) return false;
  const bool fits = title.size() <= world::kMaxNameBytes && base::is_printable_utf8(title);
  return fits || fields.reject("title", fmt::format("a line of at most {} bytes", world::kMaxNameBytes));
}

}  // namespace

std::string section_members(const world::Section& section, std::size_t segments) {
  std::string text = fmt::format("\"segments\": {}, \"kind\": \"{}\"", segments, world::kind_name(section));
  if (section.kind == world::SectionKind::element) {
    const world::ElementRow& row = base::row_of(section.element.kind);
    if (row.sided) text += fmt::format(", \"side\": \"{}\"", kSides[section.element.right ? 1 : 0]);
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
      const double value = section.element.values[i];
      const world::ElementParameter& parameter = row.parameters[i];
      const std::string shown = !parameter.names.empty() ? json_string(world::choice_of(parameter, value).name)
                                : value == 0             ? "0"
                                                         : base::to_text(value);
      text += fmt::format(", \"{}\": {}", parameter.name, shown);
    }
  }
  if (!section.title.empty()) text += ", \"title\": " + json_string(section.title);
  return text;
}

bool read_section_members(Fields& fields, std::size_t left, world::Section& section, std::size_t& segments) {
  std::int64_t count = 0;
  if (!fields.whole("segments", count, 1, world::kMaxKnots)) return false;
  segments = static_cast<std::size_t>(count);
  if (segments > left) return fields.reject("segments", fmt::format("at most the {} segments that are left", left));
  return read_kind(fields, section) && read_title(fields, section.title);
}

}  // namespace coaster::exchange
