// Medals, ticks and crosses, drawn as simple shapes.
#pragma once

#include <imgui.h>

#include <string_view>

namespace coaster::ui {

// Draws a medal on its ribbon within a square of `size` px at `low`: 1 bronze, 2 silver, 3 gold. A medal not earned is
// an outline.
void draw_medal(ImDrawList& list, ImVec2 low, float size, int medal, bool earned);
// Draws a tick in a filled disc, or a cross in a ring, within a square of `size` px.
void draw_mark(ImDrawList& list, ImVec2 low, float size, bool good);

std::string_view medal_title(int medal);  // returns "Gold"; "No medal" for 0

}  // namespace coaster::ui
