// The element of the palette: choosing and placing it.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// Shows the preview of an element with the parameters that it had last. In Build a first straight becomes a station,
// and a climb becomes a lift while nothing else drives trains; the user can choose otherwise before placing it.
void choose_element(Ui& ui, world::ElementKind kind);
// Places the element of the preview. In Build the next one like it is plain track, not a second station.
void place_shown_element(Ui& ui);

}  // namespace coaster::ui
