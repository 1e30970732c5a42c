// Queries of the track: its knots, joints, frames and segments, the evaluation of the curve, and the paper's errata.
#include <algorithm>
#include <cmath>
#include <functional>

#include "base/hash.h"
#include "base/portable_math.h"
#include "query/rows.h"
#include "sim/shape/folds.h"
#include "sim/shape/frame_methods.h"
#include "sim/solids/conflict_types.h"
#include "sim/study/jolt.h"
#include "sim/study/track_errata.h"
#include "world/evaluation_settings.h"

namespace coaster::query {
namespace {

// --- the whole track

Answer longest(const QueryContext& c, View) {
  const sim::DerivedTrack& derived = c.session.derived;
  world::Entity found;
  double most = -1;
  for (const world::Entity e : derived.order)
    if (const double one = derived.shape(e).arc.length(); one > most) most = one, found = e;
  return found.valid() ? text(world::label_of(c.session.document, found)) : none(kNoSegment);
}

// --- conflicts
const sim::Conflict* worst_conflict(const QueryContext& c) {
  const auto found = c.find.conflicts();
  const auto worst =
      std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.missing < b.missing; });
  return worst == found.end() ? nullptr : &*worst;
}
Answer conflict_missing(const QueryContext& c, View) {
  const sim::Conflict* const worst = worst_conflict(c);
  return number(worst ? worst->missing : 0.0);
}
template <double sim::Conflict::*distance>
Answer conflict_place(const QueryContext& c, View) {
  const sim::Conflict* const worst = worst_conflict(c);
  return worst ? number(worst->*distance) : none("there is no conflict");
}

Answer flooded_depth(const QueryContext& c, View) {
  double deepest = 0;
  for (const sim::FloodedTrack& stretch : c.find.flooded()) deepest = std::max(deepest, stretch.depth);
  return number(deepest);
}

// --- folds
Answer tight_bend_at(const QueryContext& c, View) {
  const auto found = c.find.tight_bends();
  return found.empty() ? none("there is no tight bend") : number(sim::tightest(found).at);
}
Answer least_radius(const QueryContext& c, View) {
  const double least = sim::least_radius(c.session.derived);
  return std::isfinite(least) ? number(least)
                              : none(c.session.derived.order.empty() ? kNoSegment : "the track is straight");
}
template <double sim::Fold::*value>
Answer first_fold(const QueryContext& c, View) {
  const auto found = c.find.folds();
  return found.empty() ? none("there is no fold") : number(found.front().*value);
}

Answer hash(const QueryContext& c, View argument) {
  if (argument == "document") return text(base::hex16(world::hash(c.session.document)));
  return text(base::hex16(world::hash(c.session.document, c.session.motion)));
}

// --- fit of an imported track
Answer open_end_distance(const QueryContext& c, View) {
  const world::Track& track = c.session.document.track;
  if (track.closed) return number(0.0);
  if (track.knots.size() < 2) return none("fewer than two knots");
  const auto place = [&](world::Entity e) { return glm::dvec3(world::knot(c.session.document, e).position); };
  return number(glm::distance(place(track.knots.front()), place(track.knots.back())));
}

template <auto member>
Answer of_import(const QueryContext& c, View) {
  return c.session.file.import ? value_at(*c.session.file.import, member) : none("the track was not imported");
}
Answer import_knots(const QueryContext& c, View) {
  return number(c.session.file.import ? c.session.file.import->knots : 0);
}

// --- knots
double spin_deg(const world::Knot& knot) { return base::degrees(double{knot.spin}); }

// --- segments
template <auto step>
Answer of_shape(const QueryContext& c, View argument) {
  return of_entity(c, argument, world::EntityKind::segment,
                   [&](world::Entity e) { return value_at(c.session.derived.shape(e), step); });
}
Value twist(const sim::SegmentShape& shape) {
  return sim::has_cusp(shape) ? none("the segment has a cusp") : number(base::degrees(shape.roll.twist));
}

constexpr ArgumentPart kHashed[]{{.words = [] { return std::vector<std::string>{"document", "motion"}; }}};

