// Build selects sections before their knots: which click selects one. No state.
#pragma once

#include <optional>

#include "edit/commands/command.h"
#include "edit/session/session.h"
#include "view/pick.h"

namespace coaster::ui {

// True in Build on a track with a planned section. A track that is all shaped by hand has nothing to protect.
bool picks_sections(const edit::Session& session);

// Returns the section of a knot or of a place on the curve, of two sections at a knot the selected one, or the one that
// has something selected, else the earlier one; kNone for anything else.
world::Entity section_under(const edit::Session& session, const view::Pick& under);

// Returns what a press there selects instead of the knot or the place: its section, unless that or something of it is
// selected; of several selected sections that one alone. `shift`: the section joins the selected ones, or leaves them.
// Nothing where sections are not picked.
std::optional<edit::Command> section_click(const edit::Session& session, const view::Pick& under, bool shift);

}  // namespace coaster::ui
