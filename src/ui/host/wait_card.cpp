#include "ui/host/wait_card.h"

#include <imgui.h>

#include <utility>

#include "ui/screens/overlays.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {

WaitCard::WaitCard(ImGuiContext& panels, ImGuiRenderer& renderer, float scale)
    : panels_(&panels), renderer_(&renderer), scale_(scale) {
  ImGui::SetCurrentContext(panels_);
  const ImGuiIO& of_panels = ImGui::GetIO();
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 mouse = of_panels.MousePos;
  context_ = ImGui::CreateContext(of_panels.Fonts);
  ImGui::SetCurrentContext(context_);
  set_up_context();
  ImGui::GetStyle() = style;
  ImGui::GetIO().UserData = of_panels.UserData;  // the theme
  share_textures(of_panels);
  input_.feed({platform::MouseMove{mouse.x, mouse.y}}, 1, 1, false);
  ImGui::SetCurrentContext(panels_);
}

WaitCard::~WaitCard() {
  ImGui::DestroyContext(context_);
  ImGui::SetCurrentContext(panels_);
}

bool WaitCard::show(const platform::Events& events, const JobState& job, int width, int height) {
  ImGui::SetCurrentContext(context_);
  input_.feed(events, width, height, false);
  ImGui::NewFrame();
  WidgetList list;
  Entry entry;
  Gesture gesture;
  Rest rest;
  const std::function<void()> begin_gesture;
  const std::function<void(const std::string&)> warn;
  WidgetFrame ui{list, entry, gesture, rest, begin_gesture, warn, scale_};
  const view::Viewport all{0, 0, static_cast<float>(width), static_cast<float>(height)};
  if (!std::exchange(dimmed_, true))
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {all.width, all.height}, packed(0x000000, 0.4f));
  const bool cancels = draw_job(ui, all, job);
  ImGui::Render();
  if (const ImDrawData* const data = ImGui::GetDrawData()) renderer_->draw(*data, width, height);
  ImGui::SetCurrentContext(panels_);
  return cancels;
}

}  // namespace coaster::ui
