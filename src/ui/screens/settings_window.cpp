// The settings window: scale, colours, motion, autosave, and the keys of every action.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "platform/sound.h"
#include "ui/actions/actions.h"
#include "ui/context/rows.h"
#include "ui/context/setting_rows.h"
#include "ui/screens/dialogs.h"

namespace coaster::ui {
namespace {

// A list: a slider would move away under the mouse.
void scale(Ui& ui) {
  const int now = static_cast<int>(std::lround(100 * ui.session().settings.look->ui_scale));
  std::vector<int> percents{75, 90, 100, 110, 125, 150, 175, 200, 250, 300};
  const auto place = std::lower_bound(percents.begin(), percents.end(), now);
  const auto current = static_cast<int>(place - percents.begin());
  if (place == percents.end() || *place != now) percents.insert(place, now);
  std::vector<Choice> choices;
  for (const int percent : percents) choices.push_back({std::to_string(percent) + " %", "Size of text and panels."});
  if (const auto to = combo(ui, "Scale", choices, current, "Size of text and panels."))
    ui.emit(edit::Set<&world::Look::ui_scale>{static_cast<float>(percents[static_cast<std::size_t>(*to)]) / 100});
}

void look(Ui& ui) {
  scale(ui);
  setting_list<&world::Look::theme>(ui, "Theme", "Colours of the panels.");
  setting_list<&world::Look::style>(ui, "Scene", "Light, sky and ground.");
  setting_list<&world::Look::units>(ui, "Units", "Units of lengths and speeds. Files and scripts stay metric.");
  const bool built = platform::sound_library() != "none";
  if (const auto to = slider(ui, "Sound (%)", static_cast<int>(std::lround(100 * ui.session().settings.look->sound)), 0,
                             100, false, built ? "Ride volume. 0 mutes it." : "This build has no sound (OpenAL)."))
    ui.emit(edit::Set<&world::Look::sound>{static_cast<float>(*to) / 100});
  setting_box<&world::Look::shadows>(ui, "Shadows", "Turn shadows on or off. Frames are faster without them.");
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
  setting_box<&world::Aids::show_hints>(ui, "Hints", "Show the first steps in the viewport.");
  ImGui::SameLine();
  setting_box<&world::Aids::show_card>(ui, "Score cards", "Show a card with results at the end of a ride.");
}

// Returns the choices with another one for an action. Its default keys are no choice.
std::vector<exchange::KeyChoice> with_choice(std::vector<exchange::KeyChoice> keys, const Action& action,
                                             const std::string& typed) {
  std::erase_if(keys, [&](const exchange::KeyChoice& c) { return c.action == action.name; });
  exchange::KeyChoice choice{std::string(action.name), {}};
  std::vector<base::Token> words;
  base::TextError error;
  if (base::tokenise(typed, words, error))
    for (const base::Token& word : words) choice.keys.push_back(word.text);
  std::vector<std::string> own;
  for (const platform::Chord& chord : {action.chord, action.other})
    if (chord.key != platform::Key::unknown) own.push_back(platform::to_text(chord));
  if (choice.keys != own && choice.keys.size() <= 2) keys.push_back(std::move(choice));
  return keys;
}

void key_fields(Ui& ui) {
  if (ui.state.kept == nullptr) return;
  const exchange::UserSettings& now = ui.state.kept->settings;
  heading(ui, "Keys", "One or two keys per action, such as Ctrl+Z. Empty: none.");
  const float below = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  if (ImGui::BeginChild("##keys", {0, std::max(3 * ImGui::GetFrameHeight(), ImGui::GetContentRegionAvail().y - below)},
                        true)) {
    ui.panel = "Settings/Keys";  // some actions are named like rows above
    for (const Action& action : actions())
      if (const auto typed = text(ui, action.name, chords_text(ui.keys.chords(action.name), " "), action.help))
        change_kept(ui).keys = with_choice(now.keys, action, *typed);
    ui.panel = "Settings";
  }
  ImGui::EndChild();
  if (button(ui, "Default keys", "Reset every action to its default keys.", !now.keys.empty()))
    change_kept(ui).keys.clear();
  ImGui::SameLine();
}

}  // namespace

bool build_settings(Ui& ui) {
  look(ui);
  keeping(ui);
  key_fields(ui);
  return button(ui, "Close", "Back to the track. Key Escape.");
}

}  // namespace coaster::ui
