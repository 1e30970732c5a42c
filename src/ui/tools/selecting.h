// Selects knots and sections by a click or a box in the viewport. Build selects sections before their knots. No state,
// no ImGui.
#pragma once

#include <optional>

#include "edit/commands/command.h"
#include "edit/session/session.h"
#include "view/camera.h"
#include "view/pick.h"

namespace coaster::ui {

enum class BoxMode : std::uint8_t { replace, add, remove };

// Returns the names of entities, for a command.
std::vector<world::EntityName> names_of(const world::Document& document, const std::vector<world::Entity>& entities);

// Returns the command that selects these knots or sections, the last one active; without any it clears the selection.
edit::Command selection_of(const world::Document& document, const std::vector<world::Entity>& entities);
// Returns the command of a Shift+click: the knot or section joins the selected ones as the active one, or leaves them.
edit::Command toggled(const edit::Session& session, world::Entity entity);
// Returns the command that copies the selected sections.
edit::Command copying(const edit::Session& session);

// Returns the command of a Ctrl+click: selects all knots along the track from the active one to this one, the shorter
// way round if the track is closed.
edit::Command up_to(const edit::Session& session, world::Entity knot);
// Returns the command that selects the knots within a rectangle on the screen; nothing if the selection does not
// change.
std::optional<edit::Command> boxed(const edit::Session& session, const view::View& view, glm::vec2 corner,
                                   glm::vec2 opposite, BoxMode mode);

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
