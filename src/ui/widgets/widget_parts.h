// Parts that widgets are made of: paths, text sizes, registration and rows.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

std::string path_of(const WidgetFrame& ui, std::string_view label);
std::string hidden(std::string_view label);  // "##label": an id without a drawn label
ImVec2 text_size(std::string_view text);

// Registers a rectangle of the current window as a widget, with its tooltip.
void note(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
          std::string value, ImVec2 low, ImVec2 high);

// Draws the label and sets the next item's place and width: beside the label, or below it when the label is long for
// the row or the control needs more than the `needed` px that are left there.
void begin_row(WidgetFrame& ui, std::string_view label, float needed = 0);

}  // namespace coaster::ui
