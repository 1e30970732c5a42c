// Queries of joints, frames and the paper's errata.
#include <algorithm>
#include <array>

#include "base/portable_math.h"
#include "query/rows.h"
#include "sim/shape/frame_methods.h"
#include "sim/study/jolt.h"
#include "sim/study/live_errata.h"
#include "world/evaluation.h"

namespace coaster::query {
namespace {

// Returns the speed of the first train by name, m/s; nothing without one.
std::optional<double> present_speed(const edit::Session& session) {
  const world::CartMotion* const first = session.motion.carts.find(world::first_cart(session.document));
  return first ? std::optional(first->speed) : std::nullopt;
}

// --- joints
Answer joint_angle(const Context& c, View argument) {
  return at_joint(c, argument, [](const curve::Joint& joint) { return base::degrees(joint.angle); });
}
Answer g_step(const Context& c, View argument) {
  return at_joint(c, argument, [&](const curve::Joint& joint) {
    const auto speed = present_speed(c.session);
    return speed ? number(sim::g_step(joint.curvature_jump, *speed)) : none(kNoTrain);
  });
}
// Calls visit(knot, before, after) for each joint of the track, with the cubics that meet there.
template <class Visit>
void for_each_joint(const edit::Session& session, Visit visit) {
  const sim::Derived& derived = session.derived;
  const std::size_t count = derived.order.size();
  for (std::size_t i = derived.closed ? 0 : 1; i < count; ++i)
    visit(session.document.track.knots[i], derived.shape(derived.order[(i + count - 1) % count]).key.cubic,
          derived.shape(derived.order[i]).key.cubic);
}
Value label_or_none(const Context& c, world::Entity knot, View why) {
  return knot.valid() ? text(world::label_of(c.session.document, knot)) : none(why);
}
constexpr View kNoJoint = "there is no joint";

// An extreme of the joints and the knot where it is; no knot without one.
template <class Figure>
struct AtJoint {
  Figure figure{};
  world::Entity knot;
};

// Returns the largest jump of curvature, at the first joint if there is none.
AtJoint<double> roughest(const edit::Session& session) {
  AtJoint<double> found;
  for_each_joint(session, [&](world::Entity knot, const curve::Cubic& before, const curve::Cubic& after) {
    const double jump = glm::length(curve::curvature_vector(after, 0.0) - curve::curvature_vector(before, 1.0));
    if (!found.knot.valid() || jump > found.figure) found = {jump, knot};
  });
  return found;
}
Answer g_step_max(const Context& c, View) {
  const auto speed = present_speed(c.session);
  const AtJoint<double> found = roughest(c.session);
  if (!found.knot.valid()) return none(kNoJoint);
  return speed ? number(sim::g_step(found.figure, *speed)) : none(kNoTrain);
}
Answer roughest_joint(const Context& c, View) {
  const AtJoint<double> found = roughest(c.session);
  return found.figure > 0 ? text(world::label_of(c.session.document, found.knot)) : none("no joint has a jump");
}
// Return steps at the fastest passage of the ride; none where it does not pass.
Value passed(std::optional<double> value) { return value ? number(*value) : none("the ride does not pass there"); }
Answer ride_g_step(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::knot, [&](world::Entity e) {
    const world::Document& document = c.session.document;
    return passed(sim::fastest_step(document, c.find.jolts(), *world::index_of(document.track.knots, e)));
  });
}
Answer ride_g_step_max(const Context& c, View) { return passed(sim::largest_step(c.session.document, c.find.jolts())); }

// Returns the least continuity, at the first of several joints.
template <class Level>
AtJoint<Level> weakest(const edit::Session& session, Level curve::Joint::*member) {
  AtJoint<Level> found;
  for_each_joint(session, [&](world::Entity knot, const curve::Cubic& before, const curve::Cubic& after) {
    const Level level = curve::joint(before, after).*member;
    if (!found.knot.valid() || level < found.figure) found = {level, knot};
  });
  return found;
}
template <auto member>
Answer weakest_level(const Context& c, View) {
  const auto found = weakest(c.session, member);
  return found.knot.valid() ? value_of(found.figure) : none(kNoJoint);
}
template <auto member>
Answer weakest_knot(const Context& c, View) {
  return label_or_none(c, weakest(c.session, member).knot, kNoJoint);
}
Answer roll_max(const Context& c, View) {
  double most = 0;
  if (c.session.document.track.knots.empty()) return none("there is no knot");
  for (const world::Entity e : c.session.document.track.knots)
    most = std::max(most, std::abs(world::roll_deg(world::knot(c.session.document, e))));
  return number(most);
}
Answer joints_g2(const Context& c, View) {
  int smooth = 0;
  for_each_joint(c.session, [&](world::Entity, const curve::Cubic& before, const curve::Cubic& after) {
    smooth += curve::joint(before, after).geometric == curve::Geometric::g2;
  });
  return number(smooth);
}

// --- jolts
// Returns that value of the jolt at a knot; none without a ride or a joint.
template <double sim::Jolt::*axis>
Answer jolt(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::knot, [&](world::Entity e) {
    if (!joint_at(c.session.document, e)) return none(kOpenEnd);
    if (c.find.ride() == nullptr) return none(kNoRide);
    const std::span<const sim::Jolt> jolts = c.find.jolts();
    const auto index = world::index_of(c.session.document.track.knots, e);
    return index && *index < jolts.size() ? number(jolts[*index].*axis) : none("the ride does not pass it");
  });
}
Answer jolt_knot(const Context& c, View) {
  AtJoint<double> worst;
  const std::span<const sim::Jolt> jolts = c.find.jolts();
  for (std::size_t i = 0; i < jolts.size(); ++i)
    if (jolts[i].total > worst.figure) worst = {jolts[i].total, c.session.document.track.knots[i]};
  return label_or_none(c, worst.knot, "there is no jolt");
}

