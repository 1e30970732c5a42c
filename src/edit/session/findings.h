// What is found out about a session when somebody wants to know: whole rides, ratings, conflicts, plans, supports. All
// of it follows from the document, the derived data, the settings and the envelope.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/kept.h"
#include "sim/plan/elements.h"
#include "sim/plan/force_plan.h"
#include "sim/ride/ghost.h"
#include "sim/shape/folds.h"
#include "sim/shape/frame_methods.h"
#include "sim/shape/shape_distance.h"
#include "sim/solids/conflicts.h"
#include "sim/solids/supports.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/element_room.h"
#include "sim/study/jolt.h"
#include "sim/study/ratings.h"
#include "sim/study/riders.h"
#include "sim/study/section_figures.h"
#include "sim/study/track_values.h"

namespace coaster::edit {

struct Session;

// What find() is asked for: one of these, or several joined by |.
enum class Want : std::uint32_t {
  nothing = 0,
  document_hash = 1,
  ride = 2,        // of the chosen cart (chosen_cart), and the tables of the rails
  ratings = 4,     // of that ride
  overloads = 8,   // its stretches beyond the envelope
  conflicts = 16,  // where the track is in its own way
  element = 32,    // the plan of the palette's element at the track's open end
  room = 64,       // where that element would be in the way
  breaks = 128,    // of the Frenet frame
  values = 256,    // that the track is coloured by
  supports = 512,
  deviation = 1024,           // from the start track of the challenge under way
  seat = 2048,                // what the riders of the chosen seat feel during that ride
  riders = 4096,              // the same of all cars
  folds = 8192,               // of the rails
  jolts = 16384,              // of that ride, at the joints
  circuit = 32768,            // ways from the open end to the first knot
  sections = 65536,           // their lengths, heights, and what the riders of the chosen seat feel on them
  conflicts_so_far = 131072,  // those found up to now; each time the search goes on by a slice
  chord_error = 262144        // of the polylines
};
constexpr Want operator|(Want a, Want b) {
  return static_cast<Want>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(Want all, Want one) {
  return (static_cast<std::uint32_t>(all) & static_cast<std::uint32_t>(one)) != 0;
}

// A member is true of the session when find() has just been asked for it; pointers and spans are good until the next
// find().
struct Findings {
  std::uint64_t document_hash = 0;
  const sim::Ghost* ride = nullptr;          // null without a ride
  const sim::RailTables* tables = nullptr;   // never null after Want::ride
  const sim::Ratings* ratings = nullptr;     // never null after Want::ratings; all 0 without a ride
  const sim::Riders* riders = nullptr;       // of the cars that were asked for; null without a ride
  std::span<const sim::RedSpan> overloads;   // none without a ride
  std::span<const sim::Conflict> conflicts;  // in the track's order; all after Want::conflicts
  bool all_conflicts = true;
  std::span<const sim::Fold> folds;  // in the track's order
  std::span<const sim::Jolt> jolts;  // by the knots' index in the track; none without a ride
  const sim::ElementPlan* element = nullptr;
  std::span<const sim::Narrow> room;               // parts of the element that lack it
  const sim::CircuitProposals* circuit = nullptr;  // never null after Want::circuit
  const sim::SectionTable* sections = nullptr;     // never null after Want::sections
  std::span<const sim::FrenetBreak> breaks;
  const sim::TrackValues* values = nullptr;
  const sim::Supports* supports = nullptr;
  double deviation = 0;    // m; 0 without a challenge
  double chord_error = 0;  // m, largest distance of the curve from the polylines' chords

  // What the members above are kept in, each with the key that it was found for.
  struct Memory {
    base::Kept<std::uint64_t, std::uint64_t> document_hash;  // by Session::edits
    sim::GhostMemo rides;
    // By the ride's serial, the build of the track and the envelope.
    base::Kept<std::tuple<std::uint64_t, std::uint64_t, sim::Envelope>, sim::Ratings> ratings;
    base::Kept<std::pair<std::uint64_t, sim::Envelope>, std::vector<sim::RedSpan>> overloads;  // by the ride's serial
    sim::Riders riders;
    base::Kept<std::pair<std::uint64_t, double>, std::vector<sim::Jolt>> jolts;  // by the ride's serial and the cutoff
    sim::Conflicts conflicts;
    sim::Folds folds;
    sim::ElementMemo elements;
    sim::ElementRoom room;
    sim::CircuitMemo circuit;
    // By Session::edits, the last build, the ride's serial and the first and the last car.
    base::Kept<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, int, int>, sim::SectionTable> sections;
    sim::OpenedTrack opened;  // for the section that completes a circuit, planned again
    sim::ForceMemo forces;
    sim::FrenetBreaks breaks;
    sim::TrackValueMemo values;
    sim::Supports supports, passed;  // shown, and passed by a ride: each counts what it rebuilds
    base::Kept<std::pair<sim::ShapeTrace, sim::ShapeTrace>, double> deviation;  // by the two tracks' traces
    base::Kept<std::pair<std::uint64_t, int>, double> chord_error;              // by the last build, and steps
  } memory;
};

// Brings up to date what is wanted, and nothing else: the one function that does. What has not changed costs a
// comparison of keys, which is some nanoseconds a segment.
const Findings& find(Session& session, Want wanted);
// The same, where Want::element and Want::room are about another element than the chosen one.
const Findings& find(Session& session, Want wanted, const world::Element& element);

// Returns the speed of the first train where its first car comes to a place of the session's track, m/s; nothing where
// it does not.
std::optional<double> speed_at(Session& session, double distance);

// Returns the plan of a force section as it is in the document; null for other sections. Good until the next plan of
// one.
const sim::ForcePlan* force_plan(Session& session, world::Entity section);

// A session to read and to ask for findings, and to do nothing else to: what panels and queries are given.
class Finder {
 public:
  Finder(Session& session) : session_(&session) {}
  const Session& session() const { return *session_; }
  const Findings& operator()(Want wanted) const { return find(*session_, wanted); }
  const sim::ForcePlan* force(world::Entity section) const { return force_plan(*session_, section); }

 private:
  Session* session_;
};

}  // namespace coaster::edit
