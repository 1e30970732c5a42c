#include "edit/perform/take_up.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "curve/arc_length.h"
#include "curve/continuity.h"
#include "edit/perform/replan.h"
#include "world/motion.h"
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
  // The section's own, and what the curvatures tell of the track beside it.
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

// Returns the task of the section, from its start to its end. `opened` is the track whose shapes are cached.
base::Result<sim::CircuitTask> task_of(const Session& session, const Document& opened, const world::WayHome& way,
                                       double risen) {
  sim::CircuitTask task = *sim::circuit_task(opened, session.findings.memory.opened.derived, nullptr);
  const double square = way.speed * way.speed - (way.coasts ? 2 * world::kGravity * risen : 0.0);
  if (square < std::min(1.0, way.speed * way.speed))
    return refused(fmt::format("the train does not reach the Complete circuit section, which would begin {} m higher",
                               risen < 0.05 ? fmt::format("{:.1g}", risen) : fmt::format("{:.1f}", risen)));
  task.speed = std::sqrt(square), task.coasts = way.coasts;
  task.losses = session.document.resistance;
  if (const world::Cart* const cart = session.document.entities.find<world::Cart>(chosen_cart(session)))
    task.losses.drag *= world::kCarMass / cart->mass;
  return task;
}

}  // namespace

Status take_up(Session& session, Change& change, const Document& former, Document& next) {
  const std::optional<SectionRun> run = world::completing(next, 0);
  const std::size_t count = next.track.segments.size();
  if (!run || !former.entities.find<world::Section>(run->section)) return {};
  if (run->count == count) return refused("a circuit has a section besides the one that completes it");
  const SectionRun was = world::run_of(former, run->section);
  if (alike(ends_of(former, was), ends_of(next, *run))) return {};
  const world::WayHome& way = world::section(next, run->section).way;
  const Document opened = stretch_of(next, run->end() % count, count - run->count);
  const double risen = driven_between(former, was, next, *run) ? 0.0
                                                               : double{nth_knot(next, run->first).position.y} -
                                                                     double{nth_knot(former, was.first).position.y};
  sim::OpenedTrack& open = session.findings.memory.opened;
  open.update(opened);
  const base::Result<sim::CircuitTask> task = task_of(session, opened, way, risen);
  if (!task) return task.status();
  sim::FormerWay like{way, {}};
  for (std::size_t i = was.first; i < was.end(); ++i)
    like.lengths.push_back(curve::arc_length(world::cubic_of(former, former.track.segments[i])));
  sim::CircuitProposals found = sim::complete_again(like, *task, open.derived, open.conflicts);
  if (found.list.empty() && !session.history.in_gesture) {
    found = sim::complete_circuit(*task, open.derived, open.conflicts);
    if (!found.list.empty()) change.note = "Complete circuit takes another way home.";
  }
  if (found.list.empty()) return refused("the Complete circuit section cannot take up the change: " + found.refusal);
  const sim::CircuitProposal& proposal = found.list.front();
  const std::size_t spans = proposal.plan.spans();
  if (const Status room = room_for(session, next.track.knots.size() + spans - run->count, count + spans - run->count);
      !room)
    return room;
  reshape(next, run->section, proposal.plan.fit, SectionEnd::stays);
  next.entities.get<world::Section>(run->section).way = proposal.way;
  change.planned.push_back(run->section);
  return {};
}

}  // namespace coaster::edit
