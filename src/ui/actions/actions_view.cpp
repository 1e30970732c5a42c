// The menu bar: the rows of the actions' table that name a menu. The actions of the menus View (cameras, colours, what
// is shown) and Window (workspaces).
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <imgui.h>

#include <fmt/format.h>

#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "sim/study/jolt.h"
#include "ui/actions/actions_detail.h"
#include "ui/actions/command_palette.h"
#include "ui/context/query_widgets.h"
#include "ui/tools/camera_controls.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace {

using platform::Key;
using world::Appearance;
using world::CameraFeel;
using world::CameraMode;
using world::EditingAids;
using world::Layer;
using world::Panels;
using world::Projection;
using world::Scenery;
using world::Style;
using world::Theme;
using world::Workspace;

constexpr auto kCamera = &world::Settings::camera_mode;

template <Layer layer>
bool layer_shown(const ActionContext& act) {
  return act.ui.session().settings.lab->layers.has(layer);
}
template <Layer layer>
void show_or_hide(ActionContext& act) {
  act.ui.emit(edit::ShowLayer{layer, !layer_shown<layer>(act)});
}
template <Layer layer>
constexpr Action showing(std::string_view name, std::string_view help) {
  return {name, "View/Show", kNoKey, kInDrag, help, show_or_hide<layer>, kAlways, layer_shown<layer>};
}

constexpr ActionCondition kInConflict{[](const ActionContext& act) { return !act.ui.find.conflicts_so_far().empty(); },
                                      "The track has no conflicts."};
void next_conflict(ActionContext& act) { show_next_conflict(act.ui); }
constexpr ActionCondition kRidden{[](const ActionContext& act) { return !act.ui.find.jolts().empty(); },
                                  "A ride needs a track and a train."};
void worst_jolt(ActionContext& act) { show_worst_jolt(act.ui); }
void fill_screen(ActionContext& act) { act.ui.out.toggles_full_screen = true; }
void open_palette(ActionContext& act) { toggle_palette(act.palette); }

// Frames with the orbit camera.
void frame(ActionContext& act, const world::Camera& camera) {
  act.ui.emit(edit::set_camera(camera));
  if (!is<kCamera, CameraMode::orbit>(act)) set<kCamera, CameraMode::orbit>(act);
}
// Includes the palette's preview, if it shows.
void frame_with_preview(ActionContext& act, const world::Camera& camera) {
  frame(act, view::kept_in_view(camera, preview_points(act.ui), act.scene, act.free));
}
void frame_all(ActionContext& act) { frame_with_preview(act, framed_all(act.ui.session(), act.scene, act.free)); }
void frame_selection(ActionContext& act) {
  const edit::Session& session = act.ui.session();
  frame_with_preview(
      act, view::frame_entity(session.settings.camera, session.document, session.settings.selected, act.scene));
}

constexpr ActionCondition kProbing{
    [](const ActionContext& act) { return selected_is(act, world::EntityKind::segment); }, "Select a segment first."};
