// Force limits by duration, as third parties read ASTM F2291 and EN 13814. Data to edit, not a compliance check.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/enum_names.h"
#include "sim/ride/simulated_ride.h"
#include "world/coaster_kind.h"

namespace coaster::sim {

inline constexpr double kForceRate = static_cast<double>(world::kTicksPerSecond) / kForceEvery;  // entries per second

// The directions in which a rider is pressed or lifted, each with its own limit.
enum class ForceAxis : std::uint8_t { down, lift, side, forward, back };  // +Gz, -Gz, +-Gy, +Gx, -Gx
inline constexpr base::NameRow kForceAxisRows[] = {{"down", "Vertical"},
                                                   {"lift", "Vertical"},
                                                   {"side", "Lateral"},
                                                   {"forward", "Longitudinal"},
                                                   {"back", "Longitudinal"}};
constexpr std::span<const base::NameRow> rows_of(ForceAxis) { return kForceAxisRows; }
inline constexpr std::size_t kForceAxes = std::size(kForceAxisRows);
// Returns felt g with the sign that plots show, from a value in the direction of a limit: out of the seat is negative.
constexpr double signed_g(ForceAxis axis, double g) {
  return axis == ForceAxis::lift || axis == ForceAxis::back ? -g : g;
}

struct ForceLimitPoint {
  double seconds, g;
  friend bool operator==(const ForceLimitPoint&, const ForceLimitPoint&) = default;
};
// For each axis the largest g by duration, durations ascending: linear between points, constant beyond them.
using EnvelopeCurve = std::vector<ForceLimitPoint>;
struct ForceLimitCurves {
  std::array<EnvelopeCurve, kForceAxes> curves;
  double shortest = 0.2;  // s: shorter overloads do not count
  double cutoff = 5.0;    // Hz, of the low-pass filter
  friend bool operator==(const ForceLimitCurves&, const ForceLimitCurves&) = default;
};
// Returns those of a kind of coaster: kiddie coasters have lower ones.
const ForceLimitCurves& default_envelope(world::CoasterKind kind = {});
double limit(const EnvelopeCurve& curve, double seconds);

// Applies a Butterworth low-pass of four poles in place to samples at `rate` per second, starting in the steady state
// of the first.
void low_pass(std::span<float> values, double rate, double cutoff);

// Returns low-passed felt g of riders of car `car` on one of the seat's axes, one value per entry of
// SimulatedRide::forces. An entry includes the impulses of the joints that the car has passed since the previous entry,
// divided by the time between entries; what entries miss beside joints (JointPassage::missed) is added to both. The
// rides of a car through tight bends (SimulatedRide::bends) are filtered at a higher rate, and an entry shows a peak
// within half an entry of it.
std::vector<float> low_passed_g(const SimulatedRide& simulated, int car, float FeltAcceleration::*axis, double cutoff);

// Returns the same on an axis of the limits, positive in the direction that it limits (side: absolute).
std::vector<float> pressed(const SimulatedRide& simulated, int car, ForceAxis axis, double cutoff);

// An overload: a stretch of a ride in which an acceleration lasts longer than its limit allows.
struct Overload {
  int car = 0;
  ForceAxis axis = ForceAxis::down;
  double from = 0, to = 0;                    // s since the start
  double from_distance = 0, to_distance = 0;  // m along the track, of that car
  double worst = 0, allowed = 0;              // g, at the largest excess: low-passed value, limit for its duration
  double at = 0;                              // s, time of the largest excess
};

// Returns all overloads of a ride, cars and axes in order. A moment is red if it belongs to an interval in which the
// value stays above a level for longer than the level's limit: found for all levels at once in O(n).
std::vector<Overload> red_spans(const SimulatedRide& simulated, const ForceLimitCurves& envelope);

// Suggests a knot to move, and its direction, to reduce an overload: finite differences over whole rides.
struct KnotMoveAdvice {
  world::Entity knot;
  glm::vec3 direction{0};  // unit, along an axis of the world
  // g over the limit, summed over the overloads of that kind, now and after a move of kAdviceStep.
  double before = 0, after = 0;
};
inline constexpr float kAdviceStep = 0.25f;  // m
inline constexpr int kAdviceReach = 3;       // knots to try on each side of the span

// Tries the knots from kAdviceReach before the span to as many after it, each along +-x, +-y and +-z. Returns the move
// that reduces the span's excess most; nothing if none does. Cost: about 40 rides, 2 ms each for a circuit of 1 km.
std::optional<KnotMoveAdvice> advise(const world::Document& document, world::Entity cart,
                                     const ForceLimitCurves& envelope, const Overload& span);

}  // namespace coaster::sim
