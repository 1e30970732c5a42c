// The ride: carts moved by arc length in fixed ticks, by one of the integrators of a table. Rail lengths are adaptive
// Gauss-Legendre in double: the motion depends on neither the display's evaluator nor its resolution.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "sim/derived.h"
#include "world/motion.h"

namespace coaster::sim {

// A point of the rails as an integrator sees it.
struct RailPoint {
  double height;   // m (y)
  double slope;    // dy/ds, the tangent's y
};
RailPoint rail_point(const SegmentShape& shape, double s);

// State along one segment: arc length (may leave [0,length]: then the tick is split there) and speed.
struct RailState {
  double s, speed;
};
// What an integrator may use besides its state.
struct RailContext {
  const SegmentShape& shape;
  double datum;             // m
  double reference_energy;  // J/kg
};

struct Integrator {
  std::string_view name;   // "rk4"
  std::string_view label;  // "Runge-Kutta 4"
  std::string_view formula;
  RailState (*advance)(const RailContext& context, RailState state, double dt);
  int substeps;  // equal parts that a tick is advanced in
};

// Rows: rk4 (default; over 10 laps of a closed track its energy drifts by less than 1e-6 of the largest kinetic energy, in loops of
// 7 m at 20 m/s with kinks of curvature at the joints too, for which one part a tick is not enough), verlet (velocity Verlet in arc length), energy (the paper's: v from the energy, then s += v dt; freezes at
// v = 0, Paper erratum, kept for comparison).
std::span<const Integrator> integrators();
std::optional<int> find_integrator(std::string_view name);

// Places every cart of the document at its start with the start speed, state stopped.
void reset(const world::Document& document, const Derived& derived, world::Motion& motion);

// After edits: carts that were added appear, removed ones go; a cart keeps its segment, fraction and speed, with a new reference
// energy if its segment's length or heights changed; a cart whose segment vanished goes to the same distance along the track.
// `changed` says whether document or derived changed since the last call: false returns at once.
void reconcile(const world::Document& document, const Derived& derived, world::Motion& motion);

// Advances by whole ticks when running; ticks are split at joints, where the force has a kink. Carts on an open track stop
// at its ends (speed 0); when all have, the state is ended.
void step(const world::Document& document, const Derived& derived, int integrator, int ticks, world::Motion& motion);

// One cart to `distance` from the start, with the speed that keeps its energy (0 where it does not reach).
void seek(const world::Document& document, const Derived& derived, world::Entity cart, double distance, world::Motion& motion);

// Energy E = v^2/2 + g (y - datum), J/kg, and its drift |E - reference| / peak kinetic energy (0 when nothing moved).
double energy(const world::Document& document, const Derived& derived, const world::CartMotion& cart);
double energy_drift(const world::Document& document, const Derived& derived, const world::CartMotion& cart);

// Where a cart is and how it is turned, by one of the methods of sim/frame_methods.h; where that is undefined another frame stands in
// and `defined` is false.
struct Pose {
  glm::dvec3 position{0};
  curve::Frame frame;
  bool defined = true;
};
Pose pose(const Derived& derived, const world::CartMotion& cart, world::FrameMethod method);

// Felt acceleration in g at `heartline` metres over the rails, on the seat's axes: at rest on the flat +1 up.
struct Felt {
  double up = 1, left = 0, forward = 0;
};
Felt felt(const Derived& derived, const world::CartMotion& cart, double heartline = 1.1);

}  // namespace coaster::sim
