// Commands that delete, mirror and reorder sections.
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/force_replan.h"
#include "edit/perform/replan.h"
#include "world/element_rows.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dvec3;
using world::Document;
using world::Entity;
using world::Knot;
using world::SectionRun;

Knot& knot_to_change(Document& document, std::size_t index) {
  const auto& knots = document.track.knots;
  return document.entities.get<Knot>(knots[index % knots.size()]);
}

// Starts track with another first handle at a knot.
void begin_there(Knot& knot, float out_length) {
  knot.out_length = out_length;
  if (knot.in_length != out_length || knot.joint == world::JointKind::automatic) knot.joint = world::JointKind::aligned;
}

// Returns the element with left and right swapped.
world::Element mirrored(world::Element element) {
  const world::ElementRow& row = base::row_of(element.kind);
  if (row.sided) element.right = !element.right;
  world::set_value(element, "roll", 0.0 - world::found_value(element, "roll").value_or(0));
  return element;
}

// Returns the program with left and right swapped.
world::ForceProgram mirrored(world::ForceProgram program) {
  program.hold = false;  // its end moves to the other side
  for (const auto channel : {world::ForceChannel::lateral, world::ForceChannel::roll})
    for (world::ForceKey& key : program.keys(channel)) key.value = 0.0 - key.value, key.slope = 0.0 - key.slope;
  return program;
}

// Mirrors a hand-shaped section across the vertical plane of its first knot's direction, and moves the track that
// follows.
Status mirror_knots(Document& document, const SectionRun& run) {
  constexpr double kUpright = 1e-4, kSteep = 0.1;  // of unit vectors
  const Knot start = nth_knot(document, run.first), end = nth_knot(document, run.end());
  const dvec3 level(start.tangent.x, 0, start.tangent.z);
  if (!(glm::length(level) > kSteep)) return refused("the section begins too steep to have a left and a right");
  const dvec3 side = glm::normalize(glm::cross(level, dvec3(0, 1, 0)));
  if (!(std::abs(glm::dot(dvec3(start.up), side)) <= kUpright))
    return refused("the section begins rolled, and would have to begin rolled to the other side");
  const auto across = [&](dvec3 v) { return v - 2.0 * glm::dot(v, side) * side; };
  const auto reflect = [&](Knot knot) {
    knot.position = glm::vec3(dvec3(start.position) + across(dvec3(knot.position) - dvec3(start.position)));
    knot.tangent = glm::vec3(across(dvec3(knot.tangent)));
    knot.up = glm::vec3(across(dvec3(knot.up)));
    knot.spin = 0.0f - knot.spin;
    world::orthonormalise(knot);
    return knot;
  };
  if (document.track.closed || run.end() < document.track.segments.size()) {
    const base::Result<sim::Carry> carry = sim::carry_between(end, reflect(end));
    if (!carry) return carry.status();
    if (const Status carried = carry_after(document, run.end(), *carry); !carried) return carried;
  }
  for (std::size_t i = 1; i <= run.count; ++i) {
    Knot& knot = knot_to_change(document, run.first + i);
    knot = reflect(knot);
  }
  for (std::size_t i = run.first; i < run.end(); ++i) {
    world::Segment& segment = document.entities.get<world::Segment>(document.track.segments[i]);
    segment.turns = -segment.turns;
  }
  return {};
}

