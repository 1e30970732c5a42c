// Actions on sections, in the menu Edit or only in the command palette.
#include <algorithm>

#include "edit/commands/commands_force.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_settings.h"
#include "ui/actions/actions_parts.h"
#include "ui/tools/section_clicks.h"
#include "ui/tools/selecting.h"
#include "world/aids.h"
#include "world/panels.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

using platform::Key;
using world::Entity;
using world::EquipmentKind;

// Returns the section under the cursor, else that of the selected knot or segment; kNone without one.
Entity section_here(const Act& act) {
  const edit::Session& session = act.ui.session();
  if (const Entity under = section_under(session, act.hovered); under.valid()) return under;
  const Entity selected = session.settings.selected;
  if (const auto* const segment = session.document.entities.find<world::Segment>(selected)) return segment->section;
  const bool knot = session.document.entities.find<world::Knot>(selected) != nullptr;
  return knot ? world::section_of_knot(session.document, selected) : world::kNone;
}
constexpr Condition kInSection{[](const Act& act) { return section_here(act).valid(); },
                               "Point at the track, or select a knot or a segment first."};
void select_section(Act& act) {
  act.ui.emit(edit::Select{{world::name_of(act.ui.session().document, section_here(act))}});
}

constexpr Condition kHasSections{[](const Act& act) { return !act.ui.session().document.track.segments.empty(); },
                                 "The track has no sections."};
// Steps from the active section, else from the one with something selected; without one to the first or the last. A
// closed track goes on at its other end.
void step_section(Act& act, bool on, bool adds) {
  const edit::Session& session = act.ui.session();
  const std::vector<world::SectionRun> runs = world::sections_of(session.document);
  Entity from = session.settings.selected;
  const bool among = selected_is(act, world::Kind::section);
  if (!among) from = section_here(act);
  const auto at =
      std::find_if(runs.begin(), runs.end(), [&](const world::SectionRun& run) { return run.section == from; });
  auto to = on ? runs.begin() : runs.end() - 1;
  if (at != runs.end()) {
    const bool at_end = on ? at + 1 == runs.end() : at == runs.begin();
    if (at_end && !session.document.track.closed)
      return act.ui.warn(on ? "This is the last section." : "This is the first section.");
    if (!at_end) to = on ? at + 1 : at - 1;
  }
  std::vector<Entity> sections;
  if (adds) sections = world::selected_sections(session.document, session.settings);
  std::erase(sections, to->section);
  sections.push_back(to->section);
  act.ui.out.commands.push_back(selection_of_sections(session.document, sections));
}
template <bool on, bool adds>
void step(Act& act) {
  step_section(act, on, adds);
}

// Emits a command for each selected section, as one step of undo.
template <class Make>
void for_each_section(Act& act, const Make& make) {
  const edit::Session& session = act.ui.session();
  act.ui.emit_each(world::selected_sections(session.document, session.settings),
                   [&](Entity e) { act.ui.emit(make(world::name_of(session.document, e))); });
}
template <class Command>
void each(Act& act) {
  for_each_section(act, [](world::Name name) { return Command{{name}}; });
}
template <EquipmentKind kind>
void equip(Act& act) {
  for_each_section(act, [](world::Name name) { return edit::EquipSection{{name}, {kind}}; });
}
template <edit::Neighbour to>
void move(Act& act) {
  act.ui.emit(edit::MoveSection{{*selected(act)}, to});
}
void join(Act& act) { act.ui.emit(edit::JoinSections{{*selected(act)}}); }
void copy(Act& act) { act.ui.out.commands.push_back(copying(act.ui.session())); }
void paste(Act& act) { act.ui.out.wants_paste = true; }

// Gives the keyboard to the first number field of Build; Tab moves to the next.
constexpr Condition kHasValues{
    [](const Act& act) { return selected(act) != nullptr || on<&world::Aids::show_element>(act); },
    "Choose an element or select something first."};
void edit_values(Act& act) {
  Ui& ui = act.ui;
  if (is<&world::Panels::workspace, world::Workspace::build>(act) && !ui.drawers.parameters.open)
    ui.drawers.parameters.toggle();
  if (ui.wish)
    ui.wish->panel = on<&world::Aids::show_element>(act)      ? "Elements"
                     : selected_is(act, world::Kind::section) ? "Section"
                                                              : "Inspector";
}

constexpr Condition kOpenTrack{[](const Act& act) {
                                 const world::Track& track = act.ui.session().document.track;
                                 return !track.closed && !track.segments.empty();
                               },
                               "Only an open track with a segment can be continued."};

constexpr Action kSectionActions[] = {
    {"Edit values", "Edit", key(Key::p), 0,
     "Type the first value of the chosen element or the selection. Tab: the next.", edit_values, kHasValues},
    {"Add force section", "Edit", kNoKey, 0, "Add a section at the open end whose forces you draw in the force graph.",
     emit<edit::AddForce>, kOpenTrack},
    {"Select section", "Edit/Select", ctrl_shift(Key::a), 0, "Select the section of the track under the cursor.",
     select_section, kInSection},
    {"Next section", "Edit/Select", key(Key::page_down), kRepeats, "Select the next section of the track.",
     step<true, false>, kHasSections},
    {"Previous section", "Edit/Select", key(Key::page_up), kRepeats, "Select the previous section.", step<false, false>,
     kHasSections},
    {"Add next section", "", shift(Key::page_down), kRepeats, "Add the next section to the selection.",
     step<true, true>, kHasSections},
    {"Add previous section", "", shift(Key::page_up), kRepeats, "Add the previous section to the selection.",
     step<false, true>, kHasSections},
    {"Copy section", "Edit", ctrl(Key::c), 0,
     "Copy the selected sections. Another window of the program can paste them.", copy, kSectionSelected},
    {"Paste section", "Edit", ctrl(Key::v), 0,
     "Add the copied sections at the open end of the track, or open a copied link.", paste},
    {"Mirror section", "", kNoKey, 0, "Swap left and right of the selected sections.", each<edit::MirrorSection>,
     kSectionSelected},
    {"Move section before", "", ctrl(Key::page_up), 0, "Swap the selected section with the one before it.",
     move<edit::Neighbour::before>, kSectionSelected},
    {"Move section after", "", ctrl(Key::page_down), 0, "Swap the selected section with the one after it.",
     move<edit::Neighbour::after>, kSectionSelected},
    {"Join with next", "", kNoKey, 0, "Make one hand-shaped section of the selected one and the next.", join,
     kSectionSelected},
    {"Make station", "", kNoKey, 0, "Make the selected sections a station.", equip<EquipmentKind::station>,
     kSectionSelected},
    {"Make lift", "", kNoKey, 0, "Make the selected sections a lift.", equip<EquipmentKind::lift>, kSectionSelected},
    {"Make launch", "", kNoKey, 0, "Make the selected sections a launch.", equip<EquipmentKind::launch>,
     kSectionSelected},
    {"Make brake", "", kNoKey, 0, "Make the selected sections a brake.", equip<EquipmentKind::brake>, kSectionSelected},
    {"Make block", "", kNoKey, 0, "Make the selected sections a block.", equip<EquipmentKind::block>, kSectionSelected},
    {"Make plain track", "", kNoKey, 0, "Remove the equipment of the selected sections.", each<edit::UnequipSection>,
     kSectionSelected},
};

}  // namespace

void delete_sections(Act& act) { each<edit::DeleteSection>(act); }

std::span<const Action> section_actions() { return kSectionActions; }

}  // namespace coaster::ui
