// What the view shows: before it is placed, the element of the palette and proposals that close the track; and
// positions along the track: where a ride failed, where the track lacks clearance, where riders are jolted.
#pragma once

#include <optional>
#include <span>

#include "sim/shape/folds.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// Shows the preview of an element with the parameters that it had last. In Build a first straight becomes a station,
// and a climb becomes a lift while nothing else drives trains; the user can choose otherwise before placing it.
void choose_element(Ui& ui, world::ElementKind kind);
// Places the element of the preview. In Build the next one like it is plain track, not a second station.
void place_shown_element(Ui& ui);

// True if a track is open and has a segment.
bool completable(const world::Document& document);
// Returns the index of the proposal on display.
std::size_t shown_proposal(const world::EditingAids& aids, const sim::CircuitProposals& found);
// Shows the first proposal and hides the palette's element.
void show_proposals(Ui& ui);
void toggle_proposals(Ui& ui);
inline constexpr std::string_view kCircuitHelp =
    "Propose up to three closing sections, from the open end of the track to its first knot.";
void next_proposal(Ui& ui);
// Closes the track with the displayed proposal and ends the preview. Without one: a notice gives the reason.
void place_proposal(Ui& ui);

// Returns the knots of the displayed proposal, or else of the palette's preview, m; empty if neither shows.
std::vector<glm::vec3> preview_points(const Ui& ui);

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
