// Commands that move, rotate, scale and mirror several knots.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "edit/commands/commands_shape.h"
#include "edit/perform/knot_runs.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dmat3;
using glm::dvec3;
using world::Entity;
using world::Knot;

constexpr double kLeastFactor = 1e-4;  // of scaling: smaller factors would lose the shape
constexpr double kShortAxis = 1e-9;

// p -> about + linear (p - about) + by.
struct Map {
  dmat3 linear{1.0};
  dvec3 about{0}, by{0};
  bool rigid_shift = false;  // linear is 1: only positions change, by one addition
};

// Returns the knot as it was when the gesture began, or as it is now.
const Knot& source(const Session& session, Entity e, bool from_start) {
  if (from_start && session.history.in_gesture)
    if (const Knot* const then = session.history.gesture_start.entities.find<Knot>(e)) return *then;
  return world::knot(session.document, e);
}

float cut_length(double length, bool& cut) {
  const double within = std::clamp(length, double{world::kMinHandle}, double{world::kMaxHandle});
  cut = cut || within != length;
  return static_cast<float>(within);
}

void turn(Knot& knot, const dmat3& linear, bool& cut) {
  const dvec3 tangent = linear * dvec3(knot.tangent), up = linear * dvec3(knot.up);
  const double stretch = glm::length(tangent);
  if (!(stretch > 0)) return;
  world::set_tangent(knot, glm::vec3(tangent / stretch));
  knot.up = glm::vec3(curve::perpendicular(dvec3(knot.tangent), up));
  world::orthonormalise(knot);
  knot.spin = static_cast<float>(std::clamp<double>(knot.spin * (glm::determinant(linear) < 0 ? -1 : 1) / stretch,
                                                    -world::kMaxSpin, world::kMaxSpin));
  knot.in_length = cut_length(knot.in_length * stretch, cut),
  knot.out_length = cut_length(knot.out_length * stretch, cut);
}

// Mirrors reverse twists: whole turns between two mirrored knots change sign, as spins do.
void turn_back_twists(world::Document& document, const std::vector<Entity>& knots, const world::Document* then) {
  for (const Entity e : document.track.segments) {
    world::Segment& segment = document.entities.get<world::Segment>(e);
    const world::Segment* const before = then ? then->entities.find<world::Segment>(e) : nullptr;
    const auto chosen = [&](Entity k) { return std::binary_search(knots.begin(), knots.end(), k); };
    if (segment.turns != 0 && chosen(segment.from) && chosen(segment.to))
      segment.turns = -(before ? before->turns : segment.turns);
  }
}

Status transform(Session& session, Change& change, const Knots& which, const Map& map, bool from_start) {
  auto knots = knots_of(session, which);
  if (!knots) return knots.status();
  bool cut = false;
  for (const Entity e : *knots) {
    Knot next = source(session, e, from_start);
    const dvec3 position =
        map.rigid_shift ? dvec3(next.position) + map.by : map.about + map.linear * (dvec3(next.position) - map.about);
    if (!map.rigid_shift) turn(next, map.linear, cut);
    constexpr double kMost = world::kMaxCoordinate;
    const dvec3 within = glm::clamp(position, dvec3(-kMost), dvec3(kMost));
    if (within != position)
      change.clamp_position("position", glm::vec3(glm::clamp(position, dvec3(-1e30), dvec3(1e30))));
    next.position = glm::vec3(within);
    session.document.entities.get<Knot>(e) = next;
  }
  if (cut)
    change.clamped.push_back(fmt::format("Kept handle lengths within the limits of {} to {} m.",
                                         base::to_text(world::kMinHandle), base::to_text(world::kMaxHandle)));
  if (glm::determinant(map.linear) < 0) {
    std::sort(knots->begin(), knots->end());
    turn_back_twists(session.document, *knots,
                     from_start && session.history.in_gesture ? &session.history.gesture_start : nullptr);
  }
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const Translate& command) {
  if (!finite(command.by)) return refused("expected 3 finite numbers");
  return transform(session, change, command.knots, {.by = dvec3(command.by), .rigid_shift = true}, command.from_start);
}

Status perform(Session& session, Change& change, const Rotate& command) {
  if (!finite(command.about) || !finite(command.axis) || !std::isfinite(command.by))
    return refused("expected finite numbers");
  const dvec3 axis(command.axis);
  if (!(glm::length(axis) >= kShortAxis)) return refused("expected an axis longer than 0");
  const dvec3 unit = axis / glm::length(axis);
  const double angle = base::radians(std::remainder(command.by, 360.0));
  const dmat3 linear(curve::rotate({1, 0, 0}, unit, angle), curve::rotate({0, 1, 0}, unit, angle),
                     curve::rotate({0, 0, 1}, unit, angle));
  return transform(session, change, command.knots, {.linear = linear, .about = dvec3(command.about)},
                   command.from_start);
}

Status perform(Session& session, Change& change, const Scale& command) {
  if (!finite(command.about) || !finite(command.by)) return refused("expected finite numbers");
  dmat3 linear(1.0);
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(double{command.by[i]}) >= kLeastFactor))
      return refused(fmt::format("expected factors of {} or more", base::to_text(kLeastFactor)));
    linear[i][i] = command.by[i];
  }
  return transform(session, change, command.knots, {.linear = linear, .about = dvec3(command.about)},
                   command.from_start);
}

Status perform(Session& session, Change& change, const Mirror& command) {
  if (!finite(command.about) || !finite(command.across)) return refused("expected finite numbers");
  const dvec3 across(command.across);
  if (!(glm::length(across) >= kShortAxis)) return refused("expected a normal longer than 0");
  const dvec3 n = across / glm::length(across);
  const dmat3 linear = dmat3(1.0) - 2.0 * glm::outerProduct(n, n);
  return transform(session, change, command.knots, {.linear = linear, .about = dvec3(command.about)}, false);
}

Status perform(Session& session, Change& change, const Align& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  if (!std::isfinite(command.to)) return refused("expected a finite coordinate");
  const int axis = static_cast<int>(command.axis);
  const std::string what = fmt::format("position.{}", base::name_of(command.axis));
  const double to = change.clamp(what, command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m");
  for (const Entity e : *knots) session.document.entities.get<Knot>(e).position[axis] = static_cast<float>(to);
  return {};
}

}  // namespace coaster::edit
