// Marks and thin lines of one frame.
#include "view/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/ground/ground.h"
#include "sim/plan/element_plan.h"
#include "sim/shape/rails.h"
#include "sim/solids/coaster_form.h"
#include "view/gizmo.h"
#include "view/marks.h"
#include "view/overlay_detail.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::view {

bool selects_sections(const world::Settings& settings) { return settings.panels->workspace == world::Workspace::build; }

namespace {

// True if knots show that are neither selected nor under the cursor: not in Ride, and not with their layer off.
bool shows_knots(const world::Settings& settings) {
  return settings.panels->workspace != world::Workspace::ride && settings.lab->layers.has(world::Layer::knots);
}

using glm::dvec3;
using sim::ElementPoint;

constexpr std::uint32_t kRimColour = 0x1b1f2766;
constexpr double kDashPx = 9;        // px, also of the gaps
constexpr double kTieLines = 1.5;    // m between the lines that stand for ties
constexpr double kPlumbSpacing = 8;  // m along the track; more for long elements
constexpr double kLeastPlumb = 0.5;  // m above the ground

// Interpolates the ideal curve at a distance along it.
class ArcLengthInterpolator {
 public:
  explicit ArcLengthInterpolator(std::span<const ElementPoint> points) : points_(points) {}
  // Distances must not decrease between calls.
  ElementPoint operator()(double s) {
    while (next_ + 1 < points_.size() && points_[next_].s < s) ++next_;
    const ElementPoint &a = points_[next_ - 1], &b = points_[next_];
    const double share = b.s > a.s ? std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0) : 0.0;
    ElementPoint p = a;
    p.s = s;
    p.position = glm::mix(a.position, b.position, share);
    p.tangent = glm::normalize(glm::mix(a.tangent, b.tangent, share));
    p.up = curve::perpendicular(p.tangent, glm::mix(a.up, b.up, share));
    return p;
  }

 private:
  std::span<const ElementPoint> points_;
  std::size_t next_ = 1;
};

// The preview under construction.
struct PreviewDrawing {
  const sim::ElementPlan& plan;
  std::span<const sim::LineConflict> narrow;
  double rails;  // m above the curve
  Overlay& overlay;
  float scale;
  const sim::Ground* ground;

  bool buried(dvec3 at) const { return ground != nullptr ? ground->land().depth(at) > 0 : at.y < 0; }
  dvec3 middle(const ElementPoint& p) const { return p.position + rails * p.up; }
  dvec3 rail(const ElementPoint& p, double side) const {
    return middle(p) + (0.5 * side * sim::kGauge) * glm::cross(p.up, p.tangent);
  }

  void line(dvec3 from, dvec3 to, float width_px, std::uint32_t rgba) const {
    add_line(from, to, width_px * scale, rgba, overlay);
  }
  void rimmed(dvec3 from, dvec3 to, float width_px, std::uint32_t rgba) const {
    line(from, to, width_px + 2, kRimColour);
    line(from, to, width_px, rgba);
  }
  std::uint32_t colour_at(const ElementPoint& p) const {
    const bool lacks_room = std::any_of(narrow.begin(), narrow.end(), [&](const sim::LineConflict& part) {
      return part.from <= p.s && p.s <= part.to;
    });
    return buried(middle(p)) ? kBuriedColour
           : lacks_room      ? kNarrowColour
           : p.s < plan.lead ? kLeadColour
                             : kElementColour;
  }
};

// Adds rails as short lines, a tie at every other step, and plumb lines.
void add_rails(const PreviewDrawing& sketch) {
  const sim::ElementPlan& plan = sketch.plan;
  const double step = std::max(kTieLines / 2, plan.length / kMaxElementSteps);
  const int steps = std::max(1, static_cast<int>(std::ceil(plan.length / step)));
  const int plumb = std::max(1, static_cast<int>(std::max(kPlumbSpacing, plan.length / 60) / step));
  ArcLengthInterpolator sample(plan.ideal.points);
  ElementPoint before = sample(0);
  for (int i = 1; i <= steps; ++i) {
    const ElementPoint here = sample(plan.length * i / steps);
    const std::uint32_t colour = sketch.colour_at(here);
    for (const double side : {-1.0, 1.0})
      sketch.rimmed(sketch.rail(before, side), sketch.rail(here, side), 2.0f, faded(colour, 0xd0));
    if (i % 2 == 0) sketch.line(sketch.rail(here, -1), sketch.rail(here, 1), 1.25f, faded(colour, 0x70));
    const dvec3 middle = sketch.middle(here);
    const double foot = surface_at(sketch.ground, middle.x, middle.z);
    if ((i % plumb == 0 || i == steps) && middle.y > foot + kLeastPlumb)
      sketch.line(middle, {middle.x, foot, middle.z}, 1.0f, faded(colour, 0x50));
    before = here;
  }
}

