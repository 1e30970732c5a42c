// How long which acceleration may last: limits by duration, as third parties read ASTM F2291 and EN 13814. Data to
// edit, not a compliance check.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/ride/ghost.h"

namespace coaster::sim {

// The directions in which a rider is pressed or lifted, each with a limit of its own.
enum class ForceAxis : std::uint8_t { down, lift, side, forward, back };  // +Gz, -Gz, +-Gy, +Gx, -Gx
inline constexpr std::size_t kForceAxes = 5;
std::string_view name(ForceAxis axis);   // "down" ...
std::string_view label(ForceAxis axis);  // "into the seat (+Gz)" ...

struct EnvelopePoint {
  double seconds, g;
  friend bool operator==(const EnvelopePoint&, const EnvelopePoint&) = default;
};
// For each axis the largest g for each duration, durations ascending: linear between points, constant beyond them.
using EnvelopeCurve = std::vector<EnvelopePoint>;
struct Envelope {
  std::array<EnvelopeCurve, kForceAxes> curves;
  double shortest = 0.2;  // s: what is shorter does not count
  double cutoff = 5.0;    // Hz, of the low-pass before it is looked at
  friend bool operator==(const Envelope&, const Envelope&) = default;
};
const Envelope& default_envelope();
double limit(const EnvelopeCurve& curve, double seconds);

// A Butterworth low-pass of four poles over samples `rate` a second apart, started in the steady state of the first
// one. In place.
void low_pass(std::span<float> values, double rate, double cutoff);

// Riders of car `car` on one axis, low-passed, positive into the direction that the axis limits (side: the size), one
// entry for each of Ghost::forces.
std::vector<float> pressed(const Ghost& ghost, int car, ForceAxis axis, double cutoff);

// A stretch of a ride in which some acceleration lasts longer than it may.
struct RedSpan {
  int car = 0;
  ForceAxis axis = ForceAxis::down;
  double from = 0, to = 0;                    // s since the start
  double from_distance = 0, to_distance = 0;  // m along the track, of that car
  double worst = 0,
         allowed = 0;  // g, where it is furthest beyond: the low-passed value and the limit for how long it lasts
  double at = 0;       // s, when
};

// All of a ride, cars and axes in order. A moment is red when it belongs to a time in which a level is never left and
// that lasts longer than the level may: found for all levels at once in O(n).
std::vector<RedSpan> red_spans(const Ghost& ghost, const Envelope& envelope);

// The same, kept while the ride and the envelope are the same.
class RedSpans {
 public:
  const std::vector<RedSpan>& update(const Ghost& ghost, const Envelope& envelope) {
    if (serial_ != ghost.serial || !(envelope_ == envelope)) spans_ = red_spans(ghost, envelope);
    serial_ = ghost.serial;
    envelope_ = envelope;
    return spans_;
  }

 private:
  std::uint64_t serial_ = 0;
  Envelope envelope_;
  std::vector<RedSpan> spans_;
};

}  // namespace coaster::sim
