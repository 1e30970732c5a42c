#include "view/overlay_element.h"

#include <algorithm>
#include <cmath>

#include "sim/plan/elements.h"
#include "sim/solids/track_mesh.h"
#include "view/overlay_lab_parts.h"

namespace coaster::view {
namespace {

using glm::dvec3;
using sim::ElementPoint;

constexpr std::uint32_t kRimColour = 0x1b1f2766;
constexpr double kDashPx = 9;        // px, also of the gaps
constexpr double kPlumbSpacing = 8;  // m along the track; more for long elements
constexpr double kLeastPlumb = 0.5;  // m above the ground

// Interpolates the ideal curve at a distance along it.
class Sampler {
 public:
  explicit Sampler(std::span<const ElementPoint> points) : points_(points) {}
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
struct Sketch {
  const sim::ElementPlan& plan;
  std::span<const sim::Narrow> narrow;
  double rails;  // m above the curve
  Overlay& overlay;
  float scale;

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
    const bool lacks_room = std::any_of(narrow.begin(), narrow.end(),
                                        [&](const sim::Narrow& part) { return part.from <= p.s && p.s <= part.to; });
    return middle(p).y < 0   ? kBuriedColour
           : lacks_room      ? kNarrowColour
           : p.s < plan.lead ? kLeadColour
                             : kElementColour;
  }
};

// Adds rails as short lines, a tie at every other step, and plumb lines.
void add_rails(const Sketch& sketch) {
  const sim::ElementPlan& plan = sketch.plan;
  const double step = std::max(sim::kTieSpacing / 2, plan.length / kMaxElementSteps);
  const int steps = std::max(1, static_cast<int>(std::ceil(plan.length / step)));
  const int plumb = std::max(1, static_cast<int>(std::max(kPlumbSpacing, plan.length / 60) / step));
  Sampler sample(plan.ideal.points);
  ElementPoint before = sample(0);
  for (int i = 1; i <= steps; ++i) {
    const ElementPoint here = sample(plan.length * i / steps);
    const std::uint32_t colour = sketch.colour_at(here);
    for (const double side : {-1.0, 1.0})
      sketch.rimmed(sketch.rail(before, side), sketch.rail(here, side), 2.0f, faded(colour, 0xd0));
    if (i % 2 == 0) sketch.line(sketch.rail(here, -1), sketch.rail(here, 1), 1.25f, faded(colour, 0x70));
    const dvec3 middle = sketch.middle(here);
    if ((i % plumb == 0 || i == steps) && middle.y > kLeastPlumb)
      sketch.line(middle, {middle.x, 0, middle.z}, 1.0f, faded(colour, 0x50));
    before = here;
  }
}

// Adds dashes of about constant length on screen, a power of two in metres.
void add_dashes(const Sketch& sketch, const View& view) {
  const sim::ElementPlan& plan = sketch.plan;
  const std::vector<ElementPoint>& points = plan.ideal.points;
  double px_per_metre = 0;
  const PixelScale scale(view);
  for (std::size_t i = 0; i < points.size(); i += std::max<std::size_t>(1, points.size() / 32))
    px_per_metre = std::max(px_per_metre, scale(points[i].position));
  if (!(px_per_metre > 0)) return;
  const double wanted = std::exp2(std::ceil(std::log2(kDashPx * static_cast<double>(sketch.scale) / px_per_metre)));
  const double dash = std::max(wanted, plan.length / (2 * kMaxElementSteps));
  Sampler sample(points);
  for (double s = 0; s < plan.length; s += 2 * dash) {
    const ElementPoint from = sample(s), to = sample(std::min(s + dash, plan.length));
    sketch.line(from.position, to.position, 2.5f, sketch.colour_at(from));
  }
}

}  // namespace

void add_element(const sim::ElementPlan& plan, std::span<const sim::Narrow> narrow, double rails, const View& view,
                 float scale, Overlay& overlay) {
  if (!plan.refusal.empty() || plan.ideal.points.size() < 2) return;
  const Sketch sketch{plan, narrow, rails, overlay, scale};
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

}  // namespace coaster::view
