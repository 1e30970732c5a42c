// Section: the name, the parameters and the equipment of the selected section.
#include <imgui.h>

#include <cmath>

#include "edit/commands/commands_sections.h"
#include "ui/context/rows.h"
#include "ui/panels/equipment_rows.h"
#include "ui/widgets/theme.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

using world::Element;
using world::Section;

// Everything is planned from the drag's start, so that a drag adds no rounding.
void change(Ui& ui, world::Name name, const Element& to) { ui.emit(edit::ChangeSection{{name}, true, to}); }

void kind_box(Ui& ui, world::Name name, const Section& section) {
  std::vector<Choice> kinds = choices_of<world::ElementKind>();
  const bool planned = section.kind == world::SectionKind::element;
  if (!planned) {
    const auto& row = base::row_of(section.kind);
    kinds.push_back({std::string(row.label), std::string(row.help)});
  }
  const int now = planned ? static_cast<int>(section.element.kind) : static_cast<int>(kinds.size()) - 1;
  const auto to = combo(ui, "Kind", kinds, now, "Plan the section as another element. What follows moves along.");
  if (to && *to != now && *to < static_cast<int>(base::count_of<world::ElementKind>()))
    change(ui, name, world::usual_element(static_cast<world::ElementKind>(*to)));
}

void section_parameters(Ui& ui, world::Name name, Element element) {
  const world::ElementRow& row = base::row_of(element.kind);
  if (row.sided) {
    const bool right = element.right;
    if (radio(ui, "Left", !right, "Turn left.")) element.right = false;
    (void)beside_last(ui, "Right");
    if (radio(ui, "Right", right, "Turn right.")) element.right = true;
    if (element.right != right) change(ui, name, element);
  }
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const world::ElementParameter& p = row.parameters[i];
    const double range = p.high - p.low, step = range > 100 ? 0.1 : range > 20 ? 0.05 : 0.01;
    const Number now{.value = element.values[i],
                     .unit = p.unit.data(),
                     .step = step,
                     .low = p.low,
                     .high = p.high,
                     .largest = 1e300};
    if (const auto to = number(ui, p.label, now, p.help)) {
      element.values[i] = *to;
      change(ui, name, element);
    }
  }
}

// The equipment of the whole section; nothing if its segments differ.
struct Equipped {
  bool mixed = false;
  const world::Equipment* equipment = nullptr;  // null: plain track
};
Equipped equipped(const world::Document& document, const world::SectionRun& run) {
  const auto at = [&](std::size_t i) { return document.entities.find<world::Equipment>(document.track.segments[i]); };
  Equipped found{false, at(run.first)};
  for (std::size_t i = run.first + 1; i < run.end(); ++i) {
    const world::Equipment* const other = at(i);
    if ((other == nullptr) != (found.equipment == nullptr) || (other && !(*other == *found.equipment)))
      return {true, nullptr};
  }
  return found;
}

// One button a kind of equipment and one for none, three beside each other; the present one is lit.
void section_equipment(Ui& ui, world::Name name, const Equipped& now) {
  constexpr int kColumns = 3;
  const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const float width = std::floor((room - gap * (kColumns - 1)) / kColumns);
  const auto choice = [&](std::string_view label, std::string_view help, int place, bool lit) {
    if (place % kColumns != 0) ImGui::SameLine();
    if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool pressed = button(ui, label, help, true, width);
    if (lit) ImGui::PopStyleColor();
    return pressed && !lit;
  };
  const world::Equipment usual, &values = now.equipment ? *now.equipment : usual;
  const auto equip = [&](world::EquipmentKind kind) {
    return edit::EquipSection{{name}, kind, values.speed, values.acceleration, values.hysteresis, values.seconds};
  };
  int place = 0;
  for (const auto& row : rows_of(world::EquipmentKind{})) {
    const auto kind = static_cast<world::EquipmentKind>(place);
    if (choice(row.label, row.help, place++, now.equipment && now.equipment->kind == kind)) ui.emit(equip(kind));
  }
  if (choice("None", "Make the whole section plain track.", place, !now.mixed && !now.equipment))
    ui.emit(edit::UnequipSection{{name}});
  if (now.equipment) equipment_rows(ui, equip(now.equipment->kind));
}

void figures(Ui& ui, const world::SectionRun& run) {
  const edit::Session& session = ui.session();
  const auto& knots = session.document.track.knots;
  const auto knot = [&](std::size_t i) -> const world::Knot& {
    return world::knot(session.document, knots[i % knots.size()]);
  };
  read_out(ui, "Length", session.derived.starts[run.end()] - session.derived.starts[run.first], 1, "m",
           "Length of the section.");
  read_out(ui, "Height at start", knot(run.first).position.y, 1, "m", "Height of the track where the section begins.");
  read_out(ui, "Height at end", knot(run.end()).position.y, 1, "m", "Height of the track where the section ends.");
}

// Buttons in pairs: what is done with the whole section.
void whole(Ui& ui, world::Name name, const world::SectionRun& run) {
  const edit::Session& session = ui.session();
  const bool open = !session.document.track.closed, last = run.end() == session.document.track.segments.size();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  bool left = true;
  const auto act = [&](std::string_view label, std::string_view help, bool enabled, auto command) {
    if (!left) ImGui::SameLine();
    left = !left;
    if (button(ui, label, help, enabled, width)) ui.emit(std::move(command));
  };
  act("Mirror", "Swap left and right. What follows moves along.", true, edit::MirrorSection{{name}});
  act("Join with next", "Join the section with the next one. The result is hand-shaped.", !last,
      edit::JoinSections{{name}});
  act("Move before", "Swap the section with the one before it.", open && run.first > 0,
      edit::MoveSection{{name}, edit::Neighbour::before});
  act("Move after", "Swap the section with the one after it.", open && !last,
      edit::MoveSection{{name}, edit::Neighbour::after});
  act("Copy", "Copy the section.", true, edit::CopySection{{name}});
  act("Paste", "Add the copied section at the open end of the track.", open && !session.copied.empty(),
      edit::PasteSections{});
  act("Delete section", "Delete the section. What follows moves to where it began.", open, edit::DeleteSection{{name}});
}

}  // namespace

bool section_shown(const Ui& ui) {
  const edit::Session& session = ui.session();
  return session.document.entities.find<Section>(session.settings.selected) != nullptr;
}

void section_panel(Ui& ui) {
  const world::Document& document = ui.session().document;
  const world::Entity e = ui.session().settings.selected;
  const Section& section = world::section(document, e);
  const world::Name name = world::name_of(document, e);
  const world::SectionRun run = world::run_of(document, e);
  // Fields of another section are other fields: what is typed in one never lands in the next.
  ImGui::PushID(static_cast<int>(name.number));
  if (const auto title = text(ui, "Title", section.title, "Name of the section. Without one it is shown by its kind."))
    ui.emit(edit::SetSectionTitle{{name}, *title});
  kind_box(ui, name, section);
  if (section.kind == world::SectionKind::element) section_parameters(ui, name, section.element);
  figures(ui, run);
  section_equipment(ui, name, equipped(document, run));
  whole(ui, name, run);
  ImGui::PopID();
}

}  // namespace coaster::ui
