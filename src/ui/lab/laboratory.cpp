#include "ui/lab/laboratory.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "edit/commands/set_setting.h"
#include "ui/lab/page_parts.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/lab_view.h"
#include "world/panels.h"

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
  struct Fit {
    ImFont* font;
    float pad;
    bool named;
  };
  const Fit fits[] = {{large, 9, true}, {large, 7, false}, {small, 7, true}, {small, 8, false}, {small, 5, false}};
  for (const Fit& fit : fits) {
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

}  // namespace

void build_laboratory(Ui& ui, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  const float bar = std::min(ImGui::GetFrameHeight(), area.height);
  ui.panel = "Laboratory";
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(palette().raised));
  if (begin_area("##laboratory", {area.x, area.y}, {area.width, bar})) {
    if (area.height > bar + 1)
      if (const auto share = height_edge(ui, area, bar, kTallest, "Height of the laboratory."))
        ui.emit(edit::Set<&world::Panels::laboratory_height>{*share});
    build_bar(ui, area.width, bar);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (area.height > bar + 1) {
    const auto index = static_cast<int>(chosen_page(ui));
    if (begin_area("##page", {area.x, area.y + bar}, {area.width, area.height - bar})) {
      ImGui::PushID(index);
      kBuild[index](ui);
      ImGui::PopID();
    }
    ImGui::End();
  }
  ui.panel.clear();
}

}  // namespace coaster::ui
