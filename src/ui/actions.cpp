// What keys and menus do.
#include "ui/actions.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <variant>

#include "ui/command_palette.h"
#include "ui/dialogs.h"
#include "ui/fly_keys.h"
#include "ui/key_map.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

using platform::Chord;
using platform::Key;
using world::CameraMode;
using world::Kind;

constexpr Chord key(Key k) { return {k, {}}; }
constexpr Chord ctrl(Key k) { return {k, {.ctrl = true}}; }
constexpr Chord shift(Key k) { return {k, {.shift = true}}; }
constexpr Chord kNoKey{};

const world::Name* selected(const Act& act) {
  const edit::Session& session = act.ui.session();
  return session.document.entities.find<world::Name>(session.settings.selected);
}

bool always(const Act&) { return true; }
bool any_selected(const Act& act) { return selected(act) != nullptr; }
bool removable(const Act& act) { return any_selected(act) && selected(act)->kind != Kind::segment; }
bool knot_selected(const Act& act) { return any_selected(act) && selected(act)->kind == Kind::knot; }
bool any_knots(const Act& act) { return !act.ui.session().document.track.knots.empty(); }
bool can_undo(const Act& act) { return !act.ui.session().history.undo.empty() || act.ui.session().history.in_gesture; }
bool can_redo(const Act& act) { return !act.ui.session().history.redo.empty(); }
bool rideable(const Act& act) {
  const edit::Session& session = act.ui.session();
  return session.document.entities.pool<world::Cart>().size() > 0 && !session.document.track.segments.empty();
}
bool insertable(const Act& act) {
  return act.hovered.kind == view::PickKind::curve || (any_selected(act) && selected(act)->kind == Kind::segment);
}
bool appending(const Act& act) { return act.ui.session().settings.append_mode; }
bool panels_shown(const Act& act) { return act.ui.session().settings.show_panels; }
template <CameraMode mode>
bool looks(const Act& act) { return act.ui.session().settings.camera_mode == mode; }

// Takes back what the mouse is dragging, in the viewport or in a number. False when it drags nothing that changes the document.
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
void transform(Act& act) { act.tool.transform().begin(act.ui, kind, {}, std::nullopt); }
bool gizmo_shown(const Act& act) { return act.ui.session().settings.show_gizmo; }
void toggle_gizmo(Act& act) { act.ui.emit(edit::SetGizmo{!gizmo_shown(act)}); }
bool snapping(const Act& act) { return act.ui.session().settings.snapping.to != world::SnapTo::off; }
void next_snapping(Act& act) {
  const world::Snapping& s = act.ui.session().settings.snapping;
  const auto next = static_cast<world::SnapTo>((static_cast<std::size_t>(s.to) + 1) % world::kSnapNames.size());
  act.ui.emit(edit::SetSnapping{next, s.step, s.angle});
}
void open_palette(Act& act) { toggle_palette(act.palette); }
bool hints_shown(const Act& act) { return act.ui.session().settings.show_hints; }
void toggle_hints(Act& act) { act.ui.emit(edit::SetHints{!hints_shown(act)}); }
void select_none(Act& act) { act.ui.emit(edit::Select{}); }

