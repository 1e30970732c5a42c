// The actions of the menus File, Ride and Edit, the table of all actions, and the keys that run them.
#include "ui/actions/actions.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "base/text.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "exchange/own/share_link.h"
#include "ui/actions/actions_detail.h"
#include "ui/tools/camera_controls.h"
#include "ui/tools/selecting.h"
#include "ui/tools/show_places.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/panel_settings.h"
#include "world/sections.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::ui {
namespace {

using platform::Key;

constexpr ActionCondition kSectionSelected{
    [](const ActionContext& act) { return selected_is(act, world::EntityKind::section); }, "Select a section first."};

template <ScreenRequest::Kind kind>
void want(ActionContext& act) {
  act.ui.want = {kind};
}
template <class Command>
void emit(ActionContext& act) {
  act.ui.emit(Command{});
}
void start_empty(ActionContext& act) { act.ui.replace(act.ui.new_track()); }
template <PictureRequest wish>
void photo(ActionContext& act) {
  act.ui.out.photo = wish;
}
constexpr ActionCondition kInChallenge{
    [](const ActionContext& act) { return act.ui.session().game.challenge.has_value(); }, "No challenge is open."};
// Shares the track as a link, or as a file if it is too large for a link.
void share(ActionContext& act) {
  act.ui.emit(edit::CopyLink{});
  if (edit::link_of(act.ui.session()).size() > exchange::kMaxLinkBytes) act.ui.want = {ScreenRequest::Kind::save_as};
}
bool filming(const ActionContext& act) { return act.ui.state.movie != nullptr; }
constexpr ActionCondition kFilmable{[](const ActionContext& act) { return filming(act) || kRideable.holds(act); },
                                    kRideable.otherwise};
void record_movie(ActionContext& act) { act.ui.out.movie = filming(act) ? MovieRequest::stop : MovieRequest::start; }

constexpr Action kFileActions[] = {
    {"New", "File", ctrl(Key::n), kOnStart, "Start an empty track.", start_empty},
    {"Open", "File", ctrl(Key::o), kOnStart, "Choose a track file to open.", want<ScreenRequest::Kind::browse>},
    {"Save", "File", ctrl(Key::s), 0, "Save the track to its file.", want<ScreenRequest::Kind::save>},
    {"Save as", "File", ctrl_shift(Key::s), 0, "Save to another file or export. The file extension selects the format.",
     want<ScreenRequest::Kind::save_as>},
    {"Share", "File", ctrl_shift(Key::l), 0,
     "Copy a link that opens this track in this view. It holds the whole track.", share},
    {"Save sections", "File", kNoKey, 0, "Save the selected sections to a file of their own.",
     want<ScreenRequest::Kind::save_sections>, kSectionSelected},
    {"Add sections", "File", kNoKey, 0, "Add the sections of a file at the open end of the track.",
     want<ScreenRequest::Kind::open_sections>},
    {"Start screen", "File", kNoKey, 0, "Recent tracks, samples, challenges and the tutorial.",
     want<ScreenRequest::Kind::start_screen>},
    {"Tutorial", "File", kNoKey, kOnStart, "Build and ride your first coaster, step by step.",
     want<ScreenRequest::Kind::tutorial>},
    {"Challenges", "File", ctrl(Key::h), kOnStart, "Choose a challenge with a goal and three medals.",
     want<ScreenRequest::Kind::challenges>},
    {"Leave challenge", "File", kNoKey, 0, "Leave the challenge. The track stays as it is.", emit<edit::LeaveChallenge>,
     kInChallenge},
    {"Settings", "File", ctrl(Key::comma), kOnStart, "Scale, theme, sound, autosave and keys.",
     want<ScreenRequest::Kind::settings>},
    {"Screenshot", "File", key(Key::f12), kInDrag, "Save a picture of the scene, without panels and selection.",
     photo<PictureRequest::scene>},
    {"Screenshot with panels", "File", ctrl(Key::f12), kInDrag, "Save a picture of the whole window.",
     photo<PictureRequest::window>},
    {"Record movie", "File", shift(Key::f12), kInDrag,
     "Record one lap as pictures and, where ffmpeg is installed, as a movie. Again to stop.", record_movie, kFilmable,
     filming},
    {"Quit", "File", ctrl(Key::q), kOnStart, "Quit coaster.", want<ScreenRequest::Kind::quit>},
};

bool running(const ActionContext& act) { return act.ui.session().motion.state == world::RideState::running; }
void play_pause(ActionContext& act) { running(act) ? act.ui.emit(edit::RidePause{}) : act.ui.emit(edit::RideStart{}); }
void single_step(ActionContext& act) {
  if (running(act)) act.ui.emit(edit::RidePause{});
  act.ui.emit(edit::RideStep{1});
}
constexpr ActionCondition kFailed{[](const ActionContext& act) { return failed_place(act.ui.session()).has_value(); },
                                  "No ride has failed."};
void show_failed_place(ActionContext& act) { show_place(act.ui, *failed_place(act.ui.session())); }

constexpr Action kRideActions[] = {
    {"Play or pause", "Ride", key(Key::space), kInDrag, "Start or pause the ride.", play_pause, kRideable},
    {"Single step", "Ride", key(Key::period), kRepeats | kInDrag, "Pause the ride and advance one tick of 1/120 s.",
     single_step, kRideable},
    {"Reset", "Ride", shift(Key::r), kInDrag, "Return the trains to their start.", emit<edit::RideStop>, kRideable},
    {"Show where it failed", "Ride", key(Key::j), kInDrag,
     "Go to where the last ride or its challenge failed and select the segment.", show_failed_place, kFailed},
    toggling<&world::EditingAids::show_card>("Score cards", "Ride", "Show a card with results at the end of a ride."),
};

using world::Entity;
using world::EquipmentKind;

// Returns the section under the cursor, else that of the selected knot or segment; kNone without one.
Entity section_here(const ActionContext& act) {
  const edit::Session& session = act.ui.session();
  if (const Entity under = section_under(session, act.hovered); under.valid()) return under;
  const Entity selected = session.settings.selected;
  if (const auto* const segment = session.document.entities.find<world::Segment>(selected)) return segment->section;
  const bool knot = session.document.entities.find<world::Knot>(selected) != nullptr;
  return knot ? world::section_of_knot(session.document, selected) : world::kNone;
}
constexpr ActionCondition kInSection{[](const ActionContext& act) { return section_here(act).valid(); },
                                     "Point at the track, or select a knot or a segment first."};
void select_section(ActionContext& act) {
  act.ui.emit(edit::Select{{world::name_of(act.ui.session().document, section_here(act))}});
}

constexpr ActionCondition kHasSections{
    [](const ActionContext& act) { return !act.ui.session().document.track.segments.empty(); },
    "The track has no sections."};
// Steps from the active section, else from the one with something selected; without one to the first or the last. A
// closed track goes on at its other end.
void step_section(ActionContext& act, bool on, bool adds) {
  const edit::Session& session = act.ui.session();
  const std::vector<world::SectionRun> runs = world::sections_of(session.document);
  Entity from = session.settings.selected;
  const bool among = selected_is(act, world::EntityKind::section);
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
  act.ui.out.commands.push_back(selection_of(session.document, sections));
}
template <bool on, bool adds>
void step(ActionContext& act) {
  step_section(act, on, adds);
}

// Emits a command for each selected section, as one step of undo.
template <class Make>
void for_each_section(ActionContext& act, const Make& make) {
  const edit::Session& session = act.ui.session();
  act.ui.emit_each(world::selected_sections(session.document, session.settings),
                   [&](Entity e) { act.ui.emit(make(world::name_of(session.document, e))); });
}
template <class Command>
void each(ActionContext& act) {
  for_each_section(act, [](world::EntityName name) { return Command{{name}}; });
}
template <EquipmentKind kind>
void equip(ActionContext& act) {
  for_each_section(act, [](world::EntityName name) { return edit::EquipSection{{name}, {kind}}; });
}
template <edit::Neighbour to>
void move(ActionContext& act) {
  act.ui.emit(edit::MoveSection{{*selected(act)}, to});
}
void join(ActionContext& act) { act.ui.emit(edit::JoinSections{{*selected(act)}}); }
void copy(ActionContext& act) { act.ui.out.commands.push_back(copying(act.ui.session())); }
void paste(ActionContext& act) { act.ui.out.wants_paste = true; }

// Gives the keyboard to the first number field of Build; Tab moves to the next.
constexpr ActionCondition kHasValues{
    [](const ActionContext& act) { return selected(act) != nullptr || on<&world::EditingAids::show_element>(act); },
    "Choose an element or select something first."};
void edit_values(ActionContext& act) {
  Ui& ui = act.ui;
  if (is<&world::Panels::workspace, world::Workspace::build>(act) && !ui.drawers.parameters.open)
    ui.drawers.parameters.toggle();
  if (ui.wish)
    ui.wish->panel = on<&world::EditingAids::show_element>(act)     ? "Elements"
                     : selected_is(act, world::EntityKind::section) ? "Section"
                                                                    : "Inspector";
}

constexpr ActionCondition kOpenTrack{[](const ActionContext& act) {
                                       const world::Track& track = act.ui.session().document.track;
                                       return !track.closed && !track.segments.empty();
                                     },
                                     "Only an open track with a segment can be continued."};

constexpr Action kSectionActions[] = {
    {"Edit values", "Edit", key(Key::p), 0,
     "Type the first value of the chosen element or the selection. Tab: the next.", edit_values, kHasValues},
    {"Add force section", "Edit", kNoKey, 0, "Add a section at the open end whose forces you draw in the force graph.",
     emit<edit::AddForceSection>, kOpenTrack},
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
};
constexpr auto kEquipmentActions = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array{Action{world::kEquipmentKinds[I].action, "", kNoKey, 0, world::kEquipmentKinds[I].action_help,
                           equip<static_cast<world::EquipmentKind>(I)>, kSectionSelected}...};
}
(std::make_index_sequence<world::kEquipmentCount>());
constexpr Action kPlainTrackActions[] = {
    {"Make plain track", "", kNoKey, 0, "Remove the equipment of the selected sections.", each<edit::UnequipSection>,
     kSectionSelected},
};

