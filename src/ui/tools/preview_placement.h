// What the view shows before it is placed: the element of the palette, and proposals that close the track.
#pragma once

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

}  // namespace coaster::ui
