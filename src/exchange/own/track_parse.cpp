// Builds a document from a track file's tree. Checks everything that docs/track-format.md promises.
#include "exchange/own/track_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <glm/glm.hpp>

#include "base/text.h"
#include "exchange/own/json.h"
#include "exchange/own/park_member.h"
#include "sim/shape/roll.h"
#include "world/components.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

using world::Document;
using world::Entity;
using world::EntityKind;

// The state of a parse. `error` is the first error, without the file's name.
struct TrackParse {
  world::Document document;
  std::vector<std::string> warnings;
  std::string error;
  int version = kTrackVersion;
  // Knots or segments read while the file was parsed: how many, and why the next one could not be read.
  struct StreamedItems {
    std::size_t count = 0;
    std::string error;
  };
  StreamedItems knots, segments;
  std::array<std::unordered_map<std::uint32_t, world::Entity>, base::count_of<world::EntityKind>()>
      by_number;  // by world::EntityKind
};

constexpr std::uint32_t kMaxIdNumber = 1'000'000'000;  // leaves room for the numbers of new entities
constexpr double kShortVector = 1e-9;

// Unit vectors keep their bits; others are normalised before they are rounded to float.
glm::vec3 direction(glm::dvec3 v) {
  const double square = glm::dot(v, v);
  return glm::vec3(std::abs(square - 1.0) <= 1e-6 ? v : v / std::sqrt(square));
}

// Returns "k3" in quotation marks.
std::string quoted_id(world::EntityKind kind, std::uint32_t number) {
  return fmt::format("\"{}\"", world::to_text(world::EntityName{kind, number}));
}

// Reads a member that names an entity: "k3".
bool read_id(JsonFieldReader& fields, std::string_view member, world::EntityKind kind, std::uint32_t& number) {
  std::string text;
  if (!fields.text(member, text)) return false;
  const auto name = world::parse_name(text);
  if (!name || name->kind != kind || name->number > kMaxIdNumber)
    return fields.reject(member, "an id such as " + quoted_id(kind, 3));
  number = name->number;
  return true;
}

// Reads a unit vector: any vector with a direction is normalised before it is rounded.
bool read_direction(JsonFieldReader& fields, std::string_view member, glm::vec3& value) {
  constexpr double kAny = 1e30;  // squares stay finite
  glm::dvec3 v;
  if (!fields.vector(member, v, kAny)) return false;
  if (!(glm::length(v) >= kShortVector)) return fields.reject(member, "a vector with a direction");
  value = direction(v);
  return true;
}

// Reads the value of one field, within its limits.
template <class T>
bool read_value(TrackParse& parse, JsonFieldReader& fields, const world::Field& field, T& value) {
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
    return fields.named(field.name, value);
  } else if constexpr (std::is_same_v<T, world::Colour>) {
    std::string text;
    if (!fields.text(field.name, text)) return false;
    const auto colour = world::parse_colour(text);
    if (!colour) return fields.reject(field.name, "a colour such as \"#d9452f\", or \"own\"");
    value = *colour;
    return true;
  } else {
    static_assert(std::is_same_v<T, world::Entity>);
    std::uint32_t number = 0;
    if (!read_id(fields, field.name, world::EntityKind::segment, number)) return false;
    const auto& segments = parse.by_number[static_cast<std::size_t>(world::EntityKind::segment)];
    const auto found = segments.find(number);
    if (found == segments.end())
      return fields.fail(field.name, "there is no segment " + quoted_id(world::EntityKind::segment, number));
    value = found->second;
    return true;
  }
}

// Reads the fields of a component, in order. Optional fields that are missing keep their default values.
template <class T>
bool read_component(TrackParse& parse, JsonFieldReader& fields, T& component) {
  bool good = true;
  T::fields([&](const world::Field& field, auto member) {
    auto& value = component.*member;
    if constexpr (world::HasFields<std::remove_cvref_t<decltype(value)>>) {
      good = good && read_component(parse, fields, value);
    } else if (good && (field.in_file == world::FilePresence::required || fields.has(field.name))) {
      good = read_value(parse, fields, field, value);
    }
  });
  return good;
}

constexpr world::SectionKind kOwnKinds[] = {world::SectionKind::free, world::SectionKind::complete,
                                            world::SectionKind::force};

// Returns the values of "kind".
std::vector<std::string> kinds() {
  std::vector<std::string> names = base::names_in(world::elements());
  names.insert(names.begin(), std::string(base::name_of(world::SectionKind::free)));
  for (const world::SectionKind own : kOwnKinds)
    if (own != world::SectionKind::free) names.emplace_back(base::name_of(own));
  return names;
}

bool read_side(JsonFieldReader& fields, world::Element& element) {
  if (!fields.has("side")) return true;
  std::string side;
  if (!fields.text("side", side)) return false;
  element.right = side == "right";
  return element.right || side == "left" || fields.reject("side", R"("left" or "right")");
}

