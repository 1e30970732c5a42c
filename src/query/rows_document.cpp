// Queries of the track: its knots, joints and segments, and the evaluation of the curve.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/hash.h"
#include "base/portable_math.h"
#include "query/rows.h"
#include "sim/shape/folds.h"
#include "sim/solids/conflict.h"

namespace coaster::query {
namespace {

// --- the whole track
Answer knots(const Context& c, View) { return number(c.session.document.track.knots.size()); }
Answer segments(const Context& c, View) { return number(c.session.document.track.segments.size()); }
Answer length(const Context& c, View) { return number(c.session.derived.measured_length); }
Answer exact_length(const Context& c, View) { return number(c.session.derived.length); }

Answer longest(const Context& c, View) {
  const sim::Derived& derived = c.session.derived;
  world::Entity found;
  double most = -1;
  for (const world::Entity e : derived.order)
    if (const double one = derived.shape(e).arc.length(); one > most) most = one, found = e;
  return found.valid() ? text(world::label_of(c.session.document, found)) : none(kNoSegment);
}

// --- conflicts
const sim::Conflict* worst_conflict(const Context& c) {
  const auto found = c.find.conflicts();
  const auto worst =
      std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.missing < b.missing; });
  return worst == found.end() ? nullptr : &*worst;
}
Answer conflicts(const Context& c, View) { return number(c.find.conflicts().size()); }
Answer conflict_missing(const Context& c, View) {
  const sim::Conflict* const worst = worst_conflict(c);
  return number(worst ? worst->missing : 0.0);
}
template <double sim::Conflict::*distance>
Answer conflict_place(const Context& c, View) {
  const sim::Conflict* const worst = worst_conflict(c);
  return worst ? number(worst->*distance) : none("there is no conflict");
}

// --- folds
Answer folds(const Context& c, View) { return number(c.find.folds().size()); }
Answer tight_bends(const Context& c, View) { return number(c.find.tight_bends().size()); }
Answer tight_bend_at(const Context& c, View) {
  const auto found = c.find.tight_bends();
  return found.empty() ? none("there is no tight bend") : number(sim::tightest(found).at);
}
Answer least_radius(const Context& c, View) {
  const double least = sim::least_radius(c.session.derived);
  return std::isfinite(least) ? number(least)
                              : none(c.session.derived.order.empty() ? kNoSegment : "the track is straight");
}
template <double sim::Fold::*value>
Answer first_fold(const Context& c, View) {
  const auto found = c.find.folds();
  return found.empty() ? none("there is no fold") : number(found.front().*value);
}

Answer hash(const Context& c, View argument) {
  if (argument == "document") return text(base::hex16(world::hash(c.session.document)));
  return text(base::hex16(world::hash(c.session.document, c.session.motion)));
}

// --- fit of an imported track
Answer open_end_distance(const Context& c, View) {
  const world::Track& track = c.session.document.track;
  if (track.closed) return number(0.0);
  if (track.knots.size() < 2) return none("fewer than two knots");
  const auto place = [&](world::Entity e) { return glm::dvec3(world::knot(c.session.document, e).position); };
  return number(glm::distance(place(track.knots.front()), place(track.knots.back())));
}

template <auto member>
Answer of_import(const Context& c, View) {
  return c.session.file.import ? number((*c.session.file.import).*member) : none("the track was not imported");
}
Answer import_knots(const Context& c, View) { return number(c.session.file.import ? c.session.file.import->knots : 0); }

// --- knots
template <auto member>
Answer of_knot(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::knot,
                   [&](world::Entity e) { return world::knot(c.session.document, e).*member; });
}
Answer roll(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::knot,
                   [&](world::Entity e) { return world::roll_deg(world::knot(c.session.document, e)); });
}
Answer spin(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::knot,
                   [&](world::Entity e) { return base::degrees(double{world::knot(c.session.document, e).spin}); });
}

// --- segments
Answer turns(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::segment,
                   [&](world::Entity e) { return world::segment(c.session.document, e).turns; });
}
Answer segment_length(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::segment,
                   [&](world::Entity e) { return c.session.derived.shape(e).measured_length; });
}
Answer twist(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::segment, [&](world::Entity e) {
    const sim::SegmentShape& shape = c.session.derived.shape(e);
    return sim::has_cusp(shape) ? none("the segment has a cusp") : number(base::degrees(shape.roll.twist));
  });
}

// --- evaluation
Answer vertices(const Context& c, View) { return number(c.session.derived.vertices); }

constexpr ArgumentPart kHashed[]{{.words = [] { return std::vector<std::string>{"document", "motion"}; }}};

