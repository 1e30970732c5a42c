#include "ui/panels/section_cells.h"

#include <imgui.h>

#include <algorithm>

#include <fmt/format.h>

#include "ui/panels/element_fields.h"
#include "ui/panels/section_changes.h"
#include "ui/widgets/theme.h"
#include "world/element_rows.h"

namespace coaster::ui {
namespace {

using world::SectionColumn;

// Returns the next editable cell of a row, from `from` on.
std::optional<SectionColumn> next_cell(const world::Section& section, std::span<const SectionColumn> columns,
                                       std::size_t from) {
  for (std::size_t i = from; i < columns.size(); ++i)
    if (takes_typing(section, columns[i])) return columns[i];
  return std::nullopt;
}

void typed_cell(Ui& ui, const Chosen& chosen, std::span<const SectionColumn> columns, std::size_t at,
                std::string_view label) {
  EditedCell& cell = *ui.inputs.cell;
  world::Element element = chosen.section().element;
  const std::string_view name = parameter_of(columns[at]);
  const auto parameters = base::row_of(element.kind).parameters;
  const auto p = std::find_if(parameters.begin(), parameters.end(),
                              [&](const world::ElementParameter& one) { return one.name == name; });
  if (std::exchange(cell.begins, false) && ui.wish) ui.wish->panel = ui.panel;
  const TypedNumber typed = cell_number(ui, label, parameter_number(*p, world::value_of(element, name)), p->help);
  if (typed.value && *typed.value != world::value_of(element, name)) {
    element.values[static_cast<std::size_t>(p - parameters.begin())] = *typed.value;
    change_sections(ui, chosen, name, element);
  }
  if (typed.open) return;
  // Tab asks for the panel's next field.
  const bool tab = ui.wish && ui.wish->panel == ui.panel;
  if (tab) ui.wish->panel.clear();
  const auto next = tab ? next_cell(chosen.section(), columns, at + 1) : std::nullopt;
  if (next) ui.inputs.cell = EditedCell{cell.section, next};
  else ui.inputs.cell.reset();
}

}  // namespace

bool takes_typing(const world::Section& section, SectionColumn column) {
  return planned_value(section, parameter_of(column)).has_value();
}

void begin_cell(Ui& ui, std::span<const SectionColumn> columns) {
  std::optional<EditedCell>& cell = ui.inputs.cell;
  if (!cell) return;
  const edit::Session& session = ui.session();
  const auto* const section = session.document.entities.find<world::Section>(session.settings.selected);
  if (section == nullptr || world::name_of(session.document, session.settings.selected) != cell->section)
    return cell.reset();
  if (!cell->column) cell->column = next_cell(*section, columns, 0);
  if (!cell->column) ui.warn("The section has no editable number in this table.");
  if (!cell->column || std::find(columns.begin(), columns.end(), *cell->column) == columns.end()) cell.reset();
}

bool cell_is_open(const Ui& ui, world::Name section) { return ui.inputs.cell && ui.inputs.cell->section == section; }
bool cell_is_open(const Ui& ui, world::Name section, SectionColumn column) {
  return cell_is_open(ui, section) && ui.inputs.cell->column == column;
}

void row_cells(Ui& ui, const world::SectionRun& run, std::span<const SectionColumn> columns) {
  const edit::Session& session = ui.session();
  const world::Section& section = world::section(session.document, run.section);
  const world::Name name = world::name_of(session.document, run.section);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!takes_typing(section, columns[i]) || !ImGui::TableSetColumnIndex(static_cast<int>(i))) continue;
    const base::NameRow& row = base::row_of(columns[i]);
    const std::string label = fmt::format("{}/{}", world::label_of(session.document, run.section), row.label);
    if (cell_is_open(ui, name, columns[i])) {
      typed_cell(ui, chosen_sections(session), columns, i, label);
      continue;
    }
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetTextLineHeight());
    const std::string_view refusal = refusal_of(ui, name, parameter_of(columns[i]));
    note(ui, label, "cell", refusal.empty() ? row.help : refusal, true,
         fixed(*planned_value(section, parameter_of(columns[i])), 2), low, high);
    // The press makes the row the active item.
    const bool over =
        ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && ImGui::IsMouseHoveringRect(low, high);
    if (over && ImGui::IsMouseDoubleClicked(0)) ui.inputs.cell = EditedCell{name, columns[i]};
  }
}

}  // namespace coaster::ui
