// Progress of an import, of a search and of a movie.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/screens/overlays.h"
#include "ui/widgets/theme.h"
#include "world/motion.h"

namespace coaster::ui {
namespace {

// `done`: 0..1, 0 also if it is not known: then a piece of the bar moves. `height` in design px.
void progress_bar(WidgetFrame& ui, double done, float height, std::uint32_t rgb, std::string_view tooltip) {
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colour(rgb));
  ImGui::ProgressBar(static_cast<float>(done), {-1, sized(std::floor(height * ui.scale))}, "");
  ImGui::PopStyleColor();
  if (done <= 0) {
    constexpr float kPiece = 0.25f;  // of the width
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float width = high.x - low.x, at = static_cast<float>(std::fmod(ImGui::GetTime() * 0.5, 1.0));
    const float left = low.x + (1 - kPiece) * width * (1 - std::abs(2 * at - 1));
    ImGui::GetWindowDrawList()->AddRectFilled({left, low.y}, {left + kPiece * width, high.y}, packed(rgb),
                                              ImGui::GetStyle().FrameRounding);
  }
  note_item(ui, "Progress", "label", tooltip, true, fixed(100 * done, 0) + " %");
}

std::string words_of(const MovieState& movie) {
  if (movie.encoding) return "Encoding the movie";
  return fmt::format("{} s, {} {}", fixed(static_cast<double>(movie.ticks) * world::kTick, 1), movie.frames,
                     movie.frames == 1 ? "picture" : "pictures");
}

// The sign of recording, left of the text.
void draw_dot(bool recording) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + height * 0.5f, at.y + height * 0.5f}, height * 0.32f,
                                              packed(recording ? palette().error : palette().accent), 24);
  ImGui::Dummy(sized({height, height}));
  ImGui::SameLine();
}

// Returns a card in the middle of the scene's width, `top` px below its upper edge.
Card card_in(const view::Viewport& scene, const char* id, std::string_view panel, float width, float top) {
  const ImVec2 at(std::floor(scene.x + (scene.width - width) * 0.5f), std::floor(scene.y + top));
  return {.id = id, .panel = panel, .at = at, .width = width};
}

}  // namespace

bool draw_job(WidgetFrame& ui, const view::Viewport& scene, const JobState& job) {
  if (!job.progress) return false;
  bool cancels = false;
  Card card = card_in(scene, "##job", job.panel, std::floor(360 * ui.scale), scene.height * 0.4f);
  card.padding = {14, 12};
  card.flags = ImGuiWindowFlags_NoDecoration;
  ImGui::SetNextWindowFocus();
  build_card(ui, card, [&] {
    ImGui::TextWrapped("%.*s", static_cast<int>(job.title.size()), job.title.data());
    progress_bar(ui, job.progress->done.load(), 8, palette().accent, "Part of the work that is done.");
    cancels = button(ui, "Cancel", "Cancel. The track stays as it is. Key Escape.", !job.progress->cancelled) ||
              ImGui::IsKeyPressed(ImGuiKey_Escape);
  });
  return cancels;
}

void draw_movie(Ui& ui, const view::Viewport& scene) {
  const MovieState* const movie = ui.state.movie;
  if (!movie) return;
  const float width = std::floor(std::min(340 * ui.scale, scene.width - 16 * ui.scale));
  Card card = card_in(scene, "##movie", "Movie", width, 10 * ui.scale);
  card.padding = {12, 9};
  card.flags |= ImGuiWindowFlags_NoNav;
  build_card(ui, card, [&] {
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
    progress_bar(ui, movie->done, 6, movie->encoding ? palette().accent : palette().error,
                 "Part of the lap that is recorded, then part of the movie that is encoded.");
  });
}

}  // namespace coaster::ui
