// The integrator table. All rows work along one segment, in arc length; ride.cpp splits ticks at joints.
#include <array>
#include <cmath>

#include "sim/ride.h"

namespace coaster::sim {
namespace {

double acceleration(const RailContext& context, double s) { return -world::kGravity * rail_point(context.shape, s).slope; }

// Classical Runge-Kutta, order 4, for s' = v, v' = -g T_y(s).
RailState rk4(const RailContext& context, RailState x, double dt) {
  const double half = 0.5 * dt;
  const double a1 = acceleration(context, x.s);
  const double v2 = x.speed + half * a1, a2 = acceleration(context, x.s + half * x.speed);
  const double v3 = x.speed + half * a2, a3 = acceleration(context, x.s + half * v2);
  const double v4 = x.speed + dt * a3, a4 = acceleration(context, x.s + dt * v3);
  return {x.s + dt / 6.0 * (x.speed + 2.0 * v2 + 2.0 * v3 + v4), x.speed + dt / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)};
}

// Velocity Verlet: symplectic, so its energy error stays bounded.
RailState verlet(const RailContext& context, RailState x, double dt) {
  const double a = acceleration(context, x.s);
  const double s = x.s + dt * x.speed + 0.5 * dt * dt * a;
  return {s, x.speed + 0.5 * dt * (a + acceleration(context, s))};
}

// Barrett 2012, section 4: the speed from the energy, then distance = speed x time. Paper erratum: where the speed is 0 it stays
// there, so a cart at rest never starts and one that should roll back stops.
RailState energy_method(const RailContext& context, RailState x, double dt) {
  const double kinetic = context.reference_energy - world::kGravity * (rail_point(context.shape, x.s).height - context.datum);
  const double speed = kinetic > 0 ? std::copysign(std::sqrt(2.0 * kinetic), x.speed) : 0.0;
  return {x.s + speed * dt, speed};
}

constexpr std::array<Integrator, 3> kTable{{
    {"rk4", "Runge-Kutta 4", "s'' = -g T_y(s), four slopes, twice a tick", rk4, 2},
    {"verlet", "Velocity Verlet", "s += v dt + a dt^2/2, v += (a_old + a_new) dt/2", verlet, 1},
    {"energy", "Energy (the paper's)", "v = sqrt(2 (E - g h)), s += v dt; freezes at v = 0", energy_method, 1},
}};

}  // namespace

RailPoint rail_point(const SegmentShape& shape, double s) {
  const double length = shape.arc.length();
  const double t = shape.arc.parameter(s);
  const double slope = curve::unit_tangent(shape.key.cubic, t).y;
  const double height = curve::point(shape.key.cubic, t).y;
  // Beyond its ends a segment goes on straight: an integrator's probe may look there before the tick is split.
  if (s < 0) return {height + s * slope, slope};
  if (s > length) return {height + (s - length) * slope, slope};
  return {height, slope};
}

std::span<const Integrator> integrators() { return kTable; }

std::optional<int> find_integrator(std::string_view name) {
  for (std::size_t i = 0; i < kTable.size(); ++i)
    if (kTable[i].name == name) return static_cast<int>(i);
  return std::nullopt;
}

}  // namespace coaster::sim
