#include "ui/panels/element_equipment_fields.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/widgets/theme.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"

namespace coaster::ui {
namespace {

// Returns true if the side was changed.
bool side_field(Ui& ui, world::Element& element) {
  const bool right = element.right;
  if (radio(ui, "Left", !right, "Turn left.")) element.right = false;
  (void)beside_last(ui, "Right");
  if (radio(ui, "Right", right, "Turn right.")) element.right = true;
  return element.right != right;
}

// Returns the value that the user selected or typed.
std::optional<double> parameter_field(Ui& ui, const world::ElementParameter& p, double value) {
  if (p.names.empty()) return number(ui, p.label, parameter_number(p, value), p.help);
  return combo(ui, p.label, choices_in(p.names), static_cast<int>(value), p.help);
}

using world::Equipment;
using world::EquipmentKind;

// The current one has a frame. `choose` gets the kind of the pressed one; nothing: plain track.
void equipment_buttons(Ui& ui, const CommonEquipment& now, bool enabled, std::string_view command,
                       const std::function<void(std::optional<EquipmentKind>)>& choose) {
  constexpr int kColumns = 3;
  const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const float width = std::floor((room - gap * (kColumns - 1)) / kColumns);
  int place = 0;
  const auto choice = [&](std::string_view label, std::string_view help, bool lit) {
    if (place++ % kColumns != 0) ImGui::SameLine();
    ImGui::BeginDisabled(!enabled);
    if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool pressed = ImGui::Button(std::string(label).c_str(), {sized(width), 0});
    if (lit) ImGui::PopStyleColor();
    ImGui::EndDisabled();
    if (lit)
      ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), packed(palette().text),
                                          ImGui::GetStyle().FrameRounding, 0,
                                          std::max(1.0f, std::floor(1.5f * ui.scale)));
    note_item(ui, fmt::format("Equipment/{}", label), "radio", help, enabled, lit ? "on" : "off");
    note_if_cut(ui, label);
    return pressed && enabled && !lit;
  };
  for (const world::EquipmentRow& row : world::kEquipmentKinds) {
    const LockedWidgets locked(ui, command);
    const auto kind = static_cast<EquipmentKind>(place);
    if (choice(row.label, row.help, now.equipment && now.equipment->kind == kind)) choose(kind);
  }
  const bool none = enabled && !now.mixed && !now.equipment;
  if (choice("None###Plain track", "Plain track.", none)) choose(std::nullopt);
}

// Shows the numbers of the kind. Returns the equipment with the number that the user changed.
std::optional<Equipment> equipment_rows(Ui& ui, Equipment now, std::string_view command) {
  const LockedWidgets locked(ui, command);
  bool changed = false;
  const auto field = [&](const char* label, float& value, const char* unit, double low, double high,
                         const char* tooltip) {
    const auto to = number(ui, label, {.value = value, .unit = unit, .low = low, .high = high}, tooltip);
    if (to) value = static_cast<float>(*to), changed = true;
  };
  field("Speed", now.speed, "m/s", 0, world::kMaxSpeed,
        "Target speed of a lift, launch or brake, and exit speed of a station.");
  field("Acceleration", now.acceleration, "m/s\u00B2", world::kMinAcceleration, world::kMaxAcceleration,
        "Largest acceleration or deceleration.");
  const world::EquipmentRow& row = base::row_of(now.kind);
  if (row.has_hysteresis)
    field("Hysteresis", now.hysteresis, "m/s", 0, world::kMaxSpeed,
          "The brake switches on above speed + hysteresis and off below speed - hysteresis.");
  if (row.has_wait) field("Wait", now.seconds, "s", 0, world::kMaxDwell, "Time that a train waits in the station.");
  return changed ? std::optional(now) : std::nullopt;
}

}  // namespace

Number parameter_number(const world::ElementParameter& p, double value) {
  const double range = p.high - p.low, step = range > 100 ? 0.1 : range > 20 ? 0.05 : 0.01;
  const char* const unit = p.unit == "deg" ? "\u00B0" : p.unit.data();  // as other panels show it
  return {.value = value, .unit = unit, .step = step, .low = p.low, .high = p.high, .largest = 1e300};
}

std::optional<std::string_view> element_fields(Ui& ui, world::Element& element, const ElementRows& rows) {
  const world::ElementRow& row = base::row_of(element.kind);
  std::optional<std::string_view> changed;
  const auto shown = [&](std::string_view name) { return !rows.shown || rows.shown(name); };
  const auto below = [&](std::string_view name) {
    if (rows.below) rows.below(name);
  };
  if (row.sided && shown("side")) {
    if (side_field(ui, element)) changed = "side";
    below("side");
  }
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const world::ElementParameter& p = row.parameters[i];
    if (!shown(p.name) || !world::counts(element, p)) continue;
    if (const auto to = parameter_field(ui, p, element.values[i])) element.values[i] = *to, changed = p.name;
    below(p.name);
  }
  return changed;
}

CommonEquipment equipped(const world::Document& document, const std::vector<world::Entity>& segments) {
  CommonEquipment found;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto* const one = document.entities.find<world::Equipment>(segments[i]);
    if (i == 0) found.equipment = one;
    const bool same = (one == nullptr) == (found.equipment == nullptr) && (!one || *one == *found.equipment);
    if (!same) return {true, nullptr};
  }
  return found;
}

void equipment_form(Ui& ui, const std::vector<world::Entity>& segments, std::string_view command,
                    const std::function<void(const std::optional<Equipment>& to)>& equip) {
  const CommonEquipment now = equipped(ui.session().document, segments);
  equipment_buttons(ui, now, !segments.empty(), command, [&](std::optional<EquipmentKind> kind) {
    if (!kind) return equip(std::nullopt);
    Equipment to = now.equipment ? *now.equipment : Equipment{};
    to.kind = *kind;
    equip(to);
  });
  if (!now.equipment) return;
  if (const auto changed = equipment_rows(ui, *now.equipment, command)) equip(changed);
}

}  // namespace coaster::ui
