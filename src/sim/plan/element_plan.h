// Plans an element of the palette at the open end of a track: its ideal curve, the spans that follow it, and their
// figures. Formulas and sources: docs/elements.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/ground/land.h"
#include "sim/plan/element_fit.h"
#include "sim/plan/element_shapes.h"
#include "world/document.h"

namespace coaster::sim {

// Equipment of consecutive spans, starting with the first.
struct EquippedSpans {
  std::size_t spans = 0;
  world::Equipment equipment;
};

struct ElementPlan {
  std::string refusal;             // why it cannot be placed; empty if it can
  std::vector<std::string> lines;  // one for each value that was clamped
  world::Element element;          // with clamped values
  ElementCurve ideal;
  ElementFit fit;  // fit.knots.front() is the track's end, with its new outgoing handle
  std::vector<EquippedSpans> equipment;
  std::optional<world::ForceProgram> forces;  // for a force element: the keys of the section
  double length = 0;                          // m, of the ideal curve with its lead-in
  double lead = 0;                            // m, of the lead-in: easing and levelling
  double lowest = 0;                          // m, least height of the rails (y)
  std::uint64_t serial = 0;                   // a new number for each plan that an ElementCache makes
  std::size_t spans() const { return fit.knots.empty() ? 0 : fit.knots.size() - 1; }
};

// Returns the end of an open track: its last knot, and the curvature of the last segment there. An empty track starts
// at (0, 2, 0) along +X, or 2 m above the land or water there. Nothing for a closed track.
std::optional<TrackEnd> open_end(const world::Document& document);
// Returns the same for the knot with that index, as if the track ended there.
TrackEnd end_at(const world::Document& document, std::size_t knot);

// Makes values beyond the limits of the table the limits, with a line for each, and others that are not numbers the
// defaults.
void clamp_values(world::Element& element, std::vector<std::string>& lines);

// Plans an element. Values beyond the limits of its table are clamped; values that are not numbers become the defaults.
// Takes a few ms.
ElementPlan plan_element(const world::Element& element, const TrackEnd& end);
// Plans an element at the end of the document's track; refused if it has no open end. A force element is planned for a
// train that passes the end at `speed` m/s; without one for kAssumedSpeed, with a line that says so.
ElementPlan plan_element(const world::Element& element, const world::Document& document,
                         std::optional<double> speed = std::nullopt);
// Returns how deep (m) the plan goes where no track may: below the ground without a land, else under water; not above 0
// if nowhere.
double depth_of(const ElementPlan& plan, const Land& land);
inline constexpr double kAssumedSpeed = 10;  // m/s, if no train reaches the open end
std::string assumed_text();

}  // namespace coaster::sim
