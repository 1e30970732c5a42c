#include "ui/tools/selecting.h"

#include <algorithm>
#include <cmath>

#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_settings.h"
#include "world/panel_settings.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {

using world::Entity;

namespace {

Entity section_of_segment(const world::Document& document, Entity e) {
  const world::Segment* const segment = document.entities.find<world::Segment>(e);
  return segment ? segment->section : world::kNone;
}

// True if the section, a segment or a knot of it is selected.
bool is_open(const edit::Session& session, Entity section) {
  const world::Document& document = session.document;
  if (world::is_selected(session.settings, section)) return true;
  const Entity active = session.settings.selected;
  if (section_of_segment(document, active) == section) return true;
  if (!document.entities.find<world::Knot>(active)) return false;
  const world::KnotSegments sides = world::neighbours(document, active);
  return section_of_segment(document, sides.before) == section || section_of_segment(document, sides.after) == section;
}

}  // namespace

std::vector<world::EntityName> names_of(const world::Document& document, const std::vector<Entity>& entities) {
  std::vector<world::EntityName> names;
  for (const Entity e : entities) names.push_back(world::name_of(document, e));
  return names;
}

edit::Command selection_of(const world::Document& document, const std::vector<Entity>& entities) {
  if (entities.empty()) return edit::Select{};
  const std::vector<world::EntityName> names = names_of(document, entities);
  if (names.size() == 1) return edit::Select{{names[0]}};
  if (names[0].kind == world::EntityKind::section) return edit::SelectSections{edit::Sections(names)};
  return edit::SelectKnots{edit::Knots(names)};
}

edit::Command toggled(const edit::Session& session, Entity entity) {
  const bool section = session.document.entities.find<world::Section>(entity) != nullptr;
  std::vector<Entity> chosen = section ? world::selected_sections(session.document, session.settings)
                                       : world::selected_knots(session.document, session.settings);
  if (std::erase(chosen, entity) == 0) chosen.push_back(entity);
  return selection_of(session.document, chosen);
}

edit::Command copying(const edit::Session& session) {
  return edit::CopySection{
      edit::Sections(names_of(session.document, world::selected_sections(session.document, session.settings)))};
}

edit::Command up_to(const edit::Session& session, Entity knot) {
  const world::Track& track = session.document.track;
  const auto from = world::index_of(track.knots, session.settings.selected), to = world::index_of(track.knots, knot);
  if (!from || !to || *from == *to) return selection_of(session.document, {knot});
  const std::size_t count = track.knots.size(), forward = (*to + count - *from) % count;
  const bool back = track.closed ? 2 * forward > count : *to < *from;
  std::vector<Entity> knots = world::selected_knots(session.document, session.settings);
  const std::size_t steps = back ? count - forward : forward;
  for (std::size_t i = 0; i <= steps; ++i) {
    const Entity e = track.knots[(*from + (back ? count - i : i)) % count];
    std::erase(knots, e);
    knots.push_back(e);
  }
  return selection_of(session.document, knots);
}

std::optional<edit::Command> boxed(const edit::Session& session, const view::View& view, glm::vec2 corner,
                                   glm::vec2 opposite, BoxMode mode) {
  const glm::vec2 low = glm::min(corner, opposite), high = glm::max(corner, opposite);
  const std::vector<Entity> before = world::selected_knots(session.document, session.settings);
  std::vector<Entity> knots = mode == BoxMode::replace ? std::vector<Entity>{} : before;
  for (const Entity e : session.document.track.knots) {
    const auto at = view::project(view, world::knot(session.document, e).position);
    if (!at || std::abs(at->z) > 1 || at->x < low.x || at->y < low.y || at->x > high.x || at->y > high.y) continue;
    if (mode == BoxMode::remove) std::erase(knots, e);
    else if (mode == BoxMode::replace || !world::is_selected(session.settings, e)) knots.push_back(e);
  }
  if (knots == before) return std::nullopt;
  return selection_of(session.document, knots);
}

bool picks_sections(const edit::Session& session) {
  if (session.settings.panels->workspace != world::Workspace::build) return false;
  const auto& sections = session.document.entities.pool<world::Section>().items();
  return std::any_of(sections.begin(), sections.end(),
                     [](const world::Section& s) { return s.kind != world::SectionKind::free; });
}

Entity section_under(const edit::Session& session, const view::Pick& under) {
  const world::Document& document = session.document;
  if (under.kind == view::PickKind::curve) return section_of_segment(document, under.entity);
  if (under.kind != view::PickKind::knot || !document.entities.alive(under.entity)) return world::kNone;
  const world::KnotSegments sides = world::neighbours(document, under.entity);
  const Entity before = section_of_segment(document, sides.before), after = section_of_segment(document, sides.after);
  if (!before.valid() || (after.valid() && is_open(session, after) && !is_open(session, before))) return after;
  return before;
}

std::optional<edit::Command> section_click(const edit::Session& session, const view::Pick& under, bool shift) {
  if (!picks_sections(session)) return std::nullopt;
  const Entity section = section_under(session, under);
  if (!section.valid()) return std::nullopt;
  const bool among_sections = session.document.entities.find<world::Section>(session.settings.selected) != nullptr;
  if (shift && (among_sections || !session.settings.selected.valid())) return toggled(session, section);
  if (is_open(session, section) && !(among_sections && !session.settings.also.empty())) return std::nullopt;
  return edit::Select{{world::name_of(session.document, section)}};
}

}  // namespace coaster::ui
