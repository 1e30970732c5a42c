// A plot: chooses the axes, lays out and draws the parts, and follows the mouse.
#include "ui/plots/plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

// The axes and their positions on the screen.
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
  // Returns the upper pixel of a label beside a value of the y axis.
  float label_top(double y_value, float label_height) const;
  AxisRange shown_x() const { return {x.low * x_unit.factor, x.high * x_unit.factor, x.scale}; }
  AxisRange shown_y() const { return {y.low * y_unit.factor, y.high * y_unit.factor, y.scale}; }
  std::string y_text(double tick, bool superscripts) const { return tick_text(shown_y(), y_ticks, tick, superscripts); }
};

// What the mouse does with the area.
struct AreaState {
  unsigned id = 0;
  bool hovered = false, held = false, activated = false, deactivated = false;
};

ImVec2 PlotArea::at(double x_value, double y_value) const {
  // Far outside is still a finite pixel, which the clip rectangle cuts off.
  constexpr double kFar = 50;
  const auto place = [](double part) { return std::isnan(part) ? part : std::clamp(part, -kFar, 1 + kFar); };
  return {low.x + static_cast<float>(place(part_of(x, x_value))) * (high.x - low.x),
          high.y - static_cast<float>(place(part_of(y, y_value))) * (high.y - low.y)};
}

// Returns "title (unit)", or the one that is not empty.
std::string axis_title(const PlotAxis& axis, const base::ShownUnit& unit) {
  if (axis.title.empty()) return std::string(unit.name);
  return axis.unit.empty() ? axis.title : fmt::format("{} ({})", axis.title, unit.name);
}

float PlotArea::label_top(double y_value, float label_height) const {
  return std::clamp(at(x.low, y_value).y - label_height * 0.5f, low.y - label_height * 0.15f,
                    high.y - label_height * 0.6f);
}

void draw_ink(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text) {
  draw_small(list, at, ink(rgb), text);
}

// Draws a vertical line over the area. Returns its pixel; nothing outside of the area.
std::optional<float> draw_vertical(ImDrawList& list, const PlotArea& area, double x, ImU32 tint, float width = 1) {
  const float at = std::floor(area.at(x, area.y.high).x) + 0.5f;
  if (!(at >= area.low.x - 1 && at <= area.high.x + 1)) return std::nullopt;
  list.AddLine({at, area.low.y}, {at, area.high.y}, tint, width);
  return at;
}

bool drawable(ImVec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

// Returns the points of one unbroken piece. Of several in one pixel column, the first, lowest, highest and last remain.
std::vector<ImVec2> thinned(const std::vector<ImVec2>& points, float width) {
  if (static_cast<float>(points.size()) < 5 * width) return points;
  std::vector<ImVec2> kept;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i, lowest = i, highest = i;
    for (; end < points.size() && std::floor(points[end].x) == std::floor(points[i].x); ++end) {
      if (points[end].y > points[lowest].y) lowest = end;
      if (points[end].y < points[highest].y) highest = end;
    }
    const std::size_t chosen[] = {i, std::min(lowest, highest), std::max(lowest, highest), end - 1};
    for (std::size_t k = 0; k < 4; ++k)
      if (k == 0 || chosen[k] != chosen[k - 1]) kept.push_back(points[chosen[k]]);
    i = end;
  }
  return kept;
}

void draw_piece(ImDrawList& list, const PlotArea& area, const Series& series, const std::vector<ImVec2>& piece) {
  if (piece.size() == 1 && series.kind == SeriesKind::line)  // a sample between two gaps
    list.AddCircleFilled(piece[0], series.width * area.scale, packed(ink(series.colour)));
  if (piece.size() < 2) return;
  const std::vector<ImVec2> points = thinned(piece, area.high.x - area.low.x);
  list.AddPolyline(points.data(), static_cast<int>(points.size()), packed(ink(series.colour)), ImDrawFlags_None,
                   series.width * area.scale);
}

void draw_lines(ImDrawList& list, const PlotArea& area, const Series& series, std::size_t count) {
  std::vector<ImVec2> piece;
  for (std::size_t i = 0; i < count; ++i) {
    const ImVec2 p = area.at(series.x[i], series.y[i]);
    if (drawable(p)) {
      piece.push_back(p);
      continue;
    }
    draw_piece(list, area, series, piece);
    piece.clear();
  }
  draw_piece(list, area, series, piece);
}

