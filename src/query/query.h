// Named values that panels, scripts and challenges read, each with a unit and a line of text. To add one, add a row to
// a table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "base/enum_names.h"
#include "base/status.h"
#include "base/text.h"
#include "exchange/own/json_output.h"
#include "world/entity.h"

namespace coaster::query {

// --- What follows the name of a query: one word, whose parts have separators between them, such as @q3.vertical/40

// An entity, a word, or a number; any text if none of these is set.
struct ArgumentPart {
  std::string_view usage = {};                    // in help; empty: all words
  std::optional<world::EntityKind> kind = {};     // the name of an entity of this kind
  std::vector<std::string> (*words)() = nullptr;  // one of these words
  int most = 0;                                   // or a whole number from 1 to this one
  bool number = false;                            // any number
  char before = 0;                                // separates it from the part before it
  bool optional = false;
};
using Argument = std::span<const ArgumentPart>;

inline constexpr ArgumentPart kKnot[]{{.usage = "@knot", .kind = world::EntityKind::knot}};
inline constexpr ArgumentPart kSegment[]{{.usage = "@segment", .kind = world::EntityKind::segment}};
inline constexpr ArgumentPart kCart[]{{.usage = "@cart", .kind = world::EntityKind::cart}};
inline constexpr ArgumentPart kSection[]{{.usage = "@section", .kind = world::EntityKind::section}};
template <base::Named E>
inline constexpr ArgumentPart kWordOf[]{{.words = base::names_of<E>}};

// Returns "@section.CHANNEL/PLACE", "document|motion" and so on.
std::string usage_of(Argument argument);

// Returns why the argument does not accept the word, with the column of the wrong part in it, from 1. Nothing if it
// does; the entity may still not exist.
std::optional<base::TextError> wrong_argument(Argument argument, std::string_view word);

struct QueryContext;  // what queries read (query/context.h)

// Ordered values such as continuity compare by rank, from 0: none < G0 < G1 < G2, off < on.
struct Ranked {
  int rank;
  std::string text;
};
// There is no value; `why` says why, if a row knows.
struct NoValue {
  std::string why;
};
using Value = std::variant<double, std::string, Ranked, glm::dvec3, NoValue>;

std::string to_text(const Value& value);  // "none" for NoValue
inline bool is_none(const Value& value) { return std::holds_alternative<NoValue>(value); }

// What the values of a query are. parameter: the argument ends in a parameter of an element, so they are numbers or the
// names of its choices.
enum class ValueType : std::uint8_t { number, text, ranked, vector, parameter };
struct ValueDomain {
  ValueType type = ValueType::number;
  std::vector<std::string> (*words)() = nullptr;  // all texts, or null for any text; all ranks, ascending
  bool may_be_none = false;                       // there is no value in some states
  bool of_view = false;  // follows from selection, settings or this machine, too: rules and goals may not use it
};

struct Query {
  std::string_view name;  // "ride.speed"; with an argument: "position"
  Argument argument;
  std::string_view unit;  // "m/s", "" if none
  std::string_view text;
  using Row = base::Result<Value> (*)(const QueryContext& context, std::string_view argument);
  Row row;  // of an argument that is accepted
  ValueDomain values;

  constexpr Query(std::string_view n, Argument a, std::string_view u, std::string_view t, Row r, ValueDomain v = {})
      : name(n), argument(a), unit(u), text(t), row(r), values(v) {}
  constexpr Query(std::string_view n, std::string_view u, std::string_view t, Row r, ValueDomain v = {})
      : Query(n, {}, u, t, r, v) {}

  // Returns a value of it; of a figure at its limit (base/units.h) that it is over it.
  std::string words(const Value& value) const;
  // None where there is no value, and for a number that is not finite, unless it has a limit: then the largest one.
  // Code::usage for an argument that the query does not accept, Code::refused for an entity that does not exist.
  base::Result<Value> evaluate(const QueryContext& context, std::string_view word) const;
};

std::span<const Query> queries();
const Query* find_query(std::string_view name);

// What the values are with that argument; never ValueType::parameter. No words: any.
struct ArgumentValueDomain {
  ValueType type = ValueType::number;
  std::vector<std::string> words;
};
ArgumentValueDomain values_with(const Query& query, std::string_view argument);

// Returns the rank of a word among the values of a ranked query, ignoring case; on and off have the synonyms true, yes,
// 1 and false, no, 0. Nothing for other words.
std::optional<int> rank_of(const Query& query, std::string_view word);

// --- The values of all queries at once, for state.json of a script

// Returns one member per query, null where there is no value; with an argument of one part one per word, number, knot,
// segment or train that it accepts and has a value. The latter are left out of tracks of more than 1000 knots.
exchange::JsonMembers all_values(const QueryContext& context);

}  // namespace coaster::query
