#include "ui/context/ui.h"

#include <imgui.h>

#include "base/hash.h"
#include "edit/commands/commands_session.h"
#include "edit/session/session.h"
#include "ui/widgets/theme.h"
#include "world/aid_settings.h"

namespace coaster::ui {

void Ui::begin_step() { emit(edit::BeginGesture{}); }
void Ui::end_step() { emit(edit::EndGesture{}); }

edit::Command Ui::new_track() const {
  const world::Land land = session().settings.aids->new_land;
  if (land == world::Land::plain) return edit::NewTrack{};
  return edit::NewPark{land, random_seed(*this)};
}

std::uint32_t random_seed(const Ui& ui) {
  constexpr std::uint64_t kMost = 9999;  // short enough to be told to others
  base::Hasher hasher;
  hasher.add(ui.state.seconds);
  hasher.add(ui.session().document.park.seed);
  return static_cast<std::uint32_t>(1 + hasher.digest() % kMost);
}

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
