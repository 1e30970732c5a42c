// Functions of panels and keys for the proposals that complete a circuit ("ways home").
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// True if a track is open and has a segment.
bool completable(const world::Document& document);
// Returns the index of the proposal on display.
std::size_t shown_way_home(const world::Aids& aids, const sim::CircuitProposals& found);
// Shows the first proposal and hides the palette's element.
void show_ways_home(Ui& ui);
void toggle_ways_home(Ui& ui);
inline constexpr std::string_view kCircuitHelp =
    "Propose up to three closing sections, from the open end of the track to its first knot.";
void next_way_home(Ui& ui);
// Closes the track with the displayed proposal and ends the preview. Without one: a notice gives the reason.
void place_way_home(Ui& ui);

}  // namespace coaster::ui
