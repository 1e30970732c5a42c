// The settings window: scale, colours, motion, autosave, and the keys of every action.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "platform/sound.h"
#include "ui/actions/actions.h"
#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"
#include "ui/screens/dialogs.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

// A list instead of a slider, which would move away under the mouse.
void scale(Ui& ui) {
  const int now = static_cast<int>(std::lround(100 * ui.session().settings.look->ui_scale));
  std::vector<int> percents{75, 90, 100, 110, 125, 150, 175, 200, 250, 300};
  const auto place = std::lower_bound(percents.begin(), percents.end(), now);
  const auto current = static_cast<int>(place - percents.begin());
  if (place == percents.end() || *place != now) percents.insert(place, now);
  std::vector<Choice> choices;
  for (const int percent : percents) choices.push_back({std::to_string(percent) + " %", "Size of text and panels."});
  if (const auto to = combo(ui, "Scale", choices, current, "Size of text and panels."))
    ui.emit(edit::Set<&world::Appearance::ui_scale>{static_cast<float>(percents[static_cast<std::size_t>(*to)]) / 100});
}

void look(Ui& ui) {
  scale(ui);
  setting_list<&world::Appearance::theme>(ui, "Theme", "Colours of the panels.");
  setting_list<&world::Appearance::style>(ui, "Scene", "Light, sky and ground.");
  setting_list<&world::Appearance::scenery>(ui, "Scenery", "How much of the surroundings is drawn.");
  setting_list<&world::EditingAids::new_land>(ui, "New tracks", "The land that new tracks begin on. Plain: no park.");
  setting_list<&world::Appearance::units>(ui, "Units", "Units of lengths and speeds. Files and scripts stay metric.");
  const bool built = platform::sound_library() != "none";
  if (const auto to = slider(ui, "Sound (%)", static_cast<int>(std::lround(100 * ui.session().settings.look->sound)), 0,
                             100, false, built ? "Ride volume. 0 mutes it." : "This build has no sound (OpenAL)."))
    ui.emit(edit::Set<&world::Appearance::sound>{static_cast<float>(*to) / 100});
  setting_box<&world::Appearance::shadows>(ui, "Shadows", "Turn shadows on or off. Frames are faster without them.");
  ImGui::SameLine();
  setting_box<&world::CameraFeel::reduced_motion>(ui, "Reduced motion",
                                                  "Level horizon, cuts between cameras, no head-bob, no widening.");
}

void keeping(Ui& ui) {
  if (ui.state.kept == nullptr) return;
  const exchange::UserSettings& now = ui.state.kept->settings;
  const int seconds = static_cast<int>(std::lround(now.autosave_seconds));
  if (const auto to =
          slider(ui, "Autosave every (s)", seconds, static_cast<int>(exchange::kMinAutosave),
                 static_cast<int>(exchange::kMaxAutosave), true, "Seconds between a change and its autosave."))
    change_kept(ui).autosave_seconds = std::clamp<double>(*to, exchange::kMinAutosave, exchange::kMaxAutosave);
  if (button(ui, "Clear recent files###Forget recent files", "Clear the list of recent files.", !now.recent.empty()))
    change_kept(ui).recent.clear();
  ImGui::SameLine();
  setting_box<&world::EditingAids::show_hints>(ui, "Hints", "Show the first steps in the viewport.");
  ImGui::SameLine();
  setting_box<&world::EditingAids::show_card>(ui, "Score cards", "Show a card with results at the end of a ride.");
}

// Returns the choices with another one for an action: a key, which is removed from other choices, or none. Default keys
// need no choice.
std::vector<exchange::KeyBinding> with_choice(std::vector<exchange::KeyBinding> keys, const Action& action,
                                              std::optional<platform::KeyChord> chord) {
  std::erase_if(keys, [&](const exchange::KeyBinding& c) { return c.action == action.name; });
  if (chord)
    for (exchange::KeyBinding& other : keys)
      std::erase_if(other.keys, [&](const std::string& text) { return platform::parse_chord(text) == chord; });
  exchange::KeyBinding choice{std::string(action.name), {}};
  if (chord) choice.keys.push_back(platform::to_text(*chord));
  std::vector<std::string> own;
  for (const platform::KeyChord& one : {action.chord, action.other})
    if (one.key != platform::Key::unknown) own.push_back(platform::to_text(one));
  if (choice.keys != own) keys.push_back(std::move(choice));
  return keys;
}

