// Planning an element of the palette at the open end of a track: its ideal curve, the spans that follow it, and what
// there is to say of them. Formulas and sources: docs/elements.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/plan/element_fit.h"
#include "sim/plan/element_shapes.h"
#include "world/document.h"

namespace coaster::sim {

struct ElementPlan {
  std::string refusal;             // why it cannot be placed; empty: it can
  std::vector<std::string> lines;  // one for each value that was cut to a limit
  world::Element element;          // as it is after that
  ElementCurve ideal;
  ElementFit fit;            // fit.knots.front() is the track's end, with its new outgoing handle
  double length = 0;         // m, of the ideal curve with what leads into it
  double lead = 0;           // m, of what leads into it: easing and levelling
  double lowest = 0;         // m, the rails' least height over the ground; below 0 they are in it
  std::uint64_t serial = 0;  // a fresh number for each plan that an ElementMemo makes
  std::size_t spans() const { return fit.knots.empty() ? 0 : fit.knots.size() - 1; }
};

// The end of an open track: its last knot, and the curvature with which the last segment gets there. An empty track
// starts at (0, 2, 0) along +X. A closed one has none.
std::optional<TrackEnd> open_end(const world::Document& document);

// Values beyond the limits of the element's table are clamped, those that are no numbers become the usual ones. Some
// ms.
ElementPlan plan_element(const world::Element& element, const TrackEnd& end);
// The same at the end of that document's track; refused where it has no open end.
ElementPlan plan_element(const world::Element& element, const world::Document& document);

// The last plan, kept while the element and the track's end are the same.
class ElementMemo {
 public:
  const ElementPlan& plan(const world::Element& element, const world::Document& document);

 private:
  std::optional<world::Element> element_;
  std::optional<TrackEnd> end_;
  ElementPlan plan_;
};

}  // namespace coaster::sim
