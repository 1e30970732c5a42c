// The card at the end of a ride: the numbers that earned it, the challenge's verdict, and why it failed.
#pragma once

#include "ui/widgets/widgets.h"

namespace coaster::ui {

// In the viewport's upper right corner, while there is a result to show and room for it.
void draw_score_card(Ui& ui, const view::Viewport& scene);

bool card_shows(const edit::Session& session);
// Where the last ride failed, or its challenge did, m along the track; nothing when neither has a place.
std::optional<double> failed_place(const edit::Session& session);
// Selects the segment there and looks at it from the orbit camera; the card, which may lie over it, is closed.
void show_place(Ui& ui, double distance);

}  // namespace coaster::ui