using world::EditingAids;
using world::EntityKind;

constexpr ActionCondition kRemovable{
    [](const ActionContext& act) { return selected(act) != nullptr && !selected_is(act, EntityKind::segment); },
    "Select a knot, a section or a train first."};
constexpr ActionCondition kKnotSelected{[](const ActionContext& act) { return selected_is(act, EntityKind::knot); },
                                        "Select a knot first."};
constexpr ActionCondition kAnyKnots{
    [](const ActionContext& act) { return !act.ui.session().document.track.knots.empty(); }, "The track has no knots."};
constexpr ActionCondition kCanUndo{[](const ActionContext& act) {
                                     return !act.ui.session().history.undo.empty() ||
                                            act.ui.session().history.in_gesture;
                                   },
                                   "There is nothing to undo."};
constexpr ActionCondition kCanRedo{[](const ActionContext& act) { return !act.ui.session().history.redo.empty(); },
                                   "There is nothing to redo."};

constexpr ActionCondition kInsertable{[](const ActionContext& act) {
                                        return act.hovered.kind == view::PickKind::curve ||
                                               selected_is(act, EntityKind::segment);
                                      },
                                      "Point at the track or select a segment first."};

// Cancels a drag in the viewport or in a number field. Returns false if no drag changes the document.
bool cancel_drags(ActionContext& act) {
  if (act.tool.cancel(act.ui)) return true;
  if (!act.ui.gesture.open) return false;
  act.ui.emit(edit::CancelGesture{});
  act.ui.gesture = {};
  ImGui::ClearActiveID();
  return true;
}

