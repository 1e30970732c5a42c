// The widgets of a frame and their positions, for scripts and lessons.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "query/widget.h"

struct ImGuiWindow;

namespace coaster::ui {

// Returns the visible part of a label: a label "Shown###Id" shows its first part and has the second as id; others are
// their own id.
std::string_view shown(std::string_view label);
std::string_view id_of(std::string_view label);

using query::Widget;

// The widgets of a frame, in drawing order.
class WidgetList {
 public:
  void clear();
  // Adds a widget over [low, high) of the window being built; `path` is made of labels. The window's clip rectangle
  // decides whether it is visible.
  void add(std::string_view path, std::string_view kind, glm::vec2 low, glm::vec2 high, bool enabled,
           std::string value);
  // Of the widget added last: its label does not fit.
  void mark_cut() { widgets_.back().cut = true; }
  // After ImGui::Render(): finds the covered ones.
  void finish();
  const std::vector<Widget>& widgets() const { return widgets_; }

 private:
  std::vector<Widget> widgets_;
  std::vector<const ImGuiWindow*> windows_;
};

}  // namespace coaster::ui