constexpr Query kDocumentRows[]{
    {"knots", "", "Number of knots.", of_document<&world::Document::track, &world::Track::knots>},
    {"segments", "", "Number of segments.", of_document<&world::Document::track, &world::Track::segments>},
    {"closed", "", "on if the track is closed.", of_document<&world::Document::track, &world::Track::closed>, kSwitch},
    {"length", "m", "Length of the track by the chosen arc-length method.",
     of_session<&edit::Session::derived, &sim::DerivedTrack::measured_length>, of_view()},
    {"exact_length", "m", "Length of the track by adaptive Gauss-Legendre.",
     of_session<&edit::Session::derived, &sim::DerivedTrack::length>},
    {"name", "", "The track's name.", of_document<&world::Document::name>, kText},
    {"start_speed", "m/s", "Start speed of trains.", of_document<&world::Document::start_speed>},
    {"open_end.distance", "m",
     "Distance of the last knot from the first one in space; 0 on a closed track, none below two knots.",
     open_end_distance, or_none()},
    {"datum", "m", "Height at which potential energy is zero.", of_document<&world::Document::datum>},
    {"longest", "", "The longest segment; none without one.", longest, of_view(or_none(kText))},
    {"conflicts", "",
     "Places where the track lacks clearance from itself: a train would be too close beside, below or above "
     "other track.",
     of_findings<&edit::SessionFindings::conflicts>},
    {"conflict.missing", "m", "Clearance missing at the worst conflict; 0 if there is none.", conflict_missing},
    {"conflict.at", "m", "Distance of the worst conflict along the track; none if there is none.",
     conflict_place<&sim::Conflict::at>, or_none()},
    {"conflict.other", "m", "Distance of its other stretch along the track; none if there is none.",
     conflict_place<&sim::Conflict::other>, or_none()},
    {"flooded", "", "Stretches of track under the water of a land, outside tunnels.",
     of_findings<&edit::SessionFindings::flooded>},
    {"flooded.depth", "m", "Largest depth of track under water; 0 if there is none.", flooded_depth},
    {"folds", "", "Places where the rails fold: the curve's radius is below the rails' distance from it.",
     of_findings<&edit::SessionFindings::folds>},
    {"fold.at", "m", "Distance of the first fold along the track; none if there is none.", first_fold<&sim::Fold::at>,
     or_none()},
    {"fold.radius", "m", "The curve's radius there; none if there is none.", first_fold<&sim::Fold::radius>, or_none()},
    {"tight_bends", "",
     "Places where the curve bends with a radius below 0.5 m or reverses its direction: no train can pass.",
     of_findings<&edit::SessionFindings::tight_bends>},
    {"tight_bend.at", "m", "Distance of the tightest one along the track; none if there is none.", tight_bend_at,
     or_none()},
    {"least_radius", "m",
     "Least radius of the curve, found exactly: 0 where it reverses its direction, none for a straight track.",
     least_radius, or_none()},
    {"hash", kHashed, "", "Hash of the document or of the motion, 16 hexadecimal digits.", hash, of_view(kText)},
    {"position", kKnot, "m", "A knot's position.", of_knot<&world::Knot::position>, kVector},
    {"tangent", kKnot, "", "A knot's direction of travel, a unit vector.", of_knot<&world::Knot::tangent>, kVector},
    {"up", kKnot, "", "Direction of riders' heads at a knot, a unit vector.", of_knot<&world::Knot::up>, kVector},
    {"roll", kKnot, "deg", "A knot's roll from the horizon, positive to the rider's right.", of_knot<world::roll_deg>},
    {"spin", kKnot, "deg/m",
     "A knot's spin: the rate of roll along the track there, against the rotation-minimising frame.",
     of_knot<spin_deg>},
    {"spin_kind", kKnot, "", "Where a knot's spin comes from: automatic or set.", of_knot<&world::Knot::spin_kind>,
     kOneOf<world::SpinKind>},
    {"in_length", kKnot, "m", "Length of a knot's incoming handle.", of_knot<&world::Knot::in_length>},
    {"out_length", kKnot, "m", "Length of a knot's outgoing handle.", of_knot<&world::Knot::out_length>},
    {"joint", kKnot, "", "A knot's kind of joint: smooth, aligned or automatic.", of_knot<&world::Knot::joint>,
     kOneOf<world::JointKind>},
    {"geometric", kKnot, "", "Geometric continuity: G0 < G1 < G2; none at the end of an open track.",
     of_joint<&curve::JointContinuity::geometric>, or_none(kRankOf<curve::GeometricContinuity>)},
    {"parametric", kKnot, "", "Parametric continuity: C0 < C1 < C2; none at the end of an open track.",
     of_joint<&curve::JointContinuity::parametric>, or_none(kRankOf<curve::ParametricContinuity>)},
    {"gap", kKnot, "m", "Distance between the ends of the segments at a knot; none at the end of an open track.",
     of_joint<&curve::JointContinuity::gap>, or_none()},
    {"speed_ratio", kKnot, "", "|C'(0)| / |B'(1)| of the segments at a knot; none at the end of an open track.",
     of_joint<&curve::JointContinuity::speed_ratio>, or_none()},
    {"curvature_jump", kKnot, "1/m",
     "Length of the difference of the curvature vectors at a knot; none at the end of an open track.",
     of_joint<&curve::JointContinuity::curvature_jump>, or_none()},
    {"turns", kSegment, "", "Whole turns of roll within a segment.", of_segment<&world::Segment::turns>},
    {"segment_length", kSegment, "m", "A segment's length by the chosen arc-length method.",
     of_shape<&sim::SegmentShape::measured_length>, of_view()},
    {"twist", kSegment, "deg", "Roll over a segment, relative to its rotation-minimising frame; none over a cusp.",
     of_shape<twist>, or_none()},
    {"import.max_error", "m",
     "Largest distance of an imported file's rows from the fitted track; none without an import.",
     of_import<&exchange::ImportReport::max_error>, or_none()},
    {"import.frame_error", "deg",
     "Largest angle between a row's frame and the fitted track's, except within 0.5 m of a jump between rows; none "
     "without an import.",
     of_import<&exchange::ImportReport::frame_error>, or_none()},
    {"import.rms_error", "m", "Root mean square of the distances of import.max_error.",
     of_import<&exchange::ImportReport::rms_error>, or_none()},
    {"import.rms_frame_error", "deg", "Root mean square of the angles of import.frame_error.",
     of_import<&exchange::ImportReport::rms_frame_error>, or_none()},
    {"import.jump_error", "deg", "As import.frame_error, within 0.5 m of where rows jump; 0 without a jump.",
     of_import<&exchange::ImportReport::jump_error>, or_none()},
    {"import.knots", "", "Number of knots of the fitted track; 0 without an import.", import_knots},
    {"vertices", "", "Number of vertices of all polylines.",
     of_session<&edit::Session::derived, &sim::DerivedTrack::vertices>, of_view()},
};

