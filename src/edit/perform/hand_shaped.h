// Makes sections free that a command shaped by hand. Private to this room.
#pragma once

#include <vector>

#include "edit/perform/perform.h"
#include "world/sections.h"

namespace coaster::edit {

// The planned sections of a document: all but the free ones.
struct PlannedSection {
  world::SectionRun run;
  world::Section value;
};
std::vector<PlannedSection> planned_sections(const world::Document& document);

// Makes those planned sections free whose shape differs from that before the command, unless the command planned them
// again, and adds a sentence to its note. A section that moved as a whole, by a translation and a rotation about the
// vertical, keeps its plan; so does one whose first and last knot changed only on the neighbour's side or in their
// spin, which belong to both. `before` are the planned sections before the command; session.derived must still belong
// to that document.
void free_hand_shaped(const std::vector<PlannedSection>& before, Session& session, Change& change);

}  // namespace coaster::edit
