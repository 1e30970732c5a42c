// Values computed on demand for a session: whole rides, ratings, conflicts, plans, supports. All of them follow from
// the document, the derived data, the settings and the envelope.
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
#include "sim/shape/frame_methods.h"
#include "sim/shape/shape_distance.h"
#include "sim/shape/tight_bends.h"
#include "sim/solids/conflicts.h"
#include "sim/solids/supports.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/element_room.h"
#include "sim/study/jolt.h"
#include "sim/study/ratings.h"
#include "sim/study/riders.h"
#include "sim/study/section_figures.h"
#include "sim/study/track_values.h"
#include "sim/study/way_jolt.h"

namespace coaster::edit {

struct Session;

// The arguments of find(): one of these, or several joined by |.
enum class Want : std::uint32_t {
  nothing = 0,
  document_hash = 1,
  ride = 2,        // ride of the selected cart (chosen_cart), and the tables of the rails
  ratings = 4,     // ratings of that ride
  overloads = 8,   // overloads of that ride
  conflicts = 16,  // where the track lacks clearance from itself
  element = 32,    // the plan of the palette's element at the track's open end
  room = 64,       // where that element lacks clearance
  breaks = 128,    // breaks of the Frenet frame
  values = 256,    // values that colour the track
  supports = 512,
  deviation = 1024,           // distance from the start track of the current challenge
  seat = 2048,                // what the riders of the selected seat feel during that ride
  riders = 4096,              // the same for all cars
  folds = 8192,               // folds of the rails
  jolts = 16384,              // jolts of that ride, at the joints
  circuit = 32768,            // ways from the open end to the first knot
  sections = 65536,           // their lengths, heights, and what the riders of the selected seat feel on them
  conflicts_so_far = 131072,  // conflicts found so far; each call continues the search by a slice
  chord_error = 262144,       // chord error of the polylines
  tight_bends = 524288        // bends too tight for a train, and reversals
};
constexpr Want operator|(Want a, Want b) {
  return static_cast<Want>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(Want all, Want one) {
  return (static_cast<std::uint32_t>(all) & static_cast<std::uint32_t>(one)) != 0;
}

// The results of find(). A member is up to date if find() has just been called for it; pointers and spans are valid
// until the next find().
struct Findings {
  std::uint64_t document_hash = 0;
  const sim::Ghost* ride = nullptr;          // null without a ride
  const sim::RailTables* tables = nullptr;   // never null after Want::ride
  const sim::Ratings* ratings = nullptr;     // never null after Want::ratings; all 0 without a ride
  const sim::Riders* riders = nullptr;       // riders of the requested cars; null without a ride
  std::span<const sim::RedSpan> overloads;   // none without a ride
  std::span<const sim::Conflict> conflicts;  // in track order; all of them after Want::conflicts
  bool all_conflicts = true;
  std::span<const sim::Fold> folds;  // in track order
  std::span<const sim::TightBend> tight_bends;
  std::span<const sim::Jolt> jolts;  // by index of the knot in the track; none without a ride
  const sim::ElementPlan* element = nullptr;
  std::span<const sim::Narrow> room;               // parts of the element that lack clearance
  const sim::CircuitProposals* circuit = nullptr;  // never null after Want::circuit
  const sim::SectionTable* sections = nullptr;     // never null after Want::sections
  std::span<const sim::FrenetBreak> breaks;
  const sim::TrackValues* values = nullptr;
  const sim::Supports* supports = nullptr;
  double deviation = 0;    // m; 0 without a challenge
  double chord_error = 0;  // m, largest distance of a piece of the curve from its chord

  // Caches behind the members above, each with the key of its result.
  struct Memory {
    base::Kept<std::uint64_t, std::uint64_t> document_hash;  // by Session::edits
    sim::GhostMemo rides;
    // Keyed by the ride's serial, the build of the track and the envelope.
    base::Kept<std::tuple<std::uint64_t, std::uint64_t, sim::Envelope>, sim::Ratings> ratings;
    base::Kept<std::pair<std::uint64_t, sim::Envelope>, std::vector<sim::RedSpan>> overloads;  // by the ride's serial
    sim::Riders riders;
    base::Kept<std::pair<std::uint64_t, double>, std::vector<sim::Jolt>> jolts;  // by the ride's serial and the cutoff
    sim::Conflicts conflicts;
    sim::Folds folds, tight_bends{sim::tight_bends_of};
    sim::ElementMemo elements;
    sim::ElementRoom room;
    sim::CircuitMemo circuit;
    sim::WayJolts way_jolts;
    // Keyed by Session::edits, the last build, the ride's serial and the first and the last car.
    base::Kept<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, int, int>, sim::SectionTable> sections;
    sim::OpenedTrack opened;  // for planning a section that completes a circuit again
    sim::ForceMemo forces;
    sim::FrenetBreaks breaks;
    sim::TrackValueMemo values;
    sim::NearTrack near;             // to the eye
    sim::Supports supports, passed;  // displayed ones, and those a ride passes: each counts its rebuilds
    base::Kept<std::pair<sim::ShapeTrace, sim::ShapeTrace>, double> deviation;  // by the two tracks' traces
    base::Kept<std::pair<std::uint64_t, int>, double> chord_error;              // by the last build, and steps
  } memory;
};

// Updates what is wanted and nothing else; no other function does. Unchanged findings cost a comparison of keys, some
// nanoseconds per segment.
const Findings& find(Session& session, Want wanted);
// Does the same, with Want::element and Want::room for another element than the selected one.
const Findings& find(Session& session, Want wanted, const world::Element& element);

// Says where the eye is: of very long tracks Want::supports finds those near it.
void look_from(Session& session, const sim::Surroundings& around);

// Returns the speed of the first train when its first car reaches a position of the session's track, m/s; nothing if it
// does not.
std::optional<double> speed_at(Session& session, double distance);

// Returns the largest jolt on a way home of Want::circuit, by its index, for the selected cart, g
// (sim/study/way_jolt.h).
double way_jolt(Session& session, std::size_t index);

// Returns the plan of a force section as it is in the document; null for other sections. Valid until the next plan of
// one.
const sim::ForcePlan* force_plan(Session& session, world::Entity section);

// Gives read access to a session and its findings, for panels and queries.
class Finder {
 public:
  Finder(Session& session) : session_(&session) {}
  const Session& session() const { return *session_; }
  const Findings& operator()(Want wanted) const { return find(*session_, wanted); }
  double way_jolt(std::size_t index) const { return edit::way_jolt(*session_, index); }
  const sim::ForcePlan* force(world::Entity section) const { return force_plan(*session_, section); }

 private:
  Session* session_;
};

}  // namespace coaster::edit
