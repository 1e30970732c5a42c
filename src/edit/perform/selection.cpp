// Commands of the selection, and of snapping and the gizmo.
#include <algorithm>
#include <cmath>

#include "edit/commands/commands_settings.h"
#include "edit/perform/knot_runs.h"

namespace coaster::edit {

using base::Status;

Status perform(Session& session, Change&, const Select& command) {
  world::Settings& settings = session.settings;
  if (const Status on = within("a parameter t", command.at, 0, 1); !on) return on;
  if (command.what.name.number == 0) {
    settings.selected = world::kNone, settings.also.clear();
    return {};
  }
  const auto e = require(session, command.what, command.what.name.kind);
  if (!e) return e.status();
  if (command.what.name.kind == world::Kind::segment) settings.selected_t = command.at;
  settings.selected = *e, settings.also.clear();
  return {};
}

namespace {

// Selects the items that a command names. The last named one becomes active; for all or selected, the active one stays
// if it is among them.
template <class Several>
Status select_several(Session& session, base::Result<std::vector<world::Entity>> chosen, const Several& named) {
  if (!chosen) return chosen.status();
  world::Settings& settings = session.settings;
  world::Entity active =
      named.which == Knots::Which::named ? world::find(session.document, named.names.back()) : settings.selected;
  if (std::find(chosen->begin(), chosen->end(), active) == chosen->end()) active = chosen->back();
  std::erase(*chosen, active);
  settings.selected = active, settings.also = std::move(*chosen);
  return {};
}

}  // namespace

Status perform(Session& session, Change&, const SelectKnots& command) {
  return select_several(session, knots_of(session, command.knots), command.knots);
}
Status perform(Session& session, Change&, const SelectSections& command) {
  return select_several(session, chosen_sections(session, command.sections), command.sections);
}

Status perform(Session& session, Change& change, const SetSnapping& command) {
  if (!std::isfinite(command.step) || !std::isfinite(command.angle)) return refused("expected finite numbers");
  session.settings.snapping = {command.to, change.clamp("step", command.step, 0.001, 1000.0, "m"),
                               change.clamp("angle", command.angle, 0.1, 180.0, "degrees")};
  return {};
}

}  // namespace coaster::edit
