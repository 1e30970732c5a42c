// Commands of equipment, trains, losses, banking, and the meaning of the track's curve.
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "edit/commands/commands_operation.h"
#include "edit/perform/equipping.h"
#include "sim/fit/switch_curve.h"
#include "sim/plan/banking.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;

bool finite(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

}  // namespace

Status perform(Session& session, Change& change, const SetEquipment& command) {
  const auto segment = require(session, command.segment, world::Kind::segment);
  if (!segment) return segment.status();
  const base::Result<world::Equipment> equipment = equipment_of(command.to, change);
  if (!equipment) return equipment.status();
  equip(session.document, change, {&*segment, 1}, *equipment, world::label_of(session.document, *segment));
  return {};
}

Status perform(Session& session, Change& change, const RemoveEquipment& command) {
  const auto segment = require(session, command.segment, world::Kind::segment);
  if (!segment) return segment.status();
  if (!session.document.entities.find<world::Equipment>(*segment))
    return refused("there is no equipment on @" + world::label_of(session.document, *segment));
  session.document.entities.pool<world::Equipment>().erase(*segment);
  change.note = fmt::format("Removed the equipment of {}.", world::label_of(session.document, *segment));
  return {};
}

Status perform(Session& session, Change& change, const SetTrain& command) {
  const auto cart = require(session, command.cart, world::Kind::cart);
  if (!cart) return cart.status();
  if (!finite({command.spacing, command.length, command.mass})) return refused("expected finite numbers");
  world::Cart& design = session.document.entities.get<world::Cart>(*cart);
  design.cars = change.clamp("cars", command.cars, 1, world::kMaxCars);
  if (command.spacing != 0)
    design.spacing = change.clamp("spacing", command.spacing, world::kMinSpacing, world::kMaxSpacing, "m");
  if (command.length != 0)
    design.length = change.clamp("length", command.length, world::kMinCarLength, world::kMaxCarLength, "m");
  if (command.mass != 0) design.mass = change.clamp("mass", command.mass, world::kMinCarMass, world::kMaxCarMass, "kg");
  return {};
}

Status perform(Session& session, Change& change, const SetLosses& command) {
  if (!finite({command.rolling, command.drag})) return refused("expected finite numbers");
  session.document.resistance.rolling = change.clamp("rolling friction", command.rolling, 0.0f, world::kMaxRolling);
  session.document.resistance.drag = change.clamp("drag", command.drag, 0.0f, world::kMaxDrag, "1/m");
  return {};
}

Status perform(Session& session, Change&, const SetLossSet& command) {
  session.document.resistance = base::row_of(command.to).losses;
  return {};
}

Status perform(Session& session, Change& change, const SetHeartline& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite height");
  session.document.heartline = change.clamp("heartline", command.to, -world::kMaxHeartline, world::kMaxHeartline, "m");
  return {};
}

Status perform(Session& session, Change&, const SetRollbackFails& command) {
  session.document.rollback_fails = command.to;
  return {};
}

// Banking changes what riders feel, not the speeds of the ride, so one pass is enough.
Status perform(Session& session, Change& change, const AutoBank&) {
  const sim::Ghost* const ghost = Finder(session).ride();
  if (!ghost) return refused("banking needs a track with a train");
  const int turned = sim::bank_knots(session.document, session.derived, *ghost);
  change.respun = session.document.track.knots;
  change.note = fmt::format("Banked {} {}.", turned, turned == 1 ? "knot" : "knots");
  return {};
}

Status perform(Session& session, Change& change, const SetCurve& command) {
  if (session.document.curve == command.to) return {};
  if (command.keep == Keep::numbers) {
    session.document.curve = command.to;
    return {};
  }
  base::Result<sim::SwitchedCurve> switched = sim::switch_curve(session.document, session.derived, command.to);
  if (!switched) return switched.status();
  const world::Track& track = switched->document.track;
  if (const Status room = room_for(session, track.knots.size(), track.segments.size()); !room) return room;
  // Moving trains stay at their positions on the rails.
  for (world::CartMotion& cart : session.motion.carts.items()) {
    const sim::SegmentShape* const former = session.derived.segments.find(cart.segment);
    if (!former) continue;
    const sim::CurvePlace now = switched->place(session.derived, {cart.segment, former->arc.parameter(cart.s)});
    const curve::ArcLengthMap& arc = switched->shapes.shape(now.segment).arc;
    cart.segment = now.segment, cart.s = arc.distance(now.t), cart.segment_length = arc.length();
  }
  session.document = std::move(switched->document);
  change.note = fmt::format("The rails moved by at most {:.1f} mm. Added {} {}.", 1000 * switched->max_error,
                            switched->added, switched->added == 1 ? "knot" : "knots");
  return {};
}

}  // namespace coaster::edit
