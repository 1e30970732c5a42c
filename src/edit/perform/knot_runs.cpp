// Resolves names in a command to knots and sections of the track.
#include "edit/perform/knot_runs.h"

#include <algorithm>
#include <map>

#include "curve/frames.h"
#include "world/sections.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using world::Knot;

// Returns the knots from one to another, in the direction of travel; on an open track in either order.
base::Result<std::vector<world::Entity>> from_to(const Session& session, const std::vector<world::EntityName>& ends) {
  const auto first = require(session, {ends.front()}, world::EntityKind::knot),
             last = require(session, {ends.back()}, world::EntityKind::knot);
  if (!first || !last) return first ? last.status() : first.status();
  const world::Track& track = session.document.track;
  std::size_t from = *world::index_of(track.knots, *first), to = *world::index_of(track.knots, *last);
  if (from > to && !track.closed) std::swap(from, to);
  std::vector<world::Entity> found{track.knots[from]};
  while (from != to) found.push_back(track.knots[from = (from + 1) % track.knots.size()]);
  return found;
}

// Resolves names to entities, in one pass through the pool for many names.
base::Result<std::vector<world::Entity>> named(const Session& session, const std::vector<world::EntityName>& names) {
  std::vector<world::Entity> found;
  std::map<std::uint32_t, world::Entity> numbers;
  if (names.size() > 4)
    for (const world::Entity e : session.document.track.knots)
      numbers.emplace(world::name_of(session.document, e).number, e);
  for (const world::EntityName name : names) {
    const auto place = name.kind == world::EntityKind::knot ? numbers.find(name.number) : numbers.end();
    if (place != numbers.end()) {
      found.push_back(place->second);
      continue;
    }
    const auto e = require(session, {name}, world::EntityKind::knot);
    if (!e) return e.status();
    found.push_back(*e);
  }
  return found;
}

// --- The shape of appended knots

// Smooth between two positions, either of which may be missing: the automatic shape with the mean of its two lengths.
void shape_smooth(Knot& knot, const glm::vec3* before, const glm::vec3* after) {
  world::shape_between(knot, before, after);
  equalise(knot);
}

bool same_shape(const Knot& a, const Knot& b) {
  return a.joint == b.joint && a.tangent == b.tangent && a.in_length == b.in_length && a.out_length == b.out_length;
}

}  // namespace

base::Result<std::vector<world::Entity>> knots_of(const Session& session, const Knots& knots) {
  const world::Document& document = session.document;
  std::vector<world::Entity> chosen;
  switch (knots.which) {
    case Knots::Which::all: chosen = document.track.knots; break;
    case Knots::Which::selected: chosen = world::selected_knots(document, session.settings); break;
    case Knots::Which::named:
    case Knots::Which::range: {
      auto found = knots.which == Knots::Which::range ? from_to(session, knots.names) : named(session, knots.names);
      if (!found) return found.status();
      chosen = std::move(*found);
    }
  }
  chosen = world::in_track_order(document, chosen);
  if (!chosen.empty()) return chosen;
  return refused(knots.which == Knots::Which::selected ? "no knot is selected"
                 : knots.which == Knots::Which::all    ? "the track has no knots"
                                                       : "expected a knot, found none");
}

base::Result<std::vector<world::Entity>> chosen_sections(const Session& session, const Sections& sections) {
  std::vector<world::Entity> chosen, ordered;
  if (sections.which == Knots::Which::selected) chosen = world::selected_sections(session.document, session.settings);
  for (const world::EntityName name : sections.names) {
    const auto e = require(session, {name}, world::EntityKind::section);
    if (!e) return e.status();
    chosen.push_back(*e);
  }
  bool inside = false;  // inside a range
  for (const world::SectionRun& run : world::sections_of(session.document)) {
    const auto named = std::count(chosen.begin(), chosen.end(), run.section);
    if (named > 0 || inside || sections.which == Knots::Which::all) ordered.push_back(run.section);
    if (sections.which == Knots::Which::range && named == 1) inside = !inside;
  }
  if (!ordered.empty()) return ordered;
  return refused(sections.which == Knots::Which::selected ? "no section is selected"
                 : sections.which == Knots::Which::all    ? "the track has no sections"
                                                          : "expected a section, found none");
}

