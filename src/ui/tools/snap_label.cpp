#include "ui/tools/snap_label.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/text.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

std::string snap_words(const Ui& ui, TransformKind kind, world::SnapTo to) {
  const world::Snapping& snapping = ui.session().settings.snapping;
  if (to == world::SnapTo::off) return "Snap: off";
  if (kind == TransformKind::rotate) return fmt::format("Snap: {}\u00B0", base::to_text(snapping.angle));
  if (kind == TransformKind::scale) return "Snap: 0.1";
  if (to == world::SnapTo::grid) return in_units(ui, fmt::format("Snap: grid {} m", base::to_text(snapping.step)));
  return to == world::SnapTo::knots ? "Snap: knots" : "Snap: ground";
}

}  // namespace

void draw_snap_label(Ui& ui, TransformKind kind, world::SnapTo to) {
  const std::string words = snap_words(ui, kind, to);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float off = std::floor(16 * ui.scale), pad = std::floor(4 * ui.scale);
  ImGui::SetNextWindowPos({std::floor(mouse.x) + off, std::floor(mouse.y) + off});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad, pad));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  constexpr ImGuiWindowFlags kPassive = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("##snapping", nullptr, kPassive)) {
    ui.panel = "Cursor";
    ImGui::PushFont(small_font());
    tinted_line(words, to == world::SnapTo::off ? palette().dim : palette().accent);
    ImGui::PopFont();
    note_item(ui, "Snapping", "label", "", true, words);
    ui.panel.clear();
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace coaster::ui
