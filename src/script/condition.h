// "<query> [argument] <op> <value> [+-tolerance]": parsing it and holding a value against it.
#pragma once

#include <string>

#include "query/query.h"
#include "script/statements.h"
#include "script/words.h"

namespace coaster::script {

// Reads a condition up to the end of the words or a word of `stop` ("max" of wait). False: the failure is in `words`.
bool parse_condition(Words& words, Condition& condition, std::string_view stop = {});

// True when the value fulfils the condition. Numbers without tolerance are equal when they are so as written or in single precision;
// texts regardless of a leading @; "~" asks whether the value's text contains the other, in any case of letters.
// Code::usage when value and operator do not go together; the message says what was expected.
base::Result<bool> holds(const Condition& condition, const query::Value& value);

// The value of a query as text with its unit.
std::string describe(const query::Query& query, const query::Value& value);

}  // namespace coaster::script
