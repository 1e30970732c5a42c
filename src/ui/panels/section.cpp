// Section: the name, the parameters and the equipment of the selected sections.
#include <imgui.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_sections.h"
#include "sim/plan/force_plan.h"
#include "sim/study/riders.h"
#include "ui/context/query_widgets.h"
#include "ui/panels/element_equipment_fields.h"
#include "ui/panels/selected_sections.h"
#include "ui/tools/selecting.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "world/element_rows.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {

using world::Element;
using world::Entity;
using world::Section;
using world::SectionRun;

SelectedSections chosen_sections(const edit::Session& session) {
  return {session.document, session.settings.selected, world::selected_runs(session.document, session.settings)};
}

std::optional<double> planned_value(const Section& section, std::string_view parameter) {
  if (section.kind != world::SectionKind::element) return std::nullopt;
  return world::found_value(section.element, parameter);
}

// The first section is planned from the drag's start, so that a drag adds no rounding; the others on the result.
void change_sections(Ui& ui, const SelectedSections& chosen, std::string_view parameter, const Element& to) {
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

void ask_change(Ui& ui, world::EntityName section, std::string_view parameter) {
  ui.inputs.asked = {section, std::string(parameter), ui.session().notices.serial, false, {}};
}

void take_answer(Ui& ui) {
  SectionChangeRequest& asked = ui.inputs.asked;
  if (ui.state.waiting) return;
  if (std::exchange(asked.answered, true)) return;
  for (const edit::Notice& notice : ui.session().notices.list)
    if (notice.serial > asked.after && notice.kind != edit::NoticeKind::info && asked.refusal.empty())
      asked.refusal = notice.text;
}

std::string_view refusal_of(const Ui& ui, world::EntityName section, std::string_view parameter) {
  const SectionChangeRequest& asked = ui.inputs.asked;
  return asked.section == section && asked.parameter == parameter ? std::string_view(asked.refusal) : "";
}

namespace {

void refusal_below(Ui& ui, const SelectedSections& chosen, std::string_view parameter) {
  const std::string_view refusal = refusal_of(ui, chosen.name(), parameter);
  if (!refusal.empty()) paragraph(ui, "Refusal", refusal, palette().warning);
}

void kind_box(Ui& ui, const SelectedSections& chosen) {
  const Section& section = chosen.section();
  std::vector<Choice> kinds = choices_of<world::ElementKind>();
  kinds.resize(world::elements().size());
  const bool planned = section.kind == world::SectionKind::element;
  if (!planned) {
    const auto& row = base::row_of(section.kind);
    kinds.push_back({std::string(row.label), std::string(row.help)});
  }
  const int now = planned ? static_cast<int>(section.element.kind) : static_cast<int>(kinds.size()) - 1;
  const auto to =
      combo(ui, "Kind", kinds, now, "Plan the section as another element. The track that follows moves along.");
  if (to) {
    ask_change(ui, chosen.name(), "kind");
    ui.emit(edit::ChangeSection{{chosen.name()}, false, world::usual_element(static_cast<world::ElementKind>(*to))});
  }
  refusal_below(ui, chosen, "kind");
}

// True for a parameter that every selected section has. Those of equipment have buttons instead.
bool is_shared(const SelectedSections& chosen, std::string_view parameter) {
  const bool equips = world::found_value(chosen.section().element, "equipment").has_value();
  if (parameter == "equipment" || (equips && (parameter == "speed" || parameter == "acceleration"))) return false;
  return std::all_of(chosen.runs.begin(), chosen.runs.end(), [&](const world::SectionRun& run) {
    const Section& section = world::section(chosen.document, run.section);
    if (section.kind != world::SectionKind::element) return false;
    return parameter == "side" ? base::row_of(section.element.kind).sided
                               : world::found_value(section.element, parameter).has_value();
  });
}

void section_parameters(Ui& ui, const SelectedSections& chosen) {
  if (chosen.section().kind != world::SectionKind::element) return;
  Element element = chosen.section().element;
  const ElementRows rows{.shown = [&](std::string_view name) { return is_shared(chosen, name); },
                         .below = [&](std::string_view name) { refusal_below(ui, chosen, name); }};
  if (const auto changed = element_fields(ui, element, rows)) change_sections(ui, chosen, *changed, element);
}

// The keys are in the force graph.
void force_parameters(Ui& ui, const SelectedSections& chosen) {
  const world::ForceProgram& program = chosen.section().force;
  const Number length{.value = program.length,
                      .unit = world::unit_of(program.over).data(),
                      .low = world::shortest_of(program.over),
                      .high = world::longest_of(program.over)};
  if (const auto to = number(ui, "Asked length", length, "Length of the section, in metres or seconds."))
    ui.emit(edit::SetForceLength{{chosen.name()}, true, *to});
  const Number tolerance{.value = program.tolerance,
                         .unit = "g",
                         .step = 0.002,
                         .low = world::kLeastTolerance,
                         .high = world::kMostTolerance};
  if (const auto to = number(ui, "Tolerance", tolerance,
                             "Largest difference between what riders feel and the keys; of curvature, at 20 m/s. Less "
                             "needs more knots."))
    ui.emit(edit::SetForceTolerance{{chosen.name()}, *to});
  if (const auto to = combo_of(ui, "Keys of", program.of,
                               "Forces that riders feel, or the track's curvature. Keys take what the track has."))
    ui.emit(edit::SetForceQuantity{{chosen.name()}, *to});
  if (const auto to =
          combo_of(ui, "Keys over", program.over, "Unit of the keys: metres or seconds. Keys keep their positions."))
    ui.emit(edit::SetForceDomain{{chosen.name()}, *to});
  if (const auto on = checkbox(ui, "Keep both ends", program.hold,
                               "Neither end moves when keys change. The keys are met as nearly as that allows."))
    ui.emit(edit::HoldForceSectionEnds{{chosen.name()}, *on});
  const world::SectionRun& run = chosen.runs.front();
  const std::string uncounted = sim::uncounted_text(chosen.document, run, program);
  if (!uncounted.empty()) paragraph(ui, "Not counted", uncounted, palette().warning);
  const sim::ForcePlan* const plan = ui.find.force(run.section);
  if (plan == nullptr || !plan->refusal.empty()) return;
  if (const std::string stopped = sim::stop_text(*plan); !stopped.empty())
    paragraph(ui, "Stopped", base::sentence(stopped), palette().warning);
  const bool bends = program.of == world::ForceQuantity::curvature;
  if (!plan->fit.within) {
    read_out(
        ui, "Off by", plan->fit.felt_error, 2, "g",
        "Most that riders feel more or less than the keys say; of curvature, at 20 m/s. It is over the tolerance.");
    read_out(ui, "Off at", plan->fit.felt_at, 1, "m", "Where that is, from the section's start.");
  }
  if (!program.hold) return;
  read_out(ui, "Not met", plan->unmet, bends ? 4 : 2, bends ? "1/m" : "g",
           "Most that vertical or lateral is more or less than the keys say.");
  read_out(ui, "Not met at", plan->unmet_at, 1, world::unit_of(program.over),
           "Where that is, from the section's start.");
}

void section_equipment(Ui& ui, const SelectedSections& chosen) {
  std::vector<Entity> segments;
  const auto& all = chosen.document.track.segments;
  for (const world::SectionRun& run : chosen.runs)
    for (std::size_t i = run.first; i < run.end(); ++i) segments.push_back(all[i]);
  heading(ui, "Equipment", "Equipment of the whole section.");
  equipment_form(ui, segments, edit::EquipSection::kInfo.name, [&](const std::optional<world::Equipment>& to) {
    ui.emit_each(chosen.runs, [&](const world::SectionRun& run) {
      if (to) ui.emit(edit::EquipSection{{chosen.name(run)}, *to});
      else ui.emit(edit::UnequipSection{{chosen.name(run)}});
    });
  });
}

// True if the selected sections are neighbours.
bool in_a_row(const SelectedSections& chosen) {
  for (std::size_t i = 1; i < chosen.runs.size(); ++i)
    if (chosen.runs[i].first != chosen.runs[i - 1].end()) return false;
  return true;
}

// What is done with whole sections.
void section_buttons(Ui& ui, const SelectedSections& chosen) {
  const edit::Session& session = ui.session();
  const auto movable = [&](std::size_t knot) {
    return !chosen.document.track.closed || world::completing(chosen.document, knot);
  };
  const std::size_t end = chosen.runs.back().end();
  const bool first = chosen.runs.front().first == 0,
             last = chosen.runs.back().end() == chosen.document.track.segments.size();
  ButtonRows rows{ui, 2, "Move before"};
  const auto pressed = [&](std::string_view label, std::string_view help, std::string_view action, bool enabled) {
    return rows(label, with_keys(ui.keys, std::string(help), action), enabled);
  };
  const auto each = [&](const auto& make) {
    ui.emit_each(chosen.runs, [&](const world::SectionRun& run) { ui.emit(make(chosen.name(run))); });
  };
  if (pressed("Mirror", "Swap left and right. The track that follows moves along.", "Mirror section", true))
    each([](world::EntityName name) { return edit::MirrorSection{{name}}; });
  if (pressed("Join next", "Join the section with the next one. The result is hand-shaped.", "Join with next",
              chosen.single() && !last))
    ui.emit(edit::JoinSections{{chosen.name()}});
  if (pressed("Move before", "Swap the section with the one before it.", "Move section before",
              movable(end) && chosen.single() && !first))
    ui.emit(edit::MoveSection{{chosen.name()}, edit::Neighbour::before});
  if (pressed("Move after", "Swap the section with the one after it.", "Move section after",
              movable(end + 1) && chosen.single() && !last))
    ui.emit(edit::MoveSection{{chosen.name()}, edit::Neighbour::after});
  if (pressed("Copy", "Copy the sections.", "Copy section", true)) ui.out.commands.push_back(copying(session));
  if (pressed("Paste", "Add the copied sections at the open end of the track, or before the closing section.",
              "Paste section", movable(0)))
    ui.out.wants_paste = true;
  const bool of_forces = chosen.section().kind == world::SectionKind::force;
  if (of_forces && pressed("By hand###Shape by hand", "Make the section hand-shaped. Its knots stay, its keys go.", "",
                           chosen.single()))
    ui.emit(edit::FreeForceSection{{chosen.name()}});
  if ((!of_forces || !chosen.single()) &&
      pressed("Read forces", "Make it a force section of the same shape. What is felt becomes keys.", "",
              in_a_row(chosen)))
    ui.emit(edit::MakeForceSection{edit::Sections(chosen.names())});
  if (pressed("Delete", "Delete the sections. What follows moves to where they began.", "Delete", movable(end)))
    each([](world::EntityName name) { return edit::DeleteSection{{name}}; });
}

void section_figures_rows(Ui& ui, const SelectedSections& chosen) {
  const sim::SectionFigures& of = ui.find.sections().of(chosen.runs.front());
  read_out(ui, "Length", of.length, 1, "m", "Length of the section.");
  read_out(ui, "Height at start", of.start, 1, "m", "Height of the track where the section begins.");
  read_out(ui, "Height at end", of.end, 1, "m", "Height of the track where the section ends.");
  const auto of_ride = [&](std::string_view label, std::optional<double> value, int decimals, std::string_view unit,
                           std::string_view help) {
    if (value) read_out(ui, label, *value, decimals, unit, help);
    else read_out(ui, label, "--", "", "The ride does not reach this section.");
  };
  of_ride("Speed in", of.speed_in, 1, "m/s", "Speed where the section begins, of the chosen seat.");
  of_ride("Speed out", of.speed_out, 1, "m/s", "Speed where it ends.");
  of_ride("Most g", of.g_most, 2, "g", "Largest vertical felt g on it, of the chosen seat, not low-passed.");
  of_ride("Least g", of.g_least, 2, "g", "Least vertical felt g on it, not low-passed.");
}

}  // namespace

bool section_shown(const Ui& ui) {
  const edit::Session& session = ui.session();
  return session.document.entities.find<Section>(session.settings.selected) != nullptr;
}

void section_panel(Ui& ui) {
  const SelectedSections chosen = chosen_sections(ui.session());
  take_answer(ui);
  // Different ids for each section: text typed in a field of one never goes to the next.
  ImGui::PushID(static_cast<int>(chosen.name().number));
  if (chosen.single()) {
    const std::string& title = chosen.section().title;
    if (const auto to = text(ui, "Title", title, "Name of the section. Without one it is shown by its kind."))
      ui.emit(edit::SetSectionTitle{{chosen.name()}, *to});
    kind_box(ui, chosen);
  } else {
    read_out(ui, "Selected", fmt::format("{} sections", chosen.runs.size()), "",
             "A change applies to all of them. The values are those of the one selected last.");
  }
  section_parameters(ui, chosen);
  if (chosen.single() && chosen.section().kind == world::SectionKind::force) force_parameters(ui, chosen);
  section_equipment(ui, chosen);
  section_buttons(ui, chosen);
  if (chosen.single()) section_figures_rows(ui, chosen);
  section_paint(ui, chosen);
  section_earthwork(ui, chosen);
  ImGui::PopID();
}

}  // namespace coaster::ui
