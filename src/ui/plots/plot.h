// A plot widget: lines, points and bars on linear or logarithmic axes with titles and units, a grid, a legend, marked
// levels, a read-out under the mouse and a cursor that can be dragged. Keeps no state between frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/plots/plot_axes.h"
#include "ui/widgets/widgets.h"

namespace coaster::ui {

enum class SeriesKind : std::uint8_t { line, points, line_and_points, bars };

// x and y have the same size and outlive the call. NaN, and negative numbers on a logarithmic axis, are gaps. Lines
// must be sorted by x unless the plot is `square`.
struct Series {
  std::string label;  // "": not in the legend
  std::span<const double> x, y;
  std::uint32_t colour = 0xFFFFFF;
  SeriesKind kind = SeriesKind::line;
  float width = 1.8f;                 // design px
  std::span<const double> high = {};  // upper edge of a band from y to high, as many as y; empty: a line
};

// A horizontal line at a value: a bound.
struct LevelLine {
  std::string label;
  double y = 0;
  std::uint32_t colour = 0xF2B84B;
};

// A highlighted point with an optional label.
struct Spot {
  double x = 0, y = 0;
  std::uint32_t colour = 0xFF8A1F;
  std::string label;
};

// A point that the mouse can drag.
struct Knob {
  double x = 0, y = 0;
  std::uint32_t colour = 0xFF8A1F;
  bool chosen = false;  // drawn larger, with an outline
  bool small = false;   // a handle of another knob
  std::string value;    // value of its widget, "Panel/plot/Knob 1"; empty: no widget
};

struct PlotAxis {
  // Drawn as "title (unit)", or as the one that is not empty, in the user's unit; all values are metric.
  std::string title = {}, unit = {};
  AxisScale scale = AxisScale::linear;
  std::optional<double> low = {}, high = {};  // nothing: from the data
  double least_span = 0;                      // of a linear axis from the data, so that no noise fills the plot
};

// The position of the mouse in a plot, in the units of its axes.
struct PlotDrag {
  double x = 0, y = 0;
};

// The mouse's action on a plot's knobs.
struct KnobTouch {
  std::optional<std::size_t> over, held;  // the knob under the mouse, and the one being dragged
  bool pressed = false;                   // `held` was pressed in this frame
  bool moved = false;                     // it has moved by more than a click does
  bool released = false;                  // `held` was released in this frame
  bool twice = false;                     // double click, at `at`
  PlotDrag at = {};                       // position of the mouse
};

struct Plot {
  PlotAxis x, y;
  std::span<const Series> series;
  PlotAxis right = {};  // linear, for right_series, at the right edge; its title is drawn unchanged
  std::span<const Series> right_series = {};
  std::span<const LevelLine> levels = {};
  std::span<const Spot> spots = {};
  std::optional<double> cursor = {};         // a vertical line here; dragging returns a new one
  std::optional<double> mark = {};           // a thin vertical line here
  std::optional<double>* pointed = nullptr;  // receives the x under the mouse, if any; then no read-out is drawn
  std::span<const Knob> knobs = {};          // drawn over everything else
  KnobTouch* touch = nullptr;                // not null: only the line of a cursor can be dragged
  bool square = false;                       // one metre has the same length on both axes: for shapes
  bool drags_point = false;                  // without a cursor: returns the position of the mouse during a drag
  std::string_view empty = "no data";        // shown when nothing can be drawn
  std::string value = {};                    // value of the widget; "": the cursor's x
  float width = 0, height = 0;               // px; 0: the available space
  float labels = 0;  // px, minimum width of the y axis' labels, so that plots in a column line up
};

// Draws at ImGui's cursor and registers "Panel/label" of kind "plot" over the area of the data, so that a click in its
// middle is a click at the middle of the x axis. During a drag returns the new x of the cursor, within the axis and
// rounded to a round step no longer than a pixel, if it differs from the present one; with `drags_point`, the position
// of the mouse.
std::optional<PlotDrag> plot(WidgetFrame& ui, std::string_view label, const Plot& plot, std::string_view tooltip);

}  // namespace coaster::ui