// Returns the speed of the first train by name, m/s; nothing without one.
std::optional<double> present_speed(const edit::Session& session) {
  const world::TrainMotion* const first = session.motion.carts.find(world::first_cart(session.document));
  return first ? std::optional(first->speed) : std::nullopt;
}

// --- joints
Answer joint_angle(const QueryContext& c, View argument) {
  return at_joint(c, argument, [](const curve::JointContinuity& joint) { return base::degrees(joint.angle); });
}
Answer g_step(const QueryContext& c, View argument) {
  return at_joint(c, argument, [&](const curve::JointContinuity& joint) {
    const auto speed = present_speed(c.session);
    return speed ? number(sim::g_step(joint.curvature_jump, *speed)) : none(kNoTrain);
  });
}
// Calls visit(knot, before, after) for each joint of the track, with the cubics that meet there.
template <class Visit>
void for_each_joint(const edit::Session& session, Visit visit) {
  const sim::DerivedTrack& derived = session.derived;
  const std::size_t count = derived.order.size();
  for (std::size_t i = derived.closed ? 0 : 1; i < count; ++i)
    visit(session.document.track.knots[i], derived.shape(derived.order[(i + count - 1) % count]).key.cubic,
          derived.shape(derived.order[i]).key.cubic);
}
Value label_or_none(const QueryContext& c, world::Entity knot, View why) {
  return knot.valid() ? text(world::label_of(c.session.document, knot)) : none(why);
}
constexpr View kNoJoint = "there is no joint";

// An extreme of the joints and the knot where it is; no knot without one.
template <class ReportRow>
struct JointExtreme {
  ReportRow figure{};
  world::Entity knot;
};