// Swaps the sections of two neighbouring runs; each begins in the frame in which the other one began or ended.
Status swap_runs(Document& document, const SectionRun& run, const SectionRun& next) {
  const Knot a = nth_knot(document, run.first), b = nth_knot(document, run.end()), c = nth_knot(document, next.end());
  const bool follows = next.end() < document.track.segments.size();
  const auto second = sim::carry_between(b, a);
  if (!second) return second.status();
  const auto first = sim::carry_between(a, second->knot(c));
  if (!first) return first.status();
  const auto rest = sim::carry_between(c, first->knot(b));
  if (follows && !rest) return rest.status();
  if (follows)
    if (const Status carried = carry_after(document, next.end(), *rest); !carried) return carried;
  for (std::size_t i = run.first + 1; i <= next.end(); ++i) {
    Knot& knot = knot_to_change(document, i);
    knot = (i <= run.end() ? *first : *second).knot(knot);
  }
  begin_there(knot_to_change(document, run.first), b.out_length);
  begin_there(knot_to_change(document, next.end()), a.out_length);
  begin_there(knot_to_change(document, run.end()), follows ? c.out_length : b.in_length);
  world::swap_sections(document, run.section);
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const DeleteSection& command) {
  const auto section = require(session, command.section, world::Kind::section);
  if (!section) return section.status();
  Document next = session.document;
  const SectionRun run = world::run_of(next, *section);
  if (const Status may = may_move(next, run.end()); !may) return may;
  const bool closes_gap = run.first > 0 && run.end() < next.track.segments.size();
  const std::string title = world::words_of(world::section(next, *section));
  if (closes_gap) {
    const Knot start = nth_knot(next, run.first), end = nth_knot(next, run.end());
    const auto carry = sim::carry_between(end, start);
    if (!carry) return carry.status();
    if (const Status carried = carry_after(next, run.end(), *carry); !carried) return carried;
    begin_there(knot_to_change(next, run.first), end.out_length);
  }
  world::remove_section(next, *section);
  const auto trains = [](const Document& document) { return document.entities.pool<world::Cart>().size(); };
  const std::size_t lost = trains(session.document) - trains(next);
  change.note = fmt::format("Deleted {}{}.{}", title,
                            lost == 0   ? ""
                            : lost == 1 ? " and the train on it"
                                        : " and the trains on it",
                            closes_gap ? " The track behind it closes the gap." : "");
  return adopt(session, change, session.document, std::move(next));
}

Status perform(Session& session, Change& change, const MirrorSection& command) {
  const auto section = require(session, command.section, world::Kind::section);
  if (!section) return section.status();
  Document next = session.document;
  world::Section& value = next.entities.get<world::Section>(*section);
  const bool same = value.kind == world::SectionKind::element && mirrored(value.element) == value.element;
  if (value.kind == world::SectionKind::force) value.force = mirrored(value.force);
  const Status done = value.kind == world::SectionKind::element
                          ? replan(session, change, next, *section, mirrored(value.element))
                      : value.kind == world::SectionKind::force ? replan_force(session, change, next, *section)
                                                                : mirror_knots(next, world::run_of(next, *section));
  if (!done) return done;
  const std::string title = world::words_of(world::section(next, *section));
  change.note = same ? base::sentence(title + " is the same to both sides") : fmt::format("Mirrored {}.", title);
  return adopt(session, change, session.document, std::move(next));
}

Status perform(Session& session, Change& change, const MoveSection& command) {
  const auto section = require(session, command.section, world::Kind::section);
  if (!section) return section.status();
  Document next = session.document;
  const std::vector<SectionRun> runs = world::sections_of(next);
  const auto at = std::find(runs.begin(), runs.end(), world::run_of(next, *section));
  const bool earlier = command.to == Neighbour::before;
  const auto title = [&](const SectionRun& run) { return world::words_of(world::section(next, run.section)); };
  if (earlier ? at == runs.begin() : at + 1 == runs.end())
    return refused(fmt::format("there is no section {} {}", earlier ? "before" : "after", title(*at)));
  const auto first = earlier ? at - 1 : at;
  if (const Status may = may_move(next, (first + 1)->end()); !may) return may;
  change.note =
      fmt::format("Moved {} {} {}.", title(*at), earlier ? "before" : "after", title(earlier ? *first : *(at + 1)));
  if (const Status swapped = swap_runs(next, *first, *(first + 1)); !swapped) return swapped;
  return adopt(session, change, session.document, std::move(next));
}

}  // namespace coaster::edit
