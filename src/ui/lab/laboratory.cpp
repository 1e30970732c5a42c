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
void fold_button(Ui& ui, float bar, bool named, ImFont* font) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::PushFont(font);
  const float text = named ? text_size("Laboratory").x + std::floor(8 * ui.scale) : 0;
  const float width = bar + text;
  const bool pressed = ImGui::InvisibleButton("##fold", sized({width, bar}));
  if (ImGui::IsItemHovered())
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + bar}, packed(palette().field));
  draw_fold_mark(*ImGui::GetWindowDrawList(), {low.x + bar * 0.5f, low.y + bar * 0.5f}, ui.scale, is_open(ui));
  if (named)
    draw_text(*ImGui::GetWindowDrawList(), {low.x + bar, low.y + (bar - ImGui::GetTextLineHeight()) * 0.5f},
              palette().text, "Laboratory");
  ImGui::PopFont();
  note(ui, "", "header", with_keys(ui.keys, kTooltip, "Laboratory"), true, is_open(ui) ? "open" : "closed", low,
       {low.x + width, low.y + bar});
  if (pressed) show(ui, !is_open(ui));
}

// Selects a page and opens the strip.
void open_page(Ui& ui, world::LabPage page) {
  ui.emit(edit::Set<&world::LabView::page>{page});
  if (!is_open(ui)) show(ui, true);
}

void tab(Ui& ui, world::LabPage index, float bar, float pad, ImFont* font) {
  const base::NameRow& page = base::row_of(index);
  ImGui::PushFont(font);
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = text_size(page.label);
  const ImVec2 high(std::floor(low.x + size.x + 2 * pad), low.y + bar);
  const bool on = is_open(ui) && chosen_page(ui) == index;
  const bool pressed = ImGui::InvisibleButton(page.name.data(), sized({high.x - low.x, bar}));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered() || on) list.AddRectFilled(low, high, packed(palette().field, on ? 1.0f : 0.7f));
  if (on) list.AddRectFilled(low, {high.x, low.y + std::max(2.0f, std::floor(2 * ui.scale))}, packed(palette().accent));
  draw_text(list, {low.x + pad, std::floor(low.y + (bar - size.y) * 0.5f)}, on ? palette().text : palette().dim,
            page.label);
  ImGui::PopFont();
  note(ui, page.label, "radio", page.help, true, on ? "on" : "off", low, high);
  if (pressed && !on) open_page(ui, index);
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
    fold_button(ui, bar, fit.named, large);
    for (std::size_t i = 0; i < std::size(world::kLabPages); ++i) {
      ImGui::SameLine(0, 0);
      tab(ui, static_cast<world::LabPage>(i), bar, pad, fit.font);
    }
    return;
  }
  // The names do not fit side by side.
  fold_button(ui, bar, 2 * (bar + name) <= width, large);
  ImGui::SameLine(0, 0);
  if (const auto page = combo_of(ui, "Page", chosen_page(ui), "Page of the laboratory.", ComboPlace::beside))
    open_page(ui, *page);
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
