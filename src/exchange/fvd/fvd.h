// Import of projects of openFVD and FVD++ (.fvd): force sections become force sections.
#pragma once

#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

// The first track of the project, on its heartline. A forced section whose train rides freely becomes a force section
// with keys that follow its functions within 0.01 g; straight, curved and geometric sections, and those that keep their
// speed, become hand-shaped ones, within 1 cm of their integrated path; a section that keeps its speed gets a lift, or
// a brake where the train comes faster. Reading ends before the first section that cannot be read, with a warning.
// Layout, formulas and what is left out: docs/forces.md. Errors as read_fvd.
base::Result<LoadedTrack> parse_fvd(std::string_view bytes, std::string_view name);

}  // namespace coaster::exchange
