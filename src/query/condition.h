// Conditions "<query> [argument] <op> <value> [+-tolerance]": parsing and evaluation. Used by scripts and challenges.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "edit/session/session.h"
#include "query/query.h"

namespace coaster::query {

enum class ComparisonOperator : std::uint8_t { equal, not_equal, less, less_equal, greater, greater_equal, contains };

// "<query> [argument] <op> <value> [+-tolerance]". Without an operator the value must be true.
struct Condition {
  std::string query, argument;
  std::optional<ComparisonOperator> op;
  std::vector<base::Token> values;
  std::optional<double> tolerance;
  bool negated = false;
  std::string text;  // as written
  int column = 1;
};

// Parses a condition up to the end of the words or a word of `stop` ("max" of wait). On failure returns false; the
// error is in `words`.
bool parse_condition(base::WordReader& words, Condition& condition, std::string_view stop = {});

// True if the value meets the condition. None meets only == none and not != none. Without a tolerance, numbers are
// equal if they are equal as written or in single precision. Texts compare without a leading @; "~" means contains,
// ignoring case. Code::usage if value and operator do not fit, and for a text without a number at its start that is
// compared with a tolerance.
base::Result<bool> holds(const Condition& condition, const Value& value);

// Returns "found 3.5 m", or "but ride.lap_time is none: no lap completed".
std::string describe(const query::Query& query, const Value& value);

// Returns the number that a text begins with, as panels show it: 6.25 of "6.25 m/s". Nothing if it begins otherwise.
std::optional<double> leading_number(std::string_view text);

// --- Goals of searches: a query of track and ride, and the value that it should have

// Goals that players select from: names for queries.
struct GoalRow {
  std::string_view query, label;
  int decimals;  // of the displayed value
};
std::span<const GoalRow> goals();

// Reads a goal up to the end of the words. On failure returns false; the error is in `words`.
bool check_goal(base::WordReader& words);

// Measures "ride.lap_time == 40", "ride.g_up_max <= 4.5" and the like, with == <= < >= or >. A goal with == is met
// within its tolerance, by default a thousandth of the number, at least 0.001; the others are met if the comparison
// holds, and a search aims for the limit minus the tolerance. Code::usage if it cannot be parsed or its query does not
// follow from track and ride; Code::refused if the query has no numeric value.
base::Result<edit::GoalState> measure_goal(edit::Session& session, const std::string& goal);

}  // namespace coaster::query
