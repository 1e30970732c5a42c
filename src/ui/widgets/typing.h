// Text that is typed into a field.
#pragma once

#include <string>

#include "ui/widgets/widgets.h"

namespace coaster::ui {

enum class Typing { no, open, complete };

// Shows an InputText whose text is in ui.entry during editing. With `begin` it takes the keyboard at once, as if
// clicked. Editing completes on Enter, or when it loses focus with the text changed; Tab moves to the panel's next
// number. Escape discards the text.
Typing typed(WidgetFrame& ui, const char* key, const std::string& initial, bool begin);

// True if a wish opens the field for editing: it has the keyboard, or gets it in the next frame.
bool is_wished(WidgetFrame& ui, ImGuiID id, bool enabled);

}  // namespace coaster::ui
