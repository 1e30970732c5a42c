// The layers that the laboratory draws over the scene. A table of names; view draws them.
#pragma once

#include <cstdint>
#include <span>

#include "base/enum_names.h"

namespace coaster::world {

enum class Layer : std::uint8_t {
  polyline,
  frames,
  comb,
  circle,
  construction,
  rounding,
  flips,
  limits,
  supports,
  knots,
  conflicts,
  legend
};

// By name in scripts and recordings: "show comb on".
inline constexpr base::NameRow kLayers[] = {
    {"polyline", "Polyline", "The evaluated polyline over the track."},
    {"frames", "Frames", "Frames along the track: tangent (red), normal (green), binormal (blue)."},
    {"comb", "Curvature comb",
     "Curvature times the comb's scale, pointing away from the centre of curvature. A step marks a joint that is not "
     "G2."},
    {"circle", "Osculating circle", "Osculating circle at the probe: radius 1 / curvature."},
    {"construction", "Construction", "De Casteljau's construction of the curve point at the probe."},
    {"rounding", "Rounding",
     "Float rounding of the polyline: each vertex is displaced by its error times the magnification."},
    {"flips", "Frenet failures###Frenet's failures", "Where the Frenet normal flips or is undefined."},
    {"limits", "Highlight overloads###Red spans",
     "Where g exceeds its limit for longer than allowed, and joints with a jolt above 1 g. Not a compliance check."},
    {"supports", "Supports", "Supports, built automatically and clear of the trains."},
    {"knots", "Knots", "Knots and their handles. Hidden ones can still be selected."},
    {"conflicts", "Conflicts", "Where the track lacks clearance from itself, folds, or bends too tightly for a train."},
    {"legend", "Legend", "Numbers of the track's colours."},
};
constexpr std::span<const base::NameRow> rows_of(Layer) { return kLayers; }

// A set of layers. By default: polyline, supports, knots, conflicts and legend.
class Layers {
 public:
  bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
  void set(Layer layer, bool on) { bits_ = static_cast<std::uint16_t>(on ? bits_ | bit(layer) : bits_ & ~bit(layer)); }
  friend bool operator==(const Layers&, const Layers&) = default;

 private:
  static constexpr std::uint16_t bit(Layer layer) {
    return static_cast<std::uint16_t>(1u << static_cast<unsigned>(layer));
  }
  std::uint16_t bits_ =
      bit(Layer::polyline) | bit(Layer::supports) | bit(Layer::knots) | bit(Layer::conflicts) | bit(Layer::legend);
};

}  // namespace coaster::world
