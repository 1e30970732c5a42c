// What of the laboratory shows: the layers that are drawn over the scene, what the track is coloured by, and the pages
// of its strip. Tables of names; how a layer is drawn is the view's affair, what is on a page the panels'.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

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

// A set of layers. The polyline, the supports, the knots and the conflicts show at first.
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

// What the track is coloured by: rows of colourings(), in its order.
enum class Colouring : std::uint8_t { plain, speed, height, vertical, lateral, longitudinal, curvature, error };

struct ColouringRow {
  std::string_view name;   // in scripts and recordings: "colour speed"
  std::string_view label;  // in the panel and over the legend
  std::string_view unit;
  std::string_view help;
  bool of_ride = false;  // the whole ride is simulated for it
};
std::span<const ColouringRow> colourings();
inline std::span<const ColouringRow> rows_of(Colouring) { return colourings(); }

// Pages of the laboratory's strip: rows of lab_pages(), in its order.
enum class LabPage : std::uint8_t {
  construction,
  weights,
  hodograph,
  error,
  lengths,
  frames,
  joints,
  errata,
  measurements,
  forces
};

struct LabPageRow {
  std::string_view name;  // in scripts and recordings: "page weights"
  std::string_view help;
};
std::span<const LabPageRow> lab_pages();
inline std::span<const LabPageRow> rows_of(LabPage) { return lab_pages(); }

}  // namespace coaster::world
