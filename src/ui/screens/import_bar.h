// Progress of a file import, with a cancel button.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// Nothing while no file is read. Escape cancels, too.
void build_import_bar(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
