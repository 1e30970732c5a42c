// Text that is typed into a field.
#pragma once

#include <string>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

enum class Typing { no, open, complete };

// An InputText whose text is in ui.entry while it is typed. With `begin` it takes the keyboard at once, as if clicked.
// Complete on Enter, or when it loses focus with the text changed; Tab goes on to the panel's next number. Escape
// discards the text.
Typing typed(WidgetFrame& ui, const char* key, const std::string& initial, bool begin);

// Returns whether a wish shows the field to be typed in: it has the keyboard, or gets it with the next frame.
bool is_wished(WidgetFrame& ui, ImGuiID id, bool enabled);

}  // namespace coaster::ui
