// What follows from a session and is computed on demand: whole rides, ratings, conflicts, plans, supports. Each is
// asked for by its name, computes what it needs itself, and is remembered with the state it was found for, so asking
// again costs a comparison of keys, some nanoseconds a segment at most. Who reads a finding includes its header in sim.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "world/entity.h"
#include "world/heap_value.h"

namespace coaster::world {
struct Element;
}

namespace coaster::sim {
class ForcePlanCache;
class Ground;
class Plants;
class RideCache;
class RailTables;
class Riders;
class Supports;
struct StationBuildings;
struct CircuitProposals;
struct Conflict;
struct ElementPlan;
struct FloodedTrack;
struct Fold;
struct ForcePlan;
struct FrenetBreak;
struct SimulatedRide;
struct Jolt;
struct LineConflict;
struct OpenedTrack;
struct Ratings;
struct Overload;
struct SectionTable;
struct EyeSurroundings;
struct TrackValues;
}  // namespace coaster::sim

namespace coaster::edit {

struct FindingsCache;  // edit/session/findings_memory.h
struct Session;

// What planners and moving trains remember between two uses.
sim::RideCache& rides_of(Session& session);
sim::ForcePlanCache& force_plans_of(Session& session);
const sim::ForcePlanCache& force_plans_of(const Session& session);
sim::OpenedTrack& opened_track_of(Session& session);  // for planning a section that completes a circuit again

// Gives read access to a session and its findings, for panels and queries. References, pointers and spans are valid
// until the session changes, or the same finding is asked for with another argument.
class SessionFindings {
 public:
  SessionFindings(Session& session) : session_(&session) {}
  const Session& session() const { return *session_; }

  std::uint64_t document_hash() const;

  // The ride of the selected cart (chosen_cart): null, none or 0 without one.
  const sim::SimulatedRide* ride() const;
  const sim::RailTables& tables() const;             // of the rails
  const sim::Ratings& ratings() const;               // of that ride
  std::span<const sim::Overload> overloads() const;  // parts of it over the force limits
  std::span<const sim::Jolt> jolts() const;          // at the joints, by index of the knot in the track
  const sim::Riders* seat() const;                   // what the riders of the selected seat feel
  const sim::Riders* riders() const;                 // the same for all cars
  std::optional<double> speed_at(double) const;  // m/s, of the first train at a distance, m; nothing if it isn't there
  const sim::TrackValues& values() const;        // values that colour the track: those of the middle car

  // The track.
  const sim::SectionTable& sections() const;                 // figures of each; what the riders of the seat feel there
  std::span<const sim::Conflict> conflicts() const;          // where it lacks clearance from itself, in its order
  std::span<const sim::Conflict> conflicts_so_far() const;   // those found so far; each call searches a slice more
  bool all_conflicts() const;                                // true if the search is complete; does not search
  std::span<const sim::Fold> folds() const;                  // of the rails
  std::span<const sim::Fold> tight_bends() const;            // too tight for a train, and reversals
  std::span<const sim::FrenetBreak> breaks() const;          // of the Frenet frame
  const sim::Supports& supports() const;                     // near the eye on very long tracks
  void look_from(const sim::EyeSurroundings& around) const;  // says where the eye is
  const sim::Ground& ground() const;                         // as it is cut to the track
  const sim::Plants& plants() const;                         // on that ground
  const sim::StationBuildings& stations() const;             // roofs, gates, boards and queues
  std::span<const sim::FloodedTrack> flooded() const;        // track under its water
  double chord_error() const;                                // m, largest distance of a piece from its chord
  double deviation() const;                                  // m, from the challenge's start track; 0 without one

  // Plans: the palette's element at the track's open end, or another one; ways from the open end to the first knot.
  const sim::ElementPlan& element() const;
  const sim::ElementPlan& element(const world::Element& element) const;
  std::span<const sim::LineConflict> room() const;  // parts of the element without clearance
  std::span<const sim::LineConflict> room(const world::Element& element) const;
  const sim::CircuitProposals& circuit() const;
  double closing_jolt(std::size_t index) const;  // g, the selected cart's largest jolt on one of these ways
  // The plan of a force section as it is in the document; null for other sections.
  const sim::ForcePlan* force(world::Entity section) const;

 private:
  FindingsCache& memory() const;
  const sim::Riders* riders_of(bool all) const;
  Session* session_;
};

}  // namespace coaster::edit
