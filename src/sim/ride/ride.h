// The ride: carts moved by arc length in fixed ticks, by one of the integrators of a table. Rail lengths are adaptive
// Gauss-Legendre in double: the motion depends on neither the display's evaluator nor its resolution.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "sim/ride/ghost.h"
#include "sim/ride/train.h"
#include "world/motion.h"

namespace coaster::sim {

// One row of the table of integrators. Most advance a state by a time within a part of a tick in which no car crosses a
// joint; those of a timetable or a polyline (kind) advance the whole train instead.
enum class IntegratorKind : std::uint8_t { stepped, timetable, vertices };
struct Integrator {
  std::string_view name;   // "rk4"
  std::string_view label;  // "Runge-Kutta 4"
  std::string_view formula;
  IntegratorKind kind;
  TrainState (*advance)(const TrainContext& context, TrainState state, double dt);  // null unless stepped
  int substeps;  // equal parts that a tick is advanced in
  bool splits;  // at joints, where the force has a kink; else equal steps go over them, as a symplectic method needs to
                // keep its energy bounded
};

// Rows: rk4 (default; over 10 laps of a closed track its energy drifts by less than 1e-6 of the largest kinetic energy,
// in loops of 7 m at 20 m/s with kinks of curvature at the joints too, for which one part a tick is not enough), verlet
// (velocity Verlet in arc length), euler (semi-implicit), energy (the paper's: v from the energy, then s += v dt;
// freezes at v = 0, Paper erratum, kept for comparison), precomputed (the paper's conclusion: a timetable of the whole
// ride, looked up each tick), vertices (the paper's conclusion: from vertex to vertex of the chosen polyline; the one
// row whose motion depends on evaluator and resolution).
std::span<const Integrator> integrators();
std::optional<int> find_integrator(std::string_view name);
inline constexpr int kDefaultIntegrator = 0;

// Places every cart of the document at its start with the start speed, state stopped.
void reset(const world::Document& document, const Derived& derived, world::Motion& motion);

// After edits: carts that were added appear, removed ones go; a cart keeps its segment, fraction and speed, with a new
// reference energy if its segment's length or heights changed; a cart whose segment vanished goes to the same distance
// along the track. `changed` says whether document or derived changed since the last call: false returns at once.
void reconcile(const world::Document& document, const Derived& derived, world::Motion& motion);

// Advances by whole ticks when running; ticks are split at joints, where the force has a kink. Trains on an open track
// stop at its ends (speed 0); when all have, the state is ended. Stalls, rollbacks and collisions end the ride at once:
// the state is failed; the reason is motion.failure (off_end, too, for one that ran off an open end). `memo` keeps the
// timetables of the integrator `precomputed`.
void step(const world::Document& document, const Derived& derived, int integrator, int ticks, GhostMemo& memo,
          world::Motion& motion);

// One cart to `distance` from the start, with the speed that keeps its energy (0 where it does not reach).
void seek(const world::Document& document, const Derived& derived, world::Entity cart, double distance,
          world::Motion& motion);

// Energy E = v^2/2 + g (y - datum), J/kg, y being the cars' mean height, and its drift |E - work - reference| / peak
// kinetic energy (0 when nothing moved): what losses and equipment did counts as work, so that the drift is the
// integrator's error alone.
double energy(const world::Document& document, const Derived& derived, world::Entity entity,
              const world::CartMotion& cart);
double energy_drift(const world::Document& document, const Derived& derived, world::Entity entity,
                    const world::CartMotion& cart);

// Where a car is and how it is turned, by one of the methods of sim/shape/frame_methods.h; where that is undefined
// another frame stands in and `defined` is false.
struct Pose {
  glm::dvec3 position{0};
  curve::Frame frame;
  bool defined = true;
  double length = world::kCarLength;  // m, of the car
  bool leads = true;                  // the first of its train
};
Pose pose(const Derived& derived, const world::CartMotion& cart, world::FrameMethod method);
// Of any place on the track, and of all cars of a train, first to last.
Pose pose(const Derived& derived, CarPlace place, world::FrameMethod method);
std::vector<Pose> car_poses(const world::Document& document, const Derived& derived, world::Entity cart,
                            const world::CartMotion& motion, world::FrameMethod method);

// Felt acceleration in g of riders on the document's heartline, in one car of a train, on the seat's axes: at rest on
// the flat +1 up. Losses and what equipment did in the last tick count.
struct Felt {
  double up = 1, left = 0, forward = 0;
};
Felt felt(const world::Document& document, const Derived& derived, world::Entity entity, const world::CartMotion& cart,
          int car = 0);

}  // namespace coaster::sim
