// What a session's findings remember, each with the key of the state it was found for. Planners of this room keep their
// own memories here, too.
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "base/cached_value.h"
#include "edit/session/session.h"
#include "sim/ground/ground.h"
#include "sim/ground/plants.h"
#include "sim/plan/element_plan_cache.h"
#include "sim/plan/force_plan.h"
#include "sim/ride/simulated_ride.h"
#include "sim/shape/folds.h"
#include "sim/shape/frame_methods.h"
#include "sim/shape/shape_distance.h"
#include "sim/solids/conflicts.h"
#include "sim/solids/station_mesh.h"
#include "sim/solids/supports.h"
#include "sim/study/closing_replan.h"
#include "sim/study/colour_values.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "sim/study/ratings.h"
#include "sim/study/riders.h"

namespace coaster::edit {

struct FindingsCache {
  base::CachedValue<std::uint64_t, std::uint64_t> document_hash;  // by Session::edits
  sim::RideCache rides;
  // Keyed by the ride's serial, the builds of track and ground, and the envelope.
  base::CachedValue<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, sim::ForceLimitCurves>, sim::Ratings>
      ratings;
  base::CachedValue<std::pair<std::uint64_t, sim::ForceLimitCurves>, std::vector<sim::Overload>>
      overloads;  // by the ride's serial
  sim::Riders riders;
  base::CachedValue<std::pair<std::uint64_t, double>, std::vector<sim::Jolt>>
      jolts;  // by the ride's serial and the cutoff
  sim::Conflicts conflicts;
  sim::Folds folds, tight_bends{sim::tight_bends_of};
  sim::ElementCache elements;
  sim::ElementClearance room;
  sim::ProposalCache circuit;
  sim::ClosingJolts closing_jolts;
  // Keyed by Session::edits, the last build, the ride's serial and the first and the last car.
  base::CachedValue<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, int, int>, sim::SectionTable> sections;
  sim::OpenedTrack opened;  // for planning a section that completes a circuit again
  sim::ForcePlanCache forces;
  sim::FrenetBreaks breaks;
  sim::TrackValueCache values;
  sim::Ground ground;
  sim::Plants plants;
  base::CachedValue<std::pair<std::uint64_t, std::uint64_t>, sim::StationBuildings> stations;  // by edits and ground
  base::CachedValue<std::uint64_t, std::vector<sim::FloodedTrack>> flooded;  // by the build of the ground
  sim::NearSegments near;                                                    // to the eye
  sim::Supports supports, passed;  // displayed ones, and those a ride passes: each counts its rebuilds
  base::CachedValue<std::pair<sim::ShapeTrace, sim::ShapeTrace>, double> deviation;  // by the two tracks' traces
  base::CachedValue<std::pair<std::uint64_t, int>, double> chord_error;              // by the last build, and steps
};

}  // namespace coaster::edit
