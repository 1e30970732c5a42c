// Goals of searches: a query of track and ride, and the value that it should have.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/text.h"
#include "edit/session/session.h"

namespace coaster::query {

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
