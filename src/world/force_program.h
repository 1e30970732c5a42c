// A force section as plain data: what riders should feel along it, or how it should bend, by keys.
// sim/plan/force_plan.h makes track from it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "base/enum_names.h"
#include "world/component_fields.h"

namespace coaster::world {

enum class ForceDomain : std::uint8_t { distance, time };
inline constexpr base::NameRow kForceOvers[] = {
    {"distance", "Distance", "Keys are metres from the section's start. The rate of roll is in degrees per metre."},
    {"time", "Time", "Keys are seconds from the section's start. The rate of roll is in degrees per second."}};
constexpr std::span<const base::NameRow> rows_of(ForceDomain) { return kForceOvers; }

enum class ForceQuantity : std::uint8_t { forces, curvature };
inline constexpr base::NameRow kForceOfs[] = {
    {"forces", "Forces",
     "Keys are what riders should feel: g and the rate of roll. The train's speed shapes the track."},
    {"curvature", "Curvature", "Keys are the track's curvature and its angle of roll, at any speed."}};
constexpr std::span<const base::NameRow> rows_of(ForceQuantity) { return kForceOfs; }

enum class ForceChannel : std::uint8_t { vertical, lateral, roll };
struct ForceChannelRow {
  std::string_view name, label, unit, help;
  double usual;  // the value without keys
  double limit;  // largest magnitude of a key's value
};
inline constexpr ForceChannelRow kForceChannels[] = {
    {"vertical", "Vertical", "g", "Felt g along the rider's spine: 1 at rest, 0 floating, negative lifts.", 1, 10},
    {"lateral", "Lateral", "g", "Felt g to the rider's left.", 0, 10},
    {"roll", "Roll", "deg", "Roll per metre or per second, positive to the rider's right.", 0, 360}};
constexpr std::span<const ForceChannelRow> rows_of(ForceChannel) { return kForceChannels; }
// The same channels of a section of curvature.
inline constexpr ForceChannelRow kCurvatureChannels[] = {
    {"vertical", "Vertical", "1/m", "Curvature upwards along the rider's spine: 1 over the radius.", 0, 0.5},
    {"lateral", "Lateral", "1/m", "Curvature to the rider's left: 1 over the radius.", 0, 0.5},
    {"roll", "Roll", "deg", "Angle rolled by since the section's start, positive to the rider's right.", 0, 3600}};
constexpr std::span<const ForceChannelRow> channels_of(ForceQuantity of) {
  return of == ForceQuantity::forces ? std::span(kForceChannels) : std::span(kCurvatureChannels);
}

inline constexpr std::size_t kMostForceKeys = 200;                     // of a channel
inline constexpr double kLongestForce_m = 1000, kShortestForce_m = 3;  // of a section over distance
inline constexpr double kLongestForce_s = 60, kShortestForce_s = 0.2;  // of a section over time
inline constexpr double kKeyGap_m = 1, kKeyGap_s = 0.05;               // least distance between keys of a channel
inline constexpr double kLeastTolerance = 0.02, kMostTolerance = 0.5;  // g
inline constexpr double kSlowestForce = 3;                             // m/s; below it, forces do not shape the track
inline constexpr double kCurvatureSpeed = 20;  // m/s, at which g of tolerances and ramps count where keys are curvature
inline constexpr double kMostForceSlope = 1000;  // of a key, per metre or second

// A point of a channel's curve. Its handles are on one line, so that the curve is smooth.
struct ForceKey {
  double at = 0;                 // m or s from the section's start
  double value = 0;              // in the unit of the channel (unit_of)
  double slope = 0;              // of the curve at the key, per metre or second
  double before = 0, after = 0;  // m or s to the handles; 0: a third of the distance to the neighbouring key
  friend bool operator==(const ForceKey&, const ForceKey&) = default;
};

struct ForceProgram {
  ForceDomain over = ForceDomain::distance;
  double length = 40;       // m or s
  double tolerance = 0.05;  // g, of what is felt against what the keys say; of curvature, at kCurvatureSpeed
  double speed = 10;        // m/s of the train at the section's start, for which it was planned
  bool hold = false;  // its end stays where the track that follows begins, and the keys are met as far as possible
  ForceQuantity of = ForceQuantity::forces;
  // Ascending, kKeyGap apart. Before the first key and after the last one the value stays.
  std::array<std::vector<ForceKey>, base::count_of<ForceChannel>()> channels = {};

