#include "ui/lab/laboratory.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "edit/commands/commands_settings.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"
#include "world/lab_view.h"
#include "world/look.h"

namespace coaster::ui {

#define COASTER_PAGE(name, label, help) void name##_page(Ui& ui);
COASTER_LAB_PAGES(COASTER_PAGE)
#undef COASTER_PAGE

namespace {

// Rows of world::kLabPages, in its order.
constexpr void (*kBuild[])(Ui& ui) = {
#define COASTER_PAGE(name, label, help) name##_page,
    COASTER_LAB_PAGES(COASTER_PAGE)
#undef COASTER_PAGE
};

constexpr const char* kTooltip =
    "The laboratory: construction, evaluation, measurement, frames and joints of the selected segment, live.";

bool is_open(const Ui& ui) { return ui.session().settings.look->show_laboratory; }
int chosen_page(const Ui& ui) { return static_cast<int>(ui.session().settings.lab->page); }
void show(Ui& ui, bool on) { ui.emit(edit::Set<&world::Look::show_laboratory>{on}); }
void choose(Ui& ui, int page) { ui.emit(edit::Set<&world::LabView::page>{static_cast<world::LabPage>(page)}); }

void draw_triangle(const Ui& ui, ImVec2 low, float size, bool open) {
  const ImVec2 c(std::floor(low.x + size * 0.5f), std::floor(low.y + size * 0.5f));
  const float r = std::floor(4 * ui.scale);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (open)
    list.AddTriangleFilled({c.x - r, c.y - r * 0.5f}, {c.x + r, c.y - r * 0.5f}, {c.x, c.y + r * 0.7f},
                           packed(palette().text));
  else
    list.AddTriangleFilled({c.x - r, c.y + r * 0.5f}, {c.x, c.y - r * 0.7f}, {c.x + r, c.y + r * 0.5f},
                           packed(palette().text));
}

// The fold button, with the strip's name where there is room for it.
void fold_button(Ui& ui, float bar, bool named, ImFont* font) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::PushFont(font);
  const float text = named ? text_size("Laboratory").x + std::floor(8 * ui.scale) : 0;
  const float width = bar + text;
  const bool pressed = ImGui::InvisibleButton("##fold", {width, bar});
  if (ImGui::IsItemHovered())
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + bar}, packed(palette().field));
  draw_triangle(ui, low, bar, is_open(ui));
  if (named)
    ImGui::GetWindowDrawList()->AddText({low.x + bar, std::floor(low.y + (bar - ImGui::GetTextLineHeight()) * 0.5f)},
                                        packed(palette().text), "Laboratory");
  ImGui::PopFont();
  note(ui, "", "header", with_keys(ui.keys, kTooltip, "Laboratory"), true, is_open(ui) ? "open" : "closed", low,
       {low.x + width, low.y + bar});
  if (pressed) show(ui, !is_open(ui));
}

void tab(Ui& ui, const base::NameRow& page, int index, float bar, float pad, ImFont* font) {
  ImGui::PushFont(font);
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = text_size(page.label);
  const ImVec2 high(std::floor(low.x + size.x + 2 * pad), low.y + bar);
  const bool on = is_open(ui) && chosen_page(ui) == index;
  const bool pressed = ImGui::InvisibleButton(page.name.data(), {high.x - low.x, bar});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered() || on) list.AddRectFilled(low, high, packed(palette().field, on ? 1.0f : 0.7f));
  if (on) list.AddRectFilled(low, {high.x, low.y + std::max(2.0f, std::floor(2 * ui.scale))}, packed(palette().accent));
  list.AddText({std::floor(low.x + pad), std::floor(low.y + (bar - size.y) * 0.5f)},
               packed(on ? palette().text : palette().dim), page.label.data(), page.label.data() + page.label.size());
  ImGui::PopFont();
  note(ui, page.label, "radio", page.help, true, on ? "on" : "off", low, high);
  if (!pressed || on) return;
  choose(ui, index);
  if (!is_open(ui)) show(ui, true);
}

float width_of(std::span<const base::NameRow> all, float pad, ImFont* font) {
  float width = 0;
  for (const base::NameRow& page : all)
    width += std::floor(
        font->CalcTextSizeA(font->FontSize, 1e9f, 0, page.label.data(), page.label.data() + page.label.size()).x +
        2 * pad);
  return width;
}

// A list of the pages, where their names do not fit side by side.
void page_list(Ui& ui, std::span<const base::NameRow> all) {
  std::vector<Choice> choices;
  for (const base::NameRow& page : all) choices.push_back({std::string(page.label), std::string(page.help)});
  const auto chosen = combo(ui, "Page", choices, chosen_page(ui), "Page of the laboratory.", true);
  if (!chosen) return;
  choose(ui, *chosen);
  if (!is_open(ui)) show(ui, true);
}

void build_bar(Ui& ui, std::span<const base::NameRow> all, float width, float bar) {
  ImFont* const large = ImGui::GetFont();
  ImFont* const small = small_font();
  const float name = large->CalcTextSizeA(large->FontSize, 1e9f, 0, "Laboratory").x + std::floor(20 * ui.scale);
  struct Fit {
    ImFont* font;
    float pad;
    bool named;
  };
  const Fit fits[] = {{large, 9, true}, {large, 7, false}, {small, 7, true}, {small, 8, false}, {small, 5, false}};
  for (const Fit& fit : fits) {
    const float pad = std::floor(fit.pad * ui.scale);
    if (bar + (fit.named ? name : 0) + width_of(all, pad, fit.font) > width) continue;
    fold_button(ui, bar, fit.named, large);
    for (std::size_t i = 0; i < all.size(); ++i) {
      ImGui::SameLine(0, 0);
      tab(ui, all[i], static_cast<int>(i), bar, pad, fit.font);
    }
    return;
  }
  fold_button(ui, bar, false, large);
  ImGui::SameLine(0, 0);
  page_list(ui, all);
}

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                    ImGuiWindowFlags_NoNav;

}  // namespace

void build_laboratory(Ui& ui, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  const float bar = std::min(ImGui::GetFrameHeight(), area.height);
  const std::span<const base::NameRow> all = world::kLabPages;
  ui.panel = "Laboratory";
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(palette().raised));
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize({area.width, bar});
  if (ImGui::Begin("##laboratory", nullptr, kFixed)) build_bar(ui, all, area.width, bar);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  const int index = chosen_page(ui);
  if (area.height > bar + 1 && index >= 0 && index < static_cast<int>(all.size())) {
    ImGui::SetNextWindowPos({area.x, area.y + bar});
    ImGui::SetNextWindowSize({area.width, area.height - bar});
    if (ImGui::Begin("##page", nullptr, kFixed)) {
      ImGui::PushID(index);
      kBuild[index](ui);
      ImGui::PopID();
    }
    ImGui::End();
  }
  ui.panel.clear();
}

}  // namespace coaster::ui
