#include "ui/lab/strips.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "edit/commands/set_setting.h"
#include "ui/lab/force_key_editor.h"
#include "ui/lab/page_widgets.h"
#include "ui/lab/ride_plots.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {

#define COASTER_PAGE(name, label, help) void name##_page(Ui& ui);
COASTER_LAB_PAGES(COASTER_PAGE)
#undef COASTER_PAGE

namespace {

// The functions of the pages, in the order of world::kLabPages.
constexpr void (*kBuild[])(Ui& ui) = {
#define COASTER_PAGE(name, label, help) name##_page,
    COASTER_LAB_PAGES(COASTER_PAGE)
#undef COASTER_PAGE
};

constexpr const char* kTooltip =
    "The laboratory: construction, evaluation, measurement, frames and joints of the selected segment, live.";

constexpr auto kTallest = static_cast<float>(world::setting_row<&world::Panels::laboratory_height>().high);

bool is_open(const Ui& ui) { return ui.session().settings.panels->show_laboratory; }
world::LabPage chosen_page(const Ui& ui) { return ui.session().settings.lab->page; }
void show(Ui& ui, bool on) { ui.emit(edit::Set<&world::Panels::show_laboratory>{on}); }

// Shows the fold button, with the strip's name if there is space.
void fold_button(Ui& ui, float bar, bool named) {
  const std::string_view name = named ? "Laboratory" : "";
  const float width = bar + (named ? text_size(name).x + std::floor(8 * ui.scale) : 0);
  if (fold(ui, name, is_open(ui), with_keys(ui.keys, kTooltip, "Laboratory"), {width, bar})) show(ui, !is_open(ui));
  ImGui::SameLine(0, 0);
}

// Selects a page and opens the strip.
void open_page(Ui& ui, world::LabPage page) {
  ui.emit(edit::Set<&world::LabView::page>{page});
  if (!is_open(ui)) show(ui, true);
}

float width_in(ImFont* font, std::string_view text) {
  return font->CalcTextSizeA(pixels_of(*font), 1e9f, 0, text.data(), text.data() + text.size()).x;
}

float width_of_tabs(float pad, ImFont* font) {
  float width = 0;
  for (const base::NameRow& page : world::kLabPages) width += std::floor(width_in(font, page.label) + 2 * pad);
  return width;
}

void build_bar(Ui& ui, float width, float bar) {
  ImFont* const large = ImGui::GetFont();
  ImFont* const small = small_font();
  const world::LabPage now = chosen_page(ui);
  const float name = width_in(large, "Laboratory") + std::floor(20 * ui.scale);
  struct TabSizing {
    ImFont* font;
    float pad;
    bool named;
  };
  const TabSizing fits[] = {
      {large, 9, true}, {large, 7, false}, {small, 7, true}, {small, 8, false}, {small, 5, false}};
  for (const TabSizing& fit : fits) {
    const float pad = std::floor(fit.pad * ui.scale);
    if (bar + (fit.named ? name : 0) + width_of_tabs(pad, fit.font) > width) continue;
    fold_button(ui, bar, fit.named);
    const TabBar look{.height = bar, .pad = pad, .rgb = palette().accent, .font = fit.font, .line_above = true};
    for (std::size_t i = 0; i < std::size(world::kLabPages); ++i) {
      const auto page = static_cast<world::LabPage>(i);
      const bool on = is_open(ui) && now == page;
      if (tab(ui, world::kLabPages[i].label, world::kLabPages[i].help, on, look) && !on) open_page(ui, page);
    }
    return;
  }
  // The names do not fit side by side.
  fold_button(ui, bar, 2 * (bar + name) <= width);
  if (const auto page = combo_of(ui, "Page", now, "Page of the laboratory.", ComboPlace::beside)) open_page(ui, *page);
}

using sim::RideValue;

constexpr auto kTallestGraph = static_cast<float>(world::setting_row<&world::Panels::graph_height>().high);
// The values in g use the left axis.
constexpr std::array kValues{RideValue::vertical, RideValue::lateral, RideValue::speed, RideValue::height};
constexpr std::size_t kAtLeft = 2;
static_assert(kValues.size() == std::tuple_size_v<decltype(LabCache::graph_hidden)>);

// Shows a tab of the area: it opens the graph or the table of sections, or folds the open one.
void fold_button(Ui& ui, std::string_view name, std::string_view help, std::string_view action, float bar,
                 bool of_table) {
  const bool open = ui.drawers.graph.open && ui.drawers.table == of_table;
  const ImVec2 size(bar + text_size(name).x + std::floor(12 * ui.scale), bar);
  const std::string panel = std::exchange(ui.panel, std::string(name));
  if (fold(ui, name, open, with_keys(ui.keys, help, action), size, true)) ui.drawers.press(of_table);
  ui.panel = panel;
}

// Shows the value of a curve and whether it is drawn: a square in the curve's colour, empty while it is hidden.
void legend_item(Ui& ui, RideValue value, std::string shown, bool& hidden, float bar) {
  const sim::RideValueRow& row = base::row_of(value);
  const std::string_view unit = base::shown_in(ui.units, row.unit).name;
  const std::string words = fmt::format("{} {} {}", row.label, shown, unit);
  const float square = std::floor(9 * ui.scale), gap = std::floor(6 * ui.scale);
  const float room = std::max(small_size(words).x, small_size(fmt::format("{} -00.00 {}", row.label, unit)).x);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + square + gap + room, low.y + bar);
  if (high.x > ImGui::GetWindowPos().x + ImGui::GetWindowWidth()) return;
  ImGui::PushID(row.label.data(), row.label.data() + row.label.size());
  if (ImGui::InvisibleButton("##shown", sized({high.x - low.x, bar}))) hidden = !hidden;
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled({low.x - gap, low.y}, high, packed(palette().field));
  const float top = std::floor(low.y + (bar - square) * 0.5f);
  const ImU32 tint = packed(ink(RidePlots::colour_of(value)));
  if (hidden) list.AddRect({low.x, top}, {low.x + square, top + square}, tint);
  else list.AddRectFilled({low.x, top}, {low.x + square, top + square}, tint);
  draw_small(list, {low.x + square + gap, std::floor(low.y + (bar - small_pixels()) * 0.5f)},
             hidden ? palette().dim : palette().text, words);
  note(ui, row.label, "checkbox", fmt::format("{} Click to show or hide its curve.", row.help), true,
       hidden ? "off" : "on", low, high);
  note(ui, fmt::format("{}/value", row.label), "label", "", true, fmt::format("{} {}", shown, unit), low, high);
  ImGui::SameLine(0, std::floor(16 * ui.scale));
}

