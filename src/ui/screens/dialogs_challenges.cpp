// The question which challenge to begin.
#include <imgui.h>

#include "ui/screens/dialogs.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {

void Dialogs::build_challenges(Ui& ui) {
  ui.panel = "Challenges";
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().accent));
  ImGui::TextUnformatted("Challenges");
  ImGui::PopStyleColor();
  ImGui::Separator();
  const bool opened_now = !std::exchange(shelf_is_read_, true);  // by a key, perhaps, which is no answer yet
  if (opened_now) shelf_.read(ui.state.kept != nullptr ? ui.state.kept->challenges : std::filesystem::path());
  const auto chosen = draw_challenge_list(ui, shelf_, challenge_,
                                          ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing());
  const bool cancel =
      button(ui, "Cancel", "Back to the track. Key Escape.") || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  if (opened_now) return;
  if (cancel) abandon();
  else if (chosen) request(ui, {Want::Kind::challenge, chosen->string()});
}

}  // namespace coaster::ui
