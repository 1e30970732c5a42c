// Shared parts of the laboratory's pages: the probe, the layout, cached studies and small widgets.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "ui/context/ui.h"
#include "ui/plots/plot.h"

namespace coaster::ui {

// The segment and position that the pages show: the selected segment; else the segment that starts at the selected knot
// (at the last knot: ends there) or that the selected cart is on; else the first one. Nothing on a track without
// segments.
struct Probe {
  world::Entity segment;
  world::Name name;
  const sim::SegmentShape* shape = nullptr;
  double t = 0.5;
};
// Returns the probe. Without one, draws a line that says how to create a segment.
std::optional<Probe> need_probe(Ui& ui);
// Moves the probe to t, clamped to [0,1], by selecting the segment.
void move_probe(Ui& ui, const Probe& probe, double t);
// Draws a slider labelled "t", and a plot over t whose cursor is the probe.
void probe_slider(Ui& ui, const Probe& probe);
void plot_over_t(Ui& ui, const Probe& probe, std::string_view label, Plot picture, std::string_view tooltip);

// A page in two parts: controls and numbers on the left, `side` design px wide, and pictures on the right; in a narrow
// strip one below the other, in a low strip with small controls. Construct it before the first part and call pictures()
// before the second.
class Page {
 public:
  Page(const Ui& ui, float side);
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  // Begins the second part, which scrolls, and returns the height of its pictures, px.
  float pictures();
  // True if the parts are one below the other.
  bool stacked() const { return stacked_; }
  // Returns the width of the second part, px.
  float pictures_width() const { return pictures_width_; }

 private:
  void end_side();

  float scale_, pictures_width_;
  bool stacked_, compact_, in_side_ = true;
};

// Draws the upper edge of an area at the foot of the window, "Panel/Edge", over the area's first pixels; call it before
// the content. During a drag returns the area's new share of the height between menu and status bar, at most `tallest`;
// 0 on a double click. `bar` is the height of each of the two, px.
std::optional<float> height_edge(Ui& ui, const view::Viewport& area, float bar, float tallest,
                                 std::string_view tooltip);

// Shows a value in the colour of its curve, in the small font.
void colour_value(Ui& ui, std::uint32_t colour, std::string_view path, std::string_view shown, std::string_view value,
                  std::string_view tooltip);
// Shows a checkbox for one of the layers over the scene, "Laboratory/View/label".
void layer_box(Ui& ui, world::Layer layer);

// Shows three components in the small font under a common heading, registered as "Laboratory/path" with the value
// "x y z unit".
void triple_heading(Ui& ui, std::string_view unit);
void triple(Ui& ui, std::string_view path, std::string_view shown, std::uint32_t colour, glm::dvec3 value, int decimals,
            std::string_view unit, std::string_view tooltip);

// Shows a line of small, dimmed text, wrapped.
void small_note(std::string_view words);

struct Side {
  std::string_view label, tooltip;
};
// Shows two radio buttons side by side. `second`: the second one is on.
void choose_side(Ui& ui, bool& second, const Side& off, const Side& on);

// Draws two pictures side by side, or one below the other in a narrow area. Each function gets width and height, px.
using Picture = std::function<void(float width, float height)>;
void two_pictures(Ui& ui, Page& page, const Picture& first, const Picture& second);

// Colours of the laboratory, the same in the view and in the plots.
inline constexpr std::uint32_t kCurveColour = 0xFFFFFF, kPolygonColour = 0xF2B84B, kConstructionColour = 0x7FD1B9,
                               kTangentColour = 0xE5534B;
inline constexpr std::uint32_t kPointColour = 0xFF8A1F;
// Returns a colour for a row of a table; colours of different rows are easy to distinguish on the plots' background.
std::uint32_t row_colour(std::size_t row);

}  // namespace coaster::ui