// Returns the largest jump of curvature, at the first joint if there is none.
JointExtreme<double> roughest(const edit::Session& session) {
  JointExtreme<double> found;
  for_each_joint(session, [&](world::Entity knot, const curve::Cubic& before, const curve::Cubic& after) {
    const double jump = glm::length(curve::curvature_vector(after, 0.0) - curve::curvature_vector(before, 1.0));
    if (!found.knot.valid() || jump > found.figure) found = {jump, knot};
  });
  return found;
}
Answer g_step_max(const QueryContext& c, View) {
  const auto speed = present_speed(c.session);
  const JointExtreme<double> found = roughest(c.session);
  if (!found.knot.valid()) return none(kNoJoint);
  return speed ? number(sim::g_step(found.figure, *speed)) : none(kNoTrain);
}
Answer roughest_joint(const QueryContext& c, View) {
  const JointExtreme<double> found = roughest(c.session);
  return found.figure > 0 ? text(world::label_of(c.session.document, found.knot)) : none("no joint has a jump");
}
// Return steps at the fastest passage of the ride; none where it does not pass.
Value passed(std::optional<double> value) { return value ? number(*value) : none("the ride does not pass there"); }
Answer ride_g_step(const QueryContext& c, View argument) {
  return of_entity(c, argument, world::EntityKind::knot, [&](world::Entity e) {
    const world::Document& document = c.session.document;
    return passed(sim::fastest_step(document, c.find.jolts(), *world::index_of(document.track.knots, e)));
  });
}
Answer ride_g_step_max(const QueryContext& c, View) {
  return passed(sim::largest_step(c.session.document, c.find.jolts()));
}

// Returns the least continuity, at the first of several joints.
template <class Level>
JointExtreme<Level> weakest(const edit::Session& session, Level curve::JointContinuity::*member) {
  JointExtreme<Level> found;
  for_each_joint(session, [&](world::Entity knot, const curve::Cubic& before, const curve::Cubic& after) {
    const Level level = curve::joint(before, after).*member;
    if (!found.knot.valid() || level < found.figure) found = {level, knot};
  });
  return found;
}
template <auto member>
Answer weakest_level(const QueryContext& c, View) {
  const auto found = weakest(c.session, member);
  return found.knot.valid() ? value_of(found.figure) : none(kNoJoint);
}
template <auto member>
Answer weakest_knot(const QueryContext& c, View) {
  return label_or_none(c, weakest(c.session, member).knot, kNoJoint);
}
Answer roll_max(const QueryContext& c, View) {
  double most = 0;
  if (c.session.document.track.knots.empty()) return none("there is no knot");
  for (const world::Entity e : c.session.document.track.knots)
    most = std::max(most, std::abs(world::roll_deg(world::knot(c.session.document, e))));
  return number(most);
}
Answer joints_g2(const QueryContext& c, View) {
  int smooth = 0;
  for_each_joint(c.session, [&](world::Entity, const curve::Cubic& before, const curve::Cubic& after) {
    smooth += curve::joint(before, after).geometric == curve::GeometricContinuity::g2;
  });
  return number(smooth);
}

// --- jolts
// Returns that value of the jolt at a knot; none without a ride or a joint.
template <double sim::Jolt::*axis>
Answer jolt(const QueryContext& c, View argument) {
  return of_entity(c, argument, world::EntityKind::knot, [&](world::Entity e) {
    if (!joint_at(c.session.document, e)) return none(kOpenEnd);
    if (c.find.ride() == nullptr) return none(kNoRide);
    const std::span<const sim::Jolt> jolts = c.find.jolts();
    const auto index = world::index_of(c.session.document.track.knots, e);
    return index && *index < jolts.size() ? number(jolts[*index].*axis) : none("the ride does not pass it");
  });
}
Answer jolt_knot(const QueryContext& c, View) {
  JointExtreme<double> worst;
  const std::span<const sim::Jolt> jolts = c.find.jolts();
  for (std::size_t i = 0; i < jolts.size(); ++i)
    if (jolts[i].total > worst.figure) worst = {jolts[i].total, c.session.document.track.knots[i]};
  return label_or_none(c, worst.knot, "there is no jolt");
}

