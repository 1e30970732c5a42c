// The parts of the table of queries, and helpers of their rows.
#pragma once

#include <algorithm>
#include <type_traits>

#include "base/text.h"
#include "curve/continuity.h"
#include "query/context.h"
#include "query/query.h"
#include "world/element_rows.h"
#include "world/topology.h"

namespace coaster::query {

std::span<const Query> document_rows();
std::span<const Query> section_rows();
std::span<const Query> park_rows();
std::span<const Query> ride_rows();
std::span<const Query> simulated_rows();
std::span<const Query> rider_rows();
std::span<const Query> session_rows();
std::span<const Query> setting_rows();
std::span<const Query> joint_rows();
std::span<const Query> lab_rows();
std::span<const Query> element_rows();
std::span<const Query> force_rows();
std::span<const Query> game_rows();
std::span<const Query> draw_rows();
std::span<const Query> frame_rows();
std::span<const Query> evaluation_rows();

// True if one of the rows has that name.
inline bool has_row(std::span<const Query> rows, std::string_view name) {
  return std::any_of(rows.begin(), rows.end(), [&](const Query& row) { return row.name == name; });
}

// Returns what queries of track and ride read: no picture and no panels.
QueryContext context_of(const edit::SessionFindings& find);

// Returns the entity of that kind named `argument` ("@k3" or "k3"), or a Status with the error and a suggestion.
base::Result<world::Entity> entity_of(const QueryContext& context, std::string_view argument, world::EntityKind kind);

// The result of a row, and its argument.
using Answer = base::Result<Value>;
using View = std::string_view;

inline Value yes_no(bool on) { return Ranked{on ? 1 : 0, on ? "on" : "off"}; }
template <class Number>
Value number(Number n) {
  return static_cast<double>(n);
}
inline Value text(std::string_view t) { return std::string(t); }
inline Value none(std::string_view why = {}) { return NoValue{std::string(why)}; }
inline Value text_or_none(std::string_view t, std::string_view why) { return t.empty() ? none(why) : text(t); }
// Returns one of a set of words; the word none is none.
inline Value word(std::string_view w) { return w == "none" ? none() : text(w); }

// Reasons that several rows share.
inline constexpr std::string_view kNoSegment = "there is no segment", kNoRide = "there is no ride",
                                  kNoTrain = "there is no train", kNothingSelected = "nothing is selected",
                                  kOpenEnd = "no joint at an end of an open track",
                                  kNoFrame = "no frame has been drawn";

// Returns a switch as on or off, an enumerator by name, a level of continuity as ranked, the size of a list, any other
// value unchanged; none for the name none and an optional without a value.
template <class T>
Value value_of(const T& value) {
  if constexpr (std::is_same_v<T, bool>) return yes_no(value);
  else if constexpr (std::is_same_v<T, curve::GeometricContinuity> || std::is_same_v<T, curve::ParametricContinuity>)
    return value == T{} ? none() : Value(Ranked{static_cast<int>(value), std::string(base::name_of(value))});
  else if constexpr (base::Named<T>) return word(base::name_of(value));
  else if constexpr (std::is_arithmetic_v<T>) return number(value);
  else if constexpr (std::is_same_v<T, glm::vec3>) return glm::dvec3(value);
  else if constexpr (std::is_same_v<T, std::optional<double>>)
    return value ? number(*value) : none("the ride does not arrive there");
  else if constexpr (std::is_convertible_v<T, std::string_view>) return text(value);
  else if constexpr (requires { value.size(); }) return number(value.size());
  else return value;
}

// The values of a row, by what it returns.
std::vector<std::string> on_off();
inline constexpr ValueDomain kText{ValueType::text}, kVector{ValueType::vector}, kSwitch{ValueType::ranked, on_off};
template <base::Named E>
inline constexpr ValueDomain kOneOf{ValueType::text, base::names_of<E>};
template <base::Named E>
inline constexpr ValueDomain kRankOf{ValueType::ranked, base::names_of<E>};
constexpr ValueDomain texts(std::vector<std::string> (*words)()) { return {ValueType::text, words}; }
constexpr ValueDomain or_none(ValueDomain values = {}) {
  values.may_be_none = true;
  return values;
}
constexpr ValueDomain of_view(ValueDomain values = {}) {
  values.of_view = true;
  return values;
}
template <class T>
constexpr ValueDomain values_of() {
  if constexpr (std::is_same_v<T, bool>) return kSwitch;
  else if constexpr (base::Named<T>) return kOneOf<T>;
  else if constexpr (std::is_arithmetic_v<T>) return {};
  else if constexpr (std::is_same_v<T, glm::vec3>) return kVector;
  else return kText;
}

// Paint in words: the palette with exactly these colours.
inline constexpr View kMixed = "mixed";
inline View palette_name(const world::Paint& paint) {
  const auto palette = world::palette_of(paint);
  return palette ? base::name_of(*palette) : kMixed;
}

// Returns the names of the parameters of all elements, and the value of one.
std::vector<std::string> parameter_names();
Value parameter_of(const world::Element& element, std::string_view name);

// Returns the value at the end of a path of members and functions.
template <class T>
Value value_at(const T& object) {
  return value_of(object);
}
template <class T, class Step, class... Path>
Value value_at(const T& object, Step step, Path... path) {
  return value_at(std::invoke(step, object), path...);
}

// Rows of what a path leads to from the session, its document, its findings or the last frame's figures:
// of_document<&world::Document::datum>.
template <auto... path>
Answer of_session(const QueryContext& c, View) {
  return value_at(c.session, path...);
}
template <auto... path>
Answer of_document(const QueryContext& c, View) {
  return value_at(c.session.document, path...);
}
template <auto... path>
Answer of_findings(const QueryContext& c, View) {
  return value_at(c.find, path...);
}
template <auto... path>
Answer of_stats(const QueryContext& c, View) {
  return value_at(c.stats, path...);
}
// The same of what the last frame drew; none before the first.
template <auto... path>
Answer of_frame(const QueryContext& c, View) {
  return c.stats.frame > 0 ? value_at(c.stats, path...) : none(kNoFrame);
}

// Returns the value of `function` for the entity that the argument names.
template <class Function>
Answer of_entity(const QueryContext& c, View argument, world::EntityKind kind, Function function) {
  const auto entity = entity_of(c, argument, kind);
  if (!entity) return entity.status();
  return value_of(function(*entity));
}

// Rows of what a path leads to from the knot, segment, section or train that the argument names.
template <world::EntityKind kind, class Component, auto... path>
Answer of_component(const QueryContext& c, View argument) {
  return of_entity(c, argument, kind,
                   [&](world::Entity e) { return value_at(c.session.document.entities.get<Component>(e), path...); });
}
template <auto... path>
constexpr auto of_knot = of_component<world::EntityKind::knot, world::Knot, path...>;
template <auto... path>
constexpr auto of_segment = of_component<world::EntityKind::segment, world::Segment, path...>;
template <auto... path>
constexpr auto of_section = of_component<world::EntityKind::section, world::Section, path...>;
template <auto... path>
constexpr auto of_train = of_component<world::EntityKind::cart, world::Train, path...>;

// Returns the joint at a knot; nothing at an end of an open track.
std::optional<curve::JointContinuity> joint_at(const world::Document& document, world::Entity knot);

// Returns the value of `function` for the joint at the knot that the argument names.
template <class Function>
Answer at_joint(const QueryContext& c, View argument, Function function) {
  return of_entity(c, argument, world::EntityKind::knot, [&](world::Entity e) {
    const auto joint = joint_at(c.session.document, e);
    return joint ? value_of(function(*joint)) : none(kOpenEnd);
  });
}
// Row of a member of it.
template <auto member>
Answer of_joint(const QueryContext& c, View argument) {
  return at_joint(c, argument, [](const curve::JointContinuity& joint) { return joint.*member; });
}

}  // namespace coaster::query
