// Shared state of the drawing steps of a plot: the axes and their positions on the screen. Private to plot*.cpp.
#pragma once

#include <imgui.h>

#include "ui/plots/plot.h"

namespace coaster::ui {

struct PlotArea {
  AxisRange x, y, right;
  base::ShownUnit x_unit, y_unit;  // units of the axes
  Ticks x_ticks, y_ticks;          // round in these units
  Ticks right_ticks;               // none without series on the right axis
  ImVec2 low, high;                // px, corners of the data area
  float scale = 1;                 // px per design px
  float text_px = 13;              // height of a line of small text
  bool pretty = true;              // the font has superscripts
  bool title_beside = false;       // the x axis' title is in the row of its ticks

  // Returns the pixel of a point; NaN for values that cannot be drawn.
  ImVec2 at(double x_value, double y_value) const;
};

std::string axis_title(const PlotAxis& axis,
                       const base::ShownUnit& unit);  // returns "title (unit)", or the one that is not empty
AxisRange scaled(const AxisRange& axis, double factor);
void draw_grid(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 outer_low);
void draw_series(ImDrawList& list, const PlotArea& area, const Series& series);
void draw_levels_and_spots(ImDrawList& list, const PlotArea& area, const Plot& plot);
void draw_legend(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 outer_low);
// Draws the knobs and registers those with a value; the plot's last item is its area.
void draw_knobs(WidgetFrame& ui, ImDrawList& list, const PlotArea& area, const Plot& plot, std::string_view label);
// Fills plot.touch. Returns whether the mouse holds the cursor.
struct AreaState {
  unsigned id = 0;
  bool hovered = false, held = false, activated = false, deactivated = false;
};
bool touch_knobs(const PlotArea& area, const Plot& plot, const AreaState& state);
PlotDrag place_under(const PlotArea& area, ImVec2 pixel);
void draw_readout(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 mouse);

}  // namespace coaster::ui