void escape(Act& act) {
  if (cancel_drags(act)) return;
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) {
    ImGui::ClosePopupToLevel(0, true);
  } else if (appending(act)) {
    act.ui.emit(edit::SetAppendMode{false});
  } else if (act.ui.session().settings.show_element) {
    act.ui.emit(edit::PreviewElement{false});
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
void toggle_append(Act& act) { act.ui.emit(edit::SetAppendMode{!appending(act)}); }

// The palette's element, where its preview shows.
bool placeable(const Act& act) {
  const edit::Session& session = act.ui.session();
  return session.settings.show_element && session.elements.plan(session.settings.element, session.document).refusal.empty();
}
void place_element(Act& act) { act.ui.emit(edit::PlaceElement{act.ui.session().settings.element}); }

// What is framed is framed for the orbit camera.
void orbit_again(Act& act) {
  if (act.ui.session().settings.camera_mode != CameraMode::orbit) act.ui.emit(edit::SetCameraMode{CameraMode::orbit});
}
void frame_all(Act& act) {
  const edit::Session& session = act.ui.session();
  act.ui.emit(edit::SetCamera{view::frame_all(session.settings.camera, session.document, act.scene)});
  orbit_again(act);
}
void frame_selection(Act& act) {
  const edit::Session& session = act.ui.session();
  act.ui.emit(edit::SetCamera{view::frame_entity(session.settings.camera, session.document, session.settings.selected, act.scene)});
  orbit_again(act);
}
void toggle_panels(Act& act) { act.ui.emit(edit::SetPanels{!panels_shown(act)}); }
bool laboratory_shown(const Act& act) { return act.ui.session().settings.show_laboratory; }
void toggle_laboratory(Act& act) { act.ui.emit(edit::ShowLaboratory{!laboratory_shown(act)}); }

bool probing(const Act& act) { return any_selected(act) && selected(act)->kind == Kind::segment; }
// Along the selected segment; from its end on to the neighbour, where there is one.
void step_probe(Act& act, double by) {
  const edit::Session& session = act.ui.session();
  const world::Track& track = session.document.track;
  const double from = session.settings.selected_t, end = by > 0 ? 1 : 0;
  if (from != end) {
    act.ui.emit(edit::Select{{*selected(act)}, std::clamp(from + by, 0.0, 1.0)});
    return;
  }
  const auto found = std::find(track.segments.begin(), track.segments.end(), session.settings.selected);
  if (found == track.segments.end()) return;
  const auto count = static_cast<std::ptrdiff_t>(track.segments.size()), next = found - track.segments.begin() + (by > 0 ? 1 : -1);
  if (!track.closed && (next < 0 || next >= count)) return;
  const world::Entity segment = track.segments[static_cast<std::size_t>((next + count) % count)];
  act.ui.emit(edit::Select{{world::name_of(session.document, segment)}, 1 - end});
}
constexpr double kProbeStep = 1.0 / 64;
void probe_back(Act& act) { step_probe(act, -kProbeStep); }
void probe_on(Act& act) { step_probe(act, kProbeStep); }

bool coloured(const Act& act) { return act.ui.session().settings.colouring != world::Colouring::plain; }
void next_colouring(Act& act) {
  const auto next = (static_cast<std::size_t>(act.ui.session().settings.colouring) + 1) % world::colourings().size();
  act.ui.emit(edit::SetColouring{static_cast<world::Colouring>(next)});
}

template <CameraMode mode>
void look(Act& act) { choose_camera(act.ui, mode); }
void next_camera(Act& act) {
  const auto next = (static_cast<std::size_t>(act.ui.session().settings.camera_mode) + 1) % world::kCameraModeNames.size();
  choose_camera(act.ui, static_cast<CameraMode>(next));
}
bool motion_reduced(const Act& act) { return act.ui.session().settings.feel.reduced_motion; }
void toggle_reduced_motion(Act& act) { act.ui.emit(edit::SetReducedMotion{!motion_reduced(act)}); }
bool head_bobs(const Act& act) { return act.ui.session().settings.feel.head_bob; }
void toggle_head_bob(Act& act) { act.ui.emit(edit::SetHeadBob{!head_bobs(act)}); }

void play_pause(Act& act) {
  if (act.ui.session().motion.state == world::RideState::running)
    act.ui.emit(edit::RidePause{});
  else
    act.ui.emit(edit::RideStart{});
}
void single_step(Act& act) {
  if (act.ui.session().motion.state == world::RideState::running) act.ui.emit(edit::RidePause{});
  act.ui.emit(edit::RideStep{1});
}
void reset(Act& act) { act.ui.emit(edit::RideStop{}); }

void new_track(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::fresh, {}}); }
void open(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::browse, {}}); }
void save(Act& act) { act.ui.dialogs.save(act.ui); }
void save_as(Act& act) { act.ui.dialogs.save_as(act.ui); }
void settings(Act& act) { act.ui.dialogs.show_settings(); }
void screenshot(Act& act) { act.ui.out.wants_screenshot = true; }
void quit(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::quit, {}}); }

template <world::Theme theme>
bool themed(const Act& act) { return act.ui.session().settings.theme == theme; }
template <world::Theme theme>
void paint(Act& act) { act.ui.emit(edit::SetTheme{theme}); }

