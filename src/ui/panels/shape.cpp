// Shape: operations on the selected knots or on all knots, and snapping.
#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include <fmt/format.h>

#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "ui/context/ui.h"
#include "ui/tools/selecting.h"
#include "ui/widgets/button_rows.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

// The selected knots (both of a selected segment), or all of them.
edit::Knots shaped_knots(const edit::Session& session) {
  const world::Document& document = session.document;
  edit::Knots knots = named_knots(document, world::selected_knots(document, session.settings));
  if (const world::Segment* const segment = document.entities.find<world::Segment>(session.settings.selected))
    knots.names = {world::name_of(document, segment->from), world::name_of(document, segment->to)};
  if (knots.names.empty() || knots.names.size() == document.track.knots.size()) return edit::Knots::Which::all;
  return knots;
}

glm::vec3 middle_of(const edit::Session& session, const edit::Knots& knots) {
  glm::dvec3 sum(0);
  double count = 0;
  for (const world::Entity e : session.document.track.knots) {
    const world::Name name = world::name_of(session.document, e);
    if (knots.which == edit::Knots::Which::named &&
        std::find(knots.names.begin(), knots.names.end(), name) == knots.names.end())
      continue;
    sum += glm::dvec3(world::knot(session.document, e).position), ++count;
  }
  return count > 0 ? glm::vec3(sum / count) : glm::vec3(0);
}

// Buttons for commands that a challenge may lock.
struct Buttons {
  Ui& ui;
  ButtonRows rows;
  Buttons(Ui& of, int columns, std::string_view widest) : ui(of), rows{of, columns, widest} {}
  bool operator()(std::string_view label, std::string_view tooltip, bool enabled = true,
                  std::string_view command = {}) {
    const LockedWidgets locked(ui, command);
    return rows(label, tooltip, enabled);
  }
};

void snapping(Ui& ui) {
  const world::Snapping& now = ui.session().settings.snapping;
  if (const auto to = combo_of(ui, "Snap to", now.to,
                               fmt::format("Dragged knots snap to this. {} selects the next. Hold Ctrl while dragging "
                                           "to invert snapping.",
                                           ui.keys.shown("Next snapping"))))
    ui.emit(edit::SetSnapping{*to, now.step, now.angle});
  if (const auto to =
          number(ui, "Step", {.value = now.step, .unit = "m", .decimals = 3, .step = 0.01, .low = 0.001, .high = 1000},
                 "Step of the grid."))
    ui.emit(edit::SetSnapping{now.to, *to, now.angle});
  if (const auto to = number(
          ui, "Angle", {.value = now.angle, .unit = "\u00B0", .decimals = 1, .step = 0.1, .low = 0.1, .high = 180},
          "Rotations snap to multiples of this angle."))
    ui.emit(edit::SetSnapping{now.to, now.step, *to});
}

void whole_track(Ui& ui) {
  const edit::Session& session = ui.session();
  const world::Track& track = session.document.track;
  const std::size_t chosen = world::selected_knots(session.document, session.settings).size();
  Buttons next{ui, 3, "Duplicate"};
  if (next("Reverse", "Reverse the direction of travel. The shape is unchanged.", !track.segments.empty()))
    ui.emit(edit::Reverse{});
  if (next("Duplicate",
           "Copy the track between the selected neighbouring knots to the open end, rotated to continue from there.",
           !track.closed && chosen >= 2))
    ui.emit(edit::Duplicate{shaped_knots(session)});
  if (next("Close", "Close the track exactly: ends nearer than 2 m become one knot, others get a segment between them.",
           !track.closed && track.knots.size() >= 2))
    ui.emit(edit::CloseExactly{});
}

}  // namespace

void shape_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  const edit::Knots knots = shaped_knots(session);
  const std::size_t on_track = session.document.track.knots.size();
  const bool any = on_track > 0, all = knots.which == edit::Knots::Which::all;
  const std::size_t count = all ? on_track : knots.names.size();
  read_out(ui, "Acts on", fmt::format("{}{} {}", all ? "all " : "", count, count == 1 ? "knot" : "knots"), "",
           fmt::format("The selected knots, or all when none is selected. Shift+click adds a knot, Ctrl+click adds all "
                       "up to it, {} draws a box, {} selects all.",
                       ui.keys.shown("Box select"), ui.keys.shown("Select all")));
  Buttons next{ui, 2, "Equalise handles"};
  if (next("Smooth", "Fit the natural C2 spline through the knots: curvature is continuous at every joint.",
           on_track > 1, edit::Smooth::kInfo.name))
    ui.emit(edit::Smooth{knots});
  if (next("Equalise handles", "Set both handles to their average length (C1).", any, edit::Equalise::kInfo.name))
    ui.emit(edit::Equalise{knots});
  if (next("Straighten", "Move neighbouring knots onto the line from the first to the last.", any && count > 1))
    ui.emit(edit::Straighten{knots});
  if (next("Drop to ground", "Move the knots to the ground and level them.", any)) ui.emit(edit::DropToGround{knots});
  constexpr std::array<std::string_view, 3> kMirrors{"Mirror X", "Mirror Y", "Mirror Z"};
  Buttons mirrors{ui, 3, kMirrors[1]};
  for (int i = 0; i < 3; ++i)
    if (mirrors(kMirrors[static_cast<std::size_t>(i)],
                "Mirror across the plane through the centre of the knots, normal to the axis.", any)) {
      glm::vec3 across(0);
      across[i] = 1;
      ui.emit(edit::Mirror{knots, across, middle_of(session, knots)});
    }
  if (const auto to =
          number(ui, "Radius", {.value = ui.inputs.radius, .unit = "m", .step = 0.1, .low = 0.1, .high = 1e5},
                 "Radius of curvature for Set radius."))
    ui.inputs.radius = *to;
  if (button(ui, "Set radius", "Give the knots this radius of curvature by changing their handle lengths.",
             any && count < on_track, -1))
    ui.emit(edit::SetRadius{knots, ui.inputs.radius});
  whole_track(ui);
  snapping(ui);
}

}  // namespace coaster::ui