// Draws one column of pixels after another, so that the cost does not grow with the number of points.
void draw_band(ImDrawList& list, const PlotArea& area, const Series& series, std::size_t count) {
  const ImU32 tint = packed(ink(series.colour), 0.75f);
  const float half = 0.5f * series.width * area.scale;
  const auto column_of = [&](std::size_t i) { return std::floor(area.at(series.x[i], series.y[i]).x); };
  for (std::size_t i = 0; i < count;) {
    const float left = column_of(i);
    float bottom = -1e30f, top = 1e30f;  // px, downwards
    do {
      bottom = std::max(bottom, area.at(series.x[i], series.y[i]).y);
      top = std::min(top, area.at(series.x[i], series.high[i]).y);
    } while (++i < count && column_of(i) == left);
    const float right = i < count ? std::max(column_of(i), left + 1) : left + 1;
    if (top <= bottom) list.AddRectFilled({left, top - half}, {right, bottom + half}, tint);
  }
}

void draw_bars(ImDrawList& list, const PlotArea& area, const Series& series, std::size_t count) {
  const float room = (area.high.x - area.low.x) / static_cast<float>(std::max<std::size_t>(count, 1));
  const float half = std::max(1.0f, std::min(0.35f * room, 22 * area.scale));
  const float zero = area.y.scale == AxisScale::linear ? area.at(area.x.low, 0).y : area.high.y;
  for (std::size_t i = 0; i < count; ++i) {
    const ImVec2 p = area.at(series.x[i], series.y[i]);
    if (drawable(p))
      list.AddRectFilled({p.x - half, std::min(p.y, zero)}, {p.x + half, std::max(p.y, zero)},
                         packed(ink(series.colour), 0.85f));
  }
}

struct Nearest {
  const Series* series = nullptr;
  std::size_t index = 0;
  float distance = 1e30f;
  ImVec2 place{};
};

// Finds the point to read: of lines at the mouse's x, of points (and shapes) the nearest.
Nearest nearest(const PlotArea& area, const Series& s, ImVec2 mouse, bool by_x) {
  Nearest best;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    const ImVec2 p = area.at(s.x[i], s.y[i]);
    if (!drawable(p)) continue;
    const float distance = by_x ? std::abs(p.x - mouse.x) : std::hypot(p.x - mouse.x, p.y - mouse.y);
    if (distance < best.distance) best = {&s, i, distance, p};
  }
  return best;
}

void draw_grid(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 outer_low) {
  const float line = area.text_px, gap = std::floor(4 * area.scale);
  const ImU32 major = packed(palette().border, 0.9f), minor = packed(palette().border, 0.4f);
  list.AddRectFilled(area.low, area.high, packed(palette().plot));
  const auto row = [&](double value, ImU32 tint) {
    const float y = std::floor(area.at(area.x.low, value).y) + 0.5f;
    if (y >= area.low.y - 1 && y <= area.high.y + 1) list.AddLine({area.low.x, y}, {area.high.x, y}, tint);
  };
  for (const double v : area.y_ticks.minor) row(v / area.y_unit.factor, minor);
  for (const double v : area.x_ticks.minor) (void)draw_vertical(list, area, v / area.x_unit.factor, minor);
  for (const double tick : area.y_ticks.major) {
    const double v = tick / area.y_unit.factor;
    row(v, v == 0 ? packed(palette().dim, 0.7f) : major);
    const std::string text = area.y_text(tick, area.pretty);
    const ImVec2 size = small_size(text);
    draw_ink(list, {area.low.x - size.x - gap, area.label_top(v, size.y)}, palette().dim, text);
  }
  for (const double tick : area.x_ticks.major) {
    const double v = tick / area.x_unit.factor;
    (void)draw_vertical(list, area, v, v == 0 && plot.square ? packed(palette().dim, 0.7f) : major);
    const std::string text = tick_text(area.shown_x(), area.x_ticks, tick, area.pretty);
    const ImVec2 size = small_size(text);
    draw_ink(list, {std::max(outer_low.x, area.at(v, area.y.low).x - size.x * 0.5f), area.high.y + gap * 0.5f},
             palette().dim, text);
  }
  PlotArea right = area;
  right.y = area.right;
  for (const double v : area.right_ticks.major) {
    const std::string text = tick_text(area.right, area.right_ticks, v, area.pretty);
    draw_ink(list, {area.high.x + gap, right.label_top(v, small_size(text).y)}, palette().dim, text);
  }
  if (!area.right_ticks.major.empty())
    draw_ink(list, {area.high.x + gap, outer_low.y}, palette().text, plot.right.title);
  draw_ink(list, outer_low, palette().text, axis_title(plot.y, area.y_unit));
  if (plot.square) return;
  const std::string title = axis_title(plot.x, area.x_unit);
  const ImVec2 size = small_size(title);
  const float below = area.high.y + gap * 0.5f;
  if (area.title_beside) draw_ink(list, {area.high.x + line, below}, palette().text, title);
  else draw_ink(list, {(area.low.x + area.high.x - size.x) * 0.5f, below + line}, palette().text, title);
}

