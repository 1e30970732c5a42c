#include "sim/study/track_errata.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/portable_math.h"
#include "curve/continuity.h"
#include "curve/paper_errata.h"
#include "sim/ride/ride.h"

namespace coaster::sim {
namespace {

// Returns the steepest of 33 points on the rails; at the ends only a slope into the segment counts.
double steepest_place(const SegmentShape& shape) {
  double best = 0.5 * shape.arc.length(), most = -1;
  for (int i = 1; i < kFrameIntervals; ++i) {
    const double s = shape.arc.length() * i / kFrameIntervals, slope = std::abs(rail_point(shape, s).slope);
    if (slope > most) most = slope, best = s;
  }
  return best;
}

// Returns the distance in m that a cart moves in kFrozenTicks from rest at `from` on segment `index`, by an integrator;
// it stops at the segment's ends.
double way_from_rest(const DerivedTrack& derived, std::size_t index, double from, const Integrator& row) {
  const SegmentShape& shape = derived.shape_at(index);
  const std::array<TrackPlace, 1> car{TrackPlace{index, from}};
  const TrainContext context{derived, car, 0.0, world::kGravity * rail_point(shape, from).height, {}, 0.0, 0.0};
  TrainState state;
  for (int tick = 0; tick < kFrozenTicks; ++tick) {
    state = row.advance(context, state, world::kTick);
    if (from + state.x <= 0.0 || from + state.x >= shape.arc.length()) break;
  }
  return std::abs(std::clamp(from + state.x, 0.0, shape.arc.length()) - from);
}

Erratum frozen(const DerivedTrack& derived, std::size_t index) {
  const auto named = [](std::string_view name) -> const Integrator& {
    return base::row_of(*base::value_named<world::IntegratorId>(name));
  };
  const double from = steepest_place(derived.shape_at(index));
  return {"frozen",
          "The speed follows from the energy, then distance = speed x time.",
          way_from_rest(derived, index, from, named("energy")),
          "m",
          way_from_rest(derived, index, from, named("rk4")),
          "m",
          "A train at rest on a slope never starts: with v = 0 it does not move. With s'' = -g T_y it rolls "
          "off. Values: metres after half a second."};
}

// Returns the larger curvature jump of the segment's two joints.
double curvature_jump(const DerivedTrack& derived, std::size_t index) {
  const std::size_t count = derived.order.size();
  double jump = 0;
  for (const std::size_t at : {index, index + 1}) {
    if (!derived.closed && (at == 0 || at == count)) continue;
    const curve::Cubic &before = derived.shape_at((at + count - 1) % count).key.cubic,
                       &after = derived.shape_at(at % count).key.cubic;
    jump = std::max(jump, glm::length(curve::curvature_vector(after, 0.0) - curve::curvature_vector(before, 1.0)));
  }
  return jump;
}

Erratum flip(const curve::Cubic& cubic) {
  const curve::FlipClaim claim = curve::flip_claim(cubic);
  return {"frenet_flip",
          "The Frenet-Serret frame orients the train.",
          base::degrees(claim.frenet_angle),
          "deg",
          0.0,
          "deg",
          claim.defined
              ? "The normal turns by this angle within 1/32 of the segment, by 180 degrees at an inflection; a "
                "rotation-minimising frame by definition does not turn about the tangent."
              : "A straight has no Frenet-Serret normal; a rotation-minimising frame continues unchanged."};
}

}  // namespace

double g_step(double jump, double speed) { return speed * speed * jump / world::kGravity; }

std::array<Erratum, kErrata.size()> errata(const DerivedTrack& derived, world::Entity segment, double speed,
                                           int steps) {
  const auto at = std::find(derived.order.begin(), derived.order.end(), segment);
  COASTER_CHECK(at != derived.order.end(), "errata need a segment of the track");
  const SegmentShape& shape = derived.shape(segment);
  const curve::Cubic& cubic = shape.key.cubic;
  const curve::GravesenClaim gravesen = curve::gravesen_claim(cubic);
  const auto index = static_cast<std::size_t>(at - derived.order.begin());
  const double jump = curvature_jump(derived, index);
  return {
      {{"gravesen", "The arc length is half the control polygon multiplied by the chord.", gravesen.product, "m^2",
        gravesen.mean, "m",
        "It is their mean, (chord + polygon) / 2, with an error of at most (polygon - chord) / 2. The product is an "
        "area."},
       {"line", "A vertex of the polyline is B(0) + i dB, with one difference dB.", 0.0, "m",
        curve::line_claim(cubic, steps), "m",
        "That is a straight line in equal steps; a cubic needs three differences. The value is the line's distance "
        "from the curve."},
       frozen(derived, index),
       {"g_step", "C1 continuity makes the path smooth.", 0.0, "g", g_step(jump, speed), "g",
        "C1 leaves jumps of curvature, so the force jumps by v^2 |dK| / g. Equal curvature vectors (G2) remove "
        "them."},
       flip(cubic),
       {"pen", "Lines between the control points form a pen that contains the curve.", 0.0, "m",
        curve::pen_claim(cubic), "m",
        "The curve stays in their convex hull, not in their polygon, which may cross itself. The value is its distance "
        "from the "
        "closed polygon."}}};
}

std::optional<Erratum> erratum(const DerivedTrack& derived, world::Entity segment, double speed, int steps,
                               std::string_view name) {
  for (const Erratum& one : errata(derived, segment, speed, steps))
    if (one.name == name) return one;
  return std::nullopt;
}

}  // namespace coaster::sim