bool read_choice(JsonFieldReader& fields, const world::ElementParameter& parameter, double& value) {
  std::string name;
  if (!fields.text(parameter.name, name)) return false;
  const std::vector<std::string> names = base::names_in(parameter.names);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return fields.reject(parameter.name, base::alternatives(names, "\""));
  value = static_cast<double>(found - names.begin());
  return true;
}

bool read_parameters(JsonFieldReader& fields, world::Element& element) {
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

bool read_kind(JsonFieldReader& fields, world::Section& section) {
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

bool read_title(JsonFieldReader& fields, std::string& title) {
  if (!fields.has("title")) return true;
  if (!fields.text("title", title)) return false;
  const bool fits = title.size() <= world::kMaxNameBytes && base::is_printable_utf8(title);
  return fits || fields.reject("title", fmt::format("a line of at most {} bytes", world::kMaxNameBytes));
}

// Reads the section. Missing parameters have their default values. Returns false after a failure, also with more
// segments than are `left`.
bool read_section_members(JsonFieldReader& fields, std::size_t left, world::Section& section, std::size_t& segments) {
  std::int64_t count = 0;
  if (!fields.whole("segments", count, 1, world::kMaxKnots)) return false;
  segments = static_cast<std::size_t>(count);
  if (segments > left) return fields.reject("segments", fmt::format("at most the {} segments that are left", left));
  return read_kind(fields, section) && read_title(fields, section.title);
}

constexpr std::size_t kFew = 2, kAll = 5;  // numbers in a key, at least and at most

bool read_key(JsonFieldReader& fields, std::string_view channel, std::size_t index, const Json& value,
              world::ForceKey& key) {
  const auto wrong = [&] {
    return fields.fail(fmt::format("{}[{}]", channel, index),
                       fmt::format("expected {} or {} numbers, found {}", kFew, kAll, describe(value)));
  };
  if (!value.is_array() || (value.size() != kFew && value.size() != kAll)) return wrong();
  double* const members[] = {&key.at, &key.value, &key.slope, &key.before, &key.after};
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_number()) return wrong();
    *members[i] = value[i].get<double>();
    if (*members[i] == 0) *members[i] = 0;  // not -0, which is printed as 0
  }
  return true;
}

bool read_list(JsonFieldReader& fields, std::string_view member, std::vector<world::ForceKey>& keys) {
  const Json* const list = fields.list(member, world::kMostForceKeys);
  if (!list) return false;
  keys.resize(list->size());
  for (std::size_t i = 0; i < list->size(); ++i)
    if (!read_key(fields, member, i, (*list)[i], keys[i])) return false;
  return true;
}

// Reads the keys of all channels. Returns false after a failure, also for a program beyond its limits.
bool read_force_keys(JsonFieldReader& fields, world::ForceProgram& force) {
  for (std::size_t c = 0; c < force.channels.size(); ++c) {
    const std::string_view name = base::name_of(static_cast<world::ForceChannel>(c));
    if (fields.has(name) && !read_list(fields, name, force.channels[c])) return false;
  }
  const auto wrong = world::broken(force);
  return !wrong || fields.fail({}, *wrong);
}

constexpr double kParallel = 1e-6;  // sine of the angle between tangent and up

// Creates the entity of an "id" member, with its name.
bool create(TrackParse& parse, JsonFieldReader& fields, EntityKind kind, Entity& e) {
  std::uint32_t number = 0;
  if (!read_id(fields, "id", kind, number)) return false;
  auto& taken = parse.by_number[static_cast<std::size_t>(kind)];
  if (taken.contains(number)) return fields.fail("id", quoted_id(kind, number) + " is already used");
  e = parse.document.entities.create();
  parse.document.entities.put(e, world::EntityName{kind, number});
  taken.emplace(number, e);
  std::uint32_t& last = parse.document.last_number[static_cast<std::size_t>(kind)];
  last = std::max(last, number);
  return true;
}

// Adds the component and the unknown members.
template <class Component>
bool keep(TrackParse& parse, const JsonFieldReader& fields, Entity e, Component component) {
  parse.document.entities.put(e, std::move(component));
  std::string extra = fields.unknown(parse.warnings);
  if (!extra.empty()) parse.document.entities.put(e, world::UnknownMembers{std::move(extra)});
  return true;
}

bool read_knot(TrackParse& parse, const Json& value, std::size_t index) {
  JsonFieldReader fields(value, {"knots", index}, parse.error);
  Entity e;
  world::Knot knot;
  if (!create(parse, fields, EntityKind::knot, e) || !read_component(parse, fields, knot)) return false;
  if (glm::length(glm::cross(glm::dvec3(knot.tangent), glm::dvec3(knot.up))) < kParallel)
    return fields.fail("up", "expected a vector that is not parallel to the tangent");
  world::orthonormalise(knot);
  if (knot.joint == world::JointKind::smooth && knot.in_length != knot.out_length)
    return fields.fail("joint", fmt::format("a smooth joint has equal handle lengths, found in {} and out {}",
                                            base::to_text(knot.in_length), base::to_text(knot.out_length)));
  parse.document.track.knots.push_back(e);
  return keep(parse, fields, e, knot);
}