void undo(ActionContext& act) {
  if (!cancel_drags(act)) act.ui.emit(edit::Undo{});
}
void remove(ActionContext& act) {
  const edit::Session& session = act.ui.session();
  const std::vector<world::Entity> knots = world::selected_knots(session.document, session.settings);
  if (selected_is(act, EntityKind::section)) return each<edit::DeleteSection>(act);
  if (knots.size() < 2) return act.ui.emit(edit::RemoveKnotOrTrain{{*selected(act)}});
  act.ui.emit_each(knots,
                   [&](Entity e) { act.ui.emit(edit::RemoveKnotOrTrain{{world::name_of(session.document, e)}}); });
}
// Shows the panel in Build, or where every panel shows.
void set_goal(ActionContext& act) {
  if (!is<&world::Panels::workspace, world::Workspace::all>(act)) choose_workspace(act.ui, world::Workspace::build);
  if (!act.ui.drawers.parameters.open) act.ui.drawers.parameters.wanted = true;
  act.ui.inputs.panel_to_open = "Goal";
}
void select_all(ActionContext& act) { act.ui.emit(edit::SelectKnots{edit::Knots::Which::all}); }
void box_select(ActionContext& act) { act.tool.wait_for_box(); }
template <TransformKind kind>
void transform(ActionContext& act) {
  act.tool.transform().begin(act.ui, kind, {}, std::nullopt);
}

