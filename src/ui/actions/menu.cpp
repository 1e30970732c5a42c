// The menu bar: the rows of the actions' table that name a menu.
#include <imgui.h>

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "ui/actions/actions.h"
#include "ui/context/rows.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

// Recently used files in the menu File.
void build_recent(Act& act) {
  const UserState* const kept = act.ui.state.kept;
  const bool any = kept != nullptr && !kept->settings.recent.empty();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetTextLineHeight());
  const bool open = ImGui::BeginMenu("Recent", any);
  if (open) {
    for (const std::string& file : kept->settings.recent) {
      const std::string label = name_among(file, kept->settings.recent, true);
      ImGui::PushID(file.c_str());
      const bool pressed = ImGui::MenuItem(label.c_str());
      note_item(act.ui, "File/Recent/" + label, "menu", file, true, "off");
      ImGui::PopID();
      if (pressed) act.ui.want = {Want::Kind::load, file};
    }
    ImGui::EndMenu();
  }
  note(act.ui, "File/Recent", "menu", open ? "" : "Recently used files.", any, open ? "open" : "closed", low, high);
}

void build_items(Act& act, std::string_view menu) {
  for (const Action& action : actions()) {
    if (action.menu != menu) continue;
    const bool enabled = action.enabled.holds(act);
    const bool checked = action.checked != nullptr && action.checked(act);
    const std::string label(action.name), keys = act.ui.keys.shown(action.name);
    const bool pressed = ImGui::MenuItem(label.c_str(), keys.empty() ? nullptr : keys.c_str(), checked, enabled);
    std::string help = with_keys(act.ui.keys, action.help, action.name);
    if (!enabled) help += fmt::format(" {}", action.enabled.otherwise);
    note_item(act.ui, fmt::format("{}/{}", menu, label), "menu", help, enabled, checked ? "on" : "off");
    if (pressed) action.run(act);
    if (action.name == "Open") build_recent(act);
  }
}

// At the right end: the file and the mark of unsaved changes.
void build_file_mark(Ui& ui) {
  const edit::Session& session = ui.session();
  const std::string holder = ui.state.kept != nullptr ? ui.state.kept->holder : "";
  const std::string name = session.file.path.empty() ? "no file" : session.file.path.filename().string();
  const bool unsaved = edit::dirty(ui.state.find);
  if (!unsaved && holder.empty()) return;
  const std::string words =
      fmt::format("{}{}{}", unsaved ? "\u25CF " : "", name, holder.empty() ? "" : " (in use elsewhere)");
  const float left = ImGui::GetWindowWidth() - text_size(words).x - std::floor(10 * ui.scale);
  if (left < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(left);
  tinted_line(words, palette().warning);
  note_item(ui, "Unsaved", "label",
            holder.empty() ? "The track differs from its file."
                           : fmt::format("This file is open in {}. Save under another name.", holder),
            true, words);
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
  build_file_mark(act.ui);
  act.ui.panel.clear();
  ImGui::EndMainMenuBar();
}

}  // namespace coaster::ui
