// A plot: chooses the axes, lays out and draws the parts, and follows the cursor.
#include "ui/plots/plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/plots/plot_area.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace coaster::ui {
namespace {

struct Data {
  Extent x, y, right;
};

void add_series(const Series& s, const PlotAxis& x_axis, const PlotAxis& y_axis, Extent& x, Extent& y) {
  const std::size_t n = std::min(s.x.size(), s.y.size());
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i])) continue;
    x.add(s.x[i], x_axis.scale);
    y.add(s.y[i], y_axis.scale);
    if (!s.high.empty()) y.add(s.high[i], y_axis.scale);
  }
  if (s.kind == SeriesKind::bars) y.add(0, y_axis.scale);
}

Data extent_of(const Plot& p) {
  Data data;
  for (const Series& s : p.series) add_series(s, p.x, p.y, data.x, data.y);
  for (const Series& s : p.right_series) add_series(s, p.x, p.right, data.x, data.right);
  if (!data.x.empty())
    for (const Level& level : p.levels) data.y.add(level.y, p.y.scale);
  for (const Spot& spot : p.spots) {
    data.x.add(spot.x, p.x.scale);
    data.y.add(spot.y, p.y.scale);
  }
  return data;
}

AxisRange range_of(const PlotAxis& axis, Extent extent, double margin) {
  AxisRange range = fit(extent, axis.scale, margin);
  if (axis.scale == AxisScale::linear) range = widened(range, axis.least_span);
  if (axis.low) range.low = *axis.low;
  if (axis.high) range.high = *axis.high;
  if (!(range.high > range.low)) range.high = axis.scale == AxisScale::logarithmic ? range.low * 10 : range.low + 1;
  return range;
}

// Widens one axis so that both have the same scale.
void make_square(PlotArea& area) {
  const double width = area.high.x - area.low.x, height = area.high.y - area.low.y;
  const double x_span = area.x.high - area.x.low, y_span = area.y.high - area.y.low;
  const double per_px = std::max(x_span / width, y_span / height);
  area.x = widened(area.x, per_px * width);
  area.y = widened(area.y, per_px * height);
}

int most_ticks(float room, float each, int least) { return std::max(least, static_cast<int>(room / each)); }
// Even a low plot gets up to three numbers beside it.
int most_beside(float room, float text) { return most_ticks(room, 1.9f * text, 3); }

// The labels of the right axis take their space from the data.
void lay_out_right(const Plot& p, const Data& data, float gap, PlotArea& area) {
  if (data.right.empty()) return;
  area.right = range_of(p.right, data.right, 0.06);
  area.right_ticks = ticks(area.right, most_beside(area.high.y - area.low.y, area.text_px));
  float widest = small_size(p.right.title).x;
  for (const double tick : area.right_ticks.major)
    widest = std::max(widest, small_size(tick_text(area.right, area.right_ticks, tick, area.pretty)).x);
  area.high.x = std::max(std::floor(area.high.x - widest - gap), area.low.x + 1);
}

// Lays out the plot: labels of the y axis left, its title and the legend above; labels of the x axis below, its title
// at their end if it is short, else in a separate row.
PlotArea lay_out(const WidgetFrame& ui, const Plot& p, const Data& data, ImVec2 low, ImVec2 high) {
  PlotArea area;
  area.scale = ui.scale;
  area.text_px = small_pixels();
  area.pretty = has_glyph(*ImGui::GetFont(), 0x207B);
  area.x_unit = base::shown_in(ui.units, p.x.unit), area.y_unit = base::shown_in(ui.units, p.y.unit);
  area.x = range_of(p.x, data.x, p.square ? 0.08 : 0);
  area.y = range_of(p.y, data.y, p.square ? 0.08 : 0.06);
  const float line = area.text_px, gap = std::floor(4 * ui.scale);
  const float x_title =
      p.square ? 0 : small_size(axis_title(p.x, area.x_unit)).x;  // one title is enough for both axes of a shape
  area.title_beside = x_title <= 4 * line;
  const float above = axis_title(p.y, area.y_unit).empty() ? line * 0.5f : line + gap,
              below = line + gap + (area.title_beside ? 0 : line);
  const float right = area.title_beside && x_title > 0 ? x_title + line + gap : line;
  area.low = {std::floor(low.x + 3 * line), std::floor(low.y + above)};
  area.high = {std::max(std::floor(high.x - right), area.low.x + 1),
               std::max(std::floor(high.y - below), area.low.y + 1)};
  if (p.square) make_square(area);
  area.y_ticks = ticks(scaled(area.y, area.y_unit.factor), most_beside(area.high.y - area.low.y, line));
  float widest = p.labels;
  for (const double tick : area.y_ticks.major)
    widest =
        std::max(widest, small_size(tick_text(scaled(area.y, area.y_unit.factor), area.y_ticks, tick, area.pretty)).x);
  area.low.x = std::min(std::floor(low.x + widest + 2 * gap), area.high.x - 1);
  if (p.square) {
    make_square(area);
    area.y_ticks = ticks(scaled(area.y, area.y_unit.factor), most_beside(area.high.y - area.low.y, line));
  }
  lay_out_right(p, data, gap, area);
  area.x_ticks = ticks(scaled(area.x, area.x_unit.factor), most_ticks(area.high.x - area.low.x, 4.0f * line, 2));
  return area;
}

