// The pictures of one position or segment: construction, circle, rounding. Those along the track are in
// overlay_lab_track.cpp.
#include "view/overlay_lab.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "curve/bernstein.h"
#include "sim/study/rounding.h"
#include "view/overlay_lab_parts.h"
#include "world/evaluation.h"
#include "world/lab_view.h"

namespace coaster::view {
namespace {

constexpr double kMaxOffset = 1e4;  // m, limit of a magnified error

// Returns the segments whose rounding is shown, with at most kMaxRoundingVertices together.
std::vector<world::Entity> rounded_segments(const world::Document& document, const sim::Derived& derived,
                                            const world::Settings& settings) {
  const std::vector<world::Entity> selected = selected_segments(document, settings.selected);
  if (!selected.empty()) return selected;
  const auto most = static_cast<std::size_t>(kMaxRoundingVertices / (settings.evaluation->steps + 1));
  return {derived.order.begin(),
          derived.order.begin() + static_cast<std::ptrdiff_t>(std::min(most, derived.order.size()))};
}

void add_rounding(const sim::SegmentShape& shape, const world::Settings& settings, float scale, Overlay& overlay) {
  constexpr std::size_t kWhiskers = 64;
  const sim::Rounding r =
      sim::rounding(shape.curve, base::row_of(settings.evaluation->evaluator), settings.evaluation->steps);
  const std::size_t last = r.exact.size() - 1;
  std::vector<glm::dvec3> moved(r.exact.size());
  for (std::size_t i = 0; i <= last; ++i) {
    glm::dvec3 offset = settings.lab->magnification * r.error[i];
    const double size = glm::length(offset);
    if (size > kMaxOffset) offset *= kMaxOffset / size;
    moved[i] = r.exact[i] + offset;
  }
  const std::size_t every = last / kWhiskers + 1;
  for (std::size_t i = every; i < last; i += every)
    add_line(r.exact[i], moved[i], 1.0f * scale, faded(kRoundingColour, 0x60), overlay);
  for (std::size_t i = 0; i + 1 < last; ++i) add_line(moved[i], moved[i + 1], 1.75f * scale, kRoundingColour, overlay);
  add_line(moved[last - 1], moved[last], 3.0f * scale, kSeamColour, overlay);
  if (last > 1) add_disc(moved[last - 1], 3.5f * scale, kSeamColour, overlay);
}

// Appends a layer's lines, each over a dark rim, so that they read on sky, ground and rails. Layers with thousands of
// lines have no rims.
void append_rimmed(const Overlay& layer, float scale, Overlay& overlay) {
  constexpr std::size_t kFew = 2500;
  constexpr std::uint32_t kDiscRimColour = 0x1b1f2778;
  constexpr float kThin = 1.5f, kDiscRim = 2.0f;  // px at scale 1: lines are rimmed from this width on; rim of discs
  if (layer.lines.size() <= kFew)
    for (const Line& one : layer.lines)
      if (one.width_px >= kThin * scale && (one.rgba & 0xffu) == 0xffu)
        overlay.lines.push_back({one.from, one.to, one.width_px + kDiscRim * scale, kDiscRimColour});
  overlay.lines.insert(overlay.lines.end(), layer.lines.begin(), layer.lines.end());
  overlay.marks.insert(overlay.marks.end(), layer.marks.begin(), layer.marks.end());
}

}  // namespace

void add_construction(const sim::SegmentShape& shape, double t, const View& view, float scale, Overlay& overlay) {
  const curve::Construction c = curve::construction(shape.key.cubic, t);
  add_line(c.first[0], c.first[1], 2.25f * scale, kConstructionColour, overlay);
  add_line(c.first[1], c.first[2], 2.25f * scale, kConstructionColour, overlay);
  add_line(c.second[0], c.second[1], 2.75f * scale, kConstructionColour, overlay);
  // The last two points span the tangent: B'(t) = 3 (second[1] - second[0]).
  const double third = glm::length(c.second[1] - c.second[0]);
  add_arrow(c.point, curve::unit_tangent(shape.key.cubic, t), third, view, 2.75f * scale, kTangentColour, overlay);
  for (const glm::dvec3 at : c.first) add_disc(at, 3.5f * scale, kConstructionColour, overlay);
  for (const glm::dvec3 at : c.second) add_disc(at, 4.25f * scale, kConstructionColour, overlay);
  add_disc(c.point, 5.5f * scale, kTangentColour, overlay);
}

void add_circle(const sim::SegmentShape& shape, double t, float scale, Overlay& overlay) {
  const std::optional<curve::FrenetFrame> frame = curve::frenet(shape.key.cubic, t);
  if (!frame || !(frame->curvature * kMaxRadius > 1)) return;
  const double radius = 1 / frame->curvature;
  const glm::dvec3 touch = curve::point(shape.key.cubic, t), centre = touch + radius * frame->normal;
  glm::dvec3 before = touch;
  for (int i = 1; i <= kCircleSides; ++i) {
    const double angle = 2 * base::kPi * i / kCircleSides;
    const glm::dvec3 at = i == kCircleSides
                              ? touch
                              : centre + radius * (std::sin(angle) * frame->tangent - std::cos(angle) * frame->normal);
    add_line(before, at, 2.25f * scale, kCircleColour, overlay);
    before = at;
  }
  add_line(centre, touch, 1.25f * scale, faded(kCircleColour, 0xa0), overlay);
  add_disc(centre, 3.0f * scale, kCircleColour, overlay);
}

void add_rounding(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                  const View& view, Overlay& overlay) {
  for (const world::Entity e : rounded_segments(document, derived, settings))
    add_rounding(derived.shape(e), settings, mark_scale(settings, view), overlay);
}

void add_laboratory(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                    const View& view, const Findings& findings, Overlay& overlay) {
  using world::Layer;
  const float scale = mark_scale(settings, view);
  const sim::SegmentShape* const probed = derived.segments.find(settings.selected);
  const double t = settings.selected_t;
  const auto layer = [&](Layer which, bool possible, auto add) {
    if (!possible || !settings.lab->layers.has(which)) return;
    Overlay drawn;
    add(drawn);
    append_rimmed(drawn, scale, overlay);
  };
  layer(Layer::comb, true, [&](Overlay& o) { add_comb(derived, settings, view, o); });
  layer(Layer::frames, true, [&](Overlay& o) { add_frames(derived, settings, view, o); });
  layer(Layer::flips, true, [&](Overlay& o) { add_breaks(derived, findings.breaks, view, scale, o); });
  layer(Layer::conflicts, !findings.riding, [&](Overlay& o) {
    add_conflicts(derived, findings.conflicts, view, scale, o);
    add_folds(derived, findings.folds, view, scale, o);
    add_folds(derived, findings.tight_bends, view, scale, o);
  });
  layer(Layer::limits, true, [&](Overlay& o) {
    add_spans(derived, findings.spans, scale, o);
    add_jolts(derived, findings.jolts, view, scale, o);
  });
  layer(Layer::rounding, true, [&](Overlay& o) { add_rounding(document, derived, settings, view, o); });
  layer(Layer::circle, probed != nullptr, [&](Overlay& o) { add_circle(*probed, t, scale, o); });
  layer(Layer::construction, probed != nullptr, [&](Overlay& o) { add_construction(*probed, t, view, scale, o); });
}

}  // namespace coaster::view
