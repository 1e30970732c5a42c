// How sentences of notices, refusals and the history name a section.
#pragma once

#include <string>

#include "world/components.h"

namespace coaster::world {

// Returns the name of an element inside a sentence: "loop", "S-bend".
std::string words_of(ElementKind kind);
// Returns a section's title in quotation marks; without one what it is: "the loop", "the hand-shaped section".
std::string words_of(const Section& section);

}  // namespace coaster::world