// Moves along the selected segment, and at its end to the next one, if there is one.
void step_probe(ActionContext& act, double by) {
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
void probe_back(ActionContext& act) { step_probe(act, -kProbeStep); }
void probe_on(ActionContext& act) { step_probe(act, kProbeStep); }

void panels_or_next_way(ActionContext& act) {
  if (act.ui.session().settings.aids->circuit > 0) next_proposal(act.ui);
  else toggle<&Panels::show_panels>(act);
}

bool coloured(const ActionContext& act) { return !is<&world::LabView::colouring, world::Colouring::plain>(act); }
void next_colouring(ActionContext& act) {
  act.ui.emit(edit::Set<&world::LabView::colouring>{base::next_of(act.ui.session().settings.lab->colouring)});
}

template <CameraMode mode>
constexpr Action camera(std::string_view name, platform::Key k, std::string_view help,
                        ActionCondition enabled = kAlways) {
  const auto choose = [](ActionContext& act) { choose_camera(act.ui, mode); };
  return {name, "View/Camera", key(k), kInDrag, help, choose, enabled, is<kCamera, mode>};
}
// Sets a projection of the orbit camera.
template <world::Projection projection>
constexpr Action project(std::string_view name, platform::Key k, platform::Key with_ctrl, std::string_view help) {
  const auto choose = [](ActionContext& act) {
    act.ui.emit(edit::Set<&world::Camera::projection>{projection});
    if (!is<kCamera, CameraMode::orbit>(act)) set<kCamera, CameraMode::orbit>(act);
  };
  const auto chosen = [](const ActionContext& act) {
    return is<&world::Camera::projection, projection>(act) && is<kCamera, CameraMode::orbit>(act);
  };
  return {name, "View/Camera", key(k), kInDrag, help, choose, kAlways, chosen, ctrl(with_ctrl)};
}
void next_camera(ActionContext& act) { choose_camera(act.ui, base::next_of(act.ui.session().settings.camera_mode)); }

constexpr auto kWorkspace = &Panels::workspace;
template <Workspace workspace>
constexpr Action go_to(std::string_view name, platform::KeyChord chord, std::string_view help) {
  const auto choose = [](ActionContext& act) { choose_workspace(act.ui, workspace); };
  return {name, "Window", chord, kInDrag, help, choose, kAlways, is<kWorkspace, workspace>};
}

constexpr ActionCondition kBuilding{[](const ActionContext& act) { return is<kWorkspace, Workspace::build>(act); },
                                    "Go to the workspace Build first."};
void fold_parameters(ActionContext& act) { act.ui.drawers.parameters.toggle(); }
bool parameters_show(const ActionContext& act) { return act.ui.drawers.parameters.open; }
// Opens the force graph or the table of sections, or folds the open one.
template <bool table>
void press_graph(ActionContext& act) {
  act.ui.drawers.press(table);
}
template <bool table>
bool graph_shows(const ActionContext& act) {
  return act.ui.drawers.graph.open && act.ui.drawers.table == table;
}

// Selects the next evaluator that is available here.
void next_evaluator(ActionContext& act) {
  const auto count = curve::evaluators().size();
  const auto now = static_cast<std::size_t>(act.ui.session().settings.evaluation->evaluator);
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t next = (now + i) % count;
    const auto stage = static_cast<std::size_t>(curve::evaluators()[next].evaluated_by);
    if (!act.ui.state.stats.stage_refusals[stage].empty()) continue;
    return act.ui.emit(edit::Set<&world::Evaluation::evaluator>{static_cast<curve::EvaluatorId>(next)});
  }
}
void set_steps(ActionContext& act, int steps) {
  act.ui.emit(edit::Set<&world::Evaluation::steps>{std::clamp(steps, curve::kMinSteps, curve::kMaxSteps)});
}
void more_steps(ActionContext& act) { set_steps(act, 2 * act.ui.session().settings.evaluation->steps); }
void fewer_steps(ActionContext& act) { set_steps(act, act.ui.session().settings.evaluation->steps / 2); }

// Opens or closes the pages, or first switches to a workspace that has them.
bool has_laboratory(const ActionContext& act) {
  return is<kWorkspace, Workspace::laboratory>(act) || is<kWorkspace, Workspace::all>(act);
}
bool laboratory_shows(const ActionContext& act) { return has_laboratory(act) && on<&Panels::show_laboratory>(act); }
void laboratory(ActionContext& act) {
  if (!has_laboratory(act)) choose_workspace(act.ui, Workspace::laboratory);
  else toggle<&Panels::show_laboratory>(act);
}

