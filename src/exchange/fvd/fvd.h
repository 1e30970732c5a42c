// Import of openFVD and FVD++ projects (.fvd).
#pragma once

#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

// Returns the first track of the project, on its heartline. A forced section with a free speed becomes, if there is no
// heartline, a force section with keys that follow its functions within 0.01 g. All others become hand-shaped ones,
// within 1 cm of their integrated path; a section with a constant speed gets a lift, or a brake if the train arrives
// faster. If a section cannot be read, the track ends before it, with a warning. docs/forces.md has layout,
// formulas and what is left out. Errors: those of read_fvd, and Code::bad_file if no segment is left, with the section
// and the reason.
base::Result<LoadedTrack> parse_fvd(std::string_view bytes, std::string_view name);

}  // namespace coaster::exchange
