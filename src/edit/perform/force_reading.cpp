// force.read: makes a force section of track that is there.
#include <fmt/format.h>

#include "edit/commands/commands_force.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/replan.h"
#include "sim/plan/force_reading.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Document;
using world::Entity;

// Returns the run of neighbouring sections, under the name of the first; refused where others lie between them.
base::Result<world::SectionRun> run_of_all(const Document& document, const std::vector<Entity>& in_track_order) {
  world::SectionRun run = world::run_of(document, in_track_order.front());
  for (std::size_t i = 1; i < in_track_order.size(); ++i) {
    const world::SectionRun next = world::run_of(document, in_track_order[i]);
    if (next.first != run.end())
      return refused(fmt::format("{} does not follow {}: expected neighbouring sections",
                                 world::words_of(world::section(document, next.section)),
                                 world::words_of(world::section(document, in_track_order[i - 1]))));
    run.count += next.count;
  }
  return run;
}

// Refused where equipment differs along a run: it would not stay in its place.
Status same_equipment(const Document& document, const world::SectionRun& run) {
  const auto of = [&](std::size_t i) {
    const auto* const found = document.entities.find<world::Equipment>(document.track.segments[i]);
    return found != nullptr ? std::optional(*found) : std::nullopt;
  };
  for (std::size_t i = run.first + 1; i < run.end(); ++i)
    if (of(i) != of(run.first))
      return refused("part of it has equipment that the rest lacks: remove it, or read the parts one by one");
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const ReadForces& command) {
  const auto sections = chosen_sections(session, command.sections);
  if (!sections) return sections.status();
  const Document& document = session.document;
  const std::string label = world::label_of(document, sections->front());
  if (sections->size() == 1 && world::section(document, sections->front()).kind == world::SectionKind::force)
    return refused(fmt::format("@{} is a force section", label));
  const auto all = run_of_all(document, *sections);
  if (!all) return all.status();
  const world::SectionRun& run = *all;
  if (const Status same = same_equipment(document, run); !same) return same;
  const std::optional<double> speed = Finder(session).speed_at(session.derived.starts[run.first]);
  world::ForceProgram program;
  program.tolerance = command.tolerance, program.speed = speed.value_or(sim::kAssumedSpeed);
  const sim::ForceReading reading =
      sim::read_forces({session.derived, run.first, run.count}, sim::force_task(document, run, program));
  if (!reading.refusal.empty()) return refused(fmt::format("@{}: {}", label, reading.refusal));
  const sim::ForcePlan& plan = force_plans_of(session).plan(reading.plan.task);
  if (const Status room = room_for_spans(session, document, run, plan.spans()); !room) return room;
  Document next = document;
  const Entity section = world::make_section(
      next, run.first, run.count,
      {world::section(document, run.section).title, world::SectionKind::force, {}, {}, plan.task.program});
  const bool follows = document.track.closed || run.end() < document.track.segments.size();
  reshape(next, section, plan.fit.spans, follows ? SectionEnd::stays : SectionEnd::open);
  change.select = section;
  if (!speed) change.clamped.push_back(sim::assumed_text());
  std::size_t keys = 0;
  for (const auto& channel : plan.task.program.channels) keys += channel.size();
  change.note =
      fmt::format("{} keys keep the shape within {:.1f} mm, in {} spans.", keys, 1000 * reading.error, plan.spans());
  return adopt(session, change, session.document, std::move(next));
}

}  // namespace coaster::edit