// --- the selected position
struct Place {
  const sim::SegmentShape* shape;
  double t;
};
// Returns a segment's picked position; for a knot the start of the segment behind it, or at the track's end the end of
// the last segment; for a train its present position.
std::optional<Place> selected_place(const edit::Session& session) {
  const world::Entity e = session.settings.selected;
  const sim::Derived& derived = session.derived;
  if (const sim::SegmentShape* const shape = derived.segments.find(e)) return Place{shape, session.settings.selected_t};
  if (session.document.entities.find<world::Knot>(e)) {
    const world::Neighbours at = world::neighbours(session.document, e);
    if (const sim::SegmentShape* const shape = derived.segments.find(at.after)) return Place{shape, 0.0};
    if (const sim::SegmentShape* const shape = derived.segments.find(at.before)) return Place{shape, 1.0};
    return std::nullopt;
  }
  const world::CartMotion* const cart = session.motion.carts.find(e);
  const sim::SegmentShape* const shape = cart ? derived.segments.find(cart->segment) : nullptr;
  return shape ? std::optional(Place{shape, shape->arc.parameter(cart->s)}) : std::nullopt;
}
std::optional<curve::FrenetFrame> frenet_there(const edit::Session& session) {
  const auto place = selected_place(session);
  return place ? curve::frenet(place->shape->key.cubic, place->t) : std::nullopt;
}
Answer curvature(const Context& c, View) {
  const auto place = selected_place(c.session);
  if (!place) return none(kNothingSelected);
  const auto found = curve::curvature_if_any(place->shape->key.cubic, place->t);
  return found ? number(*found) : none("the curve has a cusp there");
}
Answer torsion(const Context& c, View) {
  const auto frame = frenet_there(c.session);
  if (!frame) return none(selected_place(c.session) ? "Frenet-Serret is undefined there" : kNothingSelected);
  return number(frame->torsion);
}
Answer frenet(const Context& c, View) { return yes_no(frenet_there(c.session).has_value()); }

// --- frames along the track
Answer loop_twist(const Context& c, View) {
  const sim::Derived& derived = c.session.derived;
  if (!derived.closed) return none("the track is open");
  return sim::has_cusp(derived) ? none("the track has a cusp") : number(base::degrees(sim::loop_twist(derived)));
}
Answer frenet_flips(const Context& c, View) { return number(sim::frenet_breaks(c.session.derived).size()); }
Answer cart_up(const Context& c, View) {
  const auto& carts = c.session.motion.carts;
  if (carts.size() == 0 || c.session.derived.order.empty()) return none(kNoTrain);
  const world::CartMotion* cart = carts.find(c.session.settings.selected);
  return Value(sim::pose(c.session.derived, cart ? *cart : carts.items()[0], c.session.settings.frames).frame.up);
}

// --- errata
// Those of the selected segment, else of the first one.
Answer of_erratum(const Context& c, View name, double sim::Erratum::*number_of) {
  const sim::Derived& derived = c.session.derived;
  if (derived.order.empty()) return none(kNoSegment);
  const auto speed = present_speed(c.session);
  if (!speed && name == "g_step") return none(kNoTrain);
  const world::Entity selected = c.session.settings.selected,
                      segment = derived.segments.find(selected) ? selected : derived.order.front();
  const auto found = sim::erratum(derived, segment, speed.value_or(0), c.session.settings.evaluation->steps, name);
  return number((*found).*number_of);
}
Answer erratum(const Context& c, View name) { return of_erratum(c, name, &sim::Erratum::right); }
Answer erratum_wrong(const Context& c, View name) { return of_erratum(c, name, &sim::Erratum::wrong); }

constexpr ArgumentPart kErratum[]{
    {.words = [] { return std::vector<std::string>(sim::kErrata.begin(), sim::kErrata.end()); }}};