// A segment has a fitting if its first member is present.
template <class T>
bool read_fitting(TrackParse& parse, JsonFieldReader& fields, Entity segment) {
  std::string_view first;
  T::fields([&](const world::Field& field, auto) {
    if (first.empty()) first = field.name;
  });
  if (!fields.has(first)) return true;
  T fitting;
  if (!read_component(parse, fields, fitting)) return false;
  parse.document.entities.put(segment, fitting);
  return true;
}

bool read_segment(TrackParse& parse, const Json& value, std::size_t index) {
  JsonFieldReader fields(value, {"segments", index}, parse.error);
  const auto& knots = parse.document.track.knots;
  world::Segment segment{knots[index], knots[(index + 1) % knots.size()], 0, {}};
  Entity e;
  if (!create(parse, fields, EntityKind::segment, e)) return false;
  for (const auto& [member, knot] : {std::pair{"from", segment.from}, std::pair{"to", segment.to}}) {
    std::uint32_t number = 0;
    const std::uint32_t expected = world::name_of(parse.document, knot).number;
    if (!read_id(fields, member, EntityKind::knot, number)) return false;
    if (number != expected)
      return fields.reject(member, quoted_id(EntityKind::knot, expected) + " (segments follow the order of the knots)");
  }
  if (!read_component(parse, fields, segment)) return false;
  bool good = true;
  world::Fittings::for_each([&]<class T>() { good = good && read_fitting<T>(parse, fields, e); });
  if (!good) return false;
  parse.document.track.segments.push_back(e);
  return keep(parse, fields, e, segment);
}

// Reads the section of the segments from index `first` on, and moves `first` beyond them.
bool read_section(TrackParse& parse, JsonFieldReader& fields, std::size_t& first) {
  const std::vector<Entity>& segments = parse.document.track.segments;
  Entity e;
  world::Section section;
  std::size_t count = 0;
  if (!create(parse, fields, EntityKind::section, e)) return false;
  if (!read_section_members(fields, segments.size() - first, section, count)) return false;
  if (section.kind == world::SectionKind::complete && !read_component(parse, fields, section.closing)) return false;
  if (section.kind == world::SectionKind::force &&
      !(read_component(parse, fields, section.force) && read_force_keys(fields, section.force)))
    return false;
  if (!read_component(parse, fields, section.paint)) return false;
  if (fields.has("earthwork") && !fields.named("earthwork", section.earthwork)) return false;
  for (; count > 0; --count) parse.document.entities.get<world::Segment>(segments[first++]).section = e;
  return keep(parse, fields, e, std::move(section));
}

// Files before version 3 have no sections: the whole track is one free section.
bool read_sections(TrackParse& parse, JsonFieldReader& fields) {
  const std::size_t count = parse.document.track.segments.size();
  if (parse.version < 3 && !fields.has("sections"))
    return count == 0 || world::make_section(parse.document, 0, count, {}).valid();
  std::size_t first = 0;
  return fields.each("sections", kAnyNumber, [&](JsonFieldReader& entry, auto) {
    return read_section(parse, entry, first);
  }) && (first == count || fields.fail("sections", fmt::format("expected {} segments in all, found {}", count, first)));
}

bool read_cart(TrackParse& parse, const Json& value, std::size_t index) {
  JsonFieldReader fields(value, {"carts", index}, parse.error);
  Entity e;
  world::Train cart;
  if (!create(parse, fields, EntityKind::cart, e) || !read_component(parse, fields, cart)) return false;
  if (cart.fraction == 1.0) return fields.fail("fraction", "expected a number below 1 (1 is the next segment's 0)");
  return keep(parse, fields, e, cart);
}

bool read_track_head(TrackParse& parse, JsonFieldReader& fields) {
  if (!fields.head(kTrackFormat, kTrackVersion, &parse.version)) return false;
  Document& document = parse.document;
  if (!fields.text("name", document.name)) return false;
  if (document.name.size() > world::kMaxNameBytes) {
    document.name = std::string(base::utf8_start(document.name, world::kMaxNameBytes));
    parse.warnings.push_back(fmt::format("name: cut to {} bytes", world::kMaxNameBytes));
  }
  return fields.flag("closed", document.track.closed) && read_component(parse, fields, document) &&
         read_park(fields, document.park, parse.warnings);
}

using ReadElement = bool (*)(TrackParse& parse, const Json& value, std::size_t index);