// --- the selected position
struct SelectedPosition {
  const sim::SegmentShape* shape;
  double t;
};
// Returns a segment's picked position; for a knot the start of the segment behind it, or at the track's end the end of
// the last segment; for a train its present position.
std::optional<SelectedPosition> selected_place(const edit::Session& session) {
  const world::Entity e = session.settings.selected;
  const sim::DerivedTrack& derived = session.derived;
  if (const sim::SegmentShape* const shape = derived.segments.find(e))
    return SelectedPosition{shape, session.settings.selected_t};
  if (session.document.entities.find<world::Knot>(e)) {
    const world::KnotSegments at = world::neighbours(session.document, e);
    if (const sim::SegmentShape* const shape = derived.segments.find(at.after)) return SelectedPosition{shape, 0.0};
    if (const sim::SegmentShape* const shape = derived.segments.find(at.before)) return SelectedPosition{shape, 1.0};
    return std::nullopt;
  }
  const world::TrainMotion* const cart = session.motion.carts.find(e);
  const sim::SegmentShape* const shape = cart ? derived.segments.find(cart->segment) : nullptr;
  return shape ? std::optional(SelectedPosition{shape, shape->arc.parameter(cart->s)}) : std::nullopt;
}
std::optional<curve::FrenetFrame> frenet_there(const edit::Session& session) {
  const auto place = selected_place(session);
  return place ? curve::frenet(place->shape->key.cubic, place->t) : std::nullopt;
}
Answer curvature(const QueryContext& c, View) {
  const auto place = selected_place(c.session);
  if (!place) return none(kNothingSelected);
  const auto found = curve::curvature_if_any(place->shape->key.cubic, place->t);
  return found ? number(*found) : none("the curve has a cusp there");
}
Answer torsion(const QueryContext& c, View) {
  const auto frame = frenet_there(c.session);
  if (!frame) return none(selected_place(c.session) ? "Frenet-Serret is undefined there" : kNothingSelected);
  return number(frame->torsion);
}
Answer frenet(const QueryContext& c, View) { return yes_no(frenet_there(c.session).has_value()); }

// --- frames along the track
Answer loop_twist(const QueryContext& c, View) {
  const sim::DerivedTrack& derived = c.session.derived;
  if (!derived.closed) return none("the track is open");
  return sim::has_cusp(derived) ? none("the track has a cusp") : number(base::degrees(sim::loop_twist(derived)));
}
Answer frenet_flips(const QueryContext& c, View) { return number(sim::frenet_breaks(c.session.derived).size()); }
Answer cart_up(const QueryContext& c, View) {
  const auto& carts = c.session.motion.carts;
  if (carts.size() == 0 || c.session.derived.order.empty()) return none(kNoTrain);
  const world::TrainMotion* cart = carts.find(c.session.settings.selected);
  return Value(sim::pose(c.session.derived, cart ? *cart : carts.items()[0], c.session.settings.frames).frame.up);
}

// --- errata
// Those of the selected segment, else of the first one.
Answer of_erratum(const QueryContext& c, View name, double sim::Erratum::*number_of) {
  const sim::DerivedTrack& derived = c.session.derived;
  if (derived.order.empty()) return none(kNoSegment);
  const auto speed = present_speed(c.session);
  if (!speed && name == "g_step") return none(kNoTrain);
  const world::Entity selected = c.session.settings.selected,
                      segment = derived.segments.find(selected) ? selected : derived.order.front();
  const auto found = sim::erratum(derived, segment, speed.value_or(0), c.session.settings.evaluation->steps, name);
  return number((*found).*number_of);
}
Answer erratum(const QueryContext& c, View name) { return of_erratum(c, name, &sim::Erratum::right); }
Answer erratum_wrong(const QueryContext& c, View name) { return of_erratum(c, name, &sim::Erratum::wrong); }

constexpr ArgumentPart kErratum[]{
    {.words = [] { return std::vector<std::string>(sim::kErrata.begin(), sim::kErrata.end()); }}};

