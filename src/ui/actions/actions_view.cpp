// The menu View: cameras, colours, what is shown.
#include <algorithm>

#include "edit/commands/commands_lab.h"
#include "edit/commands/commands_settings.h"
#include "ui/actions/actions_parts.h"
#include "ui/actions/command_palette.h"
#include "ui/tools/fly_keys.h"
#include "ui/tools/places.h"
#include "world/aids.h"
#include "world/camera_feel.h"
#include "world/lab_view.h"
#include "world/look.h"

namespace coaster::ui {
namespace {

using platform::Key;
using world::CameraMode;
using world::Kind;

bool panels_shown(const Act& act) { return act.ui.session().settings.look->show_panels; }
template <CameraMode mode>
bool looks(const Act& act) {
  return act.ui.session().settings.camera_mode == mode;
}

bool gizmo_shown(const Act& act) { return act.ui.session().settings.aids->show_gizmo; }
void toggle_gizmo(Act& act) { act.ui.emit(edit::Set<&world::Aids::show_gizmo>{!gizmo_shown(act)}); }

bool supports_shown(const Act& act) { return act.ui.session().settings.lab->layers.has(world::Layer::supports); }
bool knots_shown(const Act& act) { return act.ui.session().settings.lab->layers.has(world::Layer::knots); }
void toggle_knots(Act& act) { act.ui.emit(edit::ShowLayer{world::Layer::knots, !knots_shown(act)}); }
void toggle_supports(Act& act) { act.ui.emit(edit::ShowLayer{world::Layer::supports, !supports_shown(act)}); }

bool conflicts_shown(const Act& act) { return act.ui.session().settings.lab->layers.has(world::Layer::conflicts); }
bool in_conflict(const Act& act) { return !act.ui.find(edit::Want::conflicts).conflicts.empty(); }
void next_conflict(Act& act) { show_next_conflict(act.ui); }
void toggle_conflicts(Act& act) { act.ui.emit(edit::ShowLayer{world::Layer::conflicts, !conflicts_shown(act)}); }

void open_palette(Act& act) { toggle_palette(act.palette); }
bool hints_shown(const Act& act) { return act.ui.session().settings.aids->show_hints; }
void toggle_hints(Act& act) { act.ui.emit(edit::Set<&world::Aids::show_hints>{!hints_shown(act)}); }

// What is framed is framed for the orbit camera.
void orbit_again(Act& act) {
  if (act.ui.session().settings.camera_mode != CameraMode::orbit)
    act.ui.emit(edit::Set<&world::Settings::camera_mode>{CameraMode::orbit});
}
void frame_all(Act& act) {
  const edit::Session& session = act.ui.session();
  act.ui.emit(edit::SetCamera{view::frame_all(session.settings.camera, session.document, act.scene)});
  orbit_again(act);
}
void frame_selection(Act& act) {
  const edit::Session& session = act.ui.session();
  act.ui.emit(edit::SetCamera{
      view::frame_entity(session.settings.camera, session.document, session.settings.selected, act.scene)});
  orbit_again(act);
}
void toggle_panels(Act& act) { act.ui.emit(edit::Set<&world::Look::show_panels>{!panels_shown(act)}); }
bool laboratory_shown(const Act& act) { return act.ui.session().settings.look->show_laboratory; }
void toggle_laboratory(Act& act) { act.ui.emit(edit::Set<&world::Look::show_laboratory>{!laboratory_shown(act)}); }

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
  const auto count = static_cast<std::ptrdiff_t>(track.segments.size()),
             next = found - track.segments.begin() + (by > 0 ? 1 : -1);
  if (!track.closed && (next < 0 || next >= count)) return;
  const world::Entity segment = track.segments[static_cast<std::size_t>((next + count) % count)];
  act.ui.emit(edit::Select{{world::name_of(session.document, segment)}, 1 - end});
}
constexpr double kProbeStep = 1.0 / 64;
void probe_back(Act& act) { step_probe(act, -kProbeStep); }
void probe_on(Act& act) { step_probe(act, kProbeStep); }

bool coloured(const Act& act) { return act.ui.session().settings.lab->colouring != world::Colouring::plain; }
void next_colouring(Act& act) {
  act.ui.emit(edit::Set<&world::LabView::colouring>{base::next_of(act.ui.session().settings.lab->colouring)});
}

template <CameraMode mode>
void look(Act& act) {
  choose_camera(act.ui, mode);
}
void next_camera(Act& act) { choose_camera(act.ui, base::next_of(act.ui.session().settings.camera_mode)); }
bool motion_reduced(const Act& act) { return act.ui.session().settings.feel->reduced_motion; }
void toggle_reduced_motion(Act& act) {
  act.ui.emit(edit::Set<&world::CameraFeel::reduced_motion>{!motion_reduced(act)});
}
bool head_bobs(const Act& act) { return act.ui.session().settings.feel->head_bob; }
void toggle_head_bob(Act& act) { act.ui.emit(edit::Set<&world::CameraFeel::head_bob>{!head_bobs(act)}); }

template <world::Theme theme>
bool themed(const Act& act) {
  return act.ui.session().settings.look->theme == theme;
}
template <world::Theme theme>
void paint(Act& act) {
  act.ui.emit(edit::Set<&world::Look::theme>{theme});
}
template <world::Style style>
bool lit(const Act& act) {
  return act.ui.session().settings.look->style == style;
}
template <world::Style style>
void light(Act& act) {
  act.ui.emit(edit::Set<&world::Look::style>{style});
}

constexpr Action kViewActions[] = {
    {"Frame all", "View", "F", key(Key::f), kNoKey, false, true, "Show the whole track.", always, nullptr, frame_all},
    {"Frame selection", "View", "Shift+F", shift(Key::f), kNoKey, false, true, "Show the selection.", any_selected,
     nullptr, frame_selection},
    {"Command palette", "View", "Ctrl+P", ctrl(Key::p), kNoKey, false, false, "Find an action or a command.", always,
     nullptr, open_palette},
    {"First steps", "View", "", kNoKey, kNoKey, false, true, "Show or hide the first steps.", always, hints_shown,
     toggle_hints},
    {"Knots", "View", "", kNoKey, kNoKey, false, true, "Show or hide knots that are not selected.", always, knots_shown,
     toggle_knots},
    {"Supports", "View", "", kNoKey, kNoKey, false, true, "Show or hide the supports.", always, supports_shown,
     toggle_supports},
    {"Conflicts", "View", "", kNoKey, kNoKey, false, true, "Show or hide places without clearance.", always,
     conflicts_shown, toggle_conflicts},
    {"Next conflict", "View", "", kNoKey, kNoKey, false, true,
     "Go to the next place where the track lacks clearance from itself.", in_conflict, nullptr, next_conflict},
    {"Gizmo", "View", "", kNoKey, kNoKey, false, true, "Show or hide the arrows that move the selected knots.", always,
     gizmo_shown, toggle_gizmo},
    {"Panels", "View", "Tab", key(Key::tab), kNoKey, false, false, "Show or hide menu, panels and status bar.", always,
     panels_shown, toggle_panels},
    {"Next track colours", "View", "K", key(Key::k), kNoKey, false, false,
     "Colour the track by speed, height, g, curvature or error, or not at all.", always, coloured, next_colouring},
    {"Next camera", "View", "V", key(Key::v), kNoKey, false, true, "Next camera: orbit, ride, chase, fly.", always,
     nullptr, next_camera},
    {"Orbit camera", "View", "1", key(Key::d1), kNoKey, false, true, "Orbit a point with the mouse.", always,
     looks<CameraMode::orbit>, look<CameraMode::orbit>},
    {"Ride camera", "View", "2", key(Key::d2), kNoKey, false, true, "View from the first cart's seat.", rideable,
     looks<CameraMode::ride>, look<CameraMode::ride>},
    {"Chase camera", "View", "3", key(Key::d3), kNoKey, false, true,
     "Follow the first train from behind. The wheel sets the distance.", rideable, looks<CameraMode::chase>,
     look<CameraMode::chase>},
    {"Fly camera", "View", "4", key(Key::d4), kNoKey, false, true,
     "Fly with W A S D, Q down, E up, Shift faster. Drag to look around.", always, looks<CameraMode::fly>,
     look<CameraMode::fly>},
    {"Head-bob", "View", "", kNoKey, kNoKey, false, true, "Move the rider's head with g.", always, head_bobs,
     toggle_head_bob},
    {"Reduced motion", "View", "", kNoKey, kNoKey, false, true,
     "Level horizon, cuts between cameras, no head-bob, no widening.", always, motion_reduced, toggle_reduced_motion},
    {"Dark theme", "View", "", kNoKey, kNoKey, false, true, "Light on dark.", always, themed<world::Theme::dark>,
     paint<world::Theme::dark>},
    {"Light theme", "View", "", kNoKey, kNoKey, false, true, "Dark on light.", always, themed<world::Theme::light>,
     paint<world::Theme::light>},
    {"High-contrast theme", "View", "", kNoKey, kNoKey, false, true,
     "White and bright colours on black, with outlines.", always, themed<world::Theme::high_contrast>,
     paint<world::Theme::high_contrast>},
    {"Day", "View", "", kNoKey, kNoKey, false, true, "High sun, clear sky.", always, lit<world::Style::day>,
     light<world::Style::day>},
    {"Dusk", "View", "", kNoKey, kNoKey, false, true, "Low sun, long shadows.", always, lit<world::Style::dusk>,
     light<world::Style::dusk>},
    {"Blueprint", "View", "", kNoKey, kNoKey, false, true, "Lines on blue, for the laboratory and for print.", always,
     lit<world::Style::blueprint>, light<world::Style::blueprint>},
    {"Laboratory", "View", "L", key(Key::l), kNoKey, false, true, "Open or close the laboratory.", always,
     laboratory_shown, toggle_laboratory},
    {"Probe back", "View", "[", key(Key::left_bracket), kNoKey, true, false,
     "Move the selected position backward along the track by 1/64 of a segment.", probing, nullptr, probe_back},
    {"Probe on", "View", "]", key(Key::right_bracket), kNoKey, true, false,
     "Move the selected position forward along the track by 1/64 of a segment.", probing, nullptr, probe_on},
};

}  // namespace

std::span<const Action> view_actions() { return kViewActions; }

}  // namespace coaster::ui
