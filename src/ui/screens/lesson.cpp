// The lesson's card and ring.
#include "ui/screens/lesson.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/widgets/theme.h"
#include "world/camera_feel.h"

namespace coaster::ui {
namespace {

// Breathes with the clock; at rest where a script has no clock.
float breath(const State& state) {
  constexpr double kPerSecond = 0.7;
  return state.scripted || state.session.settings.feel->reduced_motion
             ? 1.0f
             : static_cast<float>(0.5 + 0.5 * std::cos(2 * 3.141592653589793 * kPerSecond * state.seconds));
}

void ring(const State& state, const Widget& widget, float scale, ImVec2 card) {
  const float grow = std::floor((3 + 3 * breath(state)) * scale);
  const ImVec2 low(widget.x - grow, widget.y - grow),
      high(widget.x + widget.width + grow, widget.y + widget.height + grow);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRect(low, high, packed(palette().warning), 5 * scale, 0, 2.5f * scale);
  // A thin line leads from the card to it.
  const ImVec2 nearest(std::clamp(card.x, low.x, high.x), std::clamp(card.y, low.y, high.y));
  list.AddLine(card, nearest, packed(palette().warning, 0.55f), 1.5f * scale);
}

}  // namespace

void draw_lesson(Ui& ui, const view::Viewport& scene, const Widget* marked) {
  const query::LessonCard* const lesson = ui.state.lesson;
  if (lesson == nullptr) return;
  const float width = std::min(std::floor(430 * ui.scale), scene.width - 16 * ui.scale);
  const ImVec2 middle(std::floor(scene.x + 0.5f * scene.width), std::floor(scene.y + 14 * ui.scale));
  ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.95f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(16 * ui.scale, 12 * ui.scale));
  ImGui::PushStyleColor(ImGuiCol_Border, colour(palette().warning));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  ImVec2 foot = middle;
  if (ImGui::Begin("##lesson", nullptr, kFlags)) {
    ui.panel = "Lesson";
    ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().warning));
    ImGui::Text("Lesson %d of %d", lesson->number, lesson->count);
    ImGui::PopStyleColor();
    paragraph(ui, "Text", lesson->text, palette().text);
    ImGui::Dummy({0, std::floor(2 * ui.scale)});
    if (button(ui, "Show me", "Let the tutorial do this step.")) ui.out.lesson_answer = query::LessonAnswer::show;
    ImGui::SameLine();
    if (button(ui, "Leave", "Leave the tutorial. The track stays as it is."))
      ui.out.lesson_answer = query::LessonAnswer::leave;
    ui.panel.clear();
    foot.y = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (marked != nullptr) ring(ui.state, *marked, ui.scale, foot);
}

}  // namespace coaster::ui