constexpr std::array kJointRows{
    Query{"joint_angle", kKnot, "deg", "Angle between the tangents of the segments at a knot.", joint_angle, or_none()},
    Query{"curvature_before", kKnot, "1/m",
          "Curvature vector at the end of the segment before a knot, towards the centre.",
          of_joint<&curve::Joint::curvature_before>, or_none(kVector)},
    Query{"curvature_after", kKnot, "1/m",
          "Curvature vector at the start of the segment after a knot, towards the centre.",
          of_joint<&curve::Joint::curvature_after>, or_none(kVector)},
    Query{"second_jump", kKnot, "m", "Length of C''(0) - B''(1) at a knot; 0 for C2.",
          of_joint<&curve::Joint::second_jump>, or_none()},
    Query{"g_step", kKnot, "g", "Jump of the force at a knot, v^2 |dK| / g, at the present speed of the first train.",
          g_step, or_none()},
    Query{"g_step_max", kNoArgument, "g", "The largest such jump of the track.", g_step_max, or_none()},
    Query{"ride.g_step", kKnot, "g",
          "The same at the fastest passage of the whole ride, of all cars; none where it does not pass.", ride_g_step,
          or_none()},
    Query{"ride.g_step_max", kNoArgument, "g", "The largest such jump of the whole ride; none without a passage.",
          ride_g_step_max, or_none()},
    Query{"roughest_joint", kNoArgument, "", "The knot with the largest jump of curvature; none if there is no jump.",
          roughest_joint, or_none(kText)},
    Query{
        "jolt", kKnot, "g",
        "Largest difference of low-passed felt g that the jumps at a knot make in the whole ride, of all cars and the "
        "three axes together.",
        jolt<&sim::Jolt::total>, or_none()},
    Query{"jolt.vertical", kKnot, "g", "The same of vertical g alone.", jolt<&sim::Jolt::up>, or_none()},
    Query{"jolt.lateral", kKnot, "g", "The same of lateral g alone.", jolt<&sim::Jolt::left>, or_none()},
    Query{"jolt.longitudinal", kKnot, "g", "The same of longitudinal g alone.", jolt<&sim::Jolt::forward>, or_none()},
    Query{"ride.jolt_knot", kNoArgument, "", "The knot with the largest jolt; none without a jolt.", jolt_knot,
          or_none(kText)},
    Query{"geometric_min", kNoArgument, "",
          "Lowest geometric continuity of all joints: G0 < G1 < G2; none without a joint.",
          weakest_level<&curve::Joint::geometric>, or_none(kRankOf<curve::Geometric>)},
    Query{"parametric_min", kNoArgument, "",
          "Lowest parametric continuity of all joints: C0 < C1 < C2; none without a joint.",
          weakest_level<&curve::Joint::parametric>, or_none(kRankOf<curve::Parametric>)},
    Query{"weakest_geometric", kNoArgument, "", "The first knot with that geometric continuity; none without a joint.",
          weakest_knot<&curve::Joint::geometric>, or_none(kText)},
    Query{"weakest_parametric", kNoArgument, "",
          "The first knot with that parametric continuity; none without a joint.",
          weakest_knot<&curve::Joint::parametric>, or_none(kText)},
    Query{"roll_max", kNoArgument, "deg", "Largest roll of a knot, to either side.", roll_max, or_none()},
    Query{"joints_g2", kNoArgument, "", "Number of joints that are G2.", joints_g2},
    Query{"curvature", kNoArgument, "1/m",
          "Curvature at the selected position, on a segment, at a knot or a train; none at a cusp, where it is "
          "unbounded.",
          curvature, of_view(or_none())},
    Query{"torsion", kNoArgument, "1/m", "Torsion at the selected position; none where Frenet-Serret is undefined.",
          torsion, of_view(or_none())},
    Query{"frenet", kNoArgument, "", "on if the Frenet-Serret frame is defined at the selected position.", frenet,
          of_view(kSwitch)},
    Query{"frenet_flips", kNoArgument, "",
          "Number of places where the Frenet-Serret normal is undefined or flips: by over 90 degrees at a joint or "
          "within "
          "1/32 of a segment around an inflection or a place close to one.",
          frenet_flips, of_view()},
    Query{
        "loop_twist", kNoArgument, "deg",
        "Remaining twist of the rotation-minimising frame on a closed track, which is spread over it; none on an open "
        "one, and with a cusp.",
        loop_twist, or_none()},
    Query{"cart_up", kNoArgument, "",
          "Up of the selected train, else the first, by the chosen frame method; a unit vector.", cart_up,
          of_view(or_none(kVector))},
    Query{"erratum", kErratum, "",
          "Correct value of an erratum: gravesen (m), line (m), frozen (m), g_step (g), frenet_flip (deg), pen (m).",
          erratum, or_none()},
    Query{"erratum_wrong", kErratum, "", "Claimed value of an erratum: gravesen in m^2, the others in the same unit.",
          erratum_wrong, or_none()},
};

}  // namespace

std::span<const Query> joint_rows() { return kJointRows; }

}  // namespace coaster::query
