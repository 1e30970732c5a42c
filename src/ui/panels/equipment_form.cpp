#include "ui/panels/equipment_form.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/widgets/theme.h"
#include "world/equipment_rows.h"

namespace coaster::ui {

Equipped equipped(const world::Document& document, const std::vector<world::Entity>& segments) {
  Equipped found;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto* const one = document.entities.find<world::Equipment>(segments[i]);
    if (i == 0) found.equipment = one;
    const bool same = (one == nullptr) == (found.equipment == nullptr) && (!one || *one == *found.equipment);
    if (!same) return {true, nullptr};
  }
  return found;
}

namespace {

using world::Equipment;
using world::EquipmentKind;

// The current one has a frame. `choose` gets the kind of the pressed one; nothing: plain track.
void equipment_buttons(Ui& ui, const Equipped& now, bool enabled, std::string_view command,
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
  for (const base::NameRow& row : world::kEquipmentKinds) {
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
  if (now.kind == EquipmentKind::brake || now.kind == EquipmentKind::block)
    field("Hysteresis", now.hysteresis, "m/s", 0, world::kMaxSpeed,
          "The brake switches on above speed + hysteresis and off below speed - hysteresis.");
  if (now.kind == EquipmentKind::station)
    field("Wait", now.seconds, "s", 0, world::kMaxDwell, "Time that a train waits in the station.");
  return changed ? std::optional(now) : std::nullopt;
}

}  // namespace

void equipment_form(Ui& ui, const std::vector<world::Entity>& segments, std::string_view command,
                    const std::function<void(const std::optional<Equipment>& to)>& equip) {
  const Equipped now = equipped(ui.session().document, segments);
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