constexpr Action kActions[] = {
    {"New", "File", "Ctrl+N", ctrl(Key::n), kNoKey, false, false, "Start an empty track.", always, nullptr, new_track},
    {"Open", "File", "Ctrl+O", ctrl(Key::o), kNoKey, false, false, "Choose a track file to open.", always, nullptr, open},
    {"Save", "File", "Ctrl+S", ctrl(Key::s), kNoKey, false, false, "Save the track to its file.", always, nullptr, save},
    {"Save as", "File", "Ctrl+Shift+S", {Key::s, {.shift = true, .ctrl = true}}, kNoKey, false, false,
     "Save the track to another file, or export it: the ending tells the format.", always, nullptr, save_as},
    {"Settings", "File", "Ctrl+,", ctrl(Key::comma), kNoKey, false, false, "Scale, colours, autosave, keys.", always, nullptr, settings},
    {"Screenshot", "File", "F12", key(Key::f12), kNoKey, false, true, "Write a picture of the window.", always, nullptr, screenshot},
    {"Quit", "File", "Ctrl+Q", ctrl(Key::q), kNoKey, false, false, "Leave the program.", always, nullptr, quit},

    {"Undo", "Edit", "Ctrl+Z", ctrl(Key::z), kNoKey, true, true, "Undo the last step; during a drag, take the drag back.", can_undo, nullptr, undo},
    {"Redo", "Edit", "Ctrl+Y", ctrl(Key::y), {Key::z, {.shift = true, .ctrl = true}}, true, false, "Redo the step undone last.",
     can_redo, nullptr, redo},
    {"Delete", "Edit", "Delete", key(Key::del), key(Key::x), false, false, "Remove the selected knot or cart.", removable, nullptr, remove},
    {"Select all", "Edit", "Ctrl+A", ctrl(Key::a), kNoKey, false, false, "Select every knot.", any_knots, nullptr, select_all},
    {"Box select", "Edit", "B", key(Key::b), kNoKey, false, false, "Drag a box around knots. Shift+drag on the empty view adds, Ctrl+drag takes away.", any_knots, nullptr, box_select},
    {"Move", "Edit", "G", key(Key::g), kNoKey, false, false, "Move the selected knots with the mouse; X, Y, Z: along an axis, Shift+axis: in a plane; digits: by metres.", knot_selected, nullptr,
     transform<TransformKind::move>},
    {"Rotate", "Edit", "R", key(Key::r), kNoKey, false, false, "Turn the selected knots about their middle; X, Y, Z: about an axis; digits: by degrees.", knot_selected, nullptr,
     transform<TransformKind::rotate>},
    {"Scale", "Edit", "S", key(Key::s), kNoKey, false, false, "Scale the selected knots and their handles; X, Y, Z: along an axis; digits: by a factor.", knot_selected, nullptr,
     transform<TransformKind::scale>},
    {"Next snapping", "Edit", "Shift+Tab", shift(Key::tab), kNoKey, false, false, "Snap to nothing, a grid, other knots or the ground. Ctrl while moving: the other way round.", always, snapping,
     next_snapping},
    {"Select none", "Edit", "", kNoKey, kNoKey, false, false, "Clear the selection. Escape does so too.", any_selected, nullptr, select_none},
    {"Add curve", "Edit", "C", key(Key::c), kNoKey, false, false, "Split the longest segment at half its length, keeping the shape.", always, nullptr, add_curve},
    {"Insert point", "Edit", "I", key(Key::i), kNoKey, false, false, "Insert a knot under the cursor, or at the picked place, keeping the shape.", insertable,
     nullptr, insert_point},
    {"Append points", "Edit", "A", key(Key::a), kNoKey, false, false, "Clicks on the ground append knots to an open track.", always, appending, toggle_append},
    {"Place element", "Edit", "Enter", key(Key::enter), kNoKey, false, false, "Add the element that the palette shows at the open end of the track.", placeable, nullptr,
     place_element},

    {"Frame all", "View", "F", key(Key::f), kNoKey, false, true, "Show the whole track.", always, nullptr, frame_all},
    {"Frame selection", "View", "Shift+F", shift(Key::f), kNoKey, false, true, "Show what is selected.", any_selected, nullptr, frame_selection},
    {"Command palette", "View", "Ctrl+P", ctrl(Key::p), kNoKey, false, false, "Find an action or a command by typing.", always, nullptr, open_palette},
    {"First steps", "View", "", kNoKey, kNoKey, false, true, "Show or dismiss the first steps.", always, hints_shown, toggle_hints},
    {"Gizmo", "View", "", kNoKey, kNoKey, false, true, "Show or hide the arrows that move the selected knots.", always, gizmo_shown, toggle_gizmo},
    {"Panels", "View", "Tab", key(Key::tab), kNoKey, false, false, "Show or hide menu, panels and status bar.", always, panels_shown, toggle_panels},
    {"Next track colours", "View", "K", key(Key::k), kNoKey, false, false, "Colour the track by speed, height, each g, curvature, error, or not at all.", always, coloured,
     next_colouring},
    {"Next camera", "View", "V", key(Key::v), kNoKey, false, true, "The next of the cameras: orbit, ride, chase, fly.", always, nullptr, next_camera},
    {"Orbit camera", "View", "1", key(Key::d1), kNoKey, false, true, "Turn about a place with the mouse.", always, looks<CameraMode::orbit>, look<CameraMode::orbit>},
    {"Ride camera", "View", "2", key(Key::d2), kNoKey, false, true, "Look from the first cart's seat.", rideable, looks<CameraMode::ride>, look<CameraMode::ride>},
    {"Chase camera", "View", "3", key(Key::d3), kNoKey, false, true, "Follow the first cart's train from behind; the wheel sets how far.", rideable, looks<CameraMode::chase>,
     look<CameraMode::chase>},
    {"Fly camera", "View", "4", key(Key::d4), kNoKey, false, true, "Fly with W A S D, Q down, E up, Shift faster; drag to look around.", always, looks<CameraMode::fly>,
     look<CameraMode::fly>},
    {"Head-bob", "View", "", kNoKey, kNoKey, false, true, "Let the rider's head give way to g.", always, head_bobs, toggle_head_bob},
    {"Reduced motion", "View", "", kNoKey, kNoKey, false, true, "Keep the rider's horizon level, cut between cameras, no bobbing, no widening.", always, motion_reduced,
     toggle_reduced_motion},
    {"Dark theme", "View", "", kNoKey, kNoKey, false, true, "Light on dark.", always, themed<world::Theme::dark>, paint<world::Theme::dark>},
    {"Light theme", "View", "", kNoKey, kNoKey, false, true, "Dark on light.", always, themed<world::Theme::light>, paint<world::Theme::light>},
    {"High-contrast theme", "View", "", kNoKey, kNoKey, false, true, "White and bright colours on black, with edges.", always, themed<world::Theme::high_contrast>,
     paint<world::Theme::high_contrast>},
    {"Laboratory", "View", "L", key(Key::l), kNoKey, false, true, "Open or fold the laboratory's pages.", always, laboratory_shown, toggle_laboratory},
    {"Probe back", "View", "[", key(Key::left_bracket), kNoKey, true, false, "Move the picked place back along the track by 1/64 of a segment.", probing, nullptr, probe_back},
    {"Probe on", "View", "]", key(Key::right_bracket), kNoKey, true, false, "Move the picked place on along the track by 1/64 of a segment.", probing, nullptr, probe_on},

    {"Play or pause", "Ride", "Space", key(Key::space), kNoKey, false, true, "Let the carts run, or hold them.", rideable, nullptr, play_pause},
    {"Single step", "Ride", ".", key(Key::period), kNoKey, true, true, "Hold the carts and advance one tick of 1/120 s.", rideable, nullptr, single_step},
    {"Reset", "Ride", "Shift+R", shift(Key::r), kNoKey, false, true, "Put the carts back to their start.", rideable, nullptr, reset},

    {"Cancel", "", "Escape", key(Key::escape), kNoKey, false, true, "Take back a drag, close a list, leave append mode, hide the element's preview, or clear the selection.", always, nullptr,
     escape},
};

}  // namespace

std::span<const Action> actions() { return kActions; }

void run_transform_keys(Act& act, const platform::Events& events) {
  platform::Events others;
  for (const platform::Event& event : events) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    if (press && press->down && (press->key == Key::escape || press->modifiers.ctrl)) others.push_back(event);
  }
  act.tool.transform().take_keys(events);
  run_keys(act, others);
}

void run_keys(Act& act, const platform::Events& events) {
  for (const platform::Event& event : events) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    if (press == nullptr || !press->down || press->key == Key::unknown) continue;
    if (is_fly_key(*press) && act.ui.session().settings.camera_mode == CameraMode::fly) continue;
    const Chord chord{press->key, press->modifiers};
    for (std::size_t row = 0; row < actions().size(); ++row) {
      const Action& action = actions()[row];
      const auto chords = act.ui.keys.chords(row);
      if (std::find(chords.begin(), chords.end(), chord) == chords.end()) continue;
      if (press->repeat && !action.repeats) continue;
      if (!action.in_drag && (act.tool.dragging() || act.ui.gesture.open)) continue;
      if (action.enabled(act)) action.run(act);
    }
  }
}

}  // namespace coaster::ui
