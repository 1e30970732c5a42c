// The settings window: scale, colours, motion, autosave, and the keys of every action.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/text.h"
#include "edit/commands/commands_settings.h"
#include "platform/sound.h"
#include "ui/actions/actions.h"
#include "ui/screens/dialogs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"
#include "world/aids.h"
#include "world/camera_feel.h"
#include "world/look.h"

namespace coaster::ui {
namespace {

// Steps and no slider: that would move away under the mouse.
void scale(Ui& ui) {
  constexpr int kPercent[] = {75, 90, 100, 110, 125, 150, 175, 200, 250, 300};
  const int now = static_cast<int>(std::lround(100 * ui.session().settings.look->ui_scale));
  std::vector<int> percents(std::begin(kPercent), std::end(kPercent));
  const auto place = std::lower_bound(percents.begin(), percents.end(), now);
  const auto current = static_cast<int>(place - percents.begin());
  if (place == percents.end() || *place != now) percents.insert(place, now);
  std::vector<Choice> choices;
  for (const int percent : percents) choices.push_back({std::to_string(percent) + " %", "Size of text and panels."});
  if (const auto to = combo(ui, "Scale", choices, current, "Size of text and panels."))
    ui.emit(edit::Set<&world::Look::ui_scale>{static_cast<float>(percents[static_cast<std::size_t>(*to)]) / 100});
}

void look(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  scale(ui);
  if (const auto to = combo_of(ui, "Theme", settings.look->theme, "Colours of the panels."))
    ui.emit(edit::Set<&world::Look::theme>{*to});
  if (const auto to = combo_of(ui, "Scene", settings.look->style, "Light, sky and ground."))
    ui.emit(edit::Set<&world::Look::style>{*to});
  const bool built = platform::sound_library() != "none";
  if (const auto to = slider(ui, "Sound (%)", static_cast<int>(std::lround(100 * settings.look->sound)), 0, 100, false,
                             built ? "Ride volume. 0 mutes it." : "This build has no sound (OpenAL)."))
    ui.emit(edit::Set<&world::Look::sound>{static_cast<float>(*to) / 100});
  if (const auto on =
          checkbox(ui, "Shadows", settings.look->shadows, "Turn shadows on or off. Frames are faster without them."))
    ui.emit(edit::Set<&world::Look::shadows>{*on});
  ImGui::SameLine();
  if (const auto on = checkbox(ui, "Reduced motion", settings.feel->reduced_motion,
                               "Level horizon, cuts between cameras, no head-bob, no widening."))
    ui.emit(edit::Set<&world::CameraFeel::reduced_motion>{*on});
}

void keeping(Ui& ui) {
  if (ui.state.kept == nullptr) return;
  const exchange::UserSettings& now = ui.state.kept->settings;
  const int seconds = static_cast<int>(std::lround(now.autosave_seconds));
  if (const auto to =
          slider(ui, "Autosave every (s)", seconds, static_cast<int>(exchange::kMinAutosave),
                 static_cast<int>(exchange::kMaxAutosave), true, "Seconds between a change and its autosave.")) {
    ui.out.settings = now;
    ui.out.settings->autosave_seconds = std::clamp<double>(*to, exchange::kMinAutosave, exchange::kMaxAutosave);
  }
  if (button(ui, "Clear recent files###Forget recent files", "Clear the list of recent files.", !now.recent.empty())) {
    ui.out.settings = now;
    ui.out.settings->recent.clear();
  }
  ImGui::SameLine();
  if (const auto on =
          checkbox(ui, "Hints", ui.session().settings.aids->show_hints, "Show the first steps in the viewport."))
    ui.emit(edit::Set<&world::Aids::show_hints>{*on});
  ImGui::SameLine();
  if (const auto on = checkbox(ui, "Score cards", ui.session().settings.aids->show_card,
                               "Show a card with results at the end of a ride."))
    ui.emit(edit::Set<&world::Aids::show_card>{*on});
}

std::string keys_text(std::span<const platform::Chord> chords) {
  std::string words;
  for (const platform::Chord& chord : chords) words += (words.empty() ? "" : " ") + platform::to_text(chord);
  return words;
}

// The choices with another one for an action: that of the table itself is no choice.
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
    ui.panel = "Settings/Keys";  // actions have names that rows above have, too
    for (std::size_t row = 0; row < actions().size(); ++row) {
      const Action& action = actions()[row];
      ImGui::PushID(static_cast<int>(row));
      if (const auto typed = text(ui, action.name, keys_text(ui.keys.chords(row)), action.help)) {
        ui.out.settings = now;
        ui.out.settings->keys = with_choice(now.keys, action, *typed);
      }
      ImGui::PopID();
    }
    ui.panel = "Settings";
  }
  ImGui::EndChild();
  if (button(ui, "Default keys", "Reset every action to its default keys.", !now.keys.empty())) {
    ui.out.settings = now;
    ui.out.settings->keys.clear();
  }
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