constexpr Action kViewActions[] = {
    go_to<Workspace::build>("Build workspace", key(Key::f8),
                            "Show the building tools: palette, parameters and force graph."),
    go_to<Workspace::ride>("Ride workspace", key(Key::f9), "Show the view and a slim bar to ride with."),
    go_to<Workspace::laboratory>("Laboratory workspace", key(Key::f10),
                                 "Show evaluators, resolution and the pages about curves."),
    {"Parameters", "Window", key(Key::f5), kInDrag, "Open or fold the parameters of Build.", fold_parameters, kBuilding,
     parameters_show},
    {"Force graph", "Window", key(Key::f6), kInDrag, "Open or fold the force graph of Build.", press_graph<false>,
     kBuilding, graph_shows<false>},
    {"Table of sections", "Window", key(Key::t), kInDrag, "Open or fold the table of sections of Build.",
     press_graph<true>, kBuilding, graph_shows<true>},
    go_to<Workspace::all>("All panels", kNoKey, "Show the panels of every workspace."),
    {"Full screen", "Window", key(Key::f11), kInDrag | kOnStart, "Fill the screen, or return to the window.",
     fill_screen},
    {"Frame all", "View", key(Key::f), kInDrag, "Show the whole track.", frame_all},
    {"Frame selection", "View", shift(Key::f), kInDrag, "Show the selection.", frame_selection, kAnySelected},
    {"Next camera", "View/Camera", key(Key::v), kInDrag, "Next camera: orbit, ride, chase, fly.", next_camera},
    camera<CameraMode::orbit>("Orbit camera", Key::d1, "Orbit a point with the mouse."),
    camera<CameraMode::ride>("Ride camera", Key::d2, "View from a seat of the first train.", kRideable),
    camera<CameraMode::chase>("Chase camera", Key::d3,
                              "Follow the first train from behind. The wheel sets the distance.", kRideable),
    camera<CameraMode::fly>("Fly camera", Key::d4,
                            "Fly with W A S D, Q down, E up, Shift faster. Drag to look around."),
    project<Projection::front>("Front view", Key::keypad_1, Key::d1,
                               "Look along -Z without perspective. Orbiting leaves the view."),
    project<Projection::side>("Side view", Key::keypad_3, Key::d3,
                              "Look along -X without perspective. Orbiting leaves the view."),
    project<Projection::top>("Top view", Key::keypad_7, Key::d7,
                             "Look down without perspective. Orbiting leaves the view."),
    project<Projection::perspective>("Perspective", Key::keypad_5, Key::d5, "Draw distant objects smaller."),
    toggling<&CameraFeel::head_bob>("Head-bob", "View/Camera", "Move the rider's head with g."),
    toggling<&CameraFeel::reduced_motion>("Reduced motion", "View/Camera",
                                          "Level horizon, cuts between cameras, no head-bob, no widening."),
    showing<Layer::knots>("Knots", "Show or hide knots that are not selected."),
    toggling<&EditingAids::show_gizmo>("Gizmo", "View/Show", "Show or hide the arrows that move the selected knots."),
    showing<Layer::supports>("Supports", "Show or hide the supports."),
    showing<Layer::conflicts>("Conflicts", "Show or hide places without clearance."),
    showing<Layer::legend>("Legend", "Show or hide the numbers of the track's colours."),
    toggling<&EditingAids::show_hints>("First steps", "View/Show", "Show or hide the first steps.", key(Key::f1)),
    choosing<&Appearance::theme, Theme::dark>("Dark theme", "View/Appearance", "Light on dark."),
    choosing<&Appearance::theme, Theme::light>("Light theme", "View/Appearance", "Dark on light."),
    choosing<&Appearance::theme, Theme::high_contrast>("High-contrast theme", "View/Appearance",
                                                       "White and bright colours on black, with outlines."),
    choosing<&Appearance::style, Style::day>("Day", "View/Appearance", "High sun, clear sky."),
    choosing<&Appearance::style, Style::dusk>("Dusk", "View/Appearance", "Low sun, long shadows."),
    choosing<&Appearance::style, Style::night>("Night", "View/Appearance", "Moonlight, stars and lamps."),
    choosing<&Appearance::style, Style::blueprint>("Blueprint", "View/Appearance",
                                                   "Lines on blue, for the laboratory and for print."),
    choosing<&Appearance::scenery, Scenery::plain>("Plain scenery", "View/Scenery",
                                                   "Land and flat water, no trees: for measuring and for print."),
    choosing<&Appearance::scenery, Scenery::park>("Park scenery", "View/Scenery",
                                                  "Trees, water, and soft light from all sides."),
    choosing<&Appearance::scenery, Scenery::rich>(
        "Rich scenery", "View/Scenery", "The same with more trees and grass near the eye, for fast graphics cards."),
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

// The recently used files in the menu File.
void build_recent(ActionContext& act) {
  const UserState* const kept = act.ui.state.kept;
  const bool any = kept != nullptr && !kept->settings.recent.empty();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetTextLineHeight());
  const bool open = ImGui::BeginMenu("Recent", any);
  if (open) {
    for (const std::string& file : kept->settings.recent) {
      const std::string label = name_among(file, kept->settings.recent, true);
      ImGui::PushID(file.c_str());
      const bool pressed = ImGui::MenuItem(label.c_str());
      note_item(act.ui, "File/Recent/" + label, "menu", file, true, "off");
      ImGui::PopID();
      if (pressed) act.ui.replace(edit::LoadTrack{file});
    }
    ImGui::EndMenu();
  }
  note(act.ui, "File/Recent", "menu",
       open  ? ""
       : any ? "Recently used files."
             : "No files have been used yet.",
       any, open ? "open" : "closed", low, high);
}

void build_items(ActionContext& act, std::string_view menu);

// A menu of the bar, or one inside another: its title, and its items while it is open.
void build_one(ActionContext& act, std::string_view menu) {
  const std::size_t slash = menu.rfind('/');
  const bool inner = slash != std::string_view::npos;
  const std::string title(inner ? menu.substr(slash + 1) : menu);
  // Once the menu is open, ImGui's last item is not its title, so the position of the title is read before.
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = inner ? ImGui::GetContentRegionAvail().x : text_size(title).x + ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 high(low.x + width, low.y + (inner ? ImGui::GetTextLineHeight() : ImGui::GetFrameHeight()));
  const bool open = ImGui::BeginMenu(title.c_str());
  if (open) {
    build_items(act, menu);
    ImGui::EndMenu();
  }
  note(act.ui, menu, "menu", open ? "" : "Open the menu.", true, open ? "open" : "closed", low, high);
}

