// The integrator table. Stepped rows work in arc length on a train between two joints; ride_step.cpp splits ticks
// there.
#include <array>
#include <cmath>

#include "sim/ride/ride.h"

namespace coaster::sim {
namespace {

// s' = v, v' = a(s) + b(v), W' = b v: gravity depends only on s, losses and equipment only on v.
TrainRates slopes(const TrainContext& context, const TrainState& state) {
  const double others = context.others(state.speed);
  return {state.speed, context.gravity(state.x) + others, others * state.speed};
}

TrainState rk4(const TrainContext& context, TrainState state, double dt) {
  return runge_kutta(state, slopes(context, state), dt, [&](const TrainState& at) { return slopes(context, at); });
}

// Velocity Verlet: symplectic without losses, so its energy error stays bounded.
TrainState verlet(const TrainContext& context, TrainState state, double dt) {
  const TrainRates k = slopes(context, state);
  const double x = state.x + dt * state.speed + 0.5 * dt * dt * k.acceleration;
  const double others = context.others(state.speed + dt * k.acceleration);
  const double speed = state.speed + 0.5 * dt * (k.acceleration + context.gravity(x) + others);
  return {x, speed, state.work + 0.5 * dt * (k.power + others * speed)};
}

// Semi-implicit Euler: the speed first, then the position with the new speed.
TrainState euler(const TrainContext& context, TrainState state, double dt) {
  const TrainRates k = slopes(context, state);
  const double speed = state.speed + dt * k.acceleration;
  return {state.x + dt * speed, speed, state.work + dt * k.power};
}

// Barrett 2012, section 4: the speed from the energy, then distance = speed x time. Paper erratum: a speed of 0 stays
// 0, so a cart at rest never starts and one that should roll back stops.
TrainState energy_method(const TrainContext& context, TrainState state, double dt) {
  const double kinetic =
      context.reference_energy + state.work - world::kGravity * (context.height(state.x) - context.datum);
  const double speed = kinetic > 0 ? std::copysign(std::sqrt(2.0 * kinetic), state.speed) : 0.0;
  return {state.x + speed * dt, speed, state.work + context.others(speed) * speed * dt};
}

constexpr std::array<Integrator, 6> kIntegrators{{
    {"rk4", "Runge-Kutta 4", "s'' = -g T_y(s), four slopes, twice a tick", IntegratorKind::stepped, rk4, 2, true},
    {"verlet", "Velocity Verlet", "s += v dt + a dt^2/2, v += (a_old + a_new) dt/2; equal steps, across joints",
     IntegratorKind::stepped, verlet, 1, false},
    {"energy", "Energy (the paper's)", "v = sqrt(2 (E - g h)), s += v dt; freezes at v = 0", IntegratorKind::stepped,
     energy_method, 1, true},
    {"euler", "Semi-implicit Euler", "v += a dt, s += v dt", IntegratorKind::stepped, euler, 1, true},
    {"precomputed", "Precomputed timetable", "s(t) and v(t) of the whole ride from tables, looked up each tick",
     IntegratorKind::timetable, nullptr, 1, true},
    {"vertices", "By polyline vertices", "from vertex to vertex in time chord / speed; as smooth as the resolution",
     IntegratorKind::vertices, nullptr, 1, true},
}};

}  // namespace

std::span<const Integrator> integrators() { return kIntegrators; }

}  // namespace coaster::sim
