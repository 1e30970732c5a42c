// The table of panels, and their columns. To add a panel: its function, and a row here.
#include "ui/panels/panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "world/aid_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {

void challenge_panel(Ui& ui);
bool challenge_shown(const Ui& ui);
void track_panel(Ui& ui);
void inspector_panel(Ui& ui);
void section_panel(Ui& ui);
void sections_panel(Ui& ui);
bool section_shown(const Ui& ui);
void shape_panel(Ui& ui);
void evaluation_panel(Ui& ui);
void ride_panel(Ui& ui);
void camera_panel(Ui& ui);
void operation_panel(Ui& ui);
void coaster_panel(Ui& ui);
void park_panel(Ui& ui);
void elements_panel(Ui& ui);
void statistics_panel(Ui& ui);
void history_panel(Ui& ui);
void goal_panel(Ui& ui);

std::span<const Panel> panels() {
  static constexpr std::array kPanels{
      Panel{"Track", PanelColumn::left, kTrack, "The whole track: name, file, size, and what you can add.",
            track_panel},
      Panel{"Inspector", PanelColumn::left, kSelection, "The selected knot, segment, section or train.",
            inspector_panel},
      Panel{"Section", PanelColumn::left, kSection, "The selected sections: name, parameters and equipment.",
            section_panel, true, section_shown},
      Panel{"Shape", PanelColumn::left, kSelection | kTrack,
            "Operations on the selected knots or on all knots, and snapping.", shape_panel, false},
      Panel{"Goal", PanelColumn::left, kSelection | kSection,
            "Let the program change numbers of what is selected until the ride does what you want.", goal_panel, false},
      Panel{"Elements", PanelColumn::left, kElement,
            "Straights, curves, helices, hills and inversions to place at the open end of the track.", elements_panel},
      Panel{"Operation", PanelColumn::left, kSelection | kTrack, "Equipment, train and losses.", operation_panel},
      Panel{"Coaster", PanelColumn::left, kTrack, "The kind of coaster and its colours.", coaster_panel},
      Panel{"Park", PanelColumn::left, kTrack, "The land around the coaster, and brushes that shape it.", park_panel,
            false},
      Panel{"Challenge", PanelColumn::right, kWhileBuilding, "The current challenge: goals, limits and medals.",
            challenge_panel, true, challenge_shown},
      Panel{"Evaluation", PanelColumn::right, kLaboratory,
            "How curves become polylines: method, resolution, accuracy and speed.", evaluation_panel},
      Panel{"Ride", PanelColumn::right, kLaboratory, "Run the trains and read their speed, height and g.", ride_panel},
      Panel{"Camera", PanelColumn::right, kLaboratory, "Camera modes and camera feel.", camera_panel},
      Panel{"Statistics", PanelColumn::right, kLaboratory, "Cost of the last frame.", statistics_panel},
      Panel{"Sections", PanelColumn::right, 0, "Every section: length, heights, speeds and g.", sections_panel, false},
      Panel{"History", PanelColumn::right, kTrack, "Undo and redo steps. Click a step to go to it.", history_panel,
            false},
  };
  return kPanels;
}

namespace {

unsigned occasions(const Ui& ui) {
  const edit::Session& session = ui.session();
  if (session.settings.panels->workspace != world::Workspace::build) return kLaboratory;
  const bool selected = session.settings.selected != world::kNone,
             chosen = session.settings.aids->show_element || session.settings.aids->circuit > 0;
  if (!selected && !chosen) return kTrack;
  return (!selected ? 0u : section_shown(ui) ? kSection : kSelection) | (chosen ? kElement : 0u);
}

bool belongs(const Ui& ui, const Panel& panel, PanelColumn column) {
  if (panel.shown != nullptr && !panel.shown(ui)) return false;
  if (ui.session().settings.panels->workspace == world::Workspace::all) return panel.column == column;
  return (panel.shows & occasions(ui)) != 0;
}

// Goes to the top when the column shows other panels, or another element, than in the frame before.
void scroll_to_what_is_new(const Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  const bool preview = settings.aids->show_element;
  const int now = static_cast<int>(occasions(ui)) * 1000 + (settings.aids->circuit > 0 ? 500 : 0) +
                  (preview ? 1 + static_cast<int>(settings.element.kind) : 0);
  int& before = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("##shown"), now);
  if (std::exchange(before, now) != now) ImGui::SetScrollY(0);
}

// Returns true while the panel is open.
bool header(WidgetFrame& ui, std::string_view name, std::string_view tooltip, bool at_first, bool open_now) {
  if (ImGui::GetCursorPosY() > 2 * ImGui::GetStyle().WindowPadding.y)
    ImGui::Dummy(sized({0, std::floor(3 * ui.scale)}));  // not before the first one
  if (open_now) ImGui::SetNextItemOpen(true);
  const bool open = ImGui::CollapsingHeader(std::string(name).c_str(), at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  note_item(ui, "", "header", tooltip, true, open ? "open" : "closed");
  return open;
}

// Scrolls down to what was built last, from `top` (px), as far as that stays in sight.
void bring_into_sight(float top) {
  const float low = ImGui::GetWindowPos().y, high = low + ImGui::GetWindowHeight();
  const float by = std::min(ImGui::GetCursorScreenPos().y - high, top - low);
  if (by > 0) ImGui::SetScrollY(ImGui::GetScrollY() + by);
}

}  // namespace

void build_column(Ui& ui, PanelColumn column, const view::Viewport& area) {
  const WindowArea look{.id = column == PanelColumn::left ? "##left" : "##right",
                        .panel = "",
                        .padding = {},
                        .more = ImGuiWindowFlags_None};
  build_area(ui, area, look, [&] {
    scroll_to_what_is_new(ui);
    // A new lesson opens the panel of its widget and brings the widget into sight.
    const auto leads_to = [&](const Panel& panel) {
      return ui.lesson_begins && ui.state.lesson->widget.starts_with(std::string(panel.name) + "/");
    };
    if (ui.lesson_begins && ui.lesson_widget && !ui.lesson_widget->visible && ui.lesson_widget->x >= area.x &&
        ui.lesson_widget->x < area.x + area.width)
      ImGui::SetScrollY(std::max(0.0f, ImGui::GetScrollY() + ui.lesson_widget->y - (area.y + 0.4f * area.height)));
    const auto build = [&](const Panel& panel) {
      if (!belongs(ui, panel, column)) return;
      ui.panel = panel.name;
      ImGui::PushID(panel.name.data(), panel.name.data() + panel.name.size());
      const bool asked = ui.inputs.panel_to_open == panel.name;
      if (asked) ui.inputs.panel_to_open = {};
      if (header(ui, panel.name, panel.help, panel.open, asked || leads_to(panel))) {
        const bool opened = asked || ImGui::IsItemToggledOpen();
        const float top = ImGui::GetItemRectMin().y;
        panel.build(ui);
        if (opened) bring_into_sight(top);
      }
      ImGui::PopID();
    };
    // In Build a selected element has priority over the rest of the selection, and a challenge over the track.
    const bool building = ui.session().settings.panels->workspace == world::Workspace::build;
    const auto is_first = [&](const Panel& panel) {
      const bool challenge = panel.build == challenge_panel && occasions(ui) == kTrack;
      return building && (panel.shows == kElement || challenge);
    };
    for (const Panel& panel : panels())
      if (is_first(panel)) build(panel);
    for (const Panel& panel : panels())
      if (!is_first(panel)) build(panel);
  });
}

}  // namespace coaster::ui
