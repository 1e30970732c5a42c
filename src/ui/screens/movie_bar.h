// How far a movie is, with a way to stop it: over the scene, and not in the movie.
#pragma once

#include "ui/widgets/widgets.h"

namespace coaster::ui {

// Nothing while no movie is made.
void build_movie_bar(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
