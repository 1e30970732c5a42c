// "<query> [argument] <op> <value> [+-tolerance]": parsing it and holding a value against it. Scripts and challenges
// share it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/words.h"
#include "query/query.h"

namespace coaster::query {

enum class Op : std::uint8_t { equal, not_equal, less, less_equal, greater, greater_equal, contains };

// "<query> [argument] <op> <value> [+-tolerance]". Without an operator: that the value is true.
struct Condition {
  std::string query, argument;
  std::optional<Op> op;
  std::vector<base::Token> values;
  std::optional<double> tolerance;
  bool negated = false;
  std::string text;  // as written
  int column = 1;
};

// Reads a condition up to the end of the words or a word of `stop` ("max" of wait). False: the failure is in `words`.
bool parse_condition(base::Words& words, Condition& condition, std::string_view stop = {});

// True when the value fulfils the condition. Numbers without tolerance are equal when they are so as written or in
// single precision; texts regardless of a leading @; "~" asks whether the value's text contains the other, in any case
// of letters. Code::usage when value and operator do not go together; the message says what was expected.
base::Result<bool> holds(const Condition& condition, const Value& value);

// The value of a query as text with its unit.
std::string describe(const query::Query& query, const Value& value);

}  // namespace coaster::query
