// The cells of the table of sections that are typed in: parameters of planned sections.
#pragma once

#include <span>

#include "sim/study/section_figures.h"
#include "ui/context/ui.h"

namespace coaster::ui {

// True for a cell that shows a parameter of its section.
bool takes_typing(const world::Section& section, world::SectionColumn column);

// Resolves which cell of the active section's row the keyboard asked for. Call it once a frame, before the rows.
void begin_cell(Ui& ui, std::span<const world::SectionColumn> columns);
// True if a cell of the section is typed in.
bool cell_is_open(const Ui& ui, world::Name section);
bool cell_is_open(const Ui& ui, world::Name section, world::SectionColumn column);

// After table_row(): registers the row's cells that can be typed in, as "q2/Height" (kind "cell"), opens one on a
// double click, and shows the field of the one that is typed in.
void row_cells(Ui& ui, const world::SectionRun& run, std::span<const world::SectionColumn> columns);

}  // namespace coaster::ui
