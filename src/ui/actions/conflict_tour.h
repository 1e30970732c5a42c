// Goes from one place where the track is in its own way to the next.
#pragma once

#include "ui/widgets/widgets.h"

namespace coaster::ui {

// Selects the next conflict's place after the selected one and looks at it with the orbit camera; nothing where there
// is none.
void show_next_conflict(Ui& ui);

}  // namespace coaster::ui