// Why there is nothing to plot, and what to do. The first element brings a train.
const char* no_ride(const world::Document& document) {
  return document.track.segments.empty()
             ? "The forces of the ride are plotted here. Place an element: the first one brings a train."
             : "No ride: the track has no train. Add a train in the Track panel.";
}

// Says at the end of the bar where the ride ends before the track does, which a short curve alone hardly shows.
void early_end(Ui& ui, const sim::SimulatedRide& ride, float bar) {
  const bool stalls = ride.end == world::FailureKind::stall;
  if (!stalls && ride.end != world::FailureKind::rollback) return;
  const std::string words = fmt::format("The train {} at {}", stalls ? "stalls" : "rolls back",
                                        measured(ui, ride.place(ride.furthest()), 1, "m"));
  const ImVec2 room = small_size(words), corner = ImGui::GetWindowPos();
  const float left = corner.x + ImGui::GetWindowWidth() - room.x - std::floor(10 * ui.scale);
  if (left < ImGui::GetCursorScreenPos().x) return;
  draw_small(*ImGui::GetWindowDrawList(), {left, std::floor(corner.y + (bar - room.y) * 0.5f)}, palette().warning,
             words);
  note(ui, "Ride ends", "label", "It is too slow there. A lift, a launch or a higher start takes it further.", true,
       words, {left, corner.y}, {left + room.x, corner.y + bar});
}

void curves(Ui& ui, const RidePlots& plots) {
  std::vector<RideValue> left, right;
  for (std::size_t i = 0; i < kValues.size(); ++i)
    if (!ui.lab.graph_hidden[i]) (i < kAtLeft ? left : right).push_back(kValues[i]);
  plots.plot_all(ui, left, right, "Plot");
}

}  // namespace

void build_laboratory(Ui& ui, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  const float bar = std::min(ImGui::GetFrameHeight(), area.height);
  const view::Viewport top{area.x, area.y, area.width, bar}, below{area.x, area.y + bar, area.width, area.height - bar};
  build_area(ui, top, {.id = "##laboratory", .panel = "Laboratory", .raised = true}, [&] {
    if (area.height > bar + 1)
      if (const auto share = height_edge(ui, area, bar, kTallest, "Height of the laboratory."))
        ui.emit(edit::Set<&world::Panels::laboratory_height>{*share});
    build_bar(ui, area.width, bar);
  });
  if (area.height <= bar + 1) return;
  build_area(ui, below, {.id = "##page", .panel = "Laboratory", .padding = {}}, [&] {
    const auto index = static_cast<int>(chosen_page(ui));
    ImGui::PushID(index);
    kBuild[index](ui);
    ImGui::PopID();
  });
}

void build_force_graph(Ui& ui, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  const float bar = std::min(ImGui::GetFrameHeight(), area.height);
  const bool open = area.height > bar + 1;
  const auto plots = RidePlots::make(ui, false);
  const world::Entity edited = open ? edited_forces(ui) : world::kNone;
  const view::Viewport top{area.x, area.y, area.width, bar}, below{area.x, area.y + bar, area.width, area.height - bar};
  build_area(ui, top, {.id = "##graph", .panel = "Forces", .raised = true}, [&] {
    if (open)
      if (const auto share = height_edge(ui, area, bar, kTallestGraph, "Height of the force graph."))
        ui.emit(edit::Set<&world::Panels::graph_height>{*share});
    fold_button(ui, "Forces", "The force graph: the whole ride along the track.", "Force graph", bar, false);
    ImGui::SameLine(0, 0);
    fold_button(ui, "Sections", "The table of sections.", "Table of sections", bar, true);
    ImGui::SameLine(0, std::floor(16 * ui.scale));
    if (edited.valid()) force_channels(ui, edited, bar);
    for (std::size_t i = 0; !edited.valid() && i < kValues.size(); ++i)
      legend_item(ui, kValues[i], plots ? plots->shown(ui, kValues[i]) : "--", ui.lab.graph_hidden[i], bar);
    if (!edited.valid() && plots) early_end(ui, plots->ride(), bar);
  });
  if (!open || ui.drawers.table) return;
  const ImVec2 padding(std::floor(6 * ui.scale), 0);
  build_area(ui, below, {.id = "##curves", .panel = "Forces", .padding = padding}, [&] {
    if (edited.valid()) force_plot(ui, edited, plots);
    else if (plots) curves(ui, *plots);
    else small_note(no_ride(ui.session().document));
  });
}

}  // namespace coaster::ui
