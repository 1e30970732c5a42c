// Commands that improve the shape of several knots: smooth, equalise, straighten, radius, drop.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "curve/natural_spline.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_shape.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/perform_context.h"
#include "sim/fit/heartline_rails_conversion.h"
#include "sim/ground/land.h"
#include "sim/plan/banking.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dvec3;
using world::Entity;
using world::JointKind;
using world::Knot;

constexpr double kShortChord = 1e-4;  // m; a spline's step is never shorter

// Index arithmetic in track order, with neighbours across the joint of a closed track.
struct KnotsInOrder {
  world::Document& document;
  std::size_t count = document.track.knots.size();
  Knot& knot(std::size_t place) const { return nth_knot(document, place); }
  dvec3 position(std::size_t place) const { return dvec3(knot(place).position); }
  bool has_before(std::size_t place) const { return document.track.closed || place > 0; }
  bool has_after(std::size_t place) const { return document.track.closed || place + 1 < count; }
  std::size_t before(std::size_t place) const { return (place + count - 1) % count; }
};

// Smooths a run; the neighbouring knots do not change.
void smooth_run(const KnotsInOrder& at, const KnotRun& run, world::SplineSteps by) {
  std::vector<std::size_t> places = run.places;
  const bool before = !run.whole && at.has_before(places.front()), after = !run.whole && at.has_after(places.back());
  if (before) places.insert(places.begin(), at.before(places.front()));
  if (after) places.push_back((places.back() + 1) % at.count);
  const bool closed = run.whole && places.size() >= 3;
  if (places.size() < 2) return;
  std::vector<dvec3> points;
  for (const std::size_t place : places) points.push_back(at.position(place));
  std::vector<double> steps;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
    steps.push_back(by == world::SplineSteps::uniform
                        ? 1.0
                        : std::max(kShortChord, glm::length(points[(i + 1) % points.size()] - points[i])));
  curve::SplinePoints spline{points, steps, {}, {}, closed};
  if (before)
    spline.first = dvec3(at.knot(places.front()).tangent) * (3.0 * at.knot(places.front()).out_length / steps.front());
  if (after)
    spline.last = dvec3(at.knot(places.back()).tangent) * (3.0 * at.knot(places.back()).in_length / steps.back());
  const std::vector<dvec3> derivative = curve::spline_derivatives(spline);
  for (std::size_t i = before ? 1 : 0; i + (after ? 1 : 0) < places.size(); ++i) {
    Knot& knot = at.knot(places[i]);
    const double speed = glm::length(derivative[i]);
    world::set_tangent(knot, glm::vec3(derivative[i]));
    const bool first = i == 0 && !closed, last = i + 1 == places.size() && !closed;
    const double in = steps[first ? 0 : (i + steps.size() - 1) % steps.size()],
                 out = steps[last ? steps.size() - 1 : i];
    knot.in_length = world::as_handle(speed * in / 3), knot.out_length = world::as_handle(speed * out / 3);
    knot.joint = knot.in_length == knot.out_length ? JointKind::smooth : JointKind::aligned;
  }
}

// Moves knots of a run onto its chord, each at its fraction of the distance; handles are a third of the gaps.
Status straighten_run(const KnotsInOrder& at, const KnotRun& run) {
  const std::vector<std::size_t>& places = run.places;
  const dvec3 start = at.position(places.front()), way = at.position(places.back()) - start;
  const double length = glm::length(way);
  if (!(length >= places.size() * 3.0 * world::kMinHandle))
    return refused("the ends of the straight are too close to each other");
  std::vector<double> share{0};
  for (std::size_t i = 1; i < places.size(); ++i)
    share.push_back(share.back() +
                    std::max(kShortChord, glm::length(at.position(places[i]) - at.position(places[i - 1]))));
  for (std::size_t i = 0; i < places.size(); ++i) {
    Knot& knot = at.knot(places[i]);
    const bool first = i == 0, last = i + 1 == places.size();
    if (!first && !last) knot.position = glm::vec3(start + way * (share[i] / share.back()));
    world::set_tangent(knot, glm::vec3(way));
    if (!first) knot.in_length = world::as_handle(length * (share[i] - share[i - 1]) / share.back() / 3);
    if (!last) knot.out_length = world::as_handle(length * (share[i + 1] - share[i]) / share.back() / 3);
    if (knot.joint == JointKind::automatic || knot.in_length != knot.out_length) knot.joint = JointKind::aligned;
  }
  return {};
}

