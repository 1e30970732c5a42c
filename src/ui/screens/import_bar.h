// How far the import of a file is, with a way to cancel it.
#pragma once

#include "ui/widgets/widgets.h"

namespace coaster::ui {

// Nothing while no file is read. Escape cancels, too.
void build_import_bar(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