bool snapping(const ActionContext& act) { return act.ui.session().settings.snapping.to != world::SnapTo::off; }
void next_snapping(ActionContext& act) {
  const world::Snapping& s = act.ui.session().settings.snapping;
  act.ui.emit(edit::SetSnapping{base::next_of(s.to), s.step, s.angle});
}

void escape(ActionContext& act) {
  if (cancel_drags(act) || act.ui.state.job.progress) return;  // the job's card takes it
  if (card_shows(act.ui.session())) act.ui.emit(edit::CloseCard{});
  else if (act.ui.session().settings.aids->brush != world::Brush::off)
    act.ui.emit(edit::Set<&EditingAids::brush>{world::Brush::off});
  else if (on<&EditingAids::append_mode>(act)) toggle<&EditingAids::append_mode>(act);
  else if (act.ui.session().settings.aids->circuit > 0) act.ui.emit(edit::Set<&EditingAids::circuit>{0});
  else if (on<&EditingAids::show_element>(act)) toggle<&EditingAids::show_element>(act);
  else if (selected(act) != nullptr) act.ui.emit(edit::Select{});
}

void insert_point(ActionContext& act) {
  const edit::Session& session = act.ui.session();
  if (act.hovered.kind == view::PickKind::curve && session.document.entities.alive(act.hovered.entity))
    act.ui.emit(edit::SplitSegment{{world::name_of(session.document, act.hovered.entity)}, act.hovered.t});
  else if (selected_is(act, EntityKind::segment))
    act.ui.emit(edit::SplitSegment{{*selected(act)}, session.settings.selected_t});
}

// True if the preview of the palette's element or of a closing section shows.
bool preview_shows(const ActionContext& act) {
  return on<&EditingAids::show_element>(act) || act.ui.session().settings.aids->circuit > 0;
}

// True if a cell of the table of sections can be edited and no preview waits to be placed.
bool has_cell(const ActionContext& act) {
  const bool shows = is<&world::Panels::workspace, world::Workspace::build>(act) && act.ui.drawers.table;
  return shows && act.ui.drawers.graph.open && !preview_shows(act) && selected_is(act, EntityKind::section);
}
// What does not fit is refused with the reason.
constexpr ActionCondition kPlaceable{[](const ActionContext& act) { return preview_shows(act) || has_cell(act); },
                                     "Choose an element first."};
void place_element(ActionContext& act) {
  if (has_cell(act)) act.ui.inputs.cell = EditedCell{*selected(act), {}};
  else if (act.ui.session().settings.aids->circuit > 0) place_proposal(act.ui);
  else place_shown_element(act.ui);
}

constexpr ActionCondition kAppendable{[](const ActionContext& act) { return append_mode_switches(act.ui.session()); },
                                      world::kClosedTrack};

constexpr ActionCondition kCompletable{[](const ActionContext& act) { return completable(act.ui.session().document); },
                                       "Only an open track with a segment can be completed."};
