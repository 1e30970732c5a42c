// Rows, buttons, switches, choices and read-outs. Fields to type in are in fields.cpp.
#include "ui/widgets/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"

namespace coaster::ui {
namespace {

constexpr float kTooltipRest = 0.45f;  // s of rest before a tooltip shows

void show_tooltip(std::string_view text, float scale) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * scale, 8 * scale));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + 320 * scale);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace

glm::vec2 mouse_position() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

std::string path_of(const WidgetFrame& ui, std::string_view label) {
  return label.empty() ? ui.panel : ui.panel + "/" + std::string(label);
}

void note(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
          std::string value, ImVec2 low, ImVec2 high) {
  std::string path = path_of(ui, label);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool over =
      ImGui::IsWindowHovered() && mouse.x >= low.x && mouse.y >= low.y && mouse.x < high.x && mouse.y < high.y;
  if (over && !tooltip.empty() && !ImGui::IsAnyMouseDown()) {
    ui.rest.next = path;
    if (ui.rest.path == path && ui.rest.seconds > kTooltipRest) show_tooltip(tooltip, ui.scale);
  }
  ui.list.add(path, kind, {low.x, low.y}, {high.x, high.y}, enabled, std::move(value));
}

void note_item(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
               std::string value) {
  note(ui, label, kind, tooltip, enabled, std::move(value), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

std::string hidden(std::string_view label) { return "##" + std::string(label); }

ImVec2 text_size(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()); }

void begin_row(WidgetFrame&, std::string_view label, float needed) {
  label = shown(label);
  constexpr float kLabelPart = 0.47f;  // of the row, for the label beside a control
  const float start = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const float label_room = std::floor(room * kLabelPart);
  const bool beside =
      text_size(label).x + ImGui::GetStyle().ItemInnerSpacing.x <= label_room && needed <= room - label_room;
  if (beside) ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().dim));
  ImGui::TextUnformatted(label.data(), label.data() + label.size());
  ImGui::PopStyleColor();
  if (beside) ImGui::SameLine(start + label_room);
  ImGui::SetNextItemWidth(beside ? room - label_room : room);
}

bool header(WidgetFrame& ui, std::string_view name, std::string_view tooltip, bool at_first) {
  const std::string label(name);
  if (ImGui::GetCursorPosY() > 2 * ImGui::GetStyle().WindowPadding.y)
    ImGui::Dummy({0, std::floor(3 * ui.scale)});  // not before the first
  const bool open = ImGui::CollapsingHeader(label.c_str(), at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  note(ui, "", "header", tooltip, true, open ? "open" : "closed", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  return open;
}

void heading(WidgetFrame& ui, std::string_view label, std::string_view tooltip) {
  const std::string_view words = shown(label);
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().dim));
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopStyleColor();
  note_item(ui, label, "label", tooltip, true);
}

void tinted(std::string_view words, std::uint32_t rgb) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour(rgb));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void paragraph(WidgetFrame& ui, std::string_view label, std::string_view words, std::uint32_t rgb) {
  tinted(words, rgb);
  note_item(ui, label, "label", "", true, std::string(words));
}

bool button(WidgetFrame& ui, std::string_view label, std::string_view tooltip, bool enabled, float width) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(std::string(label).c_str(), {width, 0});
  ImGui::EndDisabled();
  note_item(ui, label, "button", tooltip, enabled);
  return pressed && enabled;
}

bool radio(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled) {
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, std::floor(2 * ui.scale)));
  const bool pressed = ImGui::RadioButton(std::string(label).c_str(), on);
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  note_item(ui, label, "radio", tooltip, enabled, on ? "on" : "off");
  return pressed && enabled && !on;
}

bool beside_last(WidgetFrame& ui, std::string_view label) {
  const float button = ImGui::GetTextLineHeight() + 2 * std::floor(2 * ui.scale),
              room = ImGui::GetContentRegionAvail().x;
  const float start = ImGui::GetCursorPosX(), middle = std::floor(room * 0.5f);
  const float last_end = ImGui::GetItemRectMax().x - ImGui::GetCursorScreenPos().x;
  if (last_end > middle || middle + button + ImGui::GetStyle().ItemInnerSpacing.x + text_size(shown(label)).x > room)
    return false;
  ImGui::SameLine(start + middle);
  return true;
}

