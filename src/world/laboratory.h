// What of the laboratory shows besides its layers: what the track is coloured by, and the pages of its strip. Tables of
// names; what is on a page is the panels' affair.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/names.h"

namespace coaster::world {

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
