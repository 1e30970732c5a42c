#include "ui/screens/movie_bar.h"

#include <imgui.h>

#include <cmath>

#include "ui/widgets/theme.h"
#include "world/motion.h"

namespace coaster::ui {
namespace {

std::string words_of(const MovieState& movie) {
  if (movie.encoding) return "Encoding the movie";
  return fixed(static_cast<double>(movie.ticks) * world::kTick, 1) + " s, " + std::to_string(movie.frames) +
         (movie.frames == 1 ? " picture" : " pictures");
}

// The sign of recording, beside which the words stand.
void draw_dot(bool recording) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + height * 0.5f, at.y + height * 0.5f}, height * 0.32f,
                                              packed(recording ? palette().error : palette().accent), 24);
  ImGui::Dummy({height, height});
  ImGui::SameLine();
}

}  // namespace

void build_movie_bar(Ui& ui, const view::Viewport& scene) {
  const MovieState* const movie = ui.state.movie;
  if (!movie) return;
  const float width = std::floor(std::min(340 * ui.scale, scene.width - 16 * ui.scale));
  ImGui::SetNextWindowPos({std::floor(scene.x + (scene.width - width) * 0.5f), std::floor(scene.y + 10 * ui.scale)});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12 * ui.scale, 9 * ui.scale));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoNav;
  if (ImGui::Begin("##movie", nullptr, kFlags)) {
    ui.panel = "Movie";
    draw_dot(!movie->encoding);
    const std::string words = words_of(*movie);
    ImGui::TextUnformatted(words.c_str());
    note_item(ui, "State", "label", "Recorded so far.", true, words);
    const float button_width = std::floor(64 * ui.scale);
    ImGui::SameLine(ImGui::GetWindowWidth() - button_width - 12 * ui.scale);
    if (button(ui, "Stop",
               movie->encoding ? "Cancel encoding. The pictures are kept."
                               : "Stop recording. Otherwise it stops at the end of the lap.",
               true, button_width))
      ui.out.movie = MovieWish::stop;
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colour(movie->encoding ? palette().accent : palette().error));
    ImGui::ProgressBar(static_cast<float>(movie->done), {-1, std::floor(6 * ui.scale)}, "");
    ImGui::PopStyleColor();
    note_item(ui, "Progress", "label", "Part of the lap that is recorded, then part of the movie that is encoded.",
              true, fixed(100 * movie->done, 0) + " %");
    ui.panel.clear();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace coaster::ui