  std::vector<ForceKey>& keys(ForceChannel channel) { return channels[static_cast<std::size_t>(channel)]; }
  const std::vector<ForceKey>& keys(ForceChannel channel) const { return channels[static_cast<std::size_t>(channel)]; }
  std::size_t list_bytes() const {
    std::size_t bytes = 0;
    for (const std::vector<ForceKey>& keys : channels) bytes += keys.capacity() * sizeof(ForceKey);
    return bytes;
  }
  // Not the keys: files and hashes have them as lists.
  static constexpr void fields(auto visit) {
    visit(Field{"over"}, &ForceProgram::over);
    visit(Field{"length", kShortestForce_s, kLongestForce_m}, &ForceProgram::length);
    visit(Field{"tolerance", kLeastTolerance, kMostTolerance}, &ForceProgram::tolerance);
    visit(Field{"speed", 0, 1000}, &ForceProgram::speed);
    visit(Field{"hold", 0, 0, FilePresence::unusual, 1}, &ForceProgram::hold);
    visit(Field{"of", 0, 0, FilePresence::unusual, 2}, &ForceProgram::of);
  }
  friend bool operator==(const ForceProgram&, const ForceProgram&) = default;
};

inline double longest_of(ForceDomain over) { return over == ForceDomain::distance ? kLongestForce_m : kLongestForce_s; }
inline double shortest_of(ForceDomain over) {
  return over == ForceDomain::distance ? kShortestForce_m : kShortestForce_s;
}
inline double key_gap_of(ForceDomain over) { return over == ForceDomain::distance ? kKeyGap_m : kKeyGap_s; }
inline const ForceChannelRow& channel_of(ForceQuantity of, ForceChannel channel) {
  return channels_of(of)[static_cast<std::size_t>(channel)];
}
// True if the train's speed shapes the track. Curvature over distance is the same at any speed, even at none.
inline bool needs_speed(const ForceProgram& program) {
  return program.of == ForceQuantity::forces || program.over == ForceDomain::time;
}
// Return "m" or "s"; for a channel's value: "g", "deg/m" or "deg/s", of curvature "1/m" or "deg".
std::string_view unit_of(ForceDomain over);
std::string_view unit_of(const ForceProgram& program, ForceChannel channel);

// Returns nothing for a program within all limits, else the error: "vertical has two keys within 1 m at 40 m".
std::optional<std::string> broken(const ForceProgram& program);

// Returns the keys that shape the curve: the first and the last are level, as is the curve outside them.
std::vector<ForceKey> shaping_keys(const ForceProgram& program, ForceChannel channel);
// Returns the control points (m or s, value) of the cubic Bezier between two keys. Handles that are too long for the
// gap are shortened along their line, so that the curve is a function of the position.
std::array<glm::dvec2, 4> curve_between(const ForceKey& from, const ForceKey& to);

// The steps by which keys move: those of snapping, and the units in which a search counts changes.
struct KeySteps {
  double at, value;  // m or s; the channel's unit
};
inline KeySteps steps_of(const ForceProgram& program, ForceChannel channel) {
  const bool metres = program.over == ForceDomain::distance, roll = channel == ForceChannel::roll;
  const double at = metres ? 1.0 : 0.1;
  if (program.of == ForceQuantity::curvature) return {at, roll ? 5.0 : 0.001};
  return {at, !roll ? 0.1 : metres ? 1.0 : 5.0};
}

}  // namespace coaster::world
