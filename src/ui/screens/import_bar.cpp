#include "ui/screens/import_bar.h"

#include <imgui.h>

#include <cmath>

#include "ui/widgets/theme.h"

namespace coaster::ui {

void build_import_bar(Ui& ui, const view::Viewport& scene) {
  const base::Progress* const progress = ui.state.importing;
  if (!progress) return;
  const float width = std::floor(360 * ui.scale);
  ImGui::SetNextWindowPos(
      {std::floor(scene.x + (scene.width - width) * 0.5f), std::floor(scene.y + scene.height * 0.4f)});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14 * ui.scale, 12 * ui.scale));
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (ImGui::Begin("##import", nullptr, kFlags)) {
    ui.panel = "Import";
    const auto done = static_cast<float>(progress->done.load());
    ImGui::TextUnformatted("Fitting a track to the imported points");
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colour(palette().accent));
    ImGui::ProgressBar(done, {-1, std::floor(8 * ui.scale)}, "");
    ImGui::PopStyleColor();
    note_item(ui, "Progress", "label", "Part of the file that is fitted.", true, fixed(100.0 * done, 0) + " %");
    if (button(ui, "Cancel", "Cancel the import. The open track stays as it is. Key Escape.", !progress->cancelled) ||
        ImGui::IsKeyPressed(ImGuiKey_Escape))
      ui.out.cancel_import = true;
    ui.panel.clear();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace coaster::ui
