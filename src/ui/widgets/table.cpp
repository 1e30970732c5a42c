// Tables on top of Dear ImGui's.
#include "ui/widgets/table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

// Returns whether all of it fits.
bool draw_cell(const WidgetFrame& ui, const Cell& cell) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (cell.ground != 0) ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, packed(cell.ground));
  float left = at.x;
  if (cell.swatch != 0) {
    const float mark = std::floor(8 * ui.scale), y = std::floor(at.y + (ImGui::GetTextLineHeight() - mark) * 0.5f);
    list.AddRectFilled({left, y}, {left + mark, y + mark}, packed(ink(cell.swatch)), 2);
    left += mark + std::floor(5 * ui.scale);
  }
  const std::string text = shortened(cell.text, at.x + room - left);
  draw_text(list, {cell.left ? left : at.x + room - text_size(text).x, at.y}, ink(cell.colour), text);
  return text == cell.text;
}

}  // namespace

void push_table_style(const WidgetFrame& ui, float gap) {
  ImGui::PushFont(small_font());
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(std::floor(6 * ui.scale), std::floor(gap * ui.scale)));
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, colour(palette().raised));
  ImGui::PushStyleColor(ImGuiCol_TableRowBgAlt, colour(palette().raised, 0.35f));
}

void pop_table_style() {
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

namespace {

// A heading: its text, its unit if there is space, and the triangle of the sorting column.
void heading_cell(WidgetFrame& ui, std::string_view label, const TableColumn& column, int index, Sorting* sorting) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool sorts = sorting && sorting->column == index;
  const float mark = sorts ? std::floor(14 * ui.scale) : 0, height = ImGui::GetTextLineHeight();
  const float room = ImGui::GetContentRegionAvail().x;
  std::string words = in_units(ui, shown(column.title)), tooltip(column.tooltip);
  const std::string name =
      words == shown(column.title) ? std::string(column.title) : fmt::format("{}###{}", words, id_of(column.title));
  if (!column.unit.empty()) {
    const std::string_view unit = base::shown_in(ui.units, column.unit).name;
    const std::string whole = fmt::format("{} ({})", words, unit);
    if (text_size(whole).x + mark <= room) words = whole;
    else tooltip += fmt::format(" Unit: {}.", unit);
  }
  if (sorts)
    draw_fold_mark(*ImGui::GetWindowDrawList(), {at.x + std::floor(6 * ui.scale), at.y + height * 0.5f}, ui.scale,
                   sorting->descending);
  if (sorts) ImGui::SetCursorScreenPos({at.x + mark, at.y});
  (void)draw_cell(ui, {words, sorts ? palette().text : palette().dim, index == 0 || column.words});
  ImGui::SetCursorScreenPos(at);
  if (!sorting) ImGui::Dummy(sized({room, height}));
  else if (ImGui::InvisibleButton(name.c_str(), sized({room, height}))) sorting->clicked = index;
  const float right = std::min(at.x + room, ImGui::GetWindowDrawList()->GetClipRectMax().x);
  if (right <= at.x) return;  // scrolled out sideways
  note(ui, fmt::format("{}/{}", label, name), sorting ? "button" : "label", tooltip, true,
       sorts ? (sorting->descending ? "descending" : "ascending") : words, at, {right, at.y + height});
}

}  // namespace

bool begin_table(WidgetFrame& ui, std::string_view label, std::span<const TableColumn> columns, float height,
                 Sorting* sorting) {
  COASTER_CHECK(!columns.empty(), "a table has columns");
  push_table_style(ui, 1.5f);
  float width = 0;
  for (const TableColumn& column : columns) width += std::floor(column.width * ui.scale);
  const bool sideways = width > ImGui::GetContentRegionAvail().x;
  if (!ImGui::BeginTable(hidden(label).c_str(), static_cast<int>(columns.size()),
                         kTableFlags | (sideways ? ImGuiTableFlags_ScrollX : 0), {0, sized(height)},
                         sideways ? sized(width) : 0)) {
    pop_table_style();
    return false;
  }
  for (const TableColumn& column : columns)
    ImGui::TableSetupColumn(std::string(column.title).c_str(), ImGuiTableColumnFlags_WidthStretch, column.width);
  ImGui::TableSetupScrollFreeze(sideways ? 1 : 0, 1);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
    ImGui::TableSetColumnIndex(i);
    heading_cell(ui, label, columns[static_cast<std::size_t>(i)], i, sorting);
  }
  return true;
}

bool table_row(WidgetFrame& ui, std::string_view label, std::span<const Cell> cells, bool selected, std::string value,
               std::string_view tooltip, bool clickable) {
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(0);
  const ImVec2 at = ImGui::GetCursorPos();
  bool clicked = false;
  if (clickable) {
    ImGui::PushStyleColor(ImGuiCol_Header, colour(palette().accent, 0.35f));
    clicked = ImGui::Selectable(hidden(label).c_str(), selected, ImGuiSelectableFlags_SpanAllColumns);
    ImGui::PopStyleColor();
  } else {
    if (selected) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, packed(palette().accent, 0.35f));
    ImGui::Dummy(sized({1, ImGui::GetTextLineHeight()}));
  }
  // The row is located by its first cell, which is inside the clip rectangle of the column.
  const ImVec2 low = ImGui::GetItemRectMin();
  ImGui::SetCursorPos(at);
  note(ui, label, "item", tooltip, true, std::move(value), low,
       {ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetTextLineHeight()});
  (void)draw_cell(ui, cells[0]);
  for (std::size_t i = 1; i < cells.size(); ++i)
    if (ImGui::TableSetColumnIndex(static_cast<int>(i)) && !draw_cell(ui, cells[i]) && !cells[i].left)
      ui.list.mark_cut();  // a number without its end is wrong
  return clicked;
}

void end_table() {
  ImGui::EndTable();
  pop_table_style();
}

}  // namespace coaster::ui
