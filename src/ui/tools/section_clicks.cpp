#include "ui/tools/section_clicks.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "ui/tools/selecting.h"
#include "ui/tools/viewport_tool.h"
#include "view/section_handle.h"
#include "world/panels.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

using world::Entity;

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
  const world::Neighbours sides = world::neighbours(document, active);
  return section_of_segment(document, sides.before) == section || section_of_segment(document, sides.after) == section;
}

}  // namespace

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
  const world::Neighbours sides = world::neighbours(document, under.entity);
  const Entity before = section_of_segment(document, sides.before), after = section_of_segment(document, sides.after);
  if (!before.valid() || (after.valid() && is_open(session, after) && !is_open(session, before))) return after;
  return before;
}

std::optional<edit::Command> section_click(const edit::Session& session, const view::Pick& under, bool shift) {
  if (!picks_sections(session)) return std::nullopt;
  const Entity section = section_under(session, under);
  if (!section.valid()) return std::nullopt;
  const bool among_sections = session.document.entities.find<world::Section>(session.settings.selected) != nullptr;
  if (shift && (among_sections || !session.settings.selected.valid())) return toggled_section(session, section);
  if (is_open(session, section) && !(among_sections && !session.settings.also.empty())) return std::nullopt;
  return edit::Select{{world::name_of(session.document, section)}};
}

void ViewportTool::pull_section(Ui& ui, const view::View& view, glm::vec2 mouse) {
  const edit::Session& session = ui.session();
  const auto handle = view::section_handle(session.document, session.derived, drag_.pick.entity);
  if (!handle) return;
  const auto under = [&](glm::vec2 pixel) { return view::value_under(*handle, view::ray_through(view, pixel)); };
  if (!drag_.grip) {
    const auto grabbed = under(drag_.start);
    if (!grabbed || *grabbed == 0) return;
    drag_.grip = handle->value / *grabbed;
  }
  const auto value = under(mouse);
  if (!value) return;
  const double steps = ImGui::GetIO().KeyCtrl ? 1 : 20;  // per metre
  change_section(ui, handle->parameter, std::round(*value * *drag_.grip * steps) / steps);
}

void ViewportTool::turn_section(Ui& ui, const view::View& view, glm::vec2 mouse) {
  const edit::Session& session = ui.session();
  const auto handle = view::angle_handle(session.document, session.derived, drag_.pick.entity, drag_.pick.kind);
  if (!handle) return;
  const auto under = [&](glm::vec2 pixel, double near) {
    return view::angle_under(*handle, view::ray_through(view, pixel), near);
  };
  if (!drag_.grip) {
    const auto grabbed = under(drag_.start, handle->angle);
    if (!grabbed) return;
    drag_.grip = handle->angle - *grabbed;
  }
  const auto angle = under(mouse, handle->angle - *drag_.grip);
  if (!angle) return;
  const double step = ImGui::GetIO().KeyCtrl ? 5 : 0.5;  // deg
  change_section(ui, handle->parameter, std::round((*angle + *drag_.grip) / step) * step * handle->whole);
}

// Changes the section whose handle is dragged, planned again from the drag's start.
void ViewportTool::change_section(Ui& ui, std::string_view parameter, double value) {
  const edit::Session& session = ui.session();
  world::Element to = world::section(session.document, drag_.pick.entity).element;
  const double now = world::value_of(to, parameter);
  world::set_value(to, parameter, value);
  if (world::value_of(to, parameter) == now) return;
  if (!drag_.gesture) ui.emit(edit::BeginGesture{});
  drag_.gesture = true;
  ui.emit(edit::ChangeSection{{world::name_of(session.document, drag_.pick.entity)}, true, to});
}

// A click selects the knot under a section's handle, at the section's end.
void ViewportTool::click_handle(Ui& ui) {
  constexpr float kThere = 1e-3f;  // m
  const world::Document& document = ui.session().document;
  const std::vector<Entity>& knots = document.track.knots;
  const Entity knot = knots[world::run_of(document, drag_.pick.entity).end() % knots.size()];
  if (glm::distance(world::knot(document, knot).position, drag_.pick.position) < kThere)
    ui.emit(edit::Select{{world::name_of(document, knot)}});
}

}  // namespace coaster::ui
