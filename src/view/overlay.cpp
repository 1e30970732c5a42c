// Marks and thin lines of one frame.
#include "view/overlay.h"

#include <algorithm>
#include <array>

#include "view/gizmo.h"
#include "view/marks.h"
#include "view/overlay_element.h"
#include "view/overlay_lab.h"
#include "view/overlay_lab_parts.h"
#include "world/lab_view.h"
#include "world/look.h"
#include "world/selection.h"

namespace coaster::view {
namespace {

constexpr std::uint32_t kKnotColour = 0xffffffff, kSelectedColour = 0xff8a1fff, kAlsoColour = 0xffc08aff,
                        kHandleColour = 0xf2b84bff, kHandleHovered = 0xffdc96ff;
constexpr std::uint32_t kPolygonColour = 0xf2b84bff, kPlaceColour = 0xff8a1fff, kHoveredPlaceColour = 0xffffffff;
constexpr std::uint32_t kFailureColour = 0xd7263dff;
constexpr double kFailureHeight = 1.6;  // m above the rails: above the car
constexpr float kHoveredGrowth = 1.35f;
constexpr float kPlaceRadius = 4.5f;  // px
constexpr float kLineWidth = 1.5f;    // px

// Returns the segments whose control polygon is shown: the selected one, or those at the selected knot.
std::vector<world::Entity> shown_segments(const world::Document& document, world::Entity selected) {
  if (document.entities.find<world::Segment>(selected)) return {selected};
  std::vector<world::Entity> out;
  if (!document.entities.find<world::Knot>(selected)) return out;
  const world::Neighbours at = world::neighbours(document, selected);
  if (at.before.valid()) out.push_back(at.before);
  if (at.after.valid()) out.push_back(at.after);
  return out;
}

void add_line(glm::vec3 from, glm::vec3 to, float scale, Overlay& overlay) {
  overlay.lines.push_back({from, to, kLineWidth * scale, kPolygonColour});
}

// Adds control polygons and the handles of the shown knots; no line twice.
void add_polygons(const world::Document& document, const world::Settings& settings, Overlay& overlay) {
  const float scale = settings.look->ui_scale;
  const std::vector<world::Entity> knots = knots_with_handles(document, settings);
  const auto has_handles = [&](world::Entity e) { return std::find(knots.begin(), knots.end(), e) != knots.end(); };
  for (const world::Entity e : shown_segments(document, settings.selected)) {
    const world::Segment& segment = world::segment(document, e);
    const curve::Cubic c = world::cubic_of(document, e);
    if (!has_handles(segment.from)) add_line(c.p0, c.p1, scale, overlay);
    add_line(c.p1, c.p2, scale, overlay);
    if (!has_handles(segment.to)) add_line(c.p2, c.p3, scale, overlay);
  }
  for (const world::Entity e : knots) {
    const world::Knot& knot = world::knot(document, e);
    add_line(world::in_handle(knot), knot.position, scale, overlay);
    add_line(knot.position, world::out_handle(knot), scale, overlay);
  }
}

Mark mark_of(const PlacedMark& placed, const world::Settings& settings, const Pick& hovered) {
  const bool under_cursor = hovered == Pick{placed.kind, placed.knot};
  const float growth = (under_cursor ? kHoveredGrowth : 1.0f) * settings.look->ui_scale;
  if (placed.kind != PickKind::knot)
    return {placed.position, kHandleHalf * growth, under_cursor ? kHandleHovered : kHandleColour, MarkShape::square};
  return {placed.position, kKnotRadius * growth,
          placed.knot == settings.selected            ? kSelectedColour
          : world::is_selected(settings, placed.knot) ? kAlsoColour
                                                      : kKnotColour,
          MarkShape::disc};
}

// Adds a red disc with a cross above the rails.
void add_failure(const sim::Derived& derived, const world::Failure& failure, const View& view, float scale,
                 Overlay& overlay) {
  if (failure.kind == world::FailureKind::none || derived.order.empty()) return;
  const sim::TrackPlace place = sim::place_at(derived, failure.distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[place.index]);
  const glm::dvec3 at =
      curve::point(shape.key.cubic, shape.arc.parameter(place.s)) + kFailureHeight * sim::frame_at(shape, place.s).up;
  std::array<glm::dvec2, 14> cross;
  for (int i = 0; i < 7; ++i)
    for (const int side : {0, 1})
      cross[static_cast<std::size_t>(2 * i + side)] = 1.35 * (i - 3) * glm::dvec2(1, 2 * side - 1);
  add_sign(at, kFailureColour, cross, view, scale, overlay);
}

}  // namespace

Overlay build_overlay(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                      const View& view, const Pick& hovered, const Findings& findings) {
  Overlay overlay;
  add_laboratory(document, derived, settings, view, findings, overlay);
  const float scale = settings.look->ui_scale;
  if (findings.element) add_element(*findings.element, findings.narrow, view, scale, overlay);
  add_polygons(document, settings, overlay);
  // The picked position is no pickable mark, so it lies under all that are.
  if (const sim::SegmentShape* const shape = derived.segments.find(settings.selected))
    overlay.marks.push_back({glm::vec3(curve::point(shape->key.cubic, settings.selected_t)), kPlaceRadius * scale,
                             kPlaceColour, MarkShape::disc});
  if (hovered.kind == PickKind::curve)
    overlay.marks.push_back({hovered.position, kPlaceRadius * scale, kHoveredPlaceColour, MarkShape::disc});
  if (const auto gizmo = gizmo_of(document, settings, view); gizmo && !findings.riding)
    add_gizmo(*gizmo, view, scale, hovered.kind, overlay);
  std::vector<PlacedMark> marks = marks_on_screen(document, settings, view);
  std::sort(marks.begin(), marks.end(), [](const PlacedMark& a, const PlacedMark& b) { return covers(b, a); });
  for (const PlacedMark& placed : marks)
    if ((!findings.riding && settings.lab->layers.has(world::Layer::knots)) ||
        world::is_selected(settings, placed.knot) || hovered == Pick{placed.kind, placed.knot})
      overlay.marks.push_back(mark_of(placed, settings, hovered));
  add_failure(derived, findings.failure, view, scale, overlay);
  return overlay;
}

}  // namespace coaster::view
