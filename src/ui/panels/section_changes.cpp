#include "ui/panels/section_changes.h"

#include <algorithm>
#include <utility>

#include "edit/commands/commands_sections.h"
#include "world/selection.h"

namespace coaster::ui {

using world::Element;
using world::Entity;
using world::Section;
using world::SectionRun;

Chosen chosen_sections(const edit::Session& session) {
  std::vector<Entity> selected = world::selected_sections(session.document, session.settings);
  std::sort(selected.begin(), selected.end(), [](Entity a, Entity b) { return a.index < b.index; });
  Chosen chosen{session.document, session.settings.selected, {}};
  for (const SectionRun& run : world::sections_of(session.document))
    if (std::binary_search(selected.begin(), selected.end(), run.section,
                           [](Entity a, Entity b) { return a.index < b.index; }))
      chosen.runs.push_back(run);
  return chosen;
}

std::optional<double> planned_value(const Section& section, std::string_view parameter) {
  if (section.kind != world::SectionKind::element) return std::nullopt;
  return world::found_value(section.element, parameter);
}

// The first section is planned from the drag's start, so that a drag adds no rounding; the others on the result.
void change_sections(Ui& ui, const Chosen& chosen, std::string_view parameter, const Element& to) {
  ask_change(ui, chosen.name(), parameter);
  std::vector<SectionRun> runs = chosen.runs;
  std::erase_if(runs, [&](const SectionRun& run) {
    return parameter != "side" && !planned_value(world::section(chosen.document, run.section), parameter);
  });
  bool first = true;
  ui.emit_each(runs, [&](const SectionRun& run) {
    Element one = run.section == chosen.active ? to : world::section(chosen.document, run.section).element;
    if (run.section != chosen.active && parameter == "side") one.right = to.right;
    else if (run.section != chosen.active) world::set_value(one, parameter, world::value_of(to, parameter));
    ui.emit(edit::ChangeSection{{chosen.name(run)}, std::exchange(first, false), one});
  });
}

void ask_change(Ui& ui, world::Name section, std::string_view parameter) {
  ui.inputs.asked = {section, std::string(parameter), ui.session().notices.serial, false, {}};
}

void take_answer(Ui& ui) {
  AskedChange& asked = ui.inputs.asked;
  if (ui.state.waiting) return;
  if (std::exchange(asked.answered, true)) return;
  for (const edit::Notice& notice : ui.session().notices.list)
    if (notice.serial > asked.after && notice.kind != edit::NoticeKind::info && asked.refusal.empty())
      asked.refusal = notice.text;
}

std::string_view refusal_of(const Ui& ui, world::Name section, std::string_view parameter) {
  const AskedChange& asked = ui.inputs.asked;
  return asked.section == section && asked.parameter == parameter ? std::string_view(asked.refusal) : "";
}

}  // namespace coaster::ui
