// Commands of the selection, and of snapping and the gizmo.
#include <algorithm>
#include <cmath>

#include "edit/commands/commands_settings.h"
#include "edit/perform/knot_runs.h"

namespace coaster::edit {

using base::Status;

Status perform(Session& session, Change& change, const Select& command) {
  world::Settings& settings = session.settings;
  if (command.what.name.number == 0) {
    settings.selected = world::kNone, settings.also.clear();
    return {};
  }
  const auto e = require(session, command.what, command.what.name.kind);
  if (!e) return e.status();
  if (command.what.name.kind == world::Kind::segment) {
    if (!std::isfinite(command.at)) return refused("expected a finite position");
    settings.selected_t = change.clamp("position", command.at, 0.0, 1.0);
  }
  settings.selected = *e, settings.also.clear();
  return {};
}

Status perform(Session& session, Change&, const SelectKnots& command) {
  auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  world::Settings& settings = session.settings;
  // The knot named last becomes active; for all or selected, the active one stays if it is among them.
  world::Entity active = command.knots.which == Knots::Which::named
                             ? world::find(session.document, command.knots.names.back())
                             : settings.selected;
  if (std::find(knots->begin(), knots->end(), active) == knots->end()) active = knots->back();
  std::erase(*knots, active);
  settings.selected = active, settings.also = std::move(*knots);
  return {};
}

Status perform(Session& session, Change& change, const SetSnapping& command) {
  if (!std::isfinite(command.step) || !std::isfinite(command.angle)) return refused("expected finite numbers");
  session.settings.snapping = {command.to, change.clamp("step", command.step, 0.001, 1000.0, "m"),
                               change.clamp("angle", command.angle, 0.1, 180.0, "degrees")};
  return {};
}

}  // namespace coaster::edit
