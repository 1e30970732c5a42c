// Commands that add and remove knots, segments and trains, and those of the document: name, start speed, datum, the
// coaster's kind and paint.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_shape.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/replan.h"
#include "sim/ground/land.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dmat3;
using glm::dvec3;
using world::Entity;
using world::EntityKind;
using world::Knot;

constexpr float kStep = 10;         // m, distance to a new knot if there is nothing to split
constexpr double kFirstHeight = 2;  // m above the ground, of the first knot at the origin

glm::vec3 first_position(const world::Document& document) {
  return {0, static_cast<float>(sim::Land(document.park).standing(0, 0, kFirstHeight)), 0};
}

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
  if (const Status room = room_for(session, knots + 1, knots); !room) return room;
  const world::Knot knot = appended_knot(document, position);
  reshape_end(document, true, position);
  if (knots > 0) change.respun.push_back(document.track.knots.back());
  change.select = world::append_knot(document, knot);
  if (document.track.segments.size() == 1) add_first_train(document);
  return {};
}

Entity longest_segment(const sim::DerivedTrack& derived) {
  Entity longest = world::kNone;
  double most = -1;
  for (const Entity e : derived.order)
    if (const double length = derived.shape(e).arc.length(); length > most) most = length, longest = e;
  return longest;
}

// Returns the front of a train after reversing the track: its former rear, so that it stays on the same rails.
double turned(const sim::DerivedTrack& derived, double front, double behind) {
  const double place = sim::within_lap(derived.length - (front - behind), derived.length, derived.closed);
  return std::clamp(place, 0.0, derived.length);
}

// tangent, up, tangent x up as columns.
dmat3 frame_of(const Knot& knot) {
  const dvec3 tangent = glm::normalize(dvec3(knot.tangent)), up = dvec3(knot.up);
  const dvec3 normal = glm::normalize(up - glm::dot(up, tangent) * tangent);
  return {tangent, normal, glm::cross(tangent, normal)};
}

// Moves a knot from the frame `from` to the frame `to`.
Knot carried(Change& change, Knot knot, const Knot& from, const Knot& to) {
  const dmat3 turn = frame_of(to) * glm::transpose(frame_of(from));
  knot.position = change.clamp_position(
      "position", glm::vec3(dvec3(to.position) + turn * (dvec3(knot.position) - dvec3(from.position))));
  knot.tangent = glm::vec3(glm::normalize(turn * dvec3(knot.tangent)));
  knot.up = glm::vec3(glm::normalize(turn * dvec3(knot.up)));
  world::orthonormalise(knot);
  shaped_by_hand(knot);  // its neighbours have changed
  return knot;
}

// Trains have one paint for the whole track.
Status paint_sections(Session& session, const Sections& named, const auto& change) {
  const auto sections = chosen_sections(session, named);
  if (!sections) return sections.status();
  for (const world::Entity e : *sections) {
    world::Paint& paint = session.document.entities.get<world::Section>(e).paint;
    change(paint);
    paint.train = {};
  }
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const SplitSegment& command) {
  const world::Entity e = entity_of(session, command.segment);
  if (!(command.at > 0 && command.at < 1))
    return refused(fmt::format("expected a parameter t between 0 and 1, found {:.6g}", command.at));
  return split_at(session, change, e, command.at);
}

Status perform(Session& session, Change& change, const SplitLongestSegment&) {
  const world::Track& track = session.document.track;
  if (track.segments.empty()) {
    if (track.knots.empty()) return append_at(session, change, first_position(session.document));
    const world::Knot& last = world::knot(session.document, track.knots.back());
    return append_at(session, change, change.clamp_position("position", last.position + last.tangent * kStep));
  }
  const Entity longest = longest_segment(session.derived);
  const curve::ArcLengthMap& arc = session.derived.shape(longest).arc;
  return split_at(session, change, longest, arc.parameter(arc.length() / 2));
}

