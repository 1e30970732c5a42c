// Commands that shape knots and segments without adding or removing any.
#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "edit/commands/commands_document.h"
#include "edit/perform/knot_runs.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::JointKind;
using world::Kind;
using world::Knot;

constexpr double kShortDirection = 1e-9;  // m, as in world::set_tangent

Knot& knot_at(Session& session, world::Entity e) { return session.document.entities.get<Knot>(e); }

// Makes an automatic joint aligned, because it would undo the change made by hand.
void shaped_by_hand(Knot& knot) {
  if (knot.joint == JointKind::automatic) knot.joint = JointKind::aligned;
}

}  // namespace

Status perform(Session& session, Change& change, const MoveKnot& command) {
  const auto e = require(session, command.knot, Kind::knot);
  if (!e) return e.status();
  if (!finite(command.to)) return refused("expected 3 finite numbers");
  knot_at(session, *e).position = change.clamp_position("position", command.to);
  return {};
}

Status perform(Session& session, Change& change, const MoveHandle& command) {
  const auto e = require(session, {command.handle.knot}, Kind::knot);
  if (!e) return e.status();
  if (!finite(command.to)) return refused("expected 3 finite numbers");
  Knot& knot = knot_at(session, *e);
  const bool in = command.handle.end == HandleEnd::in;
  glm::dvec3 arm = glm::dvec3(command.to) - glm::dvec3(knot.position);
  if (in) arm = -arm;
  const double length = glm::length(arm);
  shaped_by_hand(knot);
  // A handle on its knot has no direction: keep the old one.
  if (length >= double{world::kMinHandle}) world::set_tangent(knot, glm::vec3(arm));
  const float clamped = change.clamp("handle length", static_cast<float>(std::max(length, 0.0)), world::kMinHandle,
                                     world::kMaxHandle, "m");
  (in ? knot.in_length : knot.out_length) = clamped;
  if (knot.joint == JointKind::smooth) knot.in_length = knot.out_length = clamped;
  return {};
}

Status perform(Session& session, Change&, const SetDirection& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  if (!finite(command.to)) return refused("expected 3 finite numbers");
  if (!(glm::length(glm::dvec3(command.to)) >= kShortDirection)) return refused("expected a direction longer than 0");
  for (const world::Entity e : *knots) {
    Knot& knot = knot_at(session, e);
    shaped_by_hand(knot);
    world::set_tangent(knot, command.to);
  }
  return {};
}

Status perform(Session& session, Change& change, const SetLengths& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  if (!std::isfinite(command.in) || !std::isfinite(command.out)) return refused("expected finite lengths");
  const float in = change.clamp("handle length", command.in, world::kMinHandle, world::kMaxHandle, "m");
  const float out = change.clamp("handle length", command.out, world::kMinHandle, world::kMaxHandle, "m");
  for (const world::Entity e : *knots) {
    Knot& knot = knot_at(session, e);
    shaped_by_hand(knot);
    knot.in_length = in, knot.out_length = out;
    if (in != out) knot.joint = JointKind::aligned;
  }
  return {};
}

Status perform(Session& session, Change& change, const SetRoll& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  if (!std::isfinite(command.to)) return refused("expected a finite angle");
  for (const world::Entity e : *knots)
    world::set_roll(knot_at(session, e), command.to);  // any angle is valid: it wraps
  change.respun = with_neighbours(session.document, *knots);
  return {};
}

Status perform(Session& session, Change& change, const SetSpin& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  if (!std::isfinite(command.to)) return refused("expected a finite rate");
  const double most = base::degrees(double{world::kMaxSpin});
  const auto spin = static_cast<float>(base::radians(change.clamp("spin", command.to, -most, most, "deg/m")));
  for (const world::Entity e : *knots) {
    Knot& knot = knot_at(session, e);
    knot.spin = std::clamp(spin, -world::kMaxSpin, world::kMaxSpin), knot.spin_kind = world::SpinKind::set;
  }
  return {};
}

Status perform(Session& session, Change& change, const AutomaticSpin& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  for (const world::Entity e : *knots) knot_at(session, e).spin_kind = world::SpinKind::automatic;
  change.respun = *knots;
  return {};
}

Status perform(Session& session, Change&, const SetJoint& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  for (const world::Entity e : *knots) {
    Knot& knot = knot_at(session, e);
    knot.joint = command.to;
    if (command.to == JointKind::smooth)
      knot.in_length = knot.out_length = static_cast<float>((double{knot.in_length} + double{knot.out_length}) / 2);
  }
  return {};
}

Status perform(Session& session, Change& change, const SetTurns& command) {
  const auto e = require(session, command.segment, Kind::segment);
  if (!e) return e.status();
  session.document.entities.get<world::Segment>(*e).turns =
      change.clamp("turns", command.to, -world::kMaxTurns, world::kMaxTurns);
  const world::Segment& segment = world::segment(session.document, *e);
  change.respun = {segment.from, segment.to};
  return {};
}

}  // namespace coaster::edit
