#include "ui/widgets/typing.h"

#include <imgui_internal.h>

namespace coaster::ui {

Typing typed(WidgetFrame& ui, const char* key, const std::string& initial, bool begin) {
  const ImGuiID id = ImGui::GetID(key);
  Entry& entry = ui.entry;
  const bool mine = entry.id == id;
  std::array<char, 1024> shown;
  if (!mine) shown[initial.copy(shown.data(), shown.size() - 1)] = 0;
  std::array<char, 1024>& buffer = mine ? entry.text : shown;
  ImGuiIO& io = ImGui::GetIO();
  const bool clicked = io.MouseClicked[0];
  // ImGui gives the keyboard to a field that is clicked; SetKeyboardFocusHere takes some frames.
  io.MouseClicked[0] = clicked || begin;
  const bool enter = ImGui::InputText(key, buffer.data(), buffer.size(),
                                      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  io.MouseClicked[0] = clicked;
  const bool active = ImGui::IsItemActive();
  if (!mine) {
    if (!active) return Typing::no;
    entry.id = id;
    entry.text = entry.initial = shown;
    return Typing::open;
  }
  const bool elsewhere = active && !ImGui::IsItemHovered() && (clicked || io.MouseClicked[1] || io.MouseClicked[2]);
  const bool tab = active && ImGui::IsKeyPressed(ImGuiKey_Tab);
  if (active && !enter && !elsewhere && !tab) return Typing::open;
  if (elsewhere || tab) ImGui::ClearActiveID();
  if (tab && ui.wish) ui.wish->panel = ui.panel;
  entry.id = 0;
  const bool escaped = ImGui::IsKeyPressed(ImGuiKey_Escape);
  return !escaped && entry.text != entry.initial ? Typing::complete : Typing::no;
}

bool is_wished(WidgetFrame& ui, ImGuiID id, bool enabled) {
  constexpr int kFrames = 3;
  if (!ui.wish || !enabled) return false;
  FieldWish& wish = *ui.wish;
  if (!wish.panel.empty() && wish.panel == ui.panel) {
    wish = {"", id, kFrames};
    ImGuiContext& g = *ImGui::GetCurrentContext();
    g.NavNextActivateId = id;  // takes effect with the next frame
    g.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
    ImGui::SetScrollHereY(0.5f);
  }
  if (wish.id != id) return false;
  if (ui.entry.id == id || --wish.frames < 0) wish.id = 0;
  return wish.id == id;
}

}  // namespace coaster::ui