std::vector<world::Entity> with_neighbours(const world::Document& document,
                                           const std::vector<world::Entity>& in_track_order) {
  const world::Track& track = document.track;
  std::vector<world::Entity> all;
  for (const KnotRun& run : runs_of(document, in_track_order)) {
    const std::size_t count = track.knots.size(), first = run.places.front(), last = run.places.back();
    if (first > 0 || track.closed) all.push_back(track.knots[(first + count - 1) % count]);
    for (const std::size_t place : run.places) all.push_back(track.knots[place]);
    if (last + 1 < count || track.closed) all.push_back(track.knots[(last + 1) % count]);
  }
  return all;
}

std::vector<KnotRun> runs_of(const world::Document& document, const std::vector<world::Entity>& in_track_order) {
  const world::Track& track = document.track;
  const std::size_t count = track.knots.size();
  std::vector<KnotRun> runs;
  if (track.closed && in_track_order.size() == count) {
    runs.emplace_back().whole = true;
    for (std::size_t i = 0; i < count; ++i) runs[0].places.push_back(i);
    return runs;
  }
  auto next = in_track_order.begin();
  for (std::size_t i = 0; i < count && next != in_track_order.end(); ++i) {
    if (track.knots[i] != *next) continue;
    ++next;
    if (runs.empty() || runs.back().places.back() + 1 != i) runs.emplace_back();
    runs.back().places.push_back(i);
  }
  // A run that ends where another begins at the track's joint continues there.
  if (track.closed && runs.size() > 1 && runs.front().places.front() == 0 && runs.back().places.back() + 1 == count) {
    std::vector<std::size_t>& into = runs.back().places;
    into.insert(into.end(), runs.front().places.begin(), runs.front().places.end());
    runs.erase(runs.begin());
  }
  return runs;
}

void equalise(Knot& knot) {
  knot.in_length = knot.out_length = static_cast<float>((double{knot.in_length} + double{knot.out_length}) / 2);
}

Knot appended_knot(const world::Document& document, glm::vec3 position) {
  Knot knot;
  knot.position = position;
  if (document.track.knots.empty()) return knot;
  const Knot& last = world::knot(document, document.track.knots.back());
  const glm::dvec3 chord = glm::dvec3(position) - glm::dvec3(last.position);
  if (glm::length(chord) < double{world::kMinHandle}) {
    const glm::vec3 level(last.tangent.x, 0, last.tangent.z);
    world::set_tangent(knot, level);
  } else {
    shape_smooth(knot, &last.position, nullptr);
  }
  knot.up = glm::vec3(curve::perpendicular(glm::normalize(glm::dvec3(knot.tangent)), {0, 1, 0}));
  return knot;
}

void reshape_end(world::Document& document, bool last, glm::vec3 beyond) {
  const auto& order = document.track.knots;
  if (order.empty()) return;
  Knot& knot = document.entities.get<Knot>(last ? order.back() : order.front());
  Knot untouched = knot;
  untouched.joint = world::JointKind::smooth;
  const glm::vec3* beside = nullptr;
  if (order.size() == 1) {
    untouched.tangent = Knot{}.tangent;
    untouched.in_length = untouched.out_length = Knot{}.in_length;
  } else {
    beside = &world::knot(document, order[last ? order.size() - 2 : 1]).position;
    shape_smooth(untouched, last ? beside : nullptr, last ? nullptr : beside);
  }
  if (!same_shape(knot, untouched)) return;
  if (last) shape_smooth(knot, beside, &beyond);
  else shape_smooth(knot, &beyond, beside);
}

void close_by_segment(world::Document& document, double longest) {
  const world::Entity first = document.track.knots.front(), last = document.track.knots.back();
  reshape_end(document, true, world::knot(document, first).position);
  reshape_end(document, false, world::knot(document, last).position);
  world::set_closed(document, true);
  Knot &start = document.entities.get<Knot>(first), &end = document.entities.get<Knot>(last);
  const double gap = glm::distance(glm::dvec3(end.position), glm::dvec3(start.position));
  const float third = world::as_handle(gap / 3);
  for (float* const handle : {&start.in_length, &end.out_length})
    if (double{*handle} > longest * gap) *handle = third;
  for (Knot* const knot : {&start, &end})
    if (knot->in_length != knot->out_length && knot->joint == world::JointKind::smooth)
      knot->joint = world::JointKind::aligned;
}

}  // namespace coaster::edit
