#include "ui/context/ui.h"

#include <imgui.h>

#include "edit/commands/commands_session.h"
#include "edit/session/session.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {

void Ui::begin_step() { emit(edit::BeginGesture{}); }
void Ui::end_step() { emit(edit::EndGesture{}); }

void build_area(Ui& ui, const view::Viewport& area, const WindowArea& look, const std::function<void()>& content) {
  if (area.width < 1 || area.height < 1) return;
  if (look.padding) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, *look.padding);
  if (look.raised) ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(palette().raised));
  ui.panel = look.panel;
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize(sized({area.width, area.height}));
  constexpr ImGuiWindowFlags kFixed =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
  if (ImGui::Begin(look.id, nullptr, look.more | kFixed)) content();
  ui.panel.clear();
  ImGui::End();
  if (look.raised) ImGui::PopStyleColor();
  if (look.padding) ImGui::PopStyleVar();
}

LockedWidgets::LockedWidgets(Ui& ui, std::string_view command) : ui_(ui), before_(ui.locked) {
  const bool locked = edit::is_locked(ui.session(), command);
  if (locked) ui.locked = edit::locked_text({std::string(command)});
  ImGui::BeginDisabled(locked);
}
LockedWidgets::~LockedWidgets() {
  ImGui::EndDisabled();
  ui_.locked = before_;
}

}  // namespace coaster::ui
