// The menu bar: the rows of the actions' table that name a menu.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "edit/commands/commands_session.h"
#include "ui/actions/actions_detail.h"
#include "ui/context/query_widgets.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace {

// The recently used files in the menu File.
void build_recent(ActionContext& act) {
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
      if (pressed) act.ui.replace(edit::LoadTrack{file});
    }
    ImGui::EndMenu();
  }
  note(act.ui, "File/Recent", "menu",
       open  ? ""
       : any ? "Recently used files."
             : "No files have been used yet.",
       any, open ? "open" : "closed", low, high);
}

void build_items(ActionContext& act, std::string_view menu);

// A menu of the bar, or one inside another: its title, and its items while it is open.
void build_one(ActionContext& act, std::string_view menu) {
  const std::size_t slash = menu.rfind('/');
  const bool inner = slash != std::string_view::npos;
  const std::string title(inner ? menu.substr(slash + 1) : menu);
  // Once the menu is open, ImGui's last item is not its title, so the position of the title is read before.
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = inner ? ImGui::GetContentRegionAvail().x : text_size(title).x + ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 high(low.x + width, low.y + (inner ? ImGui::GetTextLineHeight() : ImGui::GetFrameHeight()));
  const bool open = ImGui::BeginMenu(title.c_str());
  if (open) {
    build_items(act, menu);
    ImGui::EndMenu();
  }
  note(act.ui, menu, "menu", open ? "" : "Open the menu.", true, open ? "open" : "closed", low, high);
}

void build_item(ActionContext& act, const Action& action) {
  const bool enabled = action.enabled.holds(act);
  const bool checked = action.checked != nullptr && action.checked(act);
  const std::string label(action.name), keys = act.ui.keys.shown(action.name);
  const bool pressed = ImGui::MenuItem(label.c_str(), keys.empty() ? nullptr : keys.c_str(), checked, enabled);
  std::string help = with_keys(act.ui.keys, action.help, action.name);
  if (!enabled) help += fmt::format(" {}", action.enabled.otherwise);
  note_item(act.ui, fmt::format("{}/{}", action.menu, label), "menu", help, enabled, checked ? "on" : "off");
  if (pressed) action.run(act);
}

// Each menu inside takes the place of its first item.
void build_items(ActionContext& act, std::string_view menu) {
  std::vector<std::string_view> inside;
  for (const Action& action : actions()) {
    if (action.menu == menu) {
      build_item(act, action);
      if (action.name == "Open") build_recent(act);
    } else if (action.menu.starts_with(menu) && std::find(inside.begin(), inside.end(), action.menu) == inside.end()) {
      inside.push_back(action.menu);
      build_one(act, action.menu);
    }
  }
}

void build_menus(ActionContext& act) {
  constexpr const char* kMenus[] = {"File", "Edit", "View", "Ride", "Window"};
  constexpr int kCount = std::size(kMenus);
  const int popups = open_popups();
  int open = -1;
  for (int i = 0; i < kCount; ++i) {
    if (ImGui::IsPopupOpen(kMenus[i])) open = i;
    build_one(act, kMenus[i]);
  }
  const int step = open < 0 ? 0 : take_menu_step(popups);
  if (step != 0) ImGui::OpenPopup(kMenus[(open + step + kCount) % kCount]);
}

struct Tab {
  world::Workspace workspace;
  std::string_view action;
};
constexpr Tab kTabs[] = {{world::Workspace::build, "Build workspace"},
                         {world::Workspace::ride, "Ride workspace"},
                         {world::Workspace::laboratory, "Laboratory workspace"}};

// A tab for each workspace except `all`, which is in the menu Window; the selected one is underlined.
void build_tabs(Ui& ui) {
  const world::Workspace now = ui.session().settings.panels->workspace;
  const float pad = std::floor(10 * ui.scale), y = ImGui::GetCursorPosY();
  const TabBar bar{.height = ImGui::GetWindowHeight(), .pad = pad, .rgb = palette().accent};
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + pad);
  for (const auto& [workspace, action] : kTabs) {
    const base::NameRow& row = base::row_of(workspace);
    const std::string help = with_keys(ui.keys, row.help, action);
    if (tab(ui, fmt::format("Workspace/{}", row.label), help, workspace == now, bar)) choose_workspace(ui, workspace);
  }
  ImGui::SetCursorPosY(y);
}

// Shows the file and the mark of unsaved changes at the right end.
void build_file_mark(Ui& ui) {
  const edit::Session& session = ui.session();
  const std::string holder = ui.state.kept != nullptr ? ui.state.kept->holder : "";
  const std::string name = session.file.path.empty() ? "no file" : session.file.path.filename().string();
  const bool unsaved = edit::dirty(ui.find);
  if (!unsaved && holder.empty()) return;
  const std::string mark = unsaved ? "\u25CF " : "", use = holder.empty() ? "" : " (in use elsewhere)";
  const float right = ImGui::GetWindowWidth() - std::floor(10 * ui.scale);
  const float room = right - ImGui::GetCursorPosX() - text_size(mark + use).x;
  const std::string words = mark + shortened(name, room) + use;
  const float left = right - text_size(words).x;
  if (left < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(left);
  tinted_line(words, palette().warning);
  note_item(ui, "Unsaved", "label",
            holder.empty() ? "The track differs from its file."
                           : fmt::format("This file is open in {}. Save under another name.", holder),
            true, words);
}

}  // namespace

void build_menu(ActionContext& act) {
  if (!ImGui::BeginMainMenuBar()) return;
  act.ui.panel = "Menu";
  build_menus(act);
  build_tabs(act.ui);
  build_file_mark(act.ui);
  act.ui.panel.clear();
  ImGui::EndMainMenuBar();
}

}  // namespace coaster::ui
