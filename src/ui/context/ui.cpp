#include "ui/context/ui.h"

#include "edit/commands/commands_session.h"

namespace coaster::ui {

void Ui::begin_step() { emit(edit::BeginGesture{}); }
void Ui::end_step() { emit(edit::EndGesture{}); }

}  // namespace coaster::ui
