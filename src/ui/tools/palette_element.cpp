#include "ui/tools/palette_element.h"

#include <algorithm>

#include "edit/commands/commands_elements.h"
#include "sim/plan/elements.h"
#include "world/element_rows.h"
#include "world/panels.h"

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
  return std::ranges::any_of(document.entities.pool<world::Equipment>().items(), [](const world::Equipment& equipment) {
    return equipment.kind == EquipmentKind::lift || equipment.kind == EquipmentKind::launch;
  });
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

}  // namespace coaster::ui