// Reads an element while the file is parsed. Its error is kept until everything before it is known.
bool take(TrackParse& parse, TrackParse::StreamedItems& taken, ReadElement read, const Json& element,
          std::size_t index) {
  if (index != taken.count || !taken.error.empty()) return false;
  if (read(parse, element, index)) return ++taken.count, true;
  taken.error = std::exchange(parse.error, {});
  return false;
}

// Takes knots, and segments if they come after all knots.
bool take_element(TrackParse& parse, const Json& root, std::string_view list, std::size_t index, const Json& element) {
  if (list == "knots" && index < world::kMaxKnots) return take(parse, parse.knots, read_knot, element, index);
  if (list != "segments" || index >= parse.knots.count) return false;
  const auto knots = root.find("knots");
  return knots != root.end() && knots->is_array() && knots->size() == parse.knots.count &&
         take(parse, parse.segments, read_segment, element, index);
}

// Reads the elements that were not taken while the file was parsed.
bool read_rest(TrackParse& parse, const Json& list, const TrackParse::StreamedItems& taken, ReadElement read) {
  if (parse.error = taken.error; !parse.error.empty()) return false;
  for (std::size_t i = taken.count; i < list.size(); ++i)
    if (!read(parse, list[i], i)) return false;
  return true;
}

bool read_lists(TrackParse& parse, JsonFieldReader& fields) {
  const Json *const knots = fields.list("knots", world::kMaxKnots), *const segments = fields.list("segments"),
                    *const carts = fields.list("carts", world::kMaxCarts);
  if (!knots || !segments || !carts) return false;
  const bool closed = parse.document.track.closed;
  if (closed && knots->size() < 2) return fields.fail("closed", "a closed track has at least 2 knots");
  const std::size_t expected = closed ? knots->size() : knots->empty() ? 0 : knots->size() - 1;
  if (!read_rest(parse, *knots, parse.knots, read_knot)) return false;
  if (segments->size() != expected)
    return fields.reject("segments", fmt::format("{} for {}{}", expected, knots->size(),
                                                 closed ? " knots of a closed track" : " knots of an open track"));
  if (!read_rest(parse, *segments, parse.segments, read_segment)) return false;
  if (!read_sections(parse, fields)) return false;
  for (std::size_t i = 0; i < carts->size(); ++i)
    if (!read_cart(parse, (*carts)[i], i)) return false;
  parse.document.extra.json = fields.unknown(parse.warnings);
  return true;
}

// Shortens the warnings: a foreign file may have an unknown member on every knot.
void shorten(std::vector<std::string>& warnings) {
  constexpr std::size_t kMost = 20;
  if (warnings.size() <= kMost) return;
  const std::size_t left_out = warnings.size() - kMost;
  warnings.resize(kMost);
  warnings.push_back(fmt::format("and {} more unknown members are kept", left_out));
}

}  // namespace

base::Result<CopiedForceKeys> parse_keys(std::string_view text) {
  return read_object<CopiedForceKeys>(text, "clipboard", [](JsonFieldReader& fields, CopiedForceKeys& copied) {
    if (!fields.named("force-keys", copied.over) || (fields.has("of") && !fields.named("of", copied.of)) ||
        !read_list(fields, "keys", copied.keys))
      return false;
    world::ForceProgram program;  // for its limits
    program.over = copied.over, program.of = copied.of, program.length = world::longest_of(copied.over);
    program.keys(world::ForceChannel::roll) = copied.keys;
    if (copied.keys.empty()) return fields.fail({}, "no keys");
    const auto wrong = world::broken(program);
    return !wrong || fields.fail({}, *wrong);
  });
}

base::Result<LoadedTrack> parse_track(std::string_view text, std::string_view name) {
  TrackParse parse;
  const base::Result<Json> tree = read_json(text, name, std::bind_front(take_element, std::ref(parse)));
  if (!tree) return tree.status();
  JsonFieldReader fields(*tree, {}, parse.error);
  if (parse.error.empty() && read_track_head(parse, fields) && read_lists(parse, fields)) {
    world::settle_joints(parse.document);
    if (const auto broken = world::broken_invariant(parse.document)) parse.error = *broken;
  }
  if (!parse.error.empty()) return bad_file(name, parse.error);
  if (parse.version < 2) sim::set_automatic_spins(parse.document);
  shorten(parse.warnings);
  for (std::string& warning : parse.warnings) warning = fmt::format("{}: warning: {}", name, warning);
  LoadedTrack track{std::move(parse.document), std::move(parse.warnings), {}, {}};
  track.version = parse.version;
  return track;
}

std::string name_of_file(std::string_view path) {
  const std::string printable = base::printable_utf8(std::filesystem::path(path).stem().string());
  return std::string(base::utf8_start(printable, world::kMaxNameBytes));
}

}  // namespace coaster::exchange
