#include "ui/tools/preview_placement.h"

#include <algorithm>

#include "edit/commands/commands_elements.h"
#include "edit/commands/set_setting.h"
#include "sim/plan/element_plan.h"
#include "sim/study/complete_circuit.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace {

using world::ElementKind;
using world::EquipmentKind;

constexpr std::string_view kEquipment = "equipment";
constexpr double kNone = 0;

bool in_build(const edit::Session& session) {
  return session.settings.panels->workspace == world::Workspace::build && !session.game.challenge;
}

// True if a lift or launch gives trains their speed.
bool drives_trains(const world::Document& document) {
  return std::ranges::any_of(document.entities.pool<world::Equipment>().items(),
                             [](const world::Equipment& equipment) { return base::row_of(equipment.kind).drives; });
}

// Returns the equipment offered for an element that has none.
double offered(const edit::Session& session, ElementKind kind) {
  if (kind == ElementKind::straight && session.document.track.segments.empty())
    return world::equipment_choice(EquipmentKind::station);
  if (kind == ElementKind::climb && !drives_trains(session.document))
    return world::equipment_choice(EquipmentKind::lift);
  return kNone;
}

}  // namespace

void choose_element(Ui& ui, ElementKind kind) {
  const world::Element& last = ui.session().settings.element;
  world::Element element = last.kind == kind ? last : ui.inputs.elements[static_cast<std::size_t>(kind)];
  if (in_build(ui.session()) && world::found_value(element, kEquipment) == kNone)
    world::set_value(element, kEquipment, offered(ui.session(), kind));
  ui.emit(edit::ChooseElement{element});
}

void place_shown_element(Ui& ui) {
  world::Element element = ui.session().settings.element;
  ui.emit(edit::PlaceElement{element});
  const bool placed = ui.find.element().refusal.empty();
  if (!placed || !in_build(ui.session()) || world::found_value(element, kEquipment).value_or(kNone) == kNone) return;
  world::set_value(element, kEquipment, kNone);
  ui.emit(edit::ChooseElement{element});
}

bool completable(const world::Document& document) { return !document.track.closed && !document.track.segments.empty(); }

std::size_t shown_proposal(const world::EditingAids& aids, const sim::CircuitProposals& found) {
  const auto wanted = static_cast<std::size_t>(std::max(aids.circuit, 1));
  return std::min(wanted, std::max<std::size_t>(found.list.size(), 1)) - 1;
}

void show_proposals(Ui& ui) {
  if (ui.session().settings.aids->show_element) ui.emit(edit::Set<&world::EditingAids::show_element>{false});
  ui.emit(edit::Set<&world::EditingAids::circuit>{1});
}

void toggle_proposals(Ui& ui) {
  if (ui.session().settings.aids->circuit > 0) ui.emit(edit::Set<&world::EditingAids::circuit>{0});
  else show_proposals(ui);
}

void next_proposal(Ui& ui) {
  const sim::CircuitProposals& found = ui.find.circuit();
  if (found.list.empty()) return;
  const std::size_t next = (shown_proposal(*ui.session().settings.aids, found) + 1) % found.list.size();
  ui.emit(edit::Set<&world::EditingAids::circuit>{static_cast<int>(next) + 1});
}

void place_proposal(Ui& ui) {
  const sim::CircuitProposals& found = ui.find.circuit();
  ui.emit(edit::CompleteCircuit{static_cast<int>(shown_proposal(*ui.session().settings.aids, found)) + 1});
  if (!found.list.empty()) ui.emit(edit::Set<&world::EditingAids::circuit>{0});
}

std::vector<glm::vec3> preview_points(const Ui& ui) {
  std::vector<glm::vec3> points;
  const world::EditingAids& aids = *ui.session().settings.aids;
  const auto add = [&](const sim::ElementPlan& plan) {
    if (plan.refusal.empty())
      for (const world::Knot& knot : plan.fit.knots) points.emplace_back(knot.position);
  };
  if (aids.circuit > 0 && completable(ui.session().document)) {
    if (ui.session().history.in_gesture) return points;  // a search would hold up each frame of a drag
    const sim::CircuitProposals& ways = ui.find.circuit();
    if (!ways.list.empty()) add(ways.list[shown_proposal(aids, ways)].plan);
  } else if (aids.show_element) {
    add(ui.find.element());
  }
  return points;
}

}  // namespace coaster::ui