// Adds dashes of about constant length on screen, a power of two in metres.
void add_dashes(const PreviewDrawing& sketch, const View& view) {
  const sim::ElementPlan& plan = sketch.plan;
  const std::vector<ElementPoint>& points = plan.ideal.points;
  double px_per_metre = 0;
  const PixelScale scale(view);
  for (std::size_t i = 0; i < points.size(); i += std::max<std::size_t>(1, points.size() / 32))
    px_per_metre = std::max(px_per_metre, scale(points[i].position));
  if (!(px_per_metre > 0)) return;
  const double wanted = std::exp2(std::ceil(std::log2(kDashPx * static_cast<double>(sketch.scale) / px_per_metre)));
  const double dash = std::max(wanted, plan.length / (2 * kMaxElementSteps));
  ArcLengthInterpolator sample(points);
  for (double s = 0; s < plan.length; s += 2 * dash) {
    const ElementPoint from = sample(s), to = sample(std::min(s + dash, plan.length));
    sketch.line(from.position, to.position, 2.5f, sketch.colour_at(from));
  }
}

using world::Entity;

struct LineLook {
  float width;  // points
  std::uint32_t colour;
};
constexpr LineLook kSelectedLine{5, 0xff8a1fcc}, kHoveredLine{2, 0xffffffb0};

void add_run(const sim::DerivedTrack& derived, const world::SectionRun& run, std::size_t most, const LineLook& look,
             float scale, Overlay& overlay) {
  constexpr std::size_t kMostSteps = 16;  // per segment
  const auto steps = static_cast<int>(std::clamp<std::size_t>(most / run.count, 1, kMostSteps));
  for (std::size_t i = run.first; i < run.end(); ++i) {
    const auto at = [&](double t) { return sim::rails_point(derived.shape_at(i), t); };
    add_curve(at, 0, 1, steps, look.width * scale, look.colour, overlay);
  }
}

// Returns the section to mark under the mouse, or kNone.
Entity hovered_section(const world::Document& document, const world::Settings& settings, const Pick& hovered) {
  if (!selects_sections(settings)) return world::kNone;
  Entity section;
  if (const auto* const segment = document.entities.find<world::Segment>(hovered.entity)) section = segment->section;
  if (!section.valid() || world::is_free(document, section) || world::is_selected(settings, section))
    return world::kNone;
  return section;
}

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
std::vector<PlacedMark> shown_marks(const world::Document& document, const sim::DerivedTrack& derived,
                                    const world::Settings& settings, const View& view, const Pick& hovered,
                                    const SelectionLookup& selected, bool riding) {
  const MarkChoice choice{!riding && shows_knots(settings), !riding, hovered};
  std::vector<PlacedMark> marks = marks_on_screen(document, derived, settings, view, selected, choice).marks;
  std::sort(marks.begin(), marks.end(), [](const PlacedMark& a, const PlacedMark& b) { return covers(b, a); });
  return marks;
}

Mark mark_of(const PlacedMark& placed, const world::Settings& settings, float scale, const SelectionLookup& selected,
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
void add_failure(const sim::DerivedTrack& derived, const world::RideFailure& failure, const View& view, float scale,
                 Overlay& overlay) {
  if (failure.kind == world::FailureKind::none || derived.order.empty()) return;
  std::array<glm::dvec2, 14> cross;
  for (int i = 0; i < 7; ++i)
    for (const int side : {0, 1})
      cross[static_cast<std::size_t>(2 * i + side)] = 1.35 * (i - 3) * glm::dvec2(1, 2 * side - 1);
  add_sign(over_rails(derived, failure.distance, kFailureHeight), kFailureColour, cross, view, scale, overlay);
}

}  // namespace

void add_element(const sim::ElementPlan& plan, std::span<const sim::LineConflict> narrow, double rails,
                 const View& view, float scale, Overlay& overlay, const sim::Ground* ground) {
  if (!plan.refusal.empty() || plan.ideal.points.size() < 2) return;
  const PreviewDrawing sketch{plan, narrow, rails, overlay, scale, ground};
  add_rails(sketch);
  add_dashes(sketch, view);
  const ElementPoint& end = plan.ideal.points.back();
  add_arrow(end.position, end.tangent, std::clamp(0.05 * plan.length, 3.0, 12.0), view, 3.0f * scale, kElementColour,
            overlay);
  constexpr std::size_t kMostKnots = 400;
  const std::vector<world::Knot>& knots = plan.fit.knots;
  for (std::size_t k = 1; k < knots.size() && knots.size() <= kMostKnots; ++k) {
    add_disc(knots[k].position, 4.0f * scale, 0x1b1f27ff, overlay);
    add_disc(knots[k].position, 3.0f * scale, kElementColour, overlay);
  }
}

void add_sections(const world::Document& document, const sim::DerivedTrack& derived, const world::Settings& settings,
                  const View& view, const Pick& hovered, Overlay& overlay) {
  const float scale = mark_scale(settings, view);
  if (const Entity section = hovered_section(document, settings, hovered); section.valid())
    add_run(derived, world::run_of(document, section), kMaxSectionLines, kHoveredLine, scale, overlay);
  const std::vector<world::SectionRun> selected = world::selected_runs(document, settings);
  for (const world::SectionRun& run : selected)
    add_run(derived, run, kMaxSectionLines / selected.size(), kSelectedLine, scale, overlay);
}

Overlay build_overlay(const world::Document& document, const sim::DerivedTrack& derived,
                      const world::Settings& settings, const View& view, const Pick& hovered,
                      const MarkedFindings& findings) {
  Overlay overlay;
  add_laboratory(document, derived, settings, view, findings, overlay);
  const float scale = mark_scale(settings, view);
  const double rails = world::rails_height(document);
  if (findings.element) add_element(*findings.element, findings.narrow, rails, view, scale, overlay, findings.ground);
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
  const SelectionLookup selected(settings);
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