Status perform(Session& session, Change& change, const AppendKnot& command) {
  return append_at(session, change, change.clamp_position("position", command.at));
}

Status perform(Session& session, Change& change, const RemoveKnotOrTrain& command) {
  world::Document& document = session.document;
  if (command.what.name.kind == EntityKind::cart) {
    const auto cart = require(session, command.what, EntityKind::cart);
    if (!cart) return cart.status();
    document.entities.destroy(*cart);
    return {};
  }
  const auto e = require(session, command.what, EntityKind::knot);
  if (!e) return e.status();
  const world::KnotSegments sides = world::neighbours(document, *e);
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
    if (const Status room = room_for(session, track.knots.size(), track.knots.size()); !room) return room;
    close_by_segment(document, kLongestClosing);
  } else {
    world::set_closed(document, false);
  }
  change.respun = {track.knots.front(), track.knots.back()};
  return {};
}

Status perform(Session& session, Change& change, const AddTrain& command) {
  const world::Entity e = entity_of(session, command.segment);
  if (const Status on = within("a fraction of the length", command.at, 0, 1); !on) return on;
  if (session.document.entities.pool<world::Train>().size() >= world::kMaxCarts)
    return refused(fmt::format("a track has at most {} trains", world::kMaxCarts));
  change.select = world::add_cart(session.document, e, command.at);
  warn_of_deadlock(session);
  return {};
}

Status perform(Session& session, Change&, const SetTrackName& command) {
  if (const Status may = may_be_called(command.to, "name"); !may) return may;
  session.document.name = command.to;
  return {};
}

Status perform(Session& session, Change& change, const SetStartSpeed& command) {
  session.document.start_speed = change.clamp("start speed", command.to, -world::kMaxSpeed, world::kMaxSpeed, "m/s");
  return {};
}

Status perform(Session& session, Change& change, const SetDatum& command) {
  session.document.datum =
      change.clamp("datum", command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m");
  return {};
}

Status perform(Session& session, Change& change, const Reverse&) {
  world::Document& document = session.document;
  if (document.track.segments.empty()) return refused("there is no track to reverse");
  const sim::DerivedTrack& derived = session.derived;
  struct Start {
    Entity cart;
    double place;
  };
  std::vector<Start> starts;
  const auto& carts = document.entities.pool<world::Train>();
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const world::Train& cart = carts.items()[i];
    const std::size_t index = *world::index_of(derived.order, cart.segment);
    const double front = derived.starts[index] + cart.fraction * (derived.starts[index + 1] - derived.starts[index]);
    starts.push_back({carts.entities()[i], turned(derived, front, cart.behind())});
  }
  world::reverse(document);
  const std::size_t count = derived.order.size();
  for (const Start& start : starts) {
    // Segment i of the new order is segment count - 1 - i of the old one.
    const auto upper = std::upper_bound(derived.starts.begin(), derived.starts.end() - 1, derived.length - start.place);
    const std::size_t old = static_cast<std::size_t>(std::max<std::ptrdiff_t>(upper - derived.starts.begin() - 1, 0));
    const double length = derived.starts[old + 1] - derived.starts[old],
                 s = derived.starts[old + 1] - (derived.length - start.place);
    world::Train& cart = document.entities.get<world::Train>(start.cart);
    cart.segment = document.track.segments[count - 1 - old];
    cart.fraction = length > 0 ? std::clamp(s / length, 0.0, std::nextafter(1.0, 0.0)) : 0.0;
  }
  change.motion.kind = MotionFollowUp::Kind::reversed;
  return {};
}

