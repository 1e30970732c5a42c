// Read access to the sections of the track. topology.h changes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "world/components.h"
#include "world/document.h"

namespace coaster::world {

// The segments of a section: `count` of them from index `first` of the track.
struct SectionRun {
  Entity section;
  std::size_t first = 0, count = 0;
  std::size_t end() const { return first + count; }
  friend bool operator==(const SectionRun&, const SectionRun&) = default;
};

// Returns the sections in the order of travel. Linear in the number of segments, a few ns each.
std::vector<SectionRun> sections_of(const Document& document);
// Returns the segments of a living section.
SectionRun run_of(const Document& document, Entity section);
// Returns the section that begins or ends at the knot or contains it; of two the earlier one. kNone if the knot has no
// segment.
Entity section_of_knot(const Document& document, Entity knot);

const Section& section(const Document& document, Entity e);
bool is_free(const Document& document, Entity section);
// Returns the last section that completes the circuit, of those that begin at or after the knot with that index;
// nothing on an open track or if there is none.
std::optional<SectionRun> completing(const Document& document, std::size_t knot);

// Gives a section the paint and the earthwork of another.
void take_look(const Section& from, Section& to);
// Returns the section as hand-shaped, with its title and paint.
Section without_plan(const Section& section);
// Returns "free" or the name of the element, as in scripts and files.
std::string_view kind_name(const Section& section);
// Returns its title; without one, its kind: "Loop".
std::string title_of(const Section& section);

// Returns the name of an element inside a sentence: "loop", "S-bend".
std::string words_of(ElementKind kind);
// Returns a section's title in quotation marks; without one what it is: "the loop", "the hand-shaped section".
std::string words_of(const Section& section);

}  // namespace coaster::world