void draw_series(ImDrawList& list, const PlotArea& area, const Series& series) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  if (!series.high.empty()) return draw_band(list, area, series, count);
  if (series.kind == SeriesKind::bars) return draw_bars(list, area, series, count);
  if (series.kind != SeriesKind::points) draw_lines(list, area, series, count);
  if (series.kind == SeriesKind::line) return;
  for (std::size_t i = 0; i < count; ++i) {
    const ImVec2 p = area.at(series.x[i], series.y[i]);
    if (drawable(p)) list.AddCircleFilled(p, (series.width + 1) * area.scale, packed(ink(series.colour)));
  }
}

void draw_levels_and_spots(ImDrawList& list, const PlotArea& area, const Plot& plot) {
  for (const LevelLine& level : plot.levels) {
    const float y = std::floor(area.at(area.x.low, level.y).y) + 0.5f;
    if (!std::isfinite(y)) continue;
    const float dash = 7 * area.scale;
    for (float x = area.low.x; x < area.high.x; x += 1.7f * dash)
      list.AddLine({x, y}, {std::min(x + dash, area.high.x), y}, packed(ink(level.colour)),
                   std::max(1.0f, 1.5f * area.scale));
    const ImVec2 size = small_size(level.label);
    const float above = y - size.y - 1, top = above >= area.low.y ? above : y + 2;
    draw_ink(list, {area.high.x - size.x - 4 * area.scale, top}, level.colour, level.label);
  }
  std::vector<ImVec4> labels;  // low x, low y, high x, high y
  for (const Spot& spot : plot.spots) {
    const ImVec2 p = area.at(spot.x, spot.y);
    if (!drawable(p)) continue;
    list.AddCircleFilled(p, 4.5f * area.scale, packed(palette().plot));
    list.AddCircleFilled(p, 3.5f * area.scale, packed(ink(spot.colour)));
    if (spot.label.empty()) continue;
    const ImVec2 size = small_size(spot.label);
    const float gap = 6 * area.scale;
    const float x = p.x + gap + size.x <= area.high.x ? p.x + gap : p.x - gap - size.x;
    const float y = std::clamp(p.y - size.y - 1, area.low.y, std::max(area.low.y, area.high.y - size.y));
    if (std::ranges::any_of(labels, [&](const ImVec4& other) {
          return x < other.z && x + size.x > other.x && y < other.w && y + size.y > other.y;
        }))
      continue;  // two at one place would hide each other
    labels.push_back({x, y, x + size.x, y + size.y});
    draw_ink(list, {x, y}, spot.colour, spot.label);
  }
}

// Draws the legend in the row of the y axis' title, from the right.
void draw_legend(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 outer_low) {
  const float gap = 5 * area.scale, mark = 12 * area.scale;
  const float left = outer_low.x + small_size(axis_title(plot.y, area.y_unit)).x + 2 * gap;
  float total = 0;
  for (const Series& s : plot.series)
    if (!s.label.empty()) total += mark + gap + small_size(s.label).x + 2 * gap;
  float x = std::max(left, area.high.x - total + 2 * gap);
  for (const Series& s : plot.series) {
    if (s.label.empty()) continue;
    const float width = mark + gap + small_size(s.label).x, y = std::floor(outer_low.y + area.text_px * 0.5f);
    if (x + width > area.high.x + 1) break;
    if (s.kind == SeriesKind::points) list.AddCircleFilled({x + mark / 2, y}, 3 * area.scale, packed(ink(s.colour)));
    else
      list.AddLine({x, y}, {x + mark, y}, packed(ink(s.colour)),
                   s.kind == SeriesKind::bars ? 8 * area.scale : 2 * area.scale);
    draw_ink(list, {x + mark + gap, outer_low.y}, palette().dim, s.label);
    x += width + 2 * gap;
  }
}