// Returns the handle length with which a segment leaves a knot at curvature 1 / radius: kappa = 2/3 h / a^2, with h the
// distance of the segment's next control point from the tangent line. Nothing if h is 0: the track is straight there
// for every length.
std::optional<double> length_for(double radius, dvec3 position, dvec3 tangent, dvec3 control) {
  const dvec3 off = control - position;
  const double h = glm::length(off - glm::dot(off, tangent) * tangent);
  if (!(h > 1e-6)) return std::nullopt;
  return std::sqrt(2.0 / 3.0 * h * radius);
}

}  // namespace

Status perform(Session& session, Change& change, const Smooth& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  const KnotsInOrder at{session.document};
  if (at.count < 2) return refused("a spline needs two knots");
  for (const KnotRun& run : runs_of(session.document, *knots)) smooth_run(at, run, command.by);
  change.note = fmt::format("Smoothed {} {}.", knots->size(), knots->size() == 1 ? "knot" : "knots");
  return {};
}

Status perform(Session& session, Change&, const Equalise& command) {
  return each_knot(session, command.knots, [](Knot& knot) {
    if (knot.joint == JointKind::automatic && knot.in_length == knot.out_length) return;
    equalise(knot);
    knot.joint = JointKind::smooth;
  });
}

Status perform(Session& session, Change&, const Straighten& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  world::Document next = session.document;
  const KnotsInOrder at{next};
  bool any = false;
  for (const KnotRun& run : runs_of(session.document, *knots)) {
    if (run.whole) return refused("a closed track has no straight line from its first knot to its last");
    if (run.places.size() < 2) continue;
    if (const Status done = straighten_run(at, run); !done) return done;
    any = true;
  }
  if (!any) return refused("a straight needs two neighbouring knots");
  session.document = std::move(next);
  return {};
}

Status perform(Session& session, Change& change, const SetRadius& command) {
  constexpr double kLeast = 0.1, kMost = 1e5;  // m
  constexpr int kSweeps = 30;                  // adjacent changed knots affect each other
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  const double radius = change.clamp("radius", command.to, kLeast, kMost, "m");
  world::Document next = session.document;
  const KnotsInOrder at{next};
  std::size_t bent = 0;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bent = 0;
    const auto set = [&](std::size_t place, bool before) {
      Knot& knot = at.knot(place);
      if (before ? !at.has_before(place) : !at.has_after(place)) return;
      const Knot& other = at.knot(before ? at.before(place) : place + 1);
      const auto length = length_for(radius, dvec3(knot.position), dvec3(knot.tangent),
                                     dvec3(before ? world::out_handle(other) : world::in_handle(other)));
      if (!length) return;
      (before ? knot.in_length : knot.out_length) = world::as_handle(*length);
      knot.joint = JointKind::aligned;
      ++bent;
    };
    for (std::size_t place = 0, chosen = 0; place < at.count && chosen < knots->size(); ++place) {
      if (next.track.knots[place] != (*knots)[chosen]) continue;
      ++chosen;
      set(place, true), set(place, false);
    }
  }
  if (bent == 0) return refused("the track is straight there");
  session.document = std::move(next);
  return {};
}

