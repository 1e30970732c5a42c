#include "edit/perform/take_up.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "curve/arc_length.h"
#include "curve/continuity.h"
#include "edit/perform/replan.h"
#include "edit/session/found_way.h"
#include "world/sections.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Document;
using world::Knot;
using world::SectionRun;

// The conditions that the track imposes on a section's ends.
struct Ends {
  Knot start, end;
  glm::dvec3 before, after;  // 1/m, the curvature of the track beside them
};
bool alike(const Ends& a, const Ends& b) {
  return a.start == b.start && a.end == b.end && glm::distance(a.before, b.before) <= sim::kElementJump &&
         glm::distance(a.after, b.after) <= sim::kElementJump;
}
Ends ends_of(const Document& document, const SectionRun& run) {
  const auto& segments = document.track.segments;
  const auto cubic = [&](std::size_t i) { return world::cubic_of(document, segments[i % segments.size()]); };
  Ends ends{nth_knot(document, run.first), nth_knot(document, run.end()),
            curve::curvature_vector(cubic(run.first + segments.size() - 1), 1.0),
            curve::curvature_vector(cubic(run.end()), 0.0)};
  // These belong to the section or follow from the curvatures of the track beside it.
  ends.start.out_length = ends.end.in_length = ends.start.in_length = ends.end.out_length = 0;
  ends.start.joint = ends.end.joint = world::JointKind::aligned;
  return ends;
}

// True if equipment between the first changed knot and the section gives trains a speed.
bool driven_between(const Document& former, const SectionRun& was, const Document& next, const SectionRun& run) {
  std::size_t same = 0;
  while (same < std::min(was.first, run.first) && nth_knot(former, same).position == nth_knot(next, same).position)
    ++same;
  const auto driven = [&](const Document& document, std::size_t end) {
    for (std::size_t i = same > 0 ? same - 1 : 0; i < end; ++i)
      if (document.entities.find<world::Equipment>(document.track.segments[i])) return true;
    return false;
  };
  return driven(former, was.first) || driven(next, run.first);
}

// Returns what the change asks of the section that completes the circuit.
sim::WayChange change_of(const Session& session, const Document& former, const SectionRun& was, const Document& next,
                         const SectionRun& run) {
  const std::size_t count = next.track.segments.size();
  sim::WayChange change{.opened = stretch_of(next, run.end() % count, count - run.count),
                        .former = world::section(next, run.section).way,
                        .losses = session.document.resistance,
                        .whole = !session.history.in_gesture};
  for (std::size_t i = was.first; i < was.end(); ++i)
    change.lengths.push_back(curve::arc_length(world::cubic_of(former, former.track.segments[i])));
  if (!driven_between(former, was, next, run))
    change.risen = double{nth_knot(next, run.first).position.y} - double{nth_knot(former, was.first).position.y};
  if (const world::Cart* const cart = session.document.entities.find<world::Cart>(chosen_cart(session)))
    change.losses.drag *= world::kCarMass / cart->mass;
  return change;
}

// Returns the way home: the one that was found for this change, else searches for it. Nothing if it is to be found
// beside the frames.
std::optional<sim::ChangedWay> way_for(Session& session, sim::WayChange change) {
  WaySearch& search = session.way_search;
  if (search.found && search.found->change == change) return std::exchange(search.found, nullptr)->way;
  if (!search.beside) return sim::changed_way(change, opened_track_of(session));
  search.wanted = std::make_shared<const sim::WayChange>(std::move(change));
  return std::nullopt;
}

}  // namespace

Status take_up(Session& session, Change& change, const Document& former, Document& next) {
  const std::optional<SectionRun> run = world::completing(next, 0);
  const std::size_t count = next.track.segments.size();
  if (!run || !former.entities.find<world::Section>(run->section)) return {};
  if (run->count == count) return refused("a circuit needs a section besides the one that completes it");
  const SectionRun was = world::run_of(former, run->section);
  if (alike(ends_of(former, was), ends_of(next, *run))) return {};
  const std::optional<sim::ChangedWay> found = way_for(session, change_of(session, former, was, next, *run));
  if (!found) return refused("the closing section is not found yet");
  if (!found->refusal.empty()) return refused(found->refusal);
  if (found->another) change.note = "The closing section takes another route.";
  const std::size_t spans = found->fit.knots.size() - 1;
  if (const Status room = room_for(session, next.track.knots.size() + spans - run->count, count + spans - run->count);
      !room)
    return room;
  reshape(next, run->section, found->fit, SectionEnd::stays);
  next.entities.get<world::Section>(run->section).way = found->way;
  change.planned.push_back(run->section);
  return {};
}

}  // namespace coaster::edit