// Returns the x rounded to a multiple of a round step of the shown unit, at most a pixel long, within the axis.
double snapped(const PlotArea& area, float mouse_x) {
  const double part = (mouse_x - area.low.x) / std::max(1.0f, area.high.x - area.low.x);
  if (area.x.scale == AxisScale::logarithmic) return value_at(area.x, part);
  const AxisRange axis = scaled(area.x, area.x_unit.factor);
  const double value = value_at(axis, part);
  const double pixel = (axis.high - axis.low) / std::max(1.0f, area.high.x - area.low.x);
  const double power = std::pow(10.0, std::floor(std::log10(pixel)));
  const double step = power * (5 * power <= pixel ? 5 : 2 * power <= pixel ? 2 : 1);
  // Dividing by the number of steps per unit gives fewer decimals than multiplying by the step.
  const double steps = std::round(value / step), inverse = std::round(1 / step);
  const double rounded = inverse >= 1 ? steps / inverse : steps * step;
  return std::clamp(base::metric_value(rounded, area.x_unit), area.x.low, area.x.high);
}

void draw_cursor(ImDrawList& list, const PlotArea& area, double x, bool hot) {
  const float at = std::floor(area.at(x, area.y.high).x) + 0.5f;
  if (!(at >= area.low.x - 1 && at <= area.high.x + 1)) return;
  list.AddLine({at, area.low.y}, {at, area.high.y}, packed(palette().accent, hot ? 1.0f : 0.85f),
               std::max(1.0f, std::floor(1.5f * area.scale)));
  const float grip = std::floor(4.5f * area.scale);  // half width of the handle
  list.AddTriangleFilled({at - grip, area.low.y - 1}, {at + grip, area.low.y - 1}, {at, area.low.y + grip * 1.4f},
                         packed(palette().accent));
}

void draw_mark(ImDrawList& list, const PlotArea& area, double x) {
  const float at = std::floor(area.at(x, area.y.high).x) + 0.5f;
  if (at >= area.low.x - 1 && at <= area.high.x + 1)
    list.AddLine({at, area.low.y}, {at, area.high.y}, packed(palette().text, 0.6f), 1.0f);
}

void draw_all(ImDrawList& list, const PlotArea& area, const Plot& p, ImVec2 outer_low, bool any) {
  draw_grid(list, area, p, outer_low);
  list.PushClipRect({area.low.x - 1, area.low.y - 1}, {area.high.x + 1, area.high.y + 1}, true);
  if (any) {
    PlotArea right = area;
    right.y = area.right;
    for (const Series& s : p.right_series) draw_series(list, right, s);
    for (const Series& s : p.series) draw_series(list, area, s);
    draw_levels_and_spots(list, area, p);
  } else {
    const ImVec2 size = small_size(p.empty);
    draw_small(list, {(area.low.x + area.high.x - size.x) / 2, (area.low.y + area.high.y - size.y) / 2},
               ink(palette().dim), p.empty);
  }
  list.PopClipRect();
  if (any) draw_legend(list, area, p, outer_low);
}

}  // namespace

std::optional<PlotDrag> plot(WidgetFrame& ui, std::string_view label, const Plot& p, std::string_view tooltip) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float least = 4 * small_pixels();
  const ImVec2 size(std::max(least, p.width > 0 ? p.width : room.x), std::max(least, p.height > 0 ? p.height : room.y));
  const ImVec2 high(low.x + size.x, low.y + size.y);
  const Data data = extent_of(p);
  const bool any = !data.x.empty() && !(data.y.empty() && data.right.empty());
  const PlotArea area = lay_out(ui, p, data, low, high);

  ImGui::PushID(label.data(), label.data() + label.size());
  ImGui::SetCursorScreenPos(area.low);
  ImGui::InvisibleButton("##area", sized({area.high.x - area.low.x, area.high.y - area.low.y}));
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const AreaState state{ImGui::GetID("##area"), hovered, held, ImGui::IsItemActivated(), ImGui::IsItemDeactivated()};
  ImGui::PopID();
  ImGui::SetCursorScreenPos(low);
  ImGui::Dummy(sized(size));  // the next item is placed relative to the whole plot

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, high, true);
  draw_all(list, area, p, low, any);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (any && p.cursor && std::isfinite(*p.cursor)) draw_cursor(list, area, *p.cursor, held || hovered);
  if (any && p.mark) draw_mark(list, area, *p.mark);
  if (any && hovered && p.pointed != nullptr) *p.pointed = snapped(area, mouse.x);
  if (any && (hovered || held) && p.pointed == nullptr) draw_readout(list, area, p, mouse);
  const bool moves_cursor = p.touch == nullptr || touch_knobs(area, p, state);
  draw_knobs(ui, list, area, p, label);
  list.PopClipRect();

  const std::string value = !p.value.empty() ? p.value
                            : p.cursor       ? significant(*p.cursor * area.x_unit.factor, 6, false)
                            : any            ? ""
                                             : std::string(p.empty);
  note(ui, label, "plot", any ? "" : tooltip, true, value, area.low, area.high);
  std::string axes = axis_title(p.y, area.y_unit);
  for (const double tick : area.y_ticks.major)
    axes += " " + tick_text(scaled(area.y, area.y_unit.factor), area.y_ticks, tick, false);
  note(ui, fmt::format("{}/axes", label), "label", tooltip, true, axes, low, {high.x, area.low.y});
  if (!held || !any || !moves_cursor) return std::nullopt;
  PlotDrag wanted = place_under(area, mouse);
  if (p.cursor) wanted.x = snapped(area, mouse.x);
  const bool moves = p.cursor ? wanted.x != *p.cursor : p.drags_point;
  return moves ? std::optional(wanted) : std::nullopt;
}

}  // namespace coaster::ui