Status perform(Session& session, Change& change, const Duplicate& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  world::Document& document = session.document;
  if (document.track.closed) return refused(std::string(world::kClosedTrack));
  const std::vector<KnotRun> runs = runs_of(document, *knots);
  if (runs.size() != 1 || knots->size() < 2) return refused("expected two or more neighbouring knots");
  const std::size_t count = document.track.knots.size(), more = knots->size() - 1;
  if (const Status room = room_for(session, count + more, count - 1 + more); !room) return room;
  const Knot from = world::knot(document, knots->front()), to = world::knot(document, document.track.knots.back());
  Knot& end = document.entities.get<Knot>(document.track.knots.back());
  begin_there(end, from.out_length);
  change.respun = {document.track.knots.back()};
  for (std::size_t i = 1; i <= more; ++i) {
    const Entity original = document.track.segments[runs[0].places[i] - 1];
    const Entity copy = world::append_knot(document, carried(change, world::knot(document, (*knots)[i]), from, to));
    const Entity segment = document.track.segments.back();
    document.entities.get<world::Segment>(segment).turns = world::segment(document, original).turns;
    world::copy_fittings(document, original, document, segment);
    if (i < more) change.also.push_back(copy);
    change.select = copy;
  }
  return {};
}

Status perform(Session& session, Change& change, const CloseExactly& command) {
  world::Document& document = session.document;
  const world::Track& track = document.track;
  if (track.closed) return refused("the track is closed already");
  if (track.knots.size() < 2) return refused("a closed track needs at least 2 knots");
  if (command.within < 0) return refused("expected a distance of 0 m or more");
  const Entity first = track.knots.front(), last = track.knots.back();
  const double gap =
      glm::length(dvec3(world::knot(document, last).position) - dvec3(world::knot(document, first).position));
  if (gap <= command.within && track.knots.size() >= 3) {
    world::weld_ends(document);
    change.respun = {first};
    change.note =
        fmt::format("Joined both ends, {} m apart, into one knot.", base::to_text(std::round(gap * 1e3) / 1e3));
    return {};
  }
  if (const Status room = room_for(session, track.knots.size(), track.knots.size()); !room) return room;
  close_by_segment(document, 0);  // handles that fit the gap, whatever the ends' handles
  change.respun = {first, last};
  return {};
}

// --- The coaster's kind and paint

Status perform(Session& session, Change& change, const SetKind& command) {
  world::Document& document = session.document;
  const world::CoasterKindRow &was = base::row_of(document.kind), &is = base::row_of(command.to);
  document.kind = command.to;
  if (document.heartline == was.heartline && is.heartline != was.heartline) {
    document.heartline = is.heartline;
    change.note = fmt::format("The heartline is now {:.1f} m above the rails.", is.heartline);
    if (is.heartline < 0) change.note = fmt::format("Riders hang {:.1f} m below the rails.", -is.heartline);
  }
  if (document.resistance == was.losses) document.resistance = is.losses;
  constexpr float kFeet = 2.6f;  // m below the rails
  const auto& knots = document.entities.pool<world::Knot>().items();
  const auto low = std::ranges::count_if(knots, [](const world::Knot& knot) { return knot.position.y < kFeet; });
  if (is.heartline < 0 && low > 0)
    change.clamped.push_back(fmt::format("Riders' feet hang {} m below the rails: {} {} lower than that.", kFeet, low,
                                         low == 1 ? "knot is" : "knots are"));
  return {};
}

Status perform(Session& session, Change&, const PaintTrack& command) {
  session.document.paint = base::row_of(command.to).paint;
  return {};
}

Status perform(Session& session, Change&, const PaintTrackPart& command) {
  session.document.paint.of(command.part) = command.to;
  return {};
}

Status perform(Session& session, Change&, const PaintSections& command) {
  return paint_sections(session, command.sections,
                        [&](world::Paint& paint) { paint = base::row_of(command.to).paint; });
}

Status perform(Session& session, Change&, const PaintSectionsPart& command) {
  if (command.part == world::PaintPart::train)
    return refused("trains have one paint for the whole track: use paint.colour");
  return paint_sections(session, command.sections, [&](world::Paint& paint) { paint.of(command.part) = command.to; });
}

}  // namespace coaster::edit
