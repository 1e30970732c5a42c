// The force graph of Build while a force section is selected: drag, insert and delete its keys.
#pragma once

#include <optional>

#include "platform/events.h"
#include "ui/lab/ride_plots.h"

namespace coaster::ui {

// Returns the force section that the graph edits: the only selected one, in Build, with the graph open; kNone for none.
world::Entity edited_forces(const Ui& ui);

// Shows the section's channels as tabs in the graph's bar.
void force_channels(Ui& ui, world::Entity section, float bar);

// Plots the section's part of the ride: keys and target curve of the selected channel over the actual values, with the
// limits. Dragging a key or a handle of the selected key is one undo step and snaps (Ctrl: not); a double click inserts
// a key.
void force_plot(Ui& ui, world::Entity section, const std::optional<RidePlots>& ride);

// Handles the keyboard for editing forces and returns the other events. Tab and Shift+Tab select a key, and open
// the graph if it is folded; arrows move the key by a step (Ctrl: a tenth), Insert adds one behind it, Delete removes
// it, Escape deselects it, Ctrl+C and Ctrl+V copy and paste.
platform::Events without_force_keys(Ui& ui, const platform::Events& events);

}  // namespace coaster::ui
