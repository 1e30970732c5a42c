// Which widgets a frame had, and which of them can be seen and reached. The same rules as ImGui's own hovering, so that
// a script that follows them clicks what a person could click.
#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

#include "ui/widgets/widgets.h"

namespace coaster::ui {
namespace {

// The window that ImGui would find under a pixel; null over the viewport.
const ImGuiWindow* window_at(ImVec2 pixel) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  for (int i = g.Windows.Size - 1; i >= 0; --i) {
    const ImGuiWindow* window = g.Windows[i];
    if (!window->Active || window->Hidden || (window->Flags & ImGuiWindowFlags_NoMouseInputs) != 0) continue;
    if (window->OuterRectClipped.Contains(pixel)) return window;
  }
  return nullptr;
}

// Whether an open popup other than the window's own takes the mouse away from it; the menu bar keeps it, but for a
// modal one.
bool behind_popup(const ImGuiWindow* window) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  bool any = false;
  for (const ImGuiPopupData& popup : g.OpenPopupStack) {
    if (popup.Window == nullptr || !popup.Window->Active) continue;
    if (popup.Window == window->RootWindow) return false;
    any = any || (popup.Window->Flags & ImGuiWindowFlags_Modal) != 0 || (window->Flags & ImGuiWindowFlags_MenuBar) == 0;
  }
  return any;
}

}  // namespace

void WidgetList::clear() {
  widgets_.clear();
  windows_.clear();
}

void WidgetList::add(std::string path, std::string_view kind, glm::vec2 low, glm::vec2 high, bool enabled,
                     std::string value) {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  const glm::vec2 middle = (low + high) * 0.5f;
  Widget widget;
  widget.path = std::move(path);
  widget.kind = kind;
  widget.x = low.x;
  widget.y = low.y;
  widget.width = high.x - low.x;
  widget.height = high.y - low.y;
  widget.visible = !window->SkipItems && window->ClipRect.Contains(ImVec2(middle.x, middle.y));
  widget.enabled = enabled;
  widget.value = std::move(value);
  widgets_.push_back(std::move(widget));
  windows_.push_back(window);
}

void WidgetList::finish() {
  for (std::size_t i = 0; i < widgets_.size(); ++i) {
    Widget& w = widgets_[i];
    const ImGuiWindow* top = window_at({w.x + w.width * 0.5f, w.y + w.height * 0.5f});
    const ImGuiWindow* own = windows_[i];
    w.covered = behind_popup(own) || (w.visible && (top == nullptr || top->RootWindow != own->RootWindow));
  }
}

}  // namespace coaster::ui
