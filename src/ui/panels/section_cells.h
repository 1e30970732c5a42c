// The editable cells of the table of sections: parameters of planned sections.
#pragma once

#include <span>

#include "sim/study/section_figures.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// True for an editable cell, which shows a parameter of its section.
bool takes_typing(const world::Section& section, world::SectionColumn column);

// Finds the cell of the active section's row that the keyboard asks for. Call it once a frame, before the rows.
void begin_cell(Ui& ui, std::span<const world::SectionColumn> columns);
// True if a cell of the section is being edited.
bool cell_is_open(const Ui& ui, world::Name section);
bool cell_is_open(const Ui& ui, world::Name section, world::SectionColumn column);

// Call after table_row(): registers the row's editable cells, as "q2/Height" (kind "cell"), opens one on a double
// click, and shows the field of the one being edited.
void row_cells(Ui& ui, const world::SectionRun& run, std::span<const world::SectionColumn> columns);

}  // namespace coaster::ui
