// The values of all queries at once, for state.json of a script.
#pragma once

#include "exchange/own/json_output.h"
#include "query/query.h"

namespace coaster::query {

// Returns one member per query, null where there is no value; with an argument of one part one per word, number, knot,
// segment or train that it accepts and has a value. The latter are left out of tracks of more than 1000 knots.
exchange::JsonMembers all_values(const QueryContext& context);

}  // namespace coaster::query
