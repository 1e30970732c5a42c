// Goals of searches: a query of track and ride, and the number that it should be.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "edit/session/session.h"

namespace coaster::query {

// Goals that players choose from: names for queries.
struct GoalRow {
  std::string_view query, label;
  int decimals;  // of the value as it is shown
};
std::span<const GoalRow> goals();

// Measures "ride.lap_time == 40", "ride.g_up_max <= 4.5" and the like, with == <= < >= or >. A goal with == is met
// within its tolerance, by default a thousandth of the number, at least 0.001; the others are met by what they allow,
// and searched for at the tolerance inside. Code::usage if it cannot be read or its query does not follow from track
// and ride; Code::refused if the query has no number there.
base::Result<edit::GoalState> measure_goal(edit::Session& session, const std::string& goal);

}  // namespace coaster::query
