// The columns of the table of sections, by name in scripts.
#pragma once

#include <cstdint>
#include <span>

#include "base/enum_names.h"

namespace coaster::world {

enum class SectionColumn : std::uint8_t {
  track,
  title,
  kind,
  length,
  height,
  radius,
  angle,
  start,
  end,
  top,
  speed_in,
  speed_out,
  g_most,
  g_least,
  g_side,
  equipment
};
inline constexpr base::NameRow kSectionColumns[] = {
    {"track", "#", "Place in the track's order."},
    {"title", "Section", "Title; without one its kind. A click selects it, Shift adds it, Ctrl adds all between."},
    {"kind", "Kind", "What it was planned as, or shaped by hand."},
    {"length", "Length", "Length. Double-click that of a straight to type it."},
    {"height", "Height", "Height that it is planned with. Double-click to type it."},
    {"radius", "Radius", "Radius that it is planned with. Double-click to type it."},
    {"angle", "Angle", "Angle that it is planned with. Double-click to type it."},
    {"start", "Start", "Height where it begins."},
    {"end", "End", "Height where it ends."},
    {"top", "Top", "Largest height."},
    {"speed_in", "In", "Speed of the chosen seat where it begins."},
    {"speed_out", "Out", "Speed of the chosen seat where it ends."},
    {"g_most", "g max", "Largest vertical felt g of the chosen seat, not low-passed."},
    {"g_least", "g min", "Least vertical felt g of the chosen seat, not low-passed."},
    {"g_side", "Lateral", "Largest lateral felt g of the chosen seat, to either side, not low-passed."},
    {"equipment", "Equipment", "Equipment of its segments."}};
constexpr std::span<const base::NameRow> rows_of(SectionColumn) { return kSectionColumns; }

// Returns the parameter of an element that the column shows, or "".
constexpr std::string_view parameter_of(SectionColumn column) {
  const bool shows = column >= SectionColumn::length && column <= SectionColumn::angle;
  return shows ? kSectionColumns[static_cast<std::size_t>(column)].name : "";
}

}  // namespace coaster::world
