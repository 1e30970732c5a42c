// Decides which section a click selects: Build selects sections before their knots. No state.
#pragma once

#include <optional>

#include "edit/commands/command.h"
#include "edit/session/session.h"
#include "view/pick.h"

namespace coaster::ui {

// True in Build on a track with a planned section. A track without one has nothing to protect.
bool picks_sections(const edit::Session& session);

// Returns the section of a knot or of a position on the curve. At a knot between two sections: the selected one, or the
// one with something selected, else the earlier one. kNone for anything else.
world::Entity section_under(const edit::Session& session, const view::Pick& under);

// Returns the command that selects the section under a press instead of the knot or the position. Nothing if the
// section or a part of it is selected already; of several selected sections, that one alone is selected. `shift`: adds
// the section to the selection or removes it. Nothing where sections are not picked.
std::optional<edit::Command> section_click(const edit::Session& session, const view::Pick& under, bool shift);

}  // namespace coaster::ui
