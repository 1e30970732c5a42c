// The first steps: a card in the viewport of who has not seen it yet, until it is dismissed.
#include "ui/screens/hints.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "edit/commands/commands_settings.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"
#include "world/aids.h"

namespace coaster::ui {
namespace {

struct Hint {
  std::string key, text;
};

// With the keys as the user has them.
std::array<Hint, 8> first_steps(const KeyMap& keys) {
  const auto k = [&](std::string_view action) { return keys.shown(action); };
  return {Hint{"Drag", "orbit; wheel zooms, " + k("Frame all") + " frames all"},
          Hint{"Click", "select a knot, then drag it or its handles"},
          Hint{k("Move") + " " + k("Rotate") + " " + k("Scale"), "move, rotate, scale; then X, Y, Z or a number"},
          Hint{k("Append points"), "append knots by clicking; " + k("Add curve") + " adds a curve"},
          Hint{k("Play or pause"), "ride; " + k("Ride camera") + " rider's view, " + k("Orbit camera") + " orbit view"},
          Hint{k("Laboratory"), "the laboratory: curves, errors, forces"},
          Hint{k("Undo"), "undo, any number of steps"},
          Hint{k("Command palette"), "find any action or command"}};
}

}  // namespace

void draw_hints(Ui& ui, const view::Viewport& scene) {
  if (!ui.session().settings.aids->show_hints) return;
  const float width = std::floor(384 * ui.scale), margin = std::floor(14 * ui.scale);
  if (scene.width < width + 2 * margin || scene.height < 300 * ui.scale) return;
  // Below the track, clear of the notices at the foot.
  ImGui::SetNextWindowPos({std::floor(scene.x + margin), std::floor(scene.y + scene.height - 58 * ui.scale)},
                          ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.88f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12 * ui.scale, 10 * ui.scale));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##hints", nullptr, kFlags)) {
    ui.panel = "Hints";
    ImGui::TextUnformatted("First steps");
    for (const Hint& hint : first_steps(ui.keys)) {
      const float start = ImGui::GetCursorPosX();
      ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().accent));
      ImGui::TextUnformatted(hint.key.c_str());
      ImGui::PopStyleColor();
      ImGui::SameLine(start + std::floor(58 * ui.scale));
      ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().dim));
      ImGui::TextUnformatted(hint.text.c_str());
      ImGui::PopStyleColor();
    }
    if (button(ui, "Got it", "Hide the first steps. View/First steps shows them again."))
      ui.emit(edit::Set<&world::Aids::show_hints>{false});
    ui.panel.clear();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace coaster::ui
