// A lesson of the tutorial: a card in the viewport and a ring around the widget it is about.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// `marked`: the widget as last drawn; null when the lesson names none, or it does not show.
void draw_lesson(Ui& ui, const view::Viewport& scene, const Widget* marked);

}  // namespace coaster::ui