std::optional<bool> checkbox(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled) {
  bool wanted = on;
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, std::floor(2 * ui.scale)));
  const bool pressed = ImGui::Checkbox(std::string(label).c_str(), &wanted);
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  note_item(ui, label, "checkbox", tooltip, enabled, on ? "on" : "off");
  if (!pressed || !enabled) return std::nullopt;
  return wanted;
}

std::optional<int> combo(WidgetFrame& ui, std::string_view label, std::span<const Choice> choices, int current,
                         std::string_view tooltip, bool may_cut) {
  float widest = 0;
  for (const Choice& choice : choices) widest = std::max(widest, text_size(shown(choice.label)).x);
  begin_row(ui, label, may_cut ? 0 : widest + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetFrameHeight());
  const std::string preview(current >= 0 && current < static_cast<int>(choices.size())
                                ? shown(choices[static_cast<std::size_t>(current)].label)
                                : "");
  // Once the list is open, ImGui's last item is the list's: the box has to be known before.
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight());
  std::optional<int> chosen;
  const bool open = ImGui::BeginCombo(hidden(label).c_str(), preview.c_str());
  if (open) {
    ImGui::PushStyleColor(ImGuiCol_Header, colour(palette().accent, 0.35f));
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const bool on = static_cast<int>(i) == current;
      if (ImGui::Selectable(choices[i].label.c_str(), on) && !on) chosen = static_cast<int>(i);
      note_item(ui, std::string(label) + "/" + choices[i].label, "item", choices[i].tooltip, true, on ? "on" : "off");
    }
    ImGui::PopStyleColor();
    ImGui::EndCombo();
  }
  note(ui, label, "combo", tooltip, true, preview, low, high);
  return chosen;
}

void read_out(WidgetFrame& ui, std::string_view label, std::string_view value, std::string_view unit,
              std::string_view tooltip, bool warns) {
  const std::string_view words = shown(label);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, gap = std::floor(5 * ui.scale),
              line = ImGui::GetTextLineHeight();
  const float value_width = text_size(value).x + (unit.empty() ? 0 : gap + text_size(unit).x);
  // Units share one column, so that the numbers before them end on one edge.
  const float unit_room = unit.empty() ? 0 : std::max(text_size(unit).x, std::floor(38 * ui.scale)) + gap;
  const bool stacked = text_size(words).x + gap + value_width > room;
  const bool column = !stacked && text_size(words).x + gap + text_size(value).x + unit_room <= room;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = packed(warns ? palette().warning : palette().text);
  list.AddText(start, packed(palette().dim), words.data(), words.data() + words.size());
  const float top = start.y + (stacked ? line : 0);
  const float right = start.x + room;
  const float edge = unit.empty() ? right : column ? right - unit_room : right - text_size(unit).x - gap;
  if (value_width > room) {  // too long for any line: wrapped below its label
    const ImVec2 block = ImGui::CalcTextSize(value.data(), value.data() + value.size(), false, room);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {start.x, top}, ink, value.data(), value.data() + value.size(),
                 room);
    ImGui::Dummy({room, line + block.y});
    note_item(ui, label, "label", tooltip, true, std::string(value));
    return;
  }
  list.AddText({std::floor(edge - text_size(value).x), top}, ink, value.data(), value.data() + value.size());
  if (!unit.empty())
    list.AddText({std::floor(edge + gap), top}, packed(palette().dim), unit.data(), unit.data() + unit.size());
  ImGui::Dummy({room, stacked ? 2 * line : line});
  note_item(ui, label, "label", tooltip, true, std::string(value) + (unit.empty() ? "" : " " + std::string(unit)));
}

std::string fixed(double value, int decimals) {
  char text[352];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  bool zero = true;
  for (const char* c = text; *c != 0; ++c) zero = zero && (*c == '-' || *c == '0' || *c == '.');
  return zero && text[0] == '-' ? text + 1 : text;
}

}  // namespace coaster::ui