constexpr std::array kDocumentRows{
    Query{"knots", kNoArgument, "", "Number of knots.", knots},
    Query{"segments", kNoArgument, "", "Number of segments.", segments},
    Query{"closed", kNoArgument, "", "on if the track is closed.",
          of_document<&world::Document::track, &world::Track::closed>, kSwitch},
    Query{"length", kNoArgument, "m", "Length of the track by the chosen arc-length method.", length, of_view()},
    Query{"exact_length", kNoArgument, "m", "Length of the track by adaptive Gauss-Legendre.", exact_length},
    Query{"name", kNoArgument, "", "The track's name.", of_document<&world::Document::name>, kText},
    Query{"start_speed", kNoArgument, "m/s", "Start speed of trains.", of_document<&world::Document::start_speed>},
    Query{"open_end.distance", kNoArgument, "m",
          "Distance of the last knot from the first one in space; 0 on a closed track, none below two knots.",
          open_end_distance, or_none()},
    Query{"datum", kNoArgument, "m", "Height at which potential energy is zero.", of_document<&world::Document::datum>},
    Query{"longest", kNoArgument, "", "The longest segment; none without one.", longest, of_view(or_none(kText))},
    Query{"conflicts", kNoArgument, "",
          "Places where the track lacks clearance from itself: a train would be too close beside, below or above "
          "other track.",
          conflicts},
    Query{"conflict.missing", kNoArgument, "m", "Clearance missing at the worst conflict; 0 if there is none.",
          conflict_missing},
    Query{"conflict.at", kNoArgument, "m", "Distance of the worst conflict along the track; none if there is none.",
          conflict_place<&sim::Conflict::at>, or_none()},
    Query{"conflict.other", kNoArgument, "m", "Distance of its other stretch along the track; none if there is none.",
          conflict_place<&sim::Conflict::other>, or_none()},
    Query{"folds", kNoArgument, "",
          "Places where the rails fold: the curve's radius is below the rails' distance from it.", folds},
    Query{"fold.at", kNoArgument, "m", "Distance of the first fold along the track; none if there is none.",
          first_fold<&sim::Fold::at>, or_none()},
    Query{"fold.radius", kNoArgument, "m", "The curve's radius there; none if there is none.",
          first_fold<&sim::Fold::radius>, or_none()},
    Query{"tight_bends", kNoArgument, "",
          "Places where the curve bends with a radius below 0.5 m or reverses its direction: no train can pass.",
          tight_bends},
    Query{"tight_bend.at", kNoArgument, "m", "Distance of the tightest one along the track; none if there is none.",
          tight_bend_at, or_none()},
    Query{"least_radius", kNoArgument, "m",
          "Least radius of the curve, found exactly: 0 where it reverses its direction, none for a straight track.",
          least_radius, or_none()},
    Query{"hash", kHashed, "", "Hash of the document or of the motion, 16 hexadecimal digits.", hash, of_view(kText)},
    Query{"position", kKnot, "m", "A knot's position.", of_knot<&world::Knot::position>, kVector},
    Query{"tangent", kKnot, "", "A knot's direction of travel, a unit vector.", of_knot<&world::Knot::tangent>,
          kVector},
    Query{"up", kKnot, "", "Direction of riders' heads at a knot, a unit vector.", of_knot<&world::Knot::up>, kVector},
    Query{"roll", kKnot, "deg", "A knot's roll from the horizon, positive to the rider's right.", roll},
    Query{"spin", kKnot, "deg/m",
          "A knot's spin: the rate of roll along the track there, against the rotation-minimising frame.", spin},
    Query{"spin_kind", kKnot, "", "Where a knot's spin comes from: automatic or set.", of_knot<&world::Knot::spin_kind>,
          kOneOf<world::SpinKind>},
    Query{"in_length", kKnot, "m", "Length of a knot's incoming handle.", of_knot<&world::Knot::in_length>},
    Query{"out_length", kKnot, "m", "Length of a knot's outgoing handle.", of_knot<&world::Knot::out_length>},
    Query{"joint", kKnot, "", "A knot's kind of joint: smooth, aligned or automatic.", of_knot<&world::Knot::joint>,
          kOneOf<world::JointKind>},
    Query{"geometric", kKnot, "", "Geometric continuity: G0 < G1 < G2; none at the end of an open track.",
          of_joint<&curve::Joint::geometric>, or_none(kRankOf<curve::Geometric>)},
    Query{"parametric", kKnot, "", "Parametric continuity: C0 < C1 < C2; none at the end of an open track.",
          of_joint<&curve::Joint::parametric>, or_none(kRankOf<curve::Parametric>)},
    Query{"gap", kKnot, "m", "Distance between the ends of the segments at a knot; none at the end of an open track.",
          of_joint<&curve::Joint::gap>, or_none()},
    Query{"speed_ratio", kKnot, "", "|C'(0)| / |B'(1)| of the segments at a knot; none at the end of an open track.",
          of_joint<&curve::Joint::speed_ratio>, or_none()},
    Query{"curvature_jump", kKnot, "1/m",
          "Length of the difference of the curvature vectors at a knot; none at the end of an open track.",
          of_joint<&curve::Joint::curvature_jump>, or_none()},
    Query{"turns", kSegment, "", "Whole turns of roll within a segment.", turns},
    Query{"segment_length", kSegment, "m", "A segment's length by the chosen arc-length method.", segment_length,
          of_view()},
    Query{"twist", kSegment, "deg", "Roll over a segment, relative to its rotation-minimising frame; none over a cusp.",
          twist, or_none()},
    Query{"import.max_error", kNoArgument, "m",
          "Largest distance of an imported file's rows from the fitted track; none without an import.",
          of_import<&exchange::ImportReport::max_error>, or_none()},
    Query{
        "import.frame_error", kNoArgument, "deg",
        "Largest angle between a row's frame and the fitted track's, except within 0.5 m of a jump between rows; none "
        "without an import.",
        of_import<&exchange::ImportReport::frame_error>, or_none()},
    Query{"import.rms_error", kNoArgument, "m", "Root mean square of the distances of import.max_error.",
          of_import<&exchange::ImportReport::rms_error>, or_none()},
    Query{"import.rms_frame_error", kNoArgument, "deg", "Root mean square of the angles of import.frame_error.",
          of_import<&exchange::ImportReport::rms_frame_error>, or_none()},
    Query{"import.jump_error", kNoArgument, "deg",
          "As import.frame_error, within 0.5 m of where rows jump; 0 without a jump.",
          of_import<&exchange::ImportReport::jump_error>, or_none()},
    Query{"import.knots", kNoArgument, "", "Number of knots of the fitted track; 0 without an import.", import_knots},
    Query{"vertices", kNoArgument, "", "Number of vertices of all polylines.", vertices, of_view()},
};

}  // namespace

std::span<const Query> document_rows() { return kDocumentRows; }

}  // namespace coaster::query