Status perform(Session& session, Change& change, const DropToGround& command) {
  const float to = static_cast<float>(
      change.clamp("height", command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m"));
  const sim::Land land(session.document.park);  // as people left it: the ground is cut to the knots themselves
  return each_knot(session, command.knots, [&](Knot& knot) {
    const auto surface = static_cast<float>(land.surface(double{knot.position.x}, double{knot.position.z}));
    knot.position.y = std::clamp(surface + to, -world::kMaxCoordinate, world::kMaxCoordinate);
    world::set_tangent(knot, {knot.tangent.x, 0, knot.tangent.z});  // a vertical tangent stays
  });
}

Status perform(Session& session, Change& change, const SetEquipment& command) {
  const world::Entity segment = entity_of(session, command.segment);
  const world::Equipment equipment = equipment_of(command.to, change);
  equip(session.document, change, {&segment, 1}, equipment, world::label_of(session.document, segment));
  return {};
}

Status perform(Session& session, Change& change, const RemoveEquipment& command) {
  const world::Entity segment = entity_of(session, command.segment);
  if (!session.document.entities.find<world::Equipment>(segment))
    return refused("there is no equipment on @" + world::label_of(session.document, segment));
  session.document.entities.pool<world::Equipment>().erase(segment);
  change.note = fmt::format("Removed the equipment of {}.", world::label_of(session.document, segment));
  return {};
}

Status perform(Session& session, Change& change, const SetTrain& command) {
  const world::Entity cart = entity_of(session, command.cart);
  world::Train& design = session.document.entities.get<world::Train>(cart);
  design.cars = change.clamp("cars", command.cars, 1, world::kMaxCars);
  if (command.spacing != 0)
    design.spacing = change.clamp("spacing", command.spacing, world::kMinSpacing, world::kMaxSpacing, "m");
  if (command.length != 0)
    design.length = change.clamp("length", command.length, world::kMinCarLength, world::kMaxCarLength, "m");
  if (command.mass != 0) design.mass = change.clamp("mass", command.mass, world::kMinCarMass, world::kMaxCarMass, "kg");
  return {};
}

Status perform(Session& session, Change& change, const SetLosses& command) {
  session.document.resistance.rolling = change.clamp("rolling friction", command.rolling, 0.0f, world::kMaxRolling);
  session.document.resistance.drag = change.clamp("drag", command.drag, 0.0f, world::kMaxDrag, "1/m");
  return {};
}

Status perform(Session& session, Change&, const SetLossSet& command) {
  session.document.resistance = base::row_of(command.to).losses;
  return {};
}

Status perform(Session& session, Change& change, const SetHeartline& command) {
  session.document.heartline = change.clamp("heartline", command.to, -world::kMaxHeartline, world::kMaxHeartline, "m");
  return {};
}

Status perform(Session& session, Change&, const SetRollbackFails& command) {
  session.document.rollback_fails = command.to;
  return {};
}

// Banking changes what riders feel, not the speeds of the ride, so one pass is enough.
Status perform(Session& session, Change& change, const AutoBank&) {
  const sim::SimulatedRide* const simulated = SessionFindings(session).ride();
  if (!simulated) return refused("banking needs a track with a train");
  const int turned = sim::bank_knots(session.document, session.derived, *simulated);
  change.respun = session.document.track.knots;
  change.note = fmt::format("Banked {} {}.", turned, turned == 1 ? "knot" : "knots");
  return {};
}

Status perform(Session& session, Change& change, const SetCurve& command) {
  if (session.document.curve == command.to) return {};
  if (command.keep == CurveSwitchKeeps::numbers) {
    session.document.curve = command.to;
    return {};
  }
  base::Result<sim::SwitchedCurve> switched = sim::switch_curve(session.document, session.derived, command.to);
  if (!switched) return switched.status();
  const world::Track& track = switched->document.track;
  if (const Status room = room_for(session, track.knots.size(), track.segments.size()); !room) return room;
  // Moving trains stay at their positions on the rails.
  for (world::TrainMotion& cart : session.motion.carts.items()) {
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
