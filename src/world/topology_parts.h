// Functions shared by the files of topology.h. Private to them.
#pragma once

#include <cstddef>

#include "world/document.h"

namespace coaster::world {

Entity create_named(Document& document, Kind kind);  // gives it the next number of its kind
Entity create_section(Document& document);           // a free one
Entity create_segment(Document& document, Entity from, Entity to, Entity section);

// Returns the section of the segment at that index; kNone beyond the order's ends.
Entity section_at(const Document& document, std::size_t index);

// Removes a segment and the trains on it, and its section if it was the section's last segment.
void remove_segment(Document& document, std::size_t index);

}  // namespace coaster::world
