// The force graph of Build while a force section is selected: its keys, to be dragged, inserted and deleted.
#pragma once

#include <optional>

#include "platform/events.h"
#include "ui/lab/ride_plots.h"

namespace coaster::ui {

// The force section that the graph edits: selected alone in Build, with the graph open; kNone for none.
world::Entity edited_forces(const Ui& ui);

// The channels as buttons, in the graph's bar.
void force_channels(Ui& ui, float bar);

// The plot of the section's stretch of the ride: the chosen channel's keys and asked curve over what is felt, with the
// limits. A drag of a key or of a handle of the chosen key is one undo step and snaps (Ctrl: not), a double click
// inserts a key.
void force_plot(Ui& ui, world::Entity section, const std::optional<RidePlots>& ride);

// Works the keys of the keyboard that edit forces, and returns the other events: Tab and Shift+Tab choose a key, arrows
// move it by a step (Ctrl: a tenth), Insert adds one behind it, Delete removes it, Escape leaves it; also force_clip.h.
platform::Events without_force_keys(Ui& ui, const platform::Events& events);

}  // namespace coaster::ui
