// The menu bar: the rows of the actions' table that name a menu.
#include <imgui.h>

#include <string>

#include "ui/actions.h"
#include "ui/row.h"

namespace coaster::ui {
namespace {

void build_items(Act& act, std::string_view menu) {
  for (const Action& action : actions()) {
    if (action.menu != menu) continue;
    const bool enabled = action.enabled(act);
    const bool checked = action.checked != nullptr && action.checked(act);
    const std::string label(action.name), keys(action.keys);
    const bool pressed = ImGui::MenuItem(label.c_str(), keys.empty() ? nullptr : keys.c_str(), checked, enabled);
    note_item(act.ui, std::string(menu) + "/" + label, "menu", action.help, enabled, checked ? "on" : "off");
    if (pressed) action.run(act);
  }
}

}  // namespace

void build_menu(Act& act) {
  if (!ImGui::BeginMainMenuBar()) return;
  act.ui.panel = "Menu";
  for (const std::string_view menu : {"File", "Edit", "View", "Ride"}) {
    // Once the menu is open, ImGui's last item is not its title: the title's place has to be known before.
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + text_size(menu).x + ImGui::GetStyle().ItemSpacing.x, low.y + ImGui::GetFrameHeight());
    const bool open = ImGui::BeginMenu(std::string(menu).c_str());
    if (open) {
      build_items(act, menu);
      ImGui::EndMenu();
    }
    note(act.ui, menu, "menu", open ? "" : "Open the menu.", true, open ? "open" : "closed", low, high);
  }
  act.ui.panel.clear();
  ImGui::EndMainMenuBar();
}

}  // namespace coaster::ui
