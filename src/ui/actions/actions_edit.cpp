// The menu Edit, and Escape.
#include <imgui.h>
#include <imgui_internal.h>

#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "ui/actions/actions_parts.h"
#include "ui/tools/places.h"
#include "world/aids.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

using platform::Key;
using world::Kind;

bool removable(const Act& act) { return any_selected(act) && selected(act)->kind != Kind::segment; }
bool knot_selected(const Act& act) { return any_selected(act) && selected(act)->kind == Kind::knot; }
bool any_knots(const Act& act) { return !act.ui.session().document.track.knots.empty(); }
bool can_undo(const Act& act) { return !act.ui.session().history.undo.empty() || act.ui.session().history.in_gesture; }
bool can_redo(const Act& act) { return !act.ui.session().history.redo.empty(); }

bool insertable(const Act& act) {
  return act.hovered.kind == view::PickKind::curve || (any_selected(act) && selected(act)->kind == Kind::segment);
}
bool appending(const Act& act) { return act.ui.session().settings.aids->append_mode; }

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
void redo(Act& act) { act.ui.emit(edit::Redo{}); }
void remove(Act& act) {
  const edit::Session& session = act.ui.session();
  const std::vector<world::Entity> knots = world::selected_knots(session.document, session.settings);
  if (knots.size() < 2) return act.ui.emit(edit::RemoveKnot{{*selected(act)}});
  act.ui.emit(edit::BeginGesture{});
  for (const world::Entity e : knots) act.ui.emit(edit::RemoveKnot{{world::name_of(session.document, e)}});
  act.ui.emit(edit::EndGesture{});
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

void select_none(Act& act) { act.ui.emit(edit::Select{}); }

void escape(Act& act) {
  if (cancel_drags(act)) return;
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) {
    ImGui::ClosePopupToLevel(0, true);
  } else if (card_shows(act.ui.session())) {
    act.ui.emit(edit::CloseCard{});
  } else if (appending(act)) {
    act.ui.emit(edit::Set<&world::Aids::append_mode>{false});
  } else if (act.ui.session().settings.aids->show_element) {
    act.ui.emit(edit::Set<&world::Aids::show_element>{false});
  } else if (any_selected(act)) {
    select_none(act);
  }
}

void insert_point(Act& act) {
  const edit::Session& session = act.ui.session();
  if (act.hovered.kind == view::PickKind::curve && session.document.entities.alive(act.hovered.entity))
    act.ui.emit(edit::SplitSegment{{world::name_of(session.document, act.hovered.entity)}, act.hovered.t});
  else if (any_selected(act) && selected(act)->kind == Kind::segment)
    act.ui.emit(edit::SplitSegment{{*selected(act)}, session.settings.selected_t});
}
void add_curve(Act& act) { act.ui.emit(edit::AddCurve{}); }
void toggle_append(Act& act) { act.ui.emit(edit::Set<&world::Aids::append_mode>{!appending(act)}); }

// The palette's element, where its preview shows.
bool placeable(const Act& act) {
  return act.ui.session().settings.aids->show_element && act.ui.find(edit::Want::element).element->refusal.empty();
}
void place_element(Act& act) { act.ui.emit(edit::PlaceElement{act.ui.session().settings.element}); }

constexpr Action kEditActions[] = {
    {"Undo", "Edit", "Ctrl+Z", ctrl(Key::z), kNoKey, true, true, "Undo the last step. Cancels a drag in progress.",
     can_undo, nullptr, undo},
    {"Redo",
     "Edit",
     "Ctrl+Y",
     ctrl(Key::y),
     {Key::z, {.shift = true, .ctrl = true}},
     true,
     false,
     "Redo the last undone step.",
     can_redo,
     nullptr,
     redo},
    {"Delete", "Edit", "Delete", key(Key::del), key(Key::x), false, false, "Delete the selected knot or cart.",
     removable, nullptr, remove},
    {"Select all", "Edit", "Ctrl+A", ctrl(Key::a), kNoKey, false, false, "Select every knot.", any_knots, nullptr,
     select_all},
    {"Box select", "Edit", "B", key(Key::b), kNoKey, false, false,
     "Drag a box around knots. Shift+drag adds, Ctrl+drag removes.", any_knots, nullptr, box_select},
    {"Move", "Edit", "G", key(Key::g), kNoKey, false, false,
     "Move the selected knots. X, Y, Z: along an axis. Shift+axis: in a plane. Type metres.", knot_selected, nullptr,
     transform<TransformKind::move>},
    {"Rotate", "Edit", "R", key(Key::r), kNoKey, false, false,
     "Rotate the selected knots about their centre. X, Y, Z: about an axis. Type degrees.", knot_selected, nullptr,
     transform<TransformKind::rotate>},
    {"Scale", "Edit", "S", key(Key::s), kNoKey, false, false,
     "Scale the selected knots and their handles. X, Y, Z: along an axis. Type a factor.", knot_selected, nullptr,
     transform<TransformKind::scale>},
    {"Next snapping", "Edit", "Shift+Tab", shift(Key::tab), kNoKey, false, false,
     "Snap to nothing, the grid, knots or the ground. Ctrl while dragging inverts snapping.", always, snapping,
     next_snapping},
    {"Select none", "Edit", "", kNoKey, kNoKey, false, false, "Clear the selection. Key Escape.", any_selected, nullptr,
     select_none},
    {"Add curve", "Edit", "C", key(Key::c), kNoKey, false, false,
     "Split the longest segment at half its length. The shape is unchanged.", always, nullptr, add_curve},
    {"Insert point", "Edit", "I", key(Key::i), kNoKey, false, false,
     "Insert a knot under the cursor or at the selected position. The shape is unchanged.", insertable, nullptr,
     insert_point},
    {"Append points", "Edit", "A", key(Key::a), kNoKey, false, false,
     "Click on the ground to append knots to an open track.", always, appending, toggle_append},
    {"Place element", "Edit", "Enter", key(Key::enter), kNoKey, false, false,
     "Place the previewed element at the open end of the track.", placeable, nullptr, place_element},

    {"Cancel", "", "Escape", key(Key::escape), kNoKey, false, true,
     "Cancel a drag, close a list or the score card, end append mode, hide the preview, or clear the selection.",
     always, nullptr, escape},
};

}  // namespace

std::span<const Action> edit_actions() { return kEditActions; }

}  // namespace coaster::ui