void build_item(ActionContext& act, const Action& action) {
  const bool enabled = action.enabled.holds(act);
  const bool checked = action.checked != nullptr && action.checked(act);
  const std::string label(action.name), keys = act.ui.keys.shown(action.name);
  const bool pressed = ImGui::MenuItem(label.c_str(), keys.empty() ? nullptr : keys.c_str(), checked, enabled);
  std::string help = with_keys(act.ui.keys, action.help, action.name);
  if (!enabled) help += fmt::format(" {}", action.enabled.otherwise);
  note_item(act.ui, fmt::format("{}/{}", action.menu, label), "menu", help, enabled, checked ? "on" : "off");
  if (pressed) action.run(act);
}

// Each menu inside takes the place of its first item.
void build_items(ActionContext& act, std::string_view menu) {
  std::vector<std::string_view> inside;
  for (const Action& action : actions()) {
    if (action.menu == menu) {
      build_item(act, action);
      if (action.name == "Open") build_recent(act);
    } else if (action.menu.starts_with(menu) && std::find(inside.begin(), inside.end(), action.menu) == inside.end()) {
      inside.push_back(action.menu);
      build_one(act, action.menu);
    }
  }
}

void build_menus(ActionContext& act) {
  constexpr const char* kMenus[] = {"File", "Edit", "View", "Ride", "Window"};
  constexpr int kCount = std::size(kMenus);
  const int popups = open_popups();
  int open = -1;
  for (int i = 0; i < kCount; ++i) {
    if (ImGui::IsPopupOpen(kMenus[i])) open = i;
    build_one(act, kMenus[i]);
  }
  const int step = open < 0 ? 0 : take_menu_step(popups);
  if (step != 0) ImGui::OpenPopup(kMenus[(open + step + kCount) % kCount]);
}

struct Tab {
  world::Workspace workspace;
  std::string_view action;
};
constexpr Tab kTabs[] = {{world::Workspace::build, "Build workspace"},
                         {world::Workspace::ride, "Ride workspace"},
                         {world::Workspace::laboratory, "Laboratory workspace"}};

// A tab for each workspace except `all`, which is in the menu Window; the selected one is underlined.
void build_tabs(Ui& ui) {
  const world::Workspace now = ui.session().settings.panels->workspace;
  const float pad = std::floor(10 * ui.scale), y = ImGui::GetCursorPosY();
  const TabBar bar{.height = ImGui::GetWindowHeight(), .pad = pad, .rgb = palette().accent};
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + pad);
  for (const auto& [workspace, action] : kTabs) {
    const base::NameRow& row = base::row_of(workspace);
    const std::string help = with_keys(ui.keys, row.help, action);
    if (tab(ui, fmt::format("Workspace/{}", row.label), help, workspace == now, bar)) choose_workspace(ui, workspace);
  }
  ImGui::SetCursorPosY(y);
}

// Shows the file and the mark of unsaved changes at the right end.
void build_file_mark(Ui& ui) {
  const edit::Session& session = ui.session();
  const std::string holder = ui.state.kept != nullptr ? ui.state.kept->holder : "";
  const std::string name = session.file.path.empty() ? "no file" : session.file.path.filename().string();
  const bool unsaved = edit::dirty(ui.find);
  if (!unsaved && holder.empty()) return;
  const std::string mark = unsaved ? "\u25CF " : "", use = holder.empty() ? "" : " (in use elsewhere)";
  const float right = ImGui::GetWindowWidth() - std::floor(10 * ui.scale);
  const float room = right - ImGui::GetCursorPosX() - text_size(mark + use).x;
  const std::string words = mark + shortened(name, room) + use;
  const float left = right - text_size(words).x;
  if (left < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(left);
  tinted_line(words, palette().warning);
  note_item(ui, "Unsaved", "label",
            holder.empty() ? "The track differs from its file."
                           : fmt::format("This file is open in {}. Save under another name.", holder),
            true, words);
}

}  // namespace

void choose_workspace(Ui& ui, Workspace to) {
  ui.emit(edit::Set<&Panels::workspace>{to});
  if (to == Workspace::laboratory && !ui.session().settings.panels->show_laboratory)
    ui.emit(edit::Set<&Panels::show_laboratory>{true});
}

std::span<const Action> view_actions() { return kViewActions; }

void build_menu(ActionContext& act) {
  if (!ImGui::BeginMainMenuBar()) return;
  act.ui.panel = "Menu";
  build_menus(act);
  build_tabs(act.ui);
  build_file_mark(act.ui);
  act.ui.panel.clear();
  ImGui::EndMainMenuBar();
}

}  // namespace coaster::ui
