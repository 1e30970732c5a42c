// Marks and thin lines of one frame.
#include "view/overlay.h"

#include <algorithm>
#include <array>

#include "view/angle_handle.h"
#include "view/gizmo.h"
#include "view/marks.h"
#include "view/overlay_element.h"
#include "view/overlay_lab.h"
#include "view/overlay_lab_parts.h"
#include "view/overlay_section.h"
#include "view/section_handle.h"
#include "view/spin_ring.h"
#include "view/workspace.h"
#include "world/selection.h"

namespace coaster::view {
namespace {

constexpr std::uint32_t kKnotColour = 0xffffffff, kSelectedColour = 0xff8a1fff, kAlsoColour = 0xffc08aff,
                        kHandleColour = 0xf2b84bff, kHandleHovered = 0xffdc96ff, kSpinColour = 0xb07affff,
                        kSpinHovered = 0xdcc4ffff;
constexpr std::uint32_t kPolygonColour = 0xf2b84bff, kPlaceColour = 0xff8a1fff, kHoveredPlaceColour = 0xffffffff;
constexpr std::uint32_t kFailureColour = 0xd7263dff;
constexpr double kFailureHeight = 1.6;  // m above the rails: above the car
constexpr float kHoveredGrowth = 1.35f;
constexpr float kPlaceRadius = 4.5f;  // points
constexpr float kLineWidth = 1.5f;    // points

// Adds control polygons and the handles of the shown knots; no line twice.
void add_polygons(const world::Document& document, const world::Settings& settings, float scale, Overlay& overlay) {
  const std::vector<world::Entity> knots = knots_with_handles(document, settings);
  const auto line = [&](glm::vec3 from, glm::vec3 to) {
    overlay.lines.push_back({from, to, kLineWidth * scale, kPolygonColour});
  };
  const auto has_handles = [&](world::Entity e) { return std::find(knots.begin(), knots.end(), e) != knots.end(); };
  for (const world::Entity e : selected_segments(document, settings.selected)) {
    const world::Segment& segment = world::segment(document, e);
    const curve::Cubic c = world::cubic_of(document, e);
    if (!has_handles(segment.from)) line(c.p0, c.p1);
    line(c.p1, c.p2);
    if (!has_handles(segment.to)) line(c.p2, c.p3);
  }
  for (const world::Entity e : knots) {
    const world::Knot& knot = world::knot(document, e);
    line(world::in_handle(knot), knot.position);
    line(knot.position, world::out_handle(knot));
  }
}

// Returns the marks to draw, far to near.
std::vector<PlacedMark> shown_marks(const world::Document& document, const sim::Derived& derived,
                                    const world::Settings& settings, const View& view, const Pick& hovered,
                                    const Selected& selected, bool riding) {
  const MarkChoice choice{!riding && shows_knots(settings), !riding, hovered};
  std::vector<PlacedMark> marks = marks_on_screen(document, derived, settings, view, selected, choice).marks;
  std::sort(marks.begin(), marks.end(), [](const PlacedMark& a, const PlacedMark& b) { return covers(b, a); });
  return marks;
}

Mark mark_of(const PlacedMark& placed, const world::Settings& settings, float scale, const Selected& selected,
             const Pick& hovered) {
  const bool under_cursor = hovered == Pick{placed.kind, placed.knot};
  const float growth = (under_cursor ? kHoveredGrowth : 1.0f) * scale;
  if (placed.kind == PickKind::spin)
    return {placed.position, kHandleHalf * growth, under_cursor ? kSpinHovered : kSpinColour, MarkShape::square};
  if (placed.kind != PickKind::knot)
    return {placed.position, kHandleHalf * growth, under_cursor ? kHandleHovered : kHandleColour, MarkShape::square};
  return {placed.position, kKnotRadius * growth,
          placed.knot == settings.selected ? kSelectedColour
          : selected(placed.knot)          ? kAlsoColour
                                           : kKnotColour,
          MarkShape::disc};
}

// Adds a red disc with a cross above the rails.
void add_failure(const sim::Derived& derived, const world::Failure& failure, const View& view, float scale,
                 Overlay& overlay) {
  if (failure.kind == world::FailureKind::none || derived.order.empty()) return;
  std::array<glm::dvec2, 14> cross;
  for (int i = 0; i < 7; ++i)
    for (const int side : {0, 1})
      cross[static_cast<std::size_t>(2 * i + side)] = 1.35 * (i - 3) * glm::dvec2(1, 2 * side - 1);
  add_sign(over_rails(derived, failure.distance, kFailureHeight), kFailureColour, cross, view, scale, overlay);
}

}  // namespace

Overlay build_overlay(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                      const View& view, const Pick& hovered, const Findings& findings) {
  Overlay overlay;
  add_laboratory(document, derived, settings, view, findings, overlay);
  const float scale = mark_scale(settings, view);
  const double rails = world::rails_height(document);
  if (findings.element) add_element(*findings.element, findings.narrow, rails, view, scale, overlay);
  add_sections(document, derived, settings, view, hovered, overlay);
  add_polygons(document, settings, scale, overlay);
  // The picked position is not a pickable mark, so it is drawn below all that are.
  if (const sim::SegmentShape* const shape = derived.segments.find(settings.selected))
    add_disc(curve::point(shape->key.cubic, settings.selected_t), kPlaceRadius * scale, kPlaceColour, overlay);
  if (hovered.kind == PickKind::curve) add_disc(hovered.position, kPlaceRadius * scale, kHoveredPlaceColour, overlay);
  if (const auto gizmo = gizmo_of(document, settings, view); gizmo && !findings.riding)
    add_gizmo(*gizmo, view, scale, hovered.kind, overlay);
  if (const auto ring = spin_ring_of(document, settings, view); ring && !findings.riding)
    add_spin_ring(*ring, scale, overlay);
  const Selected selected(settings);
  for (const PlacedMark& placed : shown_marks(document, derived, settings, view, hovered, selected, findings.riding))
    overlay.marks.push_back(mark_of(placed, settings, scale, selected, hovered));
  if (section_handles_show(settings) && !findings.riding) {
    for (const AngleHandle& ring : angle_handles(document, derived, settings.selected))
      add_angle_handle(ring, scale, hovered.kind == ring.kind, overlay);
    if (const auto handle = section_handle(document, derived, settings.selected))
      add_section_handle(*handle, scale, hovered.kind == PickKind::section, overlay);
  }
  add_failure(derived, findings.failure, view, scale, overlay);
  return overlay;
}

}  // namespace coaster::view
