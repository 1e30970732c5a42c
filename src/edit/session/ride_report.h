// The ride report as JSON, and what it shares with the text, session.h's ride_report().
#pragma once

#include "edit/session/session.h"

namespace coaster::edit {

// Returns the numbers of ride_report() as JSON, in full precision, with units in the names; null for what there is none
// of. Nothing if the track has no train.
std::optional<std::string> ride_report_json(const Finder& find);
// A force section whose spans miss its tolerance (g), and by how much in words.
struct MissedForces {
  std::string section, text;
  double tolerance = 0;
};
// Returns them in the order of the track; nothing without force sections.
std::optional<std::vector<MissedForces>> forces_missed(const Finder& find);

}  // namespace coaster::edit
