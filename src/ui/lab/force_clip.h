// Copies and pastes keys of the force graph. Private to force_keys.cpp.
#pragma once

#include "platform/events.h"
#include "ui/context/ui.h"
#include "ui/lab/cache.h"

namespace coaster::ui {

// Handles a key press. Ctrl+C copies the selected key, Ctrl+Shift+C all keys of the channel. Ctrl+V pastes behind the
// selected key, half-way to the next one, or without one at the section's start; if sections were copied, it pastes
// those. Returns true if the press was one of these.
bool copy_or_paste(Ui& ui, ForceKeys& state, const world::ForceProgram& program, const platform::KeyPress& press);

}  // namespace coaster::ui
