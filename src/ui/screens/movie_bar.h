// Progress of the movie being recorded, with a stop button. Drawn over the scene, not in the movie.
#pragma once

#include "ui/context/ui.h"

namespace coaster::ui {

// Nothing while no movie is made.
void build_movie_bar(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
