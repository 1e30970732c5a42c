// The knobs of a plot: drawing and dragging them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/plots/plot_area.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

constexpr float kReach = 8;  // design px

float radius_of(const Knob& knob) { return knob.small ? 3.5f : 4.5f; }

// Returns the knob nearest to a pixel, of those within reach; of equal ones the last, which is on top.
std::optional<std::size_t> knob_at(const PlotArea& area, std::span<const Knob> knobs, ImVec2 pixel) {
  std::optional<std::size_t> nearest;
  float least = kReach * area.scale;
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    const ImVec2 at = area.at(knobs[i].x, knobs[i].y);
    const float distance = std::hypot(at.x - pixel.x, at.y - pixel.y);
    if (distance <= least) least = distance, nearest = i;
  }
  return nearest;
}

// What the mouse has held since the press, stored with the window.
constexpr int kNoKnob = -2, kCursor = -1;

}  // namespace

PlotDrag place_under(const PlotArea& area, ImVec2 pixel) {
  return {value_at(area.x, (pixel.x - area.low.x) / (area.high.x - area.low.x)),
          value_at(area.y, (area.high.y - pixel.y) / (area.high.y - area.low.y))};
}

bool touch_knobs(const PlotArea& area, const Plot& plot, const AreaState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  KnobTouch& touch = *plot.touch;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  touch = {};
  touch.at = place_under(area, io.MousePos);
  if (state.hovered) touch.over = knob_at(area, plot.knobs, io.MousePos);
  if (state.activated) {
    const bool cursor = plot.cursor && std::abs(area.at(*plot.cursor, 0).x - io.MousePos.x) <= kReach * area.scale;
    storage.SetInt(state.id, touch.over ? static_cast<int>(*touch.over) : cursor ? kCursor : kNoKnob);
  }
  const int held = storage.GetInt(state.id, kNoKnob);
  if ((state.held || state.deactivated) && held >= 0 && held < static_cast<int>(plot.knobs.size()))
    touch.held = static_cast<std::size_t>(held);
  touch.pressed = state.activated && touch.held;
  touch.moved = touch.held && io.MouseDragMaxDistanceSqr[0] >= io.MouseDragThreshold * io.MouseDragThreshold;
  touch.released = state.deactivated && touch.held;
  touch.twice = state.hovered && io.MouseDoubleClicked[0];
  return state.held && held == kCursor;
}

void draw_knobs(WidgetFrame& ui, ImDrawList& list, const PlotArea& area, const Plot& plot, std::string_view label) {
  for (std::size_t i = 0; i < plot.knobs.size(); ++i) {
    const Knob& knob = plot.knobs[i];
    const ImVec2 at = area.at(knob.x, knob.y);
    if (!(at.x >= area.low.x - 1 && at.x <= area.high.x + 1)) continue;
    const bool over = plot.touch != nullptr && (plot.touch->over == i || plot.touch->held == i);
    const float radius = (radius_of(knob) + (over ? 1.5f : 0.0f)) * area.scale;
    list.AddCircleFilled(at, radius + 1.5f * area.scale, packed(knob.chosen ? palette().text : palette().plot));
    list.AddCircleFilled(at, radius, packed(ink(knob.colour)));
    if (!knob.value.empty())
      note(ui, fmt::format("{}/Knob {}", label, i + 1), "knob", "", true, knob.value, {at.x - radius, at.y - radius},
           {at.x + radius, at.y + radius});
  }
}

}  // namespace coaster::ui
