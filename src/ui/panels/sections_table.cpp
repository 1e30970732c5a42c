// The table of sections: sorted by any column, with several rows selected at once. Cells that show a parameter of a
// planned section can be edited.
#include "ui/panels/selected_sections.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <variant>

#include <fmt/format.h>

#include "edit/commands/set_setting.h"
#include "sim/study/riders.h"
#include "ui/context/ui.h"
#include "ui/panels/element_equipment_fields.h"
#include "ui/tools/selecting.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/panel_settings.h"
#include "world/selection.h"

namespace coaster::ui {

namespace {

using world::SectionColumn;

// True for an editable cell, which shows a parameter of its section.
bool takes_typing(const world::Section& section, SectionColumn column) {
  return planned_value(section, parameter_of(column)).has_value();
}

// Returns the next editable cell of a row, from `from` on.
std::optional<SectionColumn> next_cell(const world::Section& section, std::span<const SectionColumn> columns,
                                       std::size_t from) {
  for (std::size_t i = from; i < columns.size(); ++i)
    if (takes_typing(section, columns[i])) return columns[i];
  return std::nullopt;
}

void typed_cell(Ui& ui, const SelectedSections& chosen, std::span<const SectionColumn> columns, std::size_t at,
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

// Finds the cell of the active section's row that the keyboard asks for. Call it once a frame, before the rows.
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

// True if a cell of the section is being edited.
bool cell_is_open(const Ui& ui, world::EntityName section) {
  return ui.inputs.cell && ui.inputs.cell->section == section;
}
bool cell_is_open(const Ui& ui, world::EntityName section, SectionColumn column) {
  return cell_is_open(ui, section) && ui.inputs.cell->column == column;
}

// Call after table_row(): registers the row's editable cells, as "q2/Height" (kind "cell"), opens one on a double
// click, and shows the field of the one being edited.
void row_cells(Ui& ui, const world::SectionRun& run, std::span<const SectionColumn> columns) {
  const edit::Session& session = ui.session();
  const world::Section& section = world::section(session.document, run.section);
  const world::EntityName name = world::name_of(session.document, run.section);
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
    if (mouse_over(low, high) && ImGui::IsMouseDoubleClicked(0)) ui.inputs.cell = EditedCell{name, columns[i]};
  }
}

using sim::SectionFigures;
using world::Document;

constexpr std::size_t kSectionColumnCount = base::count_of<SectionColumn>();

// A column's unit, its decimals, its width in design px, and its rank among the columns if not all fit.
struct ColumnLook {
  std::string_view unit;
  int decimals;
  float width;
  int rank;
};
constexpr std::array<ColumnLook, kSectionColumnCount> kLooks{{{"", 0, 30, 15},
                                                              {"", 0, 104, 0},
                                                              {"", 0, 90, 9},
                                                              {"m", 1, 62, 1},
                                                              {"m", 1, 62, 5},
                                                              {"m", 1, 62, 6},
                                                              {"deg", 1, 60, 7},
                                                              {"m", 1, 60, 11},
                                                              {"m", 1, 60, 12},
                                                              {"m", 1, 60, 10},
                                                              {"m/s", 1, 60, 2},
                                                              {"m/s", 1, 64, 8},
                                                              {"g", 2, 60, 3},
                                                              {"g", 2, 60, 13},
                                                              {"g", 2, 60, 14},
                                                              {"", 0, 80, 4}}};
const ColumnLook& column_look(SectionColumn column) { return kLooks[static_cast<std::size_t>(column)]; }

std::string equipment_words(const Document& document, const world::SectionRun& run) {
  const auto& all = document.track.segments;
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(run.first);
  const CommonEquipment found = equipped(document, {first, first + static_cast<std::ptrdiff_t>(run.count)});
  if (found.mixed) return "several";
  return found.equipment ? std::string(base::row_of(found.equipment->kind).label) : "";
}

// Words, a number, or nothing.
using TableValue = std::variant<std::monostate, std::string, double>;

TableValue table_value(const Document& document, const SectionFigures& of, std::size_t place, SectionColumn column) {
  const auto given = [](std::optional<double> value) { return value ? TableValue(*value) : TableValue(); };
  const world::Section& section = world::section(document, of.run.section);
  switch (column) {
    case SectionColumn::track: return static_cast<double>(place + 1);
    case SectionColumn::title: return world::title_of(section);
    case SectionColumn::kind:
      return std::string(section.kind == world::SectionKind::element ? base::row_of(section.element.kind).label
                                                                     : base::row_of(section.kind).label);
    case SectionColumn::length: return of.length;
    case SectionColumn::height:
    case SectionColumn::radius:
    case SectionColumn::angle: return given(planned_value(section, world::parameter_of(column)));
    case SectionColumn::start: return of.start;
    case SectionColumn::end: return of.end;
    case SectionColumn::top: return of.top;
    case SectionColumn::speed_in: return given(of.speed_in);
    case SectionColumn::speed_out: return given(of.speed_out);
    case SectionColumn::g_most: return given(of.g_most);
    case SectionColumn::g_least: return given(of.g_least);
    case SectionColumn::g_side: return given(of.g_side);
    case SectionColumn::equipment: return equipment_words(document, of.run);
  }
  return {};
}

// Returns the rows in the selected order; those without a value come last.
const std::vector<std::size_t>& sorted_rows(Ui& ui, const sim::SectionTable& table) {
  const world::Panels& shown = *ui.session().settings.panels;
  return ui.inputs.section_order.get({table.serial, shown.sections_by, shown.sections_descending}, [&] {
    std::vector<TableValue> entries;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      entries.push_back(table_value(ui.session().document, table.rows[i], i, shown.sections_by));
    std::vector<std::size_t> order(table.rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto missing = [&](std::size_t i) { return std::holds_alternative<std::monostate>(entries[i]); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (missing(a) || missing(b)) return !missing(a) && missing(b);
      return shown.sections_descending ? entries[b] < entries[a] : entries[a] < entries[b];
    });
    return order;
  });
}

// Returns the columns that fit, in order, and in any case the one of the first rank.
std::vector<SectionColumn> columns_in(float room, float scale) {
  std::vector<SectionColumn> by_rank(kSectionColumnCount), fitting;
  for (std::size_t i = 0; i < kSectionColumnCount; ++i)
    by_rank[static_cast<std::size_t>(kLooks[i].rank)] = static_cast<SectionColumn>(i);
  for (const SectionColumn column : by_rank) {
    room -= column_look(column).width * scale;
    if (room < 0 && !fitting.empty()) break;
    fitting.push_back(column);
  }
  std::sort(fitting.begin(), fitting.end());
  return fitting;
}

Cell section_cell(const Ui& ui, const TableValue& entry, SectionColumn column) {
  if (const auto* const words = std::get_if<std::string>(&entry)) return {*words, palette().text, true};
  if (const auto* const value = std::get_if<double>(&entry))
    return {digits(ui, *value, column_look(column).decimals, column_look(column).unit), palette().text};
  return {"--", palette().dim};
}

// A click selects one, Shift adds or removes it, Ctrl adds all rows between it and the active one, in the order on
// screen.
void select_section_row(Ui& ui, const sim::SectionTable& table, std::span<const std::size_t> order, std::size_t at) {
  const edit::Session& session = ui.session();
  const auto section = [&](std::size_t i) { return table.rows[order[i]].run.section; };
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyShift) return ui.out.commands.push_back(toggled(session, section(at)));
  std::size_t from = at;
  if (io.KeyCtrl)
    for (std::size_t i = 0; i < order.size(); ++i)
      if (section(i) == session.settings.selected) from = i;
  std::vector<world::Entity> sections;
  if (io.KeyCtrl) sections = world::selected_sections(session.document, session.settings);
  for (std::size_t i = std::min(from, at); i <= std::max(from, at); ++i)
    if (std::find(sections.begin(), sections.end(), section(i)) == sections.end()) sections.push_back(section(i));
  std::erase(sections, section(at));
  sections.push_back(section(at));
  ui.out.commands.push_back(selection_of(session.document, sections));
}

// Marks the section's middle in the view while the mouse is over its row.
void point_at_section(Ui& ui, const world::SectionRun& run) {
  const sim::DerivedTrack& derived = ui.session().derived;
  const std::size_t middle = run.first + run.count / 2;
  ui.pointed = {view::PickKind::curve, derived.order[middle], 0.5,
                glm::vec3(curve::point(derived.shape_at(middle).key.cubic, 0.5))};
}

// Scrolls to the row of the cell to be edited.
void scroll_to_cell(const Ui& ui, const sim::SectionTable& table, std::span<const std::size_t> order, float height) {
  const auto at = std::find_if(order.begin(), order.end(), [&](std::size_t row) {
    return cell_is_open(ui, world::name_of(ui.session().document, table.rows[row].run.section));
  });
  const auto rows_above = static_cast<float>(at - order.begin());
  ImGui::SetScrollY(std::max(0.0f, (rows_above + 1) * height - ImGui::GetWindowHeight() / 2));
}

void table_of_sections(Ui& ui, float height) {
  const sim::SectionTable& table = ui.find.sections();
  if (table.rows.empty()) return tinted("No sections yet. Place an element from the palette.", palette().dim);
  const Document& document = ui.session().document;
  const world::Panels& shown = *ui.session().settings.panels;
  const std::vector<SectionColumn> columns = columns_in(ImGui::GetContentRegionAvail().x, ui.scale);
  std::vector<TableColumn> heads;
  Sorting sorting{-1, shown.sections_descending, {}};
  for (const SectionColumn column : columns) {
    const base::NameRow& row = base::row_of(column);
    if (column == shown.sections_by) sorting.column = static_cast<int>(heads.size());
    const bool words =
        column == SectionColumn::title || column == SectionColumn::kind || column == SectionColumn::equipment;
    heads.push_back({row.label, column_look(column).unit, column_look(column).width, row.help, words});
  }
  if (!begin_table(ui, "Table", heads, height, &sorting)) return;
  take_answer(ui);
  begin_cell(ui, columns);
  bool sought = ui.inputs.cell.has_value();  // the edited cell is in none of the rows so far
  const std::vector<std::size_t>& order = sorted_rows(ui, table);
  const float row_height = each_row_in_sight(order.size(), [&](std::size_t at) {
    const std::size_t row = order[at];
    const SectionFigures& of = table.rows[row];
    const world::EntityName section = world::name_of(document, of.run.section);
    std::vector<Cell> cells;
    for (const SectionColumn column : columns) {
      cells.push_back(section_cell(ui, table_value(document, of, row, column), column));
      if (!refusal_of(ui, section, world::parameter_of(column)).empty()) cells.back().colour = palette().warning;
      if (cell_is_open(ui, section, column)) cells.back().text.clear();
    }
    const bool selected = world::is_selected(ui.session().settings, of.run.section);
    // A mark next to the colour of the row.
    if (selected) cells[0].swatch = palette().text;
    const std::string name = world::label_of(document, of.run.section);
    const bool typing = cell_is_open(ui, section);
    if (table_row(ui, name, cells, selected, selected ? "on" : "off", "", !typing))
      select_section_row(ui, table, order, at);
    if (ImGui::IsItemHovered()) point_at_section(ui, of.run);
    row_cells(ui, of.run, columns);
    sought = sought && !typing;
  });
  if (sought) scroll_to_cell(ui, table, order, row_height);
  end_table();
  if (!sorting.clicked) return;
  const SectionColumn by = columns[static_cast<std::size_t>(*sorting.clicked)];
  if (by != shown.sections_by) ui.emit(edit::Set<&world::Panels::sections_by>{by});
  ui.emit(edit::Set<&world::Panels::sections_descending>{by == shown.sections_by && !shown.sections_descending});
}

}  // namespace

void build_sections_table(Ui& ui, const view::Viewport& area) {
  const ImVec2 padding(std::floor(6 * ui.scale), 0);
  build_area(ui, area, {.id = "##sections", .panel = "Sections", .padding = padding},
             [&] { table_of_sections(ui, ImGui::GetContentRegionAvail().y); });
}

// The panel of the workspace `all`.
void sections_panel(Ui& ui) {
  constexpr float kRows = 9;
  table_of_sections(ui, std::floor(kRows * small_pixels() * 1.35f));
}

}  // namespace coaster::ui