void complete_circuit(ActionContext& act) { show_proposals(act.ui); }

// Steps among the shapes or among the force elements. The first press shows the preview of the present one, on an empty
// track that of a straight, where a ride begins.
void step_element(ActionContext& act, bool forwards) {
  if (act.ui.session().settings.aids->circuit > 0) act.ui.emit(edit::Set<&EditingAids::circuit>{0});
  const auto kind = act.ui.session().settings.element.kind;
  if (!on<&EditingAids::show_element>(act))
    return choose_element(act.ui, act.ui.session().document.track.knots.empty() ? world::ElementKind::straight : kind);
  const bool of_forces = world::is_of_forces(kind);
  const std::size_t first = of_forces ? world::elements().size() : 0,
                    count = of_forces ? world::force_elements().size() : world::elements().size();
  const std::size_t next = first + (static_cast<std::size_t>(kind) - first + (forwards ? 1 : count - 1)) % count;
  choose_element(act.ui, static_cast<world::ElementKind>(next));
}
void next_element(ActionContext& act) { step_element(act, true); }
void previous_element(ActionContext& act) { step_element(act, false); }

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
     emit<edit::SplitLongestSegment>},
    {"Insert point", "Edit", key(Key::i), 0,
     "Insert a knot under the cursor or at the selected position. The shape is unchanged.", insert_point, kInsertable},
    {"Append points", "Edit", key(Key::a), 0, "Click on the ground to append knots to an open track.",
     toggle<&EditingAids::append_mode>, kAppendable, on<&EditingAids::append_mode>},
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
     "Cancel a drag, close the score card, lay the brush away, end append mode, hide the preview, or clear the "
     "selection.",
     escape},
};

}  // namespace

using platform::KeyChord;
using world::CameraMode;

const world::EntityName* selected(const ActionContext& act) {
  const edit::Session& session = act.ui.session();
  return session.document.entities.find<world::EntityName>(session.settings.selected);
}

bool selected_is(const ActionContext& act, world::EntityKind kind) {
  const world::EntityName* const name = selected(act);
  return name != nullptr && name->kind == kind;
}

std::span<const Action> actions() {
  static const std::vector<Action> kAll = [] {
    std::vector<Action> all;
    for (const auto rows :
         std::initializer_list<std::span<const Action>>{kFileActions, kEditActions, kSectionActions, kEquipmentActions,
                                                        kPlainTrackActions, view_actions(), kRideActions})
      all.insert(all.end(), rows.begin(), rows.end());
    return all;
  }();
  return kAll;
}

std::vector<KeyRow> key_rows() {
  std::vector<KeyRow> rows;
  for (const Action& action : actions()) rows.push_back({action.name, action.chord, action.other});
  return rows;
}

void run_transform_keys(ActionContext& act, const platform::Events& events) {
  platform::Events others;
  for (const platform::Event& event : events) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    if (press && press->down && (press->key == Key::escape || press->modifiers.ctrl)) others.push_back(event);
  }
  act.tool.transform().take_keys(events);
  run_keys(act, others);
}

void run_keys(ActionContext& act, const platform::Events& events, unsigned only) {
  for (const platform::Event& event : events) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    if (press == nullptr || !press->down || press->key == Key::unknown) continue;
    if (is_fly_key(*press) && act.ui.session().settings.camera_mode == CameraMode::fly) continue;
    const KeyChord chord{press->key, press->modifiers};
    for (const Action& action : actions()) {
      const auto chords = act.ui.keys.chords(action.name);
      if (std::find(chords.begin(), chords.end(), chord) == chords.end()) continue;
      if (press->repeat && (action.keys & kRepeats) == 0) continue;
      if ((action.keys & only) != only) continue;
      if ((action.keys & kInDrag) == 0 && (act.tool.dragging() || act.ui.gesture.open)) continue;
      if (action.enabled.holds(act)) action.run(act);
      else if (!press->repeat) act.ui.warn(base::sentence(std::string(action.enabled.otherwise)));
    }
  }
}

}  // namespace coaster::ui
