#include "ui/context/ui.h"

#include <imgui.h>

#include "edit/commands/commands_session.h"
#include "edit/session/locks.h"

namespace coaster::ui {

void Ui::begin_step() { emit(edit::BeginGesture{}); }
void Ui::end_step() { emit(edit::EndGesture{}); }

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
