// The card of a command that takes long, over the last picture. Panels read the session, which the command is changing
// meanwhile, so the card has a Dear ImGui context of its own, with the fonts and the style of the panels.
#pragma once

#include "platform/events.h"
#include "ui/context/state.h"
#include "ui/host/imgui_input.h"
#include "ui/host/imgui_renderer.h"

namespace coaster::ui {

class WaitCard {
 public:
  // `panels`: their context, between two frames. Both it and the renderer must outlive the card.
  WaitCard(ImGuiContext& panels, ImGuiRenderer& renderer, float scale);
  ~WaitCard();
  WaitCard(const WaitCard&) = delete;
  WaitCard& operator=(const WaitCard&) = delete;

  // Draws into the bound framebuffer, which holds a picture of that size. Returns true if the user cancels.
  bool show(const platform::Events& events, const JobState& job, int width, int height);

 private:
  ImGuiContext* panels_;
  ImGuiContext* context_;
  ImGuiRenderer* renderer_;
  float scale_;
  ImGuiInput input_;
  bool dimmed_ = false;  // the picture behind it
};

}  // namespace coaster::ui