void give_key(Ui& ui, const Action& action, std::optional<platform::KeyChord> chord) {
  const std::string key = chord ? platform::to_text(*chord) : "";
  ui.inputs.keys_note =
      chord ? fmt::format("{} has the key {}.", action.name, key) : fmt::format("{} has no key.", action.name);
  for (const Action& other : actions()) {
    const auto chords = ui.keys.chords(other.name);
    if (chord && other.name != action.name && std::find(chords.begin(), chords.end(), *chord) != chords.end())
      ui.inputs.keys_note = fmt::format("{} now belongs to {}, not to {}.", key, action.name, other.name);
  }
  change_kept(ui).keys = with_choice(ui.state.kept->settings.keys, action, chord);
}

// Handles the key for the action that waits for one: Escape keeps its keys, Backspace removes them.
void take_key(Ui& ui, const platform::Events& events) {
  const auto waiting = std::find_if(actions().begin(), actions().end(),
                                    [&](const Action& a) { return a.name == ui.inputs.waits_for_key; });
  if (waiting == actions().end()) return;
  for (const platform::Event& event : events) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    if (press == nullptr || !press->down || press->repeat || press->key == platform::Key::unknown) continue;
    ui.inputs.waits_for_key.clear();
    const platform::KeyChord chord{press->key, press->modifiers};
    if (chord == platform::KeyChord{platform::Key::escape, {}}) return;
    const bool none = chord == platform::KeyChord{platform::Key::backspace, {}};
    return give_key(ui, *waiting, none ? std::nullopt : std::optional(chord));
  }
}

void key_row(Ui& ui, const Action& action) {
  begin_row(action.name);
  const bool waits = ui.inputs.waits_for_key == action.name;
  const std::string keys = chords_text(ui.keys.chords(action.name), ", "), words = waits ? "Press a key" : keys;
  if (waits) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool pressed =
      ImGui::Button(fmt::format("{}##{}", words, action.name).c_str(), {sized(ImGui::CalcItemWidth()), 0});
  if (waits) ImGui::PopStyleColor();
  note_item(ui, action.name, "button", action.help, true, words);
  if (pressed) ui.inputs.waits_for_key = waits ? "" : action.name;
}

void key_list(Ui& ui, const platform::Events& events) {
  if (ui.state.kept == nullptr) return;
  take_key(ui, events);
  heading(ui, "Keys", "Click an action, then press its key. Escape keeps its keys, Backspace removes them.");
  const float below = 2 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  if (ImGui::BeginChild("##keys",
                        {0, sized(std::max(3 * ImGui::GetFrameHeight(), ImGui::GetContentRegionAvail().y - below))},
                        true)) {
    ui.panel = "Settings/Keys";  // some actions have the same names as rows above
    for (const Action& action : actions()) key_row(ui, action);
    ui.panel = "Settings";
  }
  ImGui::EndChild();
  const std::string& note = ui.inputs.keys_note;
  paragraph(ui, "Keys note", note.empty() ? "Click an action, then press its key." : note, palette().dim);
  if (button(ui, "Default keys", "Reset every action to its default keys.", !ui.state.kept->settings.keys.empty())) {
    change_kept(ui).keys.clear();
    ui.inputs.keys_note.clear();
  }
  ImGui::SameLine();
}

}  // namespace

bool build_settings(Ui& ui, const platform::Events& events) {
  const bool waits = !ui.inputs.waits_for_key.empty();
  look(ui);
  keeping(ui);
  key_list(ui, events);
  const bool closed =
      button(ui, "Close", "Back to the track. Key Escape.") || (!waits && pressed(events, platform::Key::escape));
  if (closed) ui.inputs.waits_for_key.clear(), ui.inputs.keys_note.clear();
  return closed;
}

}  // namespace coaster::ui
