// The selected sections and changes of their parameters, by panel and table.
#pragma once

#include <string_view>
#include <vector>

#include "ui/context/ui.h"
#include "view/camera.h"
#include "world/sections.h"

namespace coaster::ui {

// The selected sections.
struct SelectedSections {
  const world::Document& document;
  world::Entity active;
  std::vector<world::SectionRun> runs;  // in the track's order
  bool single() const { return runs.size() == 1; }
  const world::Section& section() const { return world::section(document, active); }
  world::EntityName name() const { return world::name_of(document, active); }
  world::EntityName name(const world::SectionRun& run) const { return world::name_of(document, run.section); }
  std::vector<world::EntityName> names() const {
    std::vector<world::EntityName> all;
    for (const world::SectionRun& run : runs) all.push_back(name(run));
    return all;
  }
};
SelectedSections chosen_sections(const edit::Session& session);

// Returns the parameter of a planned section that has it; nothing for other sections.
std::optional<double> planned_value(const world::Section& section, std::string_view parameter);

// Sets the parameter of the selected sections that have it to its value in `to`; "side" is left or right.
void change_sections(Ui& ui, const SelectedSections& chosen, std::string_view parameter, const world::Element& to);

// Records the field that requests a change, for refusal_of().
void ask_change(Ui& ui, world::EntityName section, std::string_view parameter);
// Reads the answer to the last requested change: the notice that followed it. Call it each frame, before refusal_of().
void take_answer(Ui& ui);
// Returns the reason if the last change was refused and was one of this parameter of this section; else "".
std::string_view refusal_of(const Ui& ui, world::EntityName section, std::string_view parameter);

// Shows the paint of the selected sections, in the Section panel.
void section_paint(Ui& ui, const SelectedSections& chosen);
// Shows what is done to the land where they run below it, if there is a land.
void section_earthwork(Ui& ui, const SelectedSections& chosen);

// Builds the table of sections over `area`, in Build.
void build_sections_table(Ui& ui, const view::Viewport& area);

}  // namespace coaster::ui