void draw_readout(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 mouse) {
  mouse.x = std::clamp(mouse.x, area.low.x, area.high.x);
  std::vector<Nearest> found;
  for (const Series& s : plot.series) {
    const bool by_x = !plot.square && (s.kind == SeriesKind::line || s.kind == SeriesKind::bars);
    const Nearest one = nearest(area, s, mouse, by_x);
    if (one.series != nullptr && one.distance < (by_x ? 20 : 14) * area.scale) found.push_back(one);
  }
  if (found.empty()) return;
  constexpr std::size_t kMost = 6;
  std::stable_sort(found.begin(), found.end(),
                   [](const Nearest& a, const Nearest& b) { return a.distance < b.distance; });
  if (found.size() > kMost) found.resize(kMost);
  const auto words = [&](const std::string& name, double value, const base::ShownUnit& unit) {
    return fmt::format("{} {}{}{}", name, significant(value * unit.factor, 4, area.pretty),
                       unit.name.empty() ? "" : " ", unit.name);
  };
  std::vector<std::pair<std::uint32_t, std::string>> lines;
  const Nearest& first = found.front();
  lines.emplace_back(palette().text, words(plot.x.title, first.series->x[first.index], area.x_unit));
  for (const Nearest& one : found) {
    const Series& s = *one.series;
    lines.emplace_back(s.colour, words(s.label.empty() ? plot.y.title : s.label, s.y[one.index], area.y_unit));
    list.AddCircleFilled(one.place, 3 * area.scale, packed(ink(s.colour)));
  }
  float width = 0;
  for (const auto& [tint, text] : lines) width = std::max(width, small_size(text).x);
  const float pad = 5 * area.scale, height = area.text_px * static_cast<float>(lines.size());
  const float beside = 12 * area.scale, wide = width + 2 * pad;
  const float x = mouse.x + beside + wide <= area.high.x ? mouse.x + beside : mouse.x - beside - wide;
  const float y =
      std::clamp(mouse.y - height * 0.5f, area.low.y + pad, std::max(area.low.y + pad, area.high.y - height - pad));
  list.AddRectFilled({x, y - pad}, {x + wide, y + height + pad}, packed(palette().raised, 0.95f), 4 * area.scale);
  for (std::size_t i = 0; i < lines.size(); ++i)
    draw_ink(list, {x + pad, y + static_cast<float>(i) * area.text_px}, lines[i].first, lines[i].second);
}

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

PlotDrag place_under(const PlotArea& area, ImVec2 pixel) {
  return {value_at(area.x, (pixel.x - area.low.x) / (area.high.x - area.low.x)),
          value_at(area.y, (area.high.y - pixel.y) / (area.high.y - area.low.y))};
}

// Fills plot.touch. Returns whether the mouse holds the cursor.
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

// Draws the knobs and registers those with a value; the plot's last item is its area.
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

struct PlotExtents {
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

PlotExtents extent_of(const Plot& p) {
  PlotExtents data;
  for (const Series& s : p.series) add_series(s, p.x, p.y, data.x, data.y);
  for (const Series& s : p.right_series) add_series(s, p.x, p.right, data.x, data.right);
  if (!data.x.empty())
    for (const LevelLine& level : p.levels) data.y.add(level.y, p.y.scale);
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
void lay_out_right(const Plot& p, const PlotExtents& data, float gap, PlotArea& area) {
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
PlotArea lay_out(const WidgetFrame& ui, const Plot& p, const PlotExtents& data, ImVec2 low, ImVec2 high) {
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
  area.y_ticks = ticks(area.shown_y(), most_beside(area.high.y - area.low.y, line));
  float widest = p.labels;
  for (const double tick : area.y_ticks.major) widest = std::max(widest, small_size(area.y_text(tick, area.pretty)).x);
  area.low.x = std::min(std::floor(low.x + widest + 2 * gap), area.high.x - 1);
  if (p.square) {
    make_square(area);
    area.y_ticks = ticks(area.shown_y(), most_beside(area.high.y - area.low.y, line));
  }
  lay_out_right(p, data, gap, area);
  area.x_ticks = ticks(area.shown_x(), most_ticks(area.high.x - area.low.x, 4.0f * line, 2));
  return area;
}

// Returns the x rounded to a multiple of a round step of the shown unit, at most a pixel long, within the axis.
double snapped(const PlotArea& area, float mouse_x) {
  const double part = (mouse_x - area.low.x) / std::max(1.0f, area.high.x - area.low.x);
  if (area.x.scale == AxisScale::logarithmic) return value_at(area.x, part);
  const AxisRange axis = area.shown_x();
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
  const ImU32 tint = packed(palette().accent, hot ? 1.0f : 0.85f);
  const auto at = draw_vertical(list, area, x, tint, std::max(1.0f, std::floor(1.5f * area.scale)));
  if (!at) return;
  const float grip = std::floor(4.5f * area.scale);  // half width of the handle
  list.AddTriangleFilled({*at - grip, area.low.y - 1}, {*at + grip, area.low.y - 1}, {*at, area.low.y + grip * 1.4f},
                         packed(palette().accent));
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
  const PlotExtents data = extent_of(p);
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
  if (any && p.mark) (void)draw_vertical(list, area, *p.mark, packed(palette().text, 0.6f));
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
  for (const double tick : area.y_ticks.major) axes += " " + area.y_text(tick, false);
  note(ui, fmt::format("{}/axes", label), "label", tooltip, true, axes, low, {high.x, area.low.y});
  if (!held || !any || !moves_cursor) return std::nullopt;
  PlotDrag wanted = place_under(area, mouse);
  if (p.cursor) wanted.x = snapped(area, mouse.x);
  const bool moves = p.cursor ? wanted.x != *p.cursor : p.drags_point;
  return moves ? std::optional(wanted) : std::nullopt;
}

}  // namespace coaster::ui
