// Commands of spans and the whole track: reverse, duplicate, close.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "edit/commands/commands_shape.h"
#include "edit/perform/append_shape.h"
#include "edit/perform/knot_runs.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dmat3;
using glm::dvec3;
using world::Entity;
using world::Knot;

// Returns the front of a train after reversing the track: its former rear, so that it stays on the same rails.
double turned(const sim::Derived& derived, double front, double behind) {
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
  if (knot.joint == world::JointKind::automatic) knot.joint = world::JointKind::aligned;  // its neighbours have changed
  return knot;
}

}  // namespace

Status perform(Session& session, Change& change, const Reverse&) {
  world::Document& document = session.document;
  if (document.track.segments.empty()) return refused("there is no track to reverse");
  const sim::Derived& derived = session.derived;
  struct Start {
    Entity cart;
    double place;
  };
  std::vector<Start> starts;
  const auto& carts = document.entities.pool<world::Cart>();
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const world::Cart& cart = carts.items()[i];
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
    world::Cart& cart = document.entities.get<world::Cart>(start.cart);
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
  end.out_length = from.out_length;
  if (end.in_length != end.out_length || end.joint == world::JointKind::automatic)
    end.joint = world::JointKind::aligned;
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
  if (!std::isfinite(command.within) || command.within < 0) return refused("expected a distance of 0 m or more");
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

}  // namespace coaster::edit
