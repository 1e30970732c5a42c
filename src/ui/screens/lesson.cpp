// The lesson's card and ring.
#include "ui/screens/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "ui/widgets/theme.h"
#include "world/camera_feel.h"

namespace coaster::ui {
namespace {

// Returns a pulse by the clock, 0..1; 1 in scripts, which have no clock, and with reduced motion.
float breath(const State& state) {
  constexpr double kPerSecond = 0.7;
  return state.scripted || state.session.settings.feel->reduced_motion
             ? 1.0f
             : static_cast<float>(0.5 + 0.5 * std::cos(2 * base::kPi * kPerSecond * state.seconds));
}

void ring(const State& state, const Widget& widget, float scale, const LessonLine& line) {
  const float grow = std::floor((3 + 3 * breath(state)) * scale);
  const ImVec2 low(widget.x - grow, widget.y - grow),
      high(widget.x + widget.width + grow, widget.y + widget.height + grow);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRect(low, high, packed(palette().warning), 5 * scale, 0, 2.5f * scale);
  list.AddLine({line.from.x, line.from.y}, {line.to.x, line.to.y}, packed(palette().warning, 0.55f), 1.5f * scale);
}

}  // namespace

bool LessonGuide::begins(const query::LessonCard* lesson) const {
  constexpr int kFrames = 10;  // a panel that opens, then a column that scrolls
  return lesson != nullptr && (lesson->number != number || frames < kFrames);
}

void LessonGuide::follow(const query::LessonCard* lesson, const std::vector<Widget>& widgets) {
  target.reset(), marked.reset();
  frames = lesson != nullptr && lesson->number == number ? frames + 1 : 0;
  number = lesson != nullptr ? lesson->number : 0;
  if (lesson == nullptr) return;
  for (std::string path = lesson->widget; !path.empty() && !marked;) {
    for (const Widget& widget : widgets) {
      if (!widget.is(path)) continue;
      if (path == lesson->widget) target = widget;
      if (widget.visible) marked = widget;
    }
    const std::size_t slash = path.rfind('/');
    path.resize(slash == std::string::npos ? 0 : slash);
  }
}

LessonLine lesson_line(const LessonBox& card, const LessonBox& target) {
  const glm::vec2 from = glm::clamp(0.5f * (target.low + target.high), card.low, card.high);
  return {from, glm::clamp(from, target.low, target.high)};
}

void draw_lesson(Ui& ui, const view::Viewport& scene, const LessonGuide& guide) {
  const query::LessonCard* const lesson = ui.state.lesson;
  if (lesson == nullptr) return;
  const float width = std::min(std::floor(430 * ui.scale), scene.width - 16 * ui.scale);
  const ImVec2 middle(std::floor(scene.x + 0.5f * scene.width), std::floor(scene.y + 14 * ui.scale));
  LessonBox box;
  ImGui::PushStyleColor(ImGuiCol_Border, colour(palette().warning));
  const Card card{.id = "##lesson",
                  .panel = "Lesson",
                  .at = middle,
                  .pivot = {0.5f, 0},
                  .width = width,
                  .padding = {16, 12},
                  .alpha = 0.95f};
  build_card(ui, card, [&] {
    // The buttons are above the text, so that they stay in place from lesson to lesson.
    ImGui::AlignTextToFramePadding();
    tinted_line(fmt::format("Lesson {} of {}", lesson->number, lesson->count), palette().warning);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float buttons =
        text_size("Show me").x + text_size("Leave").x + 4 * style.FramePadding.x + style.ItemSpacing.x;
    ImGui::SameLine(std::floor(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - buttons));
    if (button(ui, "Show me", "Let the tutorial do this step.")) ui.out.lesson_answer = query::LessonAnswer::show;
    ImGui::SameLine();
    if (button(ui, "Leave", "Leave the tutorial. The track stays as it is."))
      ui.out.lesson_answer = query::LessonAnswer::leave;
    paragraph(ui, "Text", lesson->text, palette().text);
    if (lesson->strayed)
      paragraph(ui, "Strayed", "You changed something else. Show me undoes that and does this step.",
                palette().warning);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    box = {{low.x, low.y}, {low.x + size.x, low.y + size.y}};
  });
  ImGui::PopStyleColor();
  if (!guide.marked) return;
  const Widget& at = *guide.marked;
  const LessonBox target{{at.x, at.y}, {at.x + at.width, at.y + at.height}};
  ring(ui.state, at, ui.scale, lesson_line(box, target));
}

}  // namespace coaster::ui
