// Commands that copy and paste sections, as the text of a track.
#include <fmt/format.h>

#include "edit/commands/commands_sections.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/placing.h"
#include "edit/perform/replan.h"
#include "exchange/formats.h"
#include "exchange/own/track_file.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Document;
using world::Entity;
using world::Knot;
using world::SectionRun;

// Returns the section as it is without the track around it: a way home becomes free.
world::Section alone(world::Section section) {
  if (section.kind == world::SectionKind::complete) section = {world::title_of(section)};
  return section;
}

// Returns a track of only this section.
Document track_of(const Document& document, const SectionRun& run) {
  Document track = stretch_of(document, run.first, run.count);
  const world::Section& section = world::section(document, run.section);
  track.name = world::title_of(section);
  world::make_section(track, 0, run.count, alone(section));
  return track;
}

// Adds a hand-shaped section at the open end, turned so that it continues the track.
Status append_run(const Document& from, const SectionRun& run, Document& document) {
  const auto knot = [&](std::size_t i) {
    Knot copy = world::knot(from, from.track.knots[(run.first + i) % from.track.knots.size()]);
    if (copy.joint == world::JointKind::automatic) copy.joint = world::JointKind::aligned;
    return copy;
  };
  sim::Carry carry;
  if (!document.track.knots.empty()) {
    const auto found = sim::carry_between(knot(0), world::knot(document, document.track.knots.back()));
    if (!found) return found.status();
    carry = *found;
  }
  open_out(document, knot(0));
  for (std::size_t i = 1; i <= run.count; ++i) {
    world::append_knot(document, carry.knot(knot(i)));
    const world::Segment& segment = world::segment(from, from.track.segments[run.first + i - 1]);
    document.entities.get<world::Segment>(document.track.segments.back()).turns = segment.turns;
  }
  const std::size_t first = document.track.segments.size() - run.count;
  world::make_section(document, first, run.count, alone(world::section(from, run.section)));
  return {};
}

// Adds a section at the open end, planned again from there if it was planned. Its segments get the fittings of those of
// the original; additional ones get those of the last.
Status paste(Change& change, const Document& from, const SectionRun& run, Document& document) {
  const world::Section& value = world::section(from, run.section);
  const std::size_t before = document.track.segments.size();
  if (value.kind == world::SectionKind::element) {
    const sim::ElementPlan plan = sim::plan_element(value.element, document);
    if (!plan.refusal.empty()) return refused(plan.refusal);
    document.entities.get<world::Section>(place(document, plan)).title = value.title;
    change.clamped.insert(change.clamped.end(), plan.lines.begin(), plan.lines.end());
  } else if (const auto end = sim::open_end(document); end && value.kind == world::SectionKind::force) {
    const sim::ForcePlan plan = sim::plan_force(sim::force_task(document, *end, value.force));
    if (!plan.refusal.empty()) return refused(plan.refusal);
    document.entities.get<world::Section>(place_force(document, plan)).title = value.title;
  } else if (const Status appended = append_run(from, run, document); !appended) {
    return appended;
  }
  for (std::size_t i = before; i < document.track.segments.size(); ++i)
    world::copy_fittings(from, from.track.segments[run.first + std::min(i - before, run.count - 1)], document,
                         document.track.segments[i]);
  return {};
}

// Adds all sections before the one that completes the circuit. That one gets a new start and is not shaped yet. Returns
// the last section added; kNone if there is none.
base::Result<Entity> paste_before(Change& change, const Document& from, const SectionRun& home, Document& document) {
  const std::size_t count = document.track.segments.size();
  const Entity last = document.track.segments[(home.first + count - 1) % count];
  const SectionRun before = world::run_of(document, world::segment(document, last).section);
  Document open = stretch_of(document, home.end() % count, count - home.count);
  const std::size_t old = open.track.segments.size();
  for (const SectionRun& run : world::sections_of(from))
    if (const Status pasted = paste(change, from, run, open); !pasted) return pasted;
  const std::size_t added = open.track.segments.size() - old;
  world::resize_section(document, before.section, before.count + added);
  for (std::size_t i = 0; i <= added; ++i)
    document.entities.get<Knot>(document.track.knots[(before.end() + i) % document.track.knots.size()]) =
        world::knot(open, open.track.knots[old + i]);
  for (std::size_t i = 0; i < added; ++i) {
    const Entity own = open.track.segments[old + i], into = document.track.segments[before.end() + i];
    document.entities.get<world::Segment>(into).turns = world::segment(open, own).turns;
    document.entities.pool<world::Equipment>().erase(into);
    world::copy_fittings(open, own, document, into);
  }
  Entity made;
  for (const SectionRun& run : world::sections_of(open))
    if (run.first >= old)
      made =
          world::make_section(document, before.end() + run.first - old, run.count, world::section(open, run.section));
  return made;
}

}  // namespace

