// Frees sections that a command shaped by hand. Private to this room.
#pragma once

#include <vector>

#include "edit/perform/perform.h"
#include "world/sections.h"

namespace coaster::edit {

// The sections of a document that are planned: none of the free ones.
struct PlannedSection {
  world::SectionRun run;
  world::Section value;
};
std::vector<PlannedSection> planned_sections(const world::Document& document);

// Makes those sections free whose shape is another one than before the command, unless the command planned them again,
// and adds a sentence to its note. A section that moved as a whole, by a translation and a rotation about the vertical,
// keeps its plan; so it does when its neighbours' sides of its first and last knot change, and the spin there, which
// belong to both. `before` are the planned sections before the command; session.derived must still be that document's.
void free_hand_shaped(const std::vector<PlannedSection>& before, Session& session, Change& change);

}  // namespace coaster::edit
