// What the files of topology.h share. Private to them.
#pragma once

#include <cstddef>

#include "world/document.h"

namespace coaster::world {

Entity create_named(Document& document, Kind kind);  // with the next number of its kind
Entity create_section(Document& document);           // a free one
Entity create_segment(Document& document, Entity from, Entity to, Entity section);

// Returns the section of the segment at that index; kNone beyond the order's ends.
Entity section_at(const Document& document, std::size_t index);

// Removes a segment with the trains on it, and its section if it is the last one of it.
void remove_segment(Document& document, std::size_t index);

}  // namespace coaster::world
