#include "ui/widgets/button_rows.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/theme.h"

namespace coaster::ui {

bool ButtonRows::operator()(std::string_view label, std::string_view tooltip, bool enabled) {
  if (placed == 0) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x, room = ImGui::GetContentRegionAvail().x + gap;
    const float least = text_size(widest).x + style.FramePadding.x;  // it may take the padding at the right
    columns = std::clamp(static_cast<int>(room / (least + gap)), 1, columns);
    width = std::floor(room / static_cast<float>(columns) - gap);
  }
  if (placed++ % columns != 0) ImGui::SameLine();
  return button(ui, label, tooltip, enabled, width);
}

}  // namespace coaster::ui
