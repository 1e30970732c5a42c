// Which knots a click or a box in the viewport selects. No state, no ImGui.
#pragma once

#include <optional>

#include "edit/commands/command.h"
#include "edit/session/session.h"
#include "view/camera.h"

namespace coaster::ui {

enum class BoxMode : std::uint8_t { replace, add, remove };

// The knots by name, for a command.
edit::Knots named_knots(const world::Document& document, const std::vector<world::Entity>& knots);

// The command that selects these knots, the last one active; none selects nothing.
edit::Command selection_of(const world::Document& document, const std::vector<world::Entity>& knots);

// A Shift+click: the knot joins the selection as its active knot, or leaves it.
edit::Command toggled(const edit::Session& session, world::Entity knot);
// The same for sections.
edit::Command selection_of_sections(const world::Document& document, const std::vector<world::Entity>& sections);
edit::Command toggled_section(const edit::Session& session, world::Entity section);
// The command that copies the selected sections.
edit::Command copying(const edit::Session& session);

// A Ctrl+click: all knots along the track from the active one to this one, the shorter way round where the track is
// closed.
edit::Command up_to(const edit::Session& session, world::Entity knot);
// Knots whose place on the screen is within the rectangle; nothing when the selection stays as it is.
std::optional<edit::Command> boxed(const edit::Session& session, const view::View& view, glm::vec2 corner,
                                   glm::vec2 opposite, BoxMode mode);

}  // namespace coaster::ui
