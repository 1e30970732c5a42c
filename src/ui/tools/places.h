// Places along the track that the program takes the user to: where a ride failed, where the track lacks clearance,
// where riders are jolted.
#pragma once

#include <optional>

#include "ui/context/ui.h"

namespace coaster::ui {

// Whether there are carts on a track.
bool rideable(const edit::Session& session);
// Whether the score card of the last ride is open.
bool card_shows(const edit::Session& session);
// Where the last ride or its challenge failed, m along the track; nothing where neither has a place.
std::optional<double> failed_place(const edit::Session& session);
// Selects the segment at `distance` (m along the track), points the orbit camera there, and closes the score card.
void show_place(Ui& ui, double distance);
// Selects the next conflict after the selected place and points the orbit camera there; no-op without conflicts.
void show_next_conflict(Ui& ui);
// The same for folds of the rails.
void show_next_fold(Ui& ui);
// Selects the knot and points the orbit camera there.
void show_knot(Ui& ui, world::Entity knot);
// Selects the knot with the largest jolt and points the orbit camera there; no-op without a jolt.
void show_worst_jolt(Ui& ui);

}  // namespace coaster::ui
