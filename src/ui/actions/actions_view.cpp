// The menus View (cameras, colours, what is shown) and Window (workspaces).
#include <algorithm>

#include "edit/commands/commands_lab.h"
#include "sim/study/jolt.h"
#include "ui/actions/actions_detail.h"
#include "ui/actions/command_palette.h"
#include "ui/tools/cameras.h"
#include "ui/tools/previews.h"
#include "world/panels.h"

namespace coaster::ui {
namespace {

using platform::Key;
using world::Aids;
using world::CameraFeel;
using world::CameraMode;
using world::Layer;
using world::Look;
using world::Panels;
using world::Projection;
using world::Style;
using world::Theme;
using world::Workspace;

constexpr auto kCamera = &world::Settings::camera_mode;

template <Layer layer>
bool layer_shown(const Act& act) {
  return act.ui.session().settings.lab->layers.has(layer);
}
template <Layer layer>
void show_or_hide(Act& act) {
  act.ui.emit(edit::ShowLayer{layer, !layer_shown<layer>(act)});
}

constexpr Condition kInConflict{[](const Act& act) { return !act.ui.find.conflicts_so_far().empty(); },
                                "The track has no conflicts."};
void next_conflict(Act& act) { show_next_conflict(act.ui); }
constexpr Condition kRidden{[](const Act& act) { return !act.ui.find.jolts().empty(); },
                            "A ride needs a track and a train."};
void worst_jolt(Act& act) { show_worst_jolt(act.ui); }
void fill_screen(Act& act) { act.ui.out.toggles_full_screen = true; }
void open_palette(Act& act) { toggle_palette(act.palette); }

// Frames with the orbit camera.
void frame(Act& act, const world::Camera& camera) {
  act.ui.emit(edit::set_camera(camera));
  if (!is<kCamera, CameraMode::orbit>(act)) set<kCamera, CameraMode::orbit>(act);
}
// Includes the palette's preview, if it shows.
void frame_with_preview(Act& act, const world::Camera& camera) {
  frame(act, view::kept_in_view(camera, preview_points(act.ui), act.scene, act.free));
}
void frame_all(Act& act) { frame_with_preview(act, framed_all(act.ui.session(), act.scene, act.free)); }
void frame_selection(Act& act) {
  const edit::Session& session = act.ui.session();
  frame_with_preview(
      act, view::frame_entity(session.settings.camera, session.document, session.settings.selected, act.scene));
}

constexpr Condition kProbing{[](const Act& act) { return selected_is(act, world::Kind::segment); },
                             "Select a segment first."};
// Moves along the selected segment, and at its end to the next one, if there is one.
void step_probe(Act& act, double by) {
  const edit::Session& session = act.ui.session();
  const world::Track& track = session.document.track;
  const double from = session.settings.selected_t, end = by > 0 ? 1 : 0;
  if (from != end) return act.ui.emit(edit::Select{{*selected(act)}, std::clamp(from + by, 0.0, 1.0)});
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

void panels_or_next_way(Act& act) {
  if (act.ui.session().settings.aids->circuit > 0) next_proposal(act.ui);
  else toggle<&Panels::show_panels>(act);
}

bool coloured(const Act& act) { return !is<&world::LabView::colouring, world::Colouring::plain>(act); }
void next_colouring(Act& act) {
  act.ui.emit(edit::Set<&world::LabView::colouring>{base::next_of(act.ui.session().settings.lab->colouring)});
}

template <CameraMode mode>
void look(Act& act) {
  choose_camera(act.ui, mode);
}
// Sets a projection of the orbit camera.
template <world::Projection projection>
void project(Act& act) {
  act.ui.emit(edit::Set<&world::Camera::projection>{projection});
  if (!is<kCamera, CameraMode::orbit>(act)) set<kCamera, CameraMode::orbit>(act);
}
template <world::Projection projection>
bool projected(const Act& act) {
  return is<&world::Camera::projection, projection>(act) && is<kCamera, CameraMode::orbit>(act);
}
void next_camera(Act& act) { choose_camera(act.ui, base::next_of(act.ui.session().settings.camera_mode)); }

template <Workspace workspace>
void go_to(Act& act) {
  choose_workspace(act.ui, workspace);
}
constexpr auto kWorkspace = &Panels::workspace;

constexpr Condition kBuilding{[](const Act& act) { return is<kWorkspace, Workspace::build>(act); },
                              "Go to the workspace Build first."};
void fold_parameters(Act& act) { act.ui.drawers.parameters.toggle(); }
bool parameters_show(const Act& act) { return act.ui.drawers.parameters.open; }
// Opens the force graph or the table of sections, or folds the open one.
template <bool table>
void press_graph(Act& act) {
  act.ui.drawers.press(table);
}
template <bool table>
bool graph_shows(const Act& act) {
  return act.ui.drawers.graph.open && act.ui.drawers.table == table;
}

// Selects the next evaluator that is available here.
void next_evaluator(Act& act) {
  const auto count = curve::evaluators().size();
  const auto now = static_cast<std::size_t>(act.ui.session().settings.evaluation->evaluator);
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t next = (now + i) % count;
    const auto stage = static_cast<std::size_t>(curve::evaluators()[next].evaluated_by);
    if (!act.ui.state.stats.stage_refusals[stage].empty()) continue;
    return act.ui.emit(edit::Set<&world::Evaluation::evaluator>{static_cast<curve::EvaluatorId>(next)});
  }
}
void set_steps(Act& act, int steps) {
  act.ui.emit(edit::Set<&world::Evaluation::steps>{std::clamp(steps, curve::kMinSteps, curve::kMaxSteps)});
}
void more_steps(Act& act) { set_steps(act, 2 * act.ui.session().settings.evaluation->steps); }
void fewer_steps(Act& act) { set_steps(act, act.ui.session().settings.evaluation->steps / 2); }

// Opens or closes the pages, or first switches to a workspace that has them.
bool has_laboratory(const Act& act) {
  return is<kWorkspace, Workspace::laboratory>(act) || is<kWorkspace, Workspace::all>(act);
}
bool laboratory_shows(const Act& act) { return has_laboratory(act) && on<&Panels::show_laboratory>(act); }
void laboratory(Act& act) {
  if (!has_laboratory(act)) choose_workspace(act.ui, Workspace::laboratory);
  else toggle<&Panels::show_laboratory>(act);
}

constexpr Action kViewActions[] = {
    {"Build workspace", "Window", key(Key::f8), kInDrag,
     "Show the building tools: palette, parameters and force graph.", go_to<Workspace::build>, kAlways,
     is<kWorkspace, Workspace::build>},
    {"Ride workspace", "Window", key(Key::f9), kInDrag, "Show the view and a slim bar to ride with.",
     go_to<Workspace::ride>, kAlways, is<kWorkspace, Workspace::ride>},
    {"Laboratory workspace", "Window", key(Key::f10), kInDrag,
     "Show evaluators, resolution and the pages about curves.", go_to<Workspace::laboratory>, kAlways,
     is<kWorkspace, Workspace::laboratory>},
    {"Parameters", "Window", key(Key::f5), kInDrag, "Open or fold the parameters of Build.", fold_parameters, kBuilding,
     parameters_show},
    {"Force graph", "Window", key(Key::f6), kInDrag, "Open or fold the force graph of Build.", press_graph<false>,
     kBuilding, graph_shows<false>},
    {"Table of sections", "Window", key(Key::t), kInDrag, "Open or fold the table of sections of Build.",
     press_graph<true>, kBuilding, graph_shows<true>},
    {"All panels", "Window", kNoKey, kInDrag, "Show the panels of every workspace.", go_to<Workspace::all>, kAlways,
     is<kWorkspace, Workspace::all>},
    {"Full screen", "Window", key(Key::f11), kInDrag | kOnStart, "Fill the screen, or return to the window.",
     fill_screen},
    {"Frame all", "View", key(Key::f), kInDrag, "Show the whole track.", frame_all},
    {"Frame selection", "View", shift(Key::f), kInDrag, "Show the selection.", frame_selection, kAnySelected},
    {"Next camera", "View/Camera", key(Key::v), kInDrag, "Next camera: orbit, ride, chase, fly.", next_camera},
    {"Orbit camera", "View/Camera", key(Key::d1), kInDrag, "Orbit a point with the mouse.", look<CameraMode::orbit>,
     kAlways, is<kCamera, CameraMode::orbit>},
    {"Ride camera", "View/Camera", key(Key::d2), kInDrag, "View from a seat of the first train.",
     look<CameraMode::ride>, kRideable, is<kCamera, CameraMode::ride>},
    {"Chase camera", "View/Camera", key(Key::d3), kInDrag,
     "Follow the first train from behind. The wheel sets the distance.", look<CameraMode::chase>, kRideable,
     is<kCamera, CameraMode::chase>},
    {"Fly camera", "View/Camera", key(Key::d4), kInDrag,
     "Fly with W A S D, Q down, E up, Shift faster. Drag to look around.", look<CameraMode::fly>, kAlways,
     is<kCamera, CameraMode::fly>},
    {"Front view", "View/Camera", key(Key::keypad_1), kInDrag,
     "Look along -Z without perspective. Orbiting leaves the view.", project<Projection::front>, kAlways,
     projected<Projection::front>, ctrl(Key::d1)},
    {"Side view", "View/Camera", key(Key::keypad_3), kInDrag,
     "Look along -X without perspective. Orbiting leaves the view.", project<Projection::side>, kAlways,
     projected<Projection::side>, ctrl(Key::d3)},
    {"Top view", "View/Camera", key(Key::keypad_7), kInDrag, "Look down without perspective. Orbiting leaves the view.",
     project<Projection::top>, kAlways, projected<Projection::top>, ctrl(Key::d7)},
    {"Perspective", "View/Camera", key(Key::keypad_5), kInDrag, "Draw distant objects smaller.",
     project<Projection::perspective>, kAlways, projected<Projection::perspective>, ctrl(Key::d5)},
    {"Head-bob", "View/Camera", kNoKey, kInDrag, "Move the rider's head with g.", toggle<&CameraFeel::head_bob>,
     kAlways, on<&CameraFeel::head_bob>},
    {"Reduced motion", "View/Camera", kNoKey, kInDrag, "Level horizon, cuts between cameras, no head-bob, no widening.",
     toggle<&CameraFeel::reduced_motion>, kAlways, on<&CameraFeel::reduced_motion>},
    {"Knots", "View/Show", kNoKey, kInDrag, "Show or hide knots that are not selected.", show_or_hide<Layer::knots>,
     kAlways, layer_shown<Layer::knots>},
    {"Gizmo", "View/Show", kNoKey, kInDrag, "Show or hide the arrows that move the selected knots.",
     toggle<&Aids::show_gizmo>, kAlways, on<&Aids::show_gizmo>},
    {"Supports", "View/Show", kNoKey, kInDrag, "Show or hide the supports.", show_or_hide<Layer::supports>, kAlways,
     layer_shown<Layer::supports>},
    {"Conflicts", "View/Show", kNoKey, kInDrag, "Show or hide places without clearance.",
     show_or_hide<Layer::conflicts>, kAlways, layer_shown<Layer::conflicts>},
    {"Legend", "View/Show", kNoKey, kInDrag, "Show or hide the numbers of the track's colours.",
     show_or_hide<Layer::legend>, kAlways, layer_shown<Layer::legend>},
    {"First steps", "View/Show", key(Key::f1), kInDrag, "Show or hide the first steps.", toggle<&Aids::show_hints>,
     kAlways, on<&Aids::show_hints>},
    {"Dark theme", "View/Appearance", kNoKey, kInDrag, "Light on dark.", set<&Look::theme, Theme::dark>, kAlways,
     is<&Look::theme, Theme::dark>},
    {"Light theme", "View/Appearance", kNoKey, kInDrag, "Dark on light.", set<&Look::theme, Theme::light>, kAlways,
     is<&Look::theme, Theme::light>},
    {"High-contrast theme", "View/Appearance", kNoKey, kInDrag, "White and bright colours on black, with outlines.",
     set<&Look::theme, Theme::high_contrast>, kAlways, is<&Look::theme, Theme::high_contrast>},
    {"Day", "View/Appearance", kNoKey, kInDrag, "High sun, clear sky.", set<&Look::style, Style::day>, kAlways,
     is<&Look::style, Style::day>},
    {"Dusk", "View/Appearance", kNoKey, kInDrag, "Low sun, long shadows.", set<&Look::style, Style::dusk>, kAlways,
     is<&Look::style, Style::dusk>},
    {"Blueprint", "View/Appearance", kNoKey, kInDrag, "Lines on blue, for the laboratory and for print.",
     set<&Look::style, Style::blueprint>, kAlways, is<&Look::style, Style::blueprint>},
    {"Next track colours", "View", key(Key::k), 0,
     "Colour the track by speed, height, g, jerk, roll, curvature, error, or not at all.", next_colouring, kAlways,
     coloured},
    {"Next conflict", "View", kNoKey, kInDrag, "Go to the next place where the track lacks clearance from itself.",
     next_conflict, kInConflict},
    {"Worst jolt", "View", kNoKey, kInDrag, "Go to the knot whose jumps of curvature and roll riders feel most.",
     worst_jolt, kRidden},
    {"Probe back", "View", shift(Key::m), kRepeats,
     "Move the selected position backward along the track by 1/64 of a segment.", probe_back, kProbing, nullptr,
     key(Key::left_bracket)},
    {"Probe on", "View", key(Key::m), kRepeats,
     "Move the selected position forward along the track by 1/64 of a segment.", probe_on, kProbing, nullptr,
     key(Key::right_bracket)},
    {"Command palette", "View", ctrl(Key::p), kOnStart, "Find an action or a command.", open_palette},
    {"Panels", "View", key(Key::tab), 0,
     "Show or hide menu, panels and status bar. While closing sections are proposed: the next one.", panels_or_next_way,
     kAlways, on<&Panels::show_panels>},
    {"Laboratory", "View", key(Key::l), kInDrag, "Open or close the laboratory.", laboratory, kAlways,
     laboratory_shows},
    {"Next evaluator", "", key(Key::e), kInDrag, "Evaluate curves by the next method.", next_evaluator},
    {"More steps", "", key(Key::u), kInDrag, "Twice as many steps per segment.", more_steps, kAlways, nullptr,
     key(Key::equal)},
    {"Fewer steps", "", shift(Key::u), kInDrag, "Half as many steps per segment.", fewer_steps, kAlways, nullptr,
     key(Key::minus)},
};

}  // namespace

void choose_workspace(Ui& ui, Workspace to) {
  ui.emit(edit::Set<&Panels::workspace>{to});
  if (to == Workspace::laboratory && !ui.session().settings.panels->show_laboratory)
    ui.emit(edit::Set<&Panels::show_laboratory>{true});
}

std::span<const Action> view_actions() { return kViewActions; }

}  // namespace coaster::ui
