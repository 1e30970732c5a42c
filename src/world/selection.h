// Which knots are selected: one question, one answer, for pictures, panels and commands.
#pragma once

#include <vector>

#include "world/document.h"
#include "world/settings.h"

namespace coaster::world {

// The selected knots, the active one last; empty when a segment, a cart or nothing is selected. All are alive.
std::vector<Entity> selected_knots(const Document& document, const Settings& settings);
bool is_selected(const Settings& settings, Entity e);

// Those among `chosen` (any order, repeats and strangers allowed), each once, in the order of the track.
std::vector<Entity> in_track_order(const Document& document, const std::vector<Entity>& chosen);

// Forgets what is not alive any more; where the active knot is gone another selected one takes its place.
void drop_dead(const Document& document, Settings& settings);

}  // namespace coaster::world
