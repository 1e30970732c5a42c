// The drawing steps of a plot: grid and axes, series, levels and spots, legend, read-out.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "ui/plots/plot_area.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {

ImVec2 PlotArea::at(double x_value, double y_value) const {
  // Far outside is still a finite pixel, which the clip rectangle cuts off.
  constexpr double kFar = 50;
  const auto place = [](double part) { return std::isnan(part) ? part : std::clamp(part, -kFar, 1 + kFar); };
  return {low.x + static_cast<float>(place(part_of(x, x_value))) * (high.x - low.x),
          high.y - static_cast<float>(place(part_of(y, y_value))) * (high.y - low.y)};
}

std::string axis_title(const PlotAxis& axis, const base::ShownUnit& unit) {
  if (axis.title.empty()) return std::string(unit.name);
  return axis.unit.empty() ? axis.title : fmt::format("{} ({})", axis.title, unit.name);
}

AxisRange scaled(const AxisRange& axis, double factor) { return {axis.low * factor, axis.high * factor, axis.scale}; }

namespace {

void draw_ink(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text) {
  draw_small(list, at, ink(rgb), text);
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

}  // namespace

void draw_grid(ImDrawList& list, const PlotArea& area, const Plot& plot, ImVec2 outer_low) {
  const float line = area.text_px, gap = std::floor(4 * area.scale);
  const ImU32 major = packed(palette().border, 0.9f), minor = packed(palette().border, 0.4f);
  list.AddRectFilled(area.low, area.high, packed(palette().plot));
  const auto row = [&](double value, ImU32 tint) {
    const float y = std::floor(area.at(area.x.low, value).y) + 0.5f;
    if (y >= area.low.y - 1 && y <= area.high.y + 1) list.AddLine({area.low.x, y}, {area.high.x, y}, tint);
  };
  const auto column = [&](double value, ImU32 tint) {
    const float x = std::floor(area.at(value, area.y.high).x) + 0.5f;
    if (x >= area.low.x - 1 && x <= area.high.x + 1) list.AddLine({x, area.low.y}, {x, area.high.y}, tint);
  };
  for (const double v : area.y_ticks.minor) row(v / area.y_unit.factor, minor);
  for (const double v : area.x_ticks.minor) column(v / area.x_unit.factor, minor);
  const AxisRange shown_x = scaled(area.x, area.x_unit.factor), shown_y = scaled(area.y, area.y_unit.factor);
  for (const double tick : area.y_ticks.major) {
    const double v = tick / area.y_unit.factor;
    row(v, v == 0 ? packed(palette().dim, 0.7f) : major);
    const std::string text = tick_text(shown_y, area.y_ticks, tick, area.pretty);
    const ImVec2 size = small_size(text);
    const float y =
        std::clamp(area.at(area.x.low, v).y - size.y * 0.5f, area.low.y - size.y * 0.15f, area.high.y - size.y * 0.6f);
    draw_ink(list, {area.low.x - size.x - gap, y}, palette().dim, text);
  }
  for (const double tick : area.x_ticks.major) {
    const double v = tick / area.x_unit.factor;
    column(v, v == 0 && plot.square ? packed(palette().dim, 0.7f) : major);
    const std::string text = tick_text(shown_x, area.x_ticks, tick, area.pretty);
    const ImVec2 size = small_size(text);
    draw_ink(list, {std::max(outer_low.x, area.at(v, area.y.low).x - size.x * 0.5f), area.high.y + gap * 0.5f},
             palette().dim, text);
  }
  for (const double v : area.right_ticks.major) {
    const std::string text = tick_text(area.right, area.right_ticks, v, area.pretty);
    const float part = static_cast<float>(part_of(area.right, v)), height = small_size(text).y;
    const float y = std::clamp(area.high.y - part * (area.high.y - area.low.y) - height * 0.5f,
                               area.low.y - height * 0.15f, area.high.y - height * 0.6f);
    draw_ink(list, {area.high.x + gap, y}, palette().dim, text);
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
  for (const Level& level : plot.levels) {
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

}  // namespace coaster::ui
