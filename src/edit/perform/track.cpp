// Commands that add and remove knots, segments and trains, and those of the document: name, start speed, datum.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_document.h"
#include "edit/perform/append_shape.h"
#include "edit/perform/perform.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Entity;
using world::Kind;

constexpr float kStep = 10;                   // m, distance to a new knot if there is nothing to split
constexpr glm::vec3 kFirstPosition{0, 2, 0};  // m, above the ground

Status split_at(Session& session, Change& change, Entity segment, double t) {
  world::Document& document = session.document;
  const Status room = room_for(session, document.track.knots.size() + 1, document.track.segments.size() + 1);
  if (!room) return room;
  const sim::SegmentShape& shape = session.derived.shape(segment);
  const double s = shape.arc.distance(t);
  const world::SplitResult split = world::split_segment(document, segment, t, glm::vec3(sim::frame_at(shape, s).up),
                                                        static_cast<float>(shape.roll.spin(s)));
  if (!split.knot.valid())
    return refused(fmt::format("a handle would leave the limits of {} to {} m, or the knot the world",
                               base::to_text(world::kMinHandle), base::to_text(world::kMaxHandle)));
  change.motion = {MotionFollowUp::Kind::split, split.first, split.second, 0, 0};
  change.select = split.knot;
  return {};
}

Status append_at(Session& session, Change& change, glm::vec3 position) {
  world::Document& document = session.document;
  const std::size_t knots = document.track.knots.size();
  if (document.track.closed) return refused(std::string(world::kClosedTrack));
  const Status room = room_for(session, knots + 1, knots);
  if (!room) return room;
  const world::Knot knot = appended_knot(document, position);
  reshape_end(document, true, position);
  if (knots > 0) change.respun.push_back(document.track.knots.back());
  change.select = world::append_knot(document, knot);
  // A first segment gets a train, so that there is something to watch.
  if (document.track.segments.size() == 1 && document.entities.pool<world::Cart>().size() == 0)
    world::add_cart(document, document.track.segments.front(), 0.0);
  return {};
}

Entity longest_segment(const sim::Derived& derived) {
  Entity longest = world::kNone;
  double most = -1;
  for (const Entity e : derived.order)
    if (const double length = derived.shape(e).arc.length(); length > most) most = length, longest = e;
  return longest;
}

}  // namespace

Status perform(Session& session, Change& change, const SplitSegment& command) {
  const auto e = require(session, command.segment, Kind::segment);
  if (!e) return e.status();
  if (!(command.at > 0 && command.at < 1))
    return refused(fmt::format("expected a parameter t between 0 and 1, found {:.6g}", command.at));
  return split_at(session, change, *e, command.at);
}

Status perform(Session& session, Change& change, const AddCurve&) {
  const world::Track& track = session.document.track;
  if (track.segments.empty()) {
    if (track.knots.empty()) return append_at(session, change, kFirstPosition);
    const world::Knot& last = world::knot(session.document, track.knots.back());
    return append_at(session, change, change.clamp_position("position", last.position + last.tangent * kStep));
  }
  const Entity longest = longest_segment(session.derived);
  const curve::ArcLengthMap& arc = session.derived.shape(longest).arc;
  return split_at(session, change, longest, arc.parameter(arc.length() / 2));
}

Status perform(Session& session, Change& change, const AppendKnot& command) {
  if (!finite(command.at)) return refused("expected 3 finite numbers");
  return append_at(session, change, change.clamp_position("position", command.at));
}

Status perform(Session& session, Change& change, const RemoveKnot& command) {
  world::Document& document = session.document;
  if (command.knot.name.kind == Kind::cart) {
    const auto cart = require(session, command.knot, Kind::cart);
    if (!cart) return cart.status();
    document.entities.destroy(*cart);
    return {};
  }
  const auto e = require(session, command.knot, Kind::knot);
  if (!e) return e.status();
  const world::Neighbours sides = world::neighbours(document, *e);
  const bool merge = sides.before.valid() && sides.after.valid() && document.track.knots.size() > 2;
  if (merge)
    change.motion = {MotionFollowUp::Kind::merged, sides.before, sides.after,
                     session.derived.shape(sides.before).arc.length(), session.derived.shape(sides.after).arc.length()};
  if (sides.before.valid()) change.respun.push_back(world::segment(document, sides.before).from);
  if (sides.after.valid()) change.respun.push_back(world::segment(document, sides.after).to);
  world::remove_knot(document, *e);
  return {};
}

Status perform(Session& session, Change& change, const SetClosed& command) {
  world::Document& document = session.document;
  const world::Track& track = document.track;
  if (command.to == track.closed) return {};
  if (command.to) {
    if (track.knots.size() < 2) return refused("a closed track needs at least 2 knots");
    const Status room = room_for(session, track.knots.size(), track.knots.size());
    if (!room) return room;
    close_by_segment(document, kLongestClosing);
  } else {
    world::set_closed(document, false);
  }
  change.respun = {track.knots.front(), track.knots.back()};
  return {};
}

Status perform(Session& session, Change& change, const AddCart& command) {
  const auto e = require(session, command.segment, Kind::segment);
  if (!e) return e.status();
  if (const Status on = within("a fraction of the length", command.at, 0, 1); !on) return on;
  if (session.document.entities.pool<world::Cart>().size() >= world::kMaxCarts)
    return refused(fmt::format("a track has at most {} trains", world::kMaxCarts));
  change.select = world::add_cart(session.document, *e, command.at);
  warn_of_deadlock(session);
  return {};
}

Status perform(Session& session, Change&, const SetName& command) {
  if (command.to.size() > world::kMaxNameBytes)
    return refused(fmt::format("the name is over the limit of {} bytes", world::kMaxNameBytes));
  if (!base::is_printable_utf8(command.to)) return refused("expected a name in UTF-8 without control characters");
  session.document.name = command.to;
  return {};
}

Status perform(Session& session, Change& change, const SetStartSpeed& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite speed");
  session.document.start_speed = change.clamp("start speed", command.to, -world::kMaxSpeed, world::kMaxSpeed, "m/s");
  return {};
}

Status perform(Session& session, Change& change, const SetDatum& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite height");
  session.document.datum =
      change.clamp("datum", command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m");
  return {};
}

}  // namespace coaster::edit