constexpr Query kJointRows[]{
    {"joint_angle", kKnot, "deg", "Angle between the tangents of the segments at a knot.", joint_angle, or_none()},
    {"curvature_before", kKnot, "1/m", "Curvature vector at the end of the segment before a knot, towards the centre.",
     of_joint<&curve::JointContinuity::curvature_before>, or_none(kVector)},
    {"curvature_after", kKnot, "1/m", "Curvature vector at the start of the segment after a knot, towards the centre.",
     of_joint<&curve::JointContinuity::curvature_after>, or_none(kVector)},
    {"second_jump", kKnot, "m", "Length of C''(0) - B''(1) at a knot; 0 for C2.",
     of_joint<&curve::JointContinuity::second_jump>, or_none()},
    {"g_step", kKnot, "g", "Jump of the force at a knot, v^2 |dK| / g, at the present speed of the first train.",
     g_step, or_none()},
    {"g_step_max", "g", "The largest such jump of the track.", g_step_max, or_none()},
    {"ride.g_step", kKnot, "g",
     "The same at the fastest passage of the whole ride, of all cars; none where it does not pass.", ride_g_step,
     or_none()},
    {"ride.g_step_max", "g", "The largest such jump of the whole ride; none without a passage.", ride_g_step_max,
     or_none()},
    {"roughest_joint", "", "The knot with the largest jump of curvature; none if there is no jump.", roughest_joint,
     or_none(kText)},
    {"jolt", kKnot, "g",
     "Largest difference of low-passed felt g that the jumps at a knot make in the whole ride, of all cars and the "
     "three axes together.",
     jolt<&sim::Jolt::total>, or_none()},
    {"jolt.vertical", kKnot, "g", "The same of vertical g alone.", jolt<&sim::Jolt::up>, or_none()},
    {"jolt.lateral", kKnot, "g", "The same of lateral g alone.", jolt<&sim::Jolt::left>, or_none()},
    {"jolt.longitudinal", kKnot, "g", "The same of longitudinal g alone.", jolt<&sim::Jolt::forward>, or_none()},
    {"ride.jolt_knot", "", "The knot with the largest jolt; none without a jolt.", jolt_knot, or_none(kText)},
    {"geometric_min", "", "Lowest geometric continuity of all joints: G0 < G1 < G2; none without a joint.",
     weakest_level<&curve::JointContinuity::geometric>, or_none(kRankOf<curve::GeometricContinuity>)},
    {"parametric_min", "", "Lowest parametric continuity of all joints: C0 < C1 < C2; none without a joint.",
     weakest_level<&curve::JointContinuity::parametric>, or_none(kRankOf<curve::ParametricContinuity>)},
    {"weakest_geometric", "", "The first knot with that geometric continuity; none without a joint.",
     weakest_knot<&curve::JointContinuity::geometric>, or_none(kText)},
    {"weakest_parametric", "", "The first knot with that parametric continuity; none without a joint.",
     weakest_knot<&curve::JointContinuity::parametric>, or_none(kText)},
    {"roll_max", "deg", "Largest roll of a knot, to either side.", roll_max, or_none()},
    {"joints_g2", "", "Number of joints that are G2.", joints_g2},
    {"curvature", "1/m",
     "Curvature at the selected position, on a segment, at a knot or a train; none at a cusp, where it is "
     "unbounded.",
     curvature, of_view(or_none())},
    {"torsion", "1/m", "Torsion at the selected position; none where Frenet-Serret is undefined.", torsion,
     of_view(or_none())},
    {"frenet", "", "on if the Frenet-Serret frame is defined at the selected position.", frenet, of_view(kSwitch)},
    {"frenet_flips", "",
     "Number of places where the Frenet-Serret normal is undefined or flips: by over 90 degrees at a joint or "
     "within "
     "1/32 of a segment around an inflection or a place close to one.",
     frenet_flips, of_view()},
    {"loop_twist", "deg",
     "Remaining twist of the rotation-minimising frame on a closed track, which is spread over it; none on an open "
     "one, and with a cusp.",
     loop_twist, or_none()},
    {"cart_up", "", "Up of the selected train, else the first, by the chosen frame method; a unit vector.", cart_up,
     of_view(or_none(kVector))},
    {"erratum", kErratum, "",
     "Correct value of an erratum: gravesen (m), line (m), frozen (m), g_step (g), frenet_flip (deg), pen (m).",
     erratum, or_none()},
    {"erratum_wrong", kErratum, "", "Claimed value of an erratum: gravesen in m^2, the others in the same unit.",
     erratum_wrong, or_none()},
};

}  // namespace

std::span<const Query> document_rows() { return kDocumentRows; }
std::span<const Query> joint_rows() { return kJointRows; }

}  // namespace coaster::query
