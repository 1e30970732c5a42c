// Registered widgets, and which of them are visible and reachable, by the rules of ImGui's hovering: a script can click
// only what a person could click.
#include "ui/widgets/widget_list.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

namespace coaster::ui {
namespace {

// Returns the window that ImGui would find under a pixel; null over the viewport.
const ImGuiWindow* window_at(ImVec2 pixel) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  for (int i = g.Windows.Size - 1; i >= 0; --i) {
    const ImGuiWindow* window = g.Windows[i];
    if (!window->Active || window->Hidden || (window->Flags & ImGuiWindowFlags_NoMouseInputs) != 0) continue;
    if (window->OuterRectClipped.Contains(pixel)) return window;
  }
  return nullptr;
}

// Returns true if an open popup of another window captures the mouse. The menu bar keeps it, except under a modal
// popup.
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

constexpr std::string_view kId = "###";

// Returns `path` with the visible part of each label, or with its id.
std::string joined(std::string_view path, bool ids) {
  std::string result;
  while (true) {
    const std::size_t slash = path.find('/');
    const std::string_view label = path.substr(0, slash);
    const std::size_t mark = label.find(kId);
    result += ids && mark != std::string_view::npos ? label.substr(mark + kId.size()) : shown(label);
    if (slash == std::string_view::npos) return result;
    result += '/';
    path.remove_prefix(slash + 1);
  }
}

}  // namespace

std::string_view shown(std::string_view label) { return label.substr(0, label.find(kId)); }

std::string_view id_of(std::string_view label) {
  const std::size_t mark = label.find(kId);
  return mark == std::string_view::npos ? label : label.substr(mark + kId.size());
}

void WidgetList::clear() {
  widgets_.clear();
  windows_.clear();
}

void WidgetList::add(std::string_view path, std::string_view kind, glm::vec2 low, glm::vec2 high, bool enabled,
                     std::string value) {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  const glm::vec2 middle = (low + high) * 0.5f;
  Widget widget;
  const bool has_id = path.find(kId) != std::string_view::npos;
  widget.path = has_id ? joined(path, false) : std::string(path);
  if (has_id) widget.alias = joined(path, true);
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
    const bool mouse = (own->Flags & ImGuiWindowFlags_NoMouseInputs) == 0;  // else it covers only the view
    const bool other = mouse ? top == nullptr || top->RootWindow != own->RootWindow : top != nullptr;
    w.covered = behind_popup(own) || (w.visible && other);
  }
}

}  // namespace coaster::ui
