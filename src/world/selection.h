// The selected knots or sections, for pictures, panels and commands.
#pragma once

#include <vector>

#include "world/document.h"
#include "world/sections.h"
#include "world/settings.h"

namespace coaster::world {

// Returns the selected knots, the active one last; empty if a segment, a train or nothing is selected. All are alive.
std::vector<Entity> selected_knots(const Document& document, const Settings& settings);
// Returns the selected sections in the same way.
std::vector<Entity> selected_sections(const Document& document, const Settings& settings);
// Returns the runs of the selected sections, in track order.
std::vector<SectionRun> selected_runs(const Document& document, const Settings& settings);
bool is_selected(const Settings& settings, Entity e);
// Returns the mean position of knots, at least one, m.
glm::vec3 middle_of(const Document& document, const std::vector<Entity>& knots);

// Returns those knots of the track that are in `chosen` (any order, duplicates and other entities allowed), each once,
// in track order.
std::vector<Entity> in_track_order(const Document& document, const std::vector<Entity>& chosen);

// Removes deleted entities from the selection; if the active one is gone, another selected one becomes active.
void drop_dead(const Document& document, Settings& settings);

}  // namespace coaster::world
