// Positions along the track that the program shows to the user: where a ride failed, where the track lacks clearance,
// where riders are jolted.
#pragma once

#include <optional>
#include <span>

#include "sim/shape/folds.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// True if a track has carts.
bool rideable(const edit::Session& session);
// True if append mode can be switched: on where the track is open, off anywhere.
bool append_mode_switches(const edit::Session& session);
// True if the score card of the last ride is open.
bool card_shows(const edit::Session& session);
// Returns where the last ride or its challenge failed, m along the track; nothing if the failure has no position.
std::optional<double> failed_place(const edit::Session& session);
// Returns the section on which the last ride stopped below a top; nothing for a free section, for equipment there, and
// in a challenge.
std::optional<world::Entity> climb_without_lift(const edit::Session& session);
// Selects the segment at `distance` (m along the track), points the orbit camera there, and closes the score card.
void show_place(Ui& ui, double distance);
// Selects the next conflict after the selected place and points the orbit camera there; no-op without conflicts.
void show_next_conflict(Ui& ui);
// Selects the next of the folds or tight bends of the track in the same way.
void show_next(Ui& ui, std::span<const sim::Fold> found);
// Selects the knot and points the orbit camera there.
void show_knot(Ui& ui, world::Entity knot);
// Selects the knot with the largest jolt and points the orbit camera there; no-op without a jolt.
void show_worst_jolt(Ui& ui);

}  // namespace coaster::ui
