// Named values that panels, scripts and challenges read, each with a unit and a line of text. To add one, add a row to
// a table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "base/status.h"

namespace coaster::query {

struct Context;  // what queries read (query/context.h)

// Ordered values such as continuity compare by rank: none < G0 < G1 < G2, off < on.
struct Ranked {
  int rank;
  std::string text;
};
using Value = std::variant<double, std::string, Ranked, glm::dvec3>;

std::string to_text(const Value& value);

struct Query {
  std::string_view name;      // "ride.speed"; with an argument: "position"
  std::string_view argument;  // "" or what must follow: "@knot", "document|motion"
  std::string_view unit;      // "m/s", "" if none
  std::string_view text;
  base::Result<Value> (*evaluate)(const Context& context, std::string_view argument);
  std::vector<std::string> (*words)() = nullptr;  // the words that it can be, besides none; null: any text or number
};

std::span<const Query> queries();
const Query* find_query(std::string_view name);

// Returns the rank of a word for comparison with the Ranked value of a query, ignoring case: none, G0, G1, G2 (-1..2)
// for geometric and geometric_min; none, C0, C1, C2 for parametric and parametric_min; for every other query on, true,
// yes, 1 (1) and off, false, no, 0 (0). Nothing for other words. Does not check whether the query's values are ranked.
std::optional<int> rank_of(std::string_view query_name, std::string_view word);

}  // namespace coaster::query
