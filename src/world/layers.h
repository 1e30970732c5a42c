// The layers that the laboratory draws over the scene. A table of names; how a layer is drawn is the view's affair.
#pragma once

#include <cstdint>
#include <span>

#include "base/names.h"

namespace coaster::world {

// Rows of layers(), in its order.
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
  conflicts
};

// By name in scripts and recordings: "show comb on".
std::span<const base::NameRow> layers();
inline std::span<const base::NameRow> rows_of(Layer) { return layers(); }

// A set of layers. By default: polyline, supports, knots and conflicts.
class Layers {
 public:
  bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
  void set(Layer layer, bool on) { bits_ = static_cast<std::uint16_t>(on ? bits_ | bit(layer) : bits_ & ~bit(layer)); }
  friend bool operator==(const Layers&, const Layers&) = default;

 private:
  static constexpr std::uint16_t bit(Layer layer) {
    return static_cast<std::uint16_t>(1u << static_cast<unsigned>(layer));
  }
  std::uint16_t bits_ = bit(Layer::polyline) | bit(Layer::supports) | bit(Layer::knots) | bit(Layer::conflicts);
};

}  // namespace coaster::world
