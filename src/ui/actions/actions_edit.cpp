// The menu Edit, and Escape.
#include <imgui.h>
#include <imgui_internal.h>

#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_session.h"
#include "ui/actions/actions_parts.h"
#include "ui/context/ways_home.h"
#include "ui/tools/palette_element.h"
#include "ui/tools/places.h"
#include "world/element_rows.h"
#include "world/panels.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::ui {
namespace {

using platform::Key;
using world::Aids;
using world::Kind;

constexpr Condition kRemovable{
    [](const Act& act) { return selected(act) != nullptr && !selected_is(act, Kind::segment); },
    "Select a knot, a section or a train first."};
constexpr Condition kKnotSelected{[](const Act& act) { return selected_is(act, Kind::knot); }, "Select a knot first."};
constexpr Condition kAnyKnots{[](const Act& act) { return !act.ui.session().document.track.knots.empty(); },
                              "The track has no knots."};
constexpr Condition kCanUndo{
    [](const Act& act) { return !act.ui.session().history.undo.empty() || act.ui.session().history.in_gesture; },
    "There is nothing to undo."};
constexpr Condition kCanRedo{[](const Act& act) { return !act.ui.session().history.redo.empty(); },
                             "There is nothing to redo."};

constexpr Condition kInsertable{
    [](const Act& act) { return act.hovered.kind == view::PickKind::curve || selected_is(act, Kind::segment); },
    "Point at the track or select a segment first."};

// Cancels a drag in the viewport or in a number field. Returns false if no drag changes the document.
bool cancel_drags(Act& act) {
  if (act.tool.cancel(act.ui)) return true;
  if (!act.ui.gesture.open) return false;
  act.ui.emit(edit::CancelGesture{});
  act.ui.gesture = {};
  ImGui::ClearActiveID();
  return true;
}

void undo(Act& act) {
  if (!cancel_drags(act)) act.ui.emit(edit::Undo{});
}
void remove(Act& act) {
  const edit::Session& session = act.ui.session();
  const std::vector<world::Entity> knots = world::selected_knots(session.document, session.settings);
  if (selected_is(act, Kind::section)) return delete_sections(act);
  if (knots.size() < 2) return act.ui.emit(edit::RemoveKnot{{*selected(act)}});
  act.ui.emit(edit::BeginGesture{});
  for (const world::Entity e : knots) act.ui.emit(edit::RemoveKnot{{world::name_of(session.document, e)}});
  act.ui.emit(edit::EndGesture{});
}
// Shows the panel in Build, or where every panel shows.
void set_goal(Act& act) {
  if (!is<&world::Panels::workspace, world::Workspace::all>(act)) choose_workspace(act.ui, world::Workspace::build);
  if (!act.ui.drawers.parameters.open) act.ui.drawers.parameters.wanted = true;
  act.ui.inputs.panel_to_open = "Goal";
}
void select_all(Act& act) { act.ui.emit(edit::SelectKnots{edit::Knots::Which::all}); }
void box_select(Act& act) { act.tool.wait_for_box(); }
template <TransformKind kind>
void transform(Act& act) {
  act.tool.transform().begin(act.ui, kind, {}, std::nullopt);
}

bool snapping(const Act& act) { return act.ui.session().settings.snapping.to != world::SnapTo::off; }
void next_snapping(Act& act) {
  const world::Snapping& s = act.ui.session().settings.snapping;
  act.ui.emit(edit::SetSnapping{base::next_of(s.to), s.step, s.angle});
}

void escape(Act& act) {
  if (cancel_drags(act) || act.ui.state.job.progress) return;  // the job's card takes it
  if (card_shows(act.ui.session())) act.ui.emit(edit::CloseCard{});
  else if (on<&Aids::append_mode>(act)) toggle<&Aids::append_mode>(act);
  else if (act.ui.session().settings.aids->circuit > 0) act.ui.emit(edit::Set<&Aids::circuit>{0});
  else if (on<&Aids::show_element>(act)) toggle<&Aids::show_element>(act);
  else if (selected(act) != nullptr) act.ui.emit(edit::Select{});
}

void insert_point(Act& act) {
  const edit::Session& session = act.ui.session();
  if (act.hovered.kind == view::PickKind::curve && session.document.entities.alive(act.hovered.entity))
    act.ui.emit(edit::SplitSegment{{world::name_of(session.document, act.hovered.entity)}, act.hovered.t});
  else if (selected_is(act, Kind::segment))
    act.ui.emit(edit::SplitSegment{{*selected(act)}, session.settings.selected_t});
}

// True if the preview of the palette's element or of a way home shows.
bool preview_shows(const Act& act) {
  return on<&Aids::show_element>(act) || act.ui.session().settings.aids->circuit > 0;
}

// True if a cell of the table of sections can be edited and no preview waits to be placed.
bool has_cell(const Act& act) {
  const bool shows = is<&world::Panels::workspace, world::Workspace::build>(act) && act.ui.drawers.table;
  return shows && act.ui.drawers.graph.open && !preview_shows(act) && selected_is(act, Kind::section);
}
// What does not fit is refused with the reason.
constexpr Condition kPlaceable{[](const Act& act) { return preview_shows(act) || has_cell(act); },
                               "Choose an element first."};
void place_element(Act& act) {
  if (has_cell(act)) act.ui.inputs.cell = EditedCell{*selected(act), {}};
  else if (act.ui.session().settings.aids->circuit > 0) place_way_home(act.ui);
  else place_shown_element(act.ui);
}

constexpr Condition kAppendable{[](const Act& act) { return append_mode_switches(act.ui.session()); },
                                world::kClosedTrack};

constexpr Condition kCompletable{[](const Act& act) { return completable(act.ui.session().document); },
                                 "Only an open track with a segment can be completed."};
void complete_circuit(Act& act) { show_ways_home(act.ui); }

// Steps among the shapes or among the force elements. The first press shows the preview of the present one, on an empty
// track that of a straight, where a ride begins.
void step_element(Act& act, bool forwards) {
  if (act.ui.session().settings.aids->circuit > 0) act.ui.emit(edit::Set<&Aids::circuit>{0});
  const auto kind = act.ui.session().settings.element.kind;
  if (!on<&Aids::show_element>(act))
    return choose_element(act.ui, act.ui.session().document.track.knots.empty() ? world::ElementKind::straight : kind);
  const bool of_forces = world::is_of_forces(kind);
  const std::size_t first = of_forces ? world::elements().size() : 0,
                    count = of_forces ? world::force_elements().size() : world::elements().size();
  const std::size_t next = first + (static_cast<std::size_t>(kind) - first + (forwards ? 1 : count - 1)) % count;
  choose_element(act.ui, static_cast<world::ElementKind>(next));
}
void next_element(Act& act) { step_element(act, true); }
void previous_element(Act& act) { step_element(act, false); }

constexpr Action kEditActions[] = {
    {"Undo", "Edit", ctrl(Key::z), kRepeats | kInDrag, "Undo the last step. Cancels a drag in progress.", undo,
     kCanUndo},
    {"Redo", "Edit", ctrl(Key::y), kRepeats, "Redo the last undone step.", emit<edit::Redo>, kCanRedo, nullptr,
     ctrl_shift(Key::z)},
    {"Delete", "Edit", key(Key::del), 0, "Delete the selected knot, section or train.", remove, kRemovable, nullptr,
     key(Key::x)},
    {"Select all", "Edit/Select", ctrl(Key::a), 0, "Select every knot.", select_all, kAnyKnots},
    {"Box select", "Edit/Select", key(Key::b), 0, "Drag a box around knots. Shift+drag adds, Ctrl+drag removes.",
     box_select, kAnyKnots},
    {"Move", "Edit/Transform", key(Key::g), 0,
     "Move the selected knots. X, Y, Z: along an axis. Shift+axis: in a plane. Or type a number.",
     transform<TransformKind::move>, kKnotSelected},
    {"Rotate", "Edit/Transform", key(Key::r), 0,
     "Rotate the selected knots about their centre. X, Y, Z: about an axis. Type degrees.",
     transform<TransformKind::rotate>, kKnotSelected},
    {"Scale", "Edit/Transform", key(Key::s), 0,
     "Scale the selected knots and their handles. X, Y, Z: along an axis. Type a factor.",
     transform<TransformKind::scale>, kKnotSelected},
    {"Next snapping", "Edit/Transform", shift(Key::tab), 0,
     "Snap to nothing, the grid, knots or the ground. Ctrl while dragging inverts snapping.", next_snapping, kAlways,
     snapping},
    {"Select none", "Edit/Select", kNoKey, 0, "Clear the selection. Key Escape.", emit<edit::Select>, kAnySelected},
    {"Add curve", "Edit", key(Key::c), 0, "Split the longest segment at half its length. The shape is unchanged.",
     emit<edit::AddCurve>},
    {"Insert point", "Edit", key(Key::i), 0,
     "Insert a knot under the cursor or at the selected position. The shape is unchanged.", insert_point, kInsertable},
    {"Append points", "Edit", key(Key::a), 0, "Click on the ground to append knots to an open track.",
     toggle<&Aids::append_mode>, kAppendable, on<&Aids::append_mode>},
    {"Place element", "Edit", key(Key::enter), 0,
     "Place the previewed element at the open end of the track, or the previewed closing section. Without a preview: "
     "type in "
     "the selected row of the table of sections.",
     place_element, kPlaceable, nullptr, key(Key::keypad_enter)},
    {"Complete circuit", "Edit", shift(Key::c), 0,
     "Propose closing sections, from the open end of the track to its first knot.", complete_circuit, kCompletable},
    {"Next element", "Edit", key(Key::n), kRepeats, "Choose the next element of the palette and show its preview.",
     next_element},
    {"Previous element", "Edit", shift(Key::n), kRepeats,
     "Choose the previous element of the palette and show its preview.", previous_element},
    {"Goal", "Edit", kNoKey, 0, "Let the program change numbers of the selection until the ride reaches a goal.",
     set_goal, kAnySelected},

    {"Cancel", "", key(Key::escape), kInDrag,
     "Cancel a drag, close the score card, end append mode, hide the preview, or clear the selection.", escape},
};

}  // namespace

std::span<const Action> edit_actions() { return kEditActions; }

}  // namespace coaster::ui
