// The report of a ride: what the ratings, the forces and the checks of the present track say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/session/findings.h"
#include "edit/session/session.h"

namespace coaster::edit {

// --- Watches the live ride: detects its end, and has challenges judged then or while building

// Call when the train starts: from its start, or from where it was held.
void watch_start(Session& session, bool from_start);
// Call when the train was moved by hand: the ride no longer counts as one from the start.
void watch_disturbed(Session& session);
// Call when the train was reset: no ride is in progress.
void watch_reset(Session& session);
// Call after any number of ticks. Without a challenge a lap is detected after the last of them.
void watch_ticks(Session& session, int ticks);
// Call when the document or its settings have changed: judges challenges that are judged while building.
void watch_built(Session& session);

// Return the report of the selected train's ride on the present track as text, and as comma-separated values by time;
// nothing without a ride.
std::optional<std::string> ride_report(const SessionFindings& find);
std::optional<std::string> ride_csv(const SessionFindings& find);
// Returns the numbers of ride_report() as JSON, in full precision, with units in the names; null for what there is none
// of. Nothing if the track has no train.
std::optional<std::string> ride_report_json(const SessionFindings& find);
// A force section whose spans miss its tolerance (g), and by how much in words.
struct MissedForces {
  std::string section, text;
  double tolerance = 0;
};
// Returns them in the order of the track; nothing without force sections.
std::optional<std::vector<MissedForces>> forces_missed(const SessionFindings& find);

}  // namespace coaster::edit
