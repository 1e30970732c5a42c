// The ride: trains moved by arc length in fixed ticks, by one of the integrators of a table. Rail lengths are adaptive
// Gauss-Legendre in double: the motion depends on neither the display's evaluator nor its resolution.
#pragma once

#include <span>
#include <string_view>

#include "sim/ride/simulated_ride.h"
#include "sim/ride/train.h"
#include "world/motion.h"

namespace coaster::sim {

// One row of the table of integrators. Most advance a state by a time within a part of a tick in which no car crosses a
// joint. Those with a timetable or a polyline (kind) advance the whole train instead.
enum class IntegratorKind : std::uint8_t { stepped, timetable, vertices };
struct Integrator {
  std::string_view name;   // "rk4"
  std::string_view label;  // "Runge-Kutta 4"
  std::string_view formula;
  IntegratorKind kind;
  TrainState (*advance)(const TrainContext& context, TrainState state, double dt);  // null unless stepped
  int substeps;                                                                     // equal parts of a tick
  // Ticks are split at joints, where the force has a kink. Otherwise equal steps cross joints: a symplectic method
  // needs them to keep its energy bounded.
  bool splits;
};

// Returns the table: rk4 (default; over 10 laps of a closed track its energy drifts by less than 1e-6 of the largest
// kinetic energy, even in loops of 7 m at 20 m/s with kinks of curvature at the joints, which need more than one part
// per tick), verlet (velocity Verlet in arc length), euler (semi-implicit), energy (the paper's: v from the energy,
// then s += v dt; freezes at v = 0, Paper erratum, kept for comparison), precomputed (the paper's conclusion: a
// timetable of the whole ride, looked up each tick), vertices (the paper's conclusion: from vertex to vertex of the
// chosen polyline; the only row whose motion depends on evaluator and resolution).
std::span<const Integrator> integrators();

// Puts every train of the document at its start with the start speed, stopped.
void reset(const world::Document& document, const DerivedTrack& derived, world::Motion& motion);

// Updates the motion after edits: adds new trains and removes deleted ones. A train keeps its segment, fraction and
// speed, with a new reference energy if its segment's length or heights changed; if its segment is gone it keeps its
// distance along the track.
void reconcile(const world::Document& document, const DerivedTrack& derived, world::Motion& motion);

// Advances a running ride by whole ticks, split at joints, where the force has a kink. Trains on an open track stop at
// its ends (speed 0); when all have, the state is ended. Stalls, rollbacks and collisions end the ride at once: the
// state is failed and motion.failure holds the reason (off_end for a train that ran off an open end). `cache` caches
// the timetables of the integrator `precomputed`.
void step(const world::Document& document, const DerivedTrack& derived, world::IntegratorId integrator, int ticks,
          RideCache& cache, world::Motion& motion);

// Moves one train to `distance` from the start, with the speed that keeps its energy (0 if it does not reach that
// height).
void seek(const world::Document& document, const DerivedTrack& derived, world::Entity cart, double distance,
          world::Motion& motion);

// Return the energy E = v^2/2 + g (y - datum), J/kg, with y the cars' mean height, and its drift |E - work - reference|
// / peak kinetic energy (0 if nothing moved). Work includes losses and equipment, so the drift is the integrator's
// error alone.
double energy(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
              const world::TrainMotion& cart);
double energy_drift(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                    const world::TrainMotion& cart);

// Position on the rails and orientation of a car, by one of the methods of sim/shape/frame_methods.h; where the method
// is undefined another frame is used and `defined` is false.
struct Pose {
  glm::dvec3 position{0};
  curve::Frame frame;
  bool defined = true;
  double length = world::kCarLength;  // m, of the car
  bool leads = true;                  // the first car of its train
  std::uint8_t group = 0;             // of its riders (sim/solids/train_mesh.h)
  bool arms_up = false;               // the riders raise their arms
};
Pose pose(const DerivedTrack& derived, const world::TrainMotion& cart, world::FrameMethod method);
// Return the pose at a position on the track, and of all cars of a train, first to last.
Pose pose(const DerivedTrack& derived, TrackPlace place, world::FrameMethod method);
std::vector<Pose> car_poses(const world::Document& document, const DerivedTrack& derived, world::Entity cart,
                            const world::TrainMotion& motion, world::FrameMethod method);

// Felt acceleration in g of riders on the document's heartline, in one car of a train, on the seat's axes: +1 up at
// rest on level track. Includes losses and equipment of the last tick.
FeltAcceleration felt(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                      const world::TrainMotion& cart, int car = 0);

// Roll of a car about the rails against the rotation-minimising frame, positive to the right: spin times speed, and its
// derivative by time within a segment.
struct CarRoll {
  double rate = 0;          // rad/s
  double acceleration = 0;  // rad/s^2
};
CarRoll rolling(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                const world::TrainMotion& cart, int car = 0);

// Returns the poses of the cars of all trains, each as car_poses() does. Beyond the `exact` cars nearest to the eye and
// by the frame method `knots`, they are approximate, at a tenth of the cost: at most max |B''| / 8192 m from their
// place on the curve B, and turned by less than a 32nd of the segment's turn.
std::vector<Pose> shown_cars(const world::Document& document, const DerivedTrack& derived, const world::Motion& motion,
                             world::FrameMethod method, glm::dvec3 eye, std::size_t exact);

}  // namespace coaster::sim

namespace coaster::world {
inline std::span<const sim::Integrator> rows_of(IntegratorId) { return sim::integrators(); }
}  // namespace coaster::world