Document stretch_of(const Document& document, std::size_t first, std::size_t count) {
  Document stretch;
  stretch.curve = document.curve, stretch.heartline = document.heartline;
  const auto &knots = document.track.knots, &segments = document.track.segments;
  for (std::size_t i = 0; i <= count; ++i)
    world::append_knot(stretch, world::knot(document, knots[(first + i) % knots.size()]));
  for (std::size_t i = 0; i < count; ++i) {
    const Entity from = segments[(first + i) % segments.size()], to = stretch.track.segments[i];
    stretch.entities.get<world::Segment>(to).turns = world::segment(document, from).turns;
    world::copy_fittings(document, from, stretch, to);
  }
  for (Knot& knot : stretch.entities.pool<Knot>().items())
    if (knot.joint == world::JointKind::automatic) knot.joint = world::JointKind::aligned;
  return stretch;
}

namespace {

base::Result<Document> sections_alone(const Session& session, Change& change, const Sections& named) {
  const auto sections = chosen_sections(session, named);
  if (!sections) return sections.status();
  const Document& document = session.document;
  const auto run = [&](std::size_t i) { return world::run_of(document, (*sections)[i]); };
  Document alone = track_of(document, run(0));
  for (std::size_t i = 1; i < sections->size(); ++i)
    if (const Status joined = paste(change, document, run(i), alone); !joined) return joined;
  return alone;
}

// Adds the sections of a track at the open end, or before the one that completes the circuit. `done` is "Pasted" or
// "Added".
Status add_sections(Session& session, Change& change, const Document& from, std::string_view done) {
  Document next = session.document;
  const std::vector<SectionRun> added = world::sections_of(from);
  if (added.size() == 1)
    change.note = fmt::format("{} {}.", done, world::words_of(world::section(from, added[0].section)));
  else change.note = fmt::format("{} {} sections.", done, added.size());
  if (const auto home = world::completing(next, 0)) {
    const base::Result<Entity> last = paste_before(change, from, *home, next);
    if (!last) return last.status();
    change.select = *last;
  } else {
    for (const SectionRun& run : added)
      if (const Status pasted = paste(change, from, run, next); !pasted) return pasted;
    if (!next.track.segments.empty()) change.select = world::segment(next, next.track.segments.back()).section;
  }
  if (next.track.segments.size() == session.document.track.segments.size()) return refused("the track has no sections");
  if (const Status room = room_for(session, next.track.knots.size(), next.track.segments.size()); !room) return room;
  if (session.document.track.segments.empty()) add_first_train(next);
  return adopt(session, change, session.document, std::move(next));
}

}  // namespace

Status perform(Session& session, Change& change, const CopySection& command) {
  const auto alone = sections_alone(session, change, command.sections);
  if (!alone) return alone.status();
  session.copied = exchange::print_track(*alone);
  const std::vector<SectionRun> copied = world::sections_of(*alone);
  change.note = copied.size() == 1
                    ? fmt::format("Copied {}.", world::words_of(world::section(*alone, copied[0].section)))
                    : fmt::format("Copied {} sections.", copied.size());
  return {};
}

Status perform(Session& session, Change& change, const PasteSections& command) {
  const std::string& text = command.text.empty() ? session.copied : command.text;
  if (text.empty()) return refused("nothing was copied: copy sections first");
  if (const Status may = may_move(session.document, 0); !may) return may;
  const auto loaded = exchange::parse_track(text, "clipboard");
  if (!loaded) return refused(loaded.status().message);
  return add_sections(session, change, loaded->document, "Pasted");
}

Status perform(Session& session, Change& change, const SaveSections& command) {
  if (command.path.empty()) return refused("expected a file to save to");
  if (is_own_file(session, command.path)) return refused("this is the file of the track: choose another name");
  const auto alone = sections_alone(session, change, command.sections);
  if (!alone) return alone.status();
  const Status saved = exchange::save_track(change.files, command.path, *alone);
  if (saved) change.note = fmt::format("Saved the sections to {}", command.path);
  return saved;
}

Status perform(Session& session, Change& change, const OpenSections& command) {
  if (const Status may = may_move(session.document, 0); !may) return may;
  const auto loaded = exchange::load_track(change.files, command.path);
  if (!loaded) return loaded.status();
  return add_sections(session, change, loaded->document, "Added");
}

}  // namespace coaster::edit
