// Commands of the park.
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "edit/commands/commands_park.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/perform_context.h"
#include "exchange/own/park_member.h"
#include "sim/ground/brush.h"
#include "world/aid_settings.h"

namespace coaster::edit {

using base::Status;

namespace {

constexpr std::int64_t kMostSeed = std::numeric_limits<std::uint32_t>::max();

std::uint32_t seed_of(Change& change, std::int64_t wish) {
  return static_cast<std::uint32_t>(change.clamp("seed", wish, std::int64_t{0}, kMostSeed));
}

Status needs_land(const Session& session) {
  if (!session.document.park.plain()) return {};
  return refused("there is no land: choose one first, for example with: park hills");
}

// Makes a stroke about places that `makes` returns for the land and the clamped radius.
Status stroke(Session& session, Change& change, std::initializer_list<glm::vec2> places, double radius,
              const auto& makes) {
  if (const Status land = needs_land(session); !land) return land;
  radius = change.clamp("radius", radius, world::kLeastBrush, world::kLargestBrush, "m");
  for (const glm::vec2 at : places)
    if (!(std::fabs(at.x) <= world::kGroundSquare / 2) || !(std::fabs(at.y) <= world::kGroundSquare / 2))
      return refused(fmt::format("the land can be shaped up to {} m from its middle", world::kGroundSquare / 2));
  session.document.park.tiles = makes(sim::Land(session.document.park), radius);
  return {};
}

// Makes the stroke `makes(land, brush, more...)` of a command with a place and a radius.
Status brush_stroke(Session& session, Change& change, const auto& command, auto makes, auto... more) {
  return stroke(session, change, {command.at}, command.radius, [&](const sim::Land& land, double radius) {
    return makes(land, {command.at, radius}, more...);
  });
}

}  // namespace

Status perform(Session& session, Change& change, const SetLand& command) {
  if (session.game.challenge) return refused("the land of a challenge stays as it is");
  world::Document& document = session.document;
  if (!document.park.tiles.empty()) change.note = "The strokes of brushes went with the former land.";
  document.park = world::usual_park(command.to, document.park.seed);
  exchange::drop_member(document.extra, "park");  // of a later version
  return {};
}

Status perform(Session& session, Change& change, const NewPark& command) {
  world::Document document;
  document.park = world::usual_park(command.land, seed_of(change, command.seed));
  start_over(session, std::move(document), {});
  return {};
}

Status perform(Session& session, Change& change, const SetParkSeed& command) {
  if (const Status land = needs_land(session); !land) return land;
  session.document.park.seed = seed_of(change, command.to);
  return {};
}

Status perform(Session& session, Change& change, const SetParkRelief& command) {
  if (const Status land = needs_land(session); !land) return land;
  session.document.park.relief = change.clamp("relief", command.to, 0, world::kMaxRelief) + 0.0;
  return {};
}

Status perform(Session& session, Change& change, const SetParkWoods& command) {
  if (const Status land = needs_land(session); !land) return land;
  session.document.park.woods = change.clamp("woods", command.to, 0, 1) + 0.0;
  return {};
}

Status perform(Session& session, Change& change, const SetParkWater& command) {
  if (const Status land = needs_land(session); !land) return land;
  session.document.park.water =
      change.clamp("water", command.to.level, world::kLowestWater, world::kHighestWater, "m") + 0.0;
  return {};
}

Status perform(Session& session, Change&, const ResetPark&) {
  if (const Status land = needs_land(session); !land) return land;
  if (session.document.park.tiles.empty()) return refused("no brush has touched the land");
  session.document.park.tiles = {};
  return {};
}

Status perform(Session& session, Change& change, const RaiseGround& command) {
  return brush_stroke(session, change, command, sim::raised, command.by);
}

Status perform(Session& session, Change& change, const SmoothGround& command) {
  return brush_stroke(session, change, command, sim::smoothed);
}

Status perform(Session& session, Change& change, const FlattenGround& command) {
  const double to = change.clamp("height", command.to, -world::kHighestGround, world::kHighestGround, "m");
  return brush_stroke(session, change, command, sim::flattened, to);
}

Status perform(Session& session, Change& change, const SlopeGround& command) {
  return stroke(session, change, {command.from, command.to}, command.radius, [&](const sim::Land& land, double radius) {
    return sim::sloped(land, command.from, command.to, radius);
  });
}

Status perform(Session& session, Change& change, const PaintWoods& command) {
  const double to = change.clamp("woods", command.to, 0, 1);
  return brush_stroke(session, change, command, sim::wooded, to);
}

Status perform(Session& session, Change& change, const ResetWoods& command) {
  return brush_stroke(session, change, command, sim::wooded, std::nullopt);
}

Status perform(Session& session, Change&, const SetEarthwork& command) {
  const auto sections = chosen_sections(session, command.sections);
  if (!sections) return sections.status();
  for (const world::Entity e : *sections) session.document.entities.get<world::Section>(e).earthwork = command.to;
  return {};
}

}  // namespace coaster::edit
