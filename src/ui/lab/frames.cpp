// Frames: orientation of carts along the track, curvature and torsion of the segment, and where Frenet-Serret fails.
#include <string>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "sim/shape/frame_methods.h"
#include "ui/context/setting_rows.h"
#include "ui/lab/cache.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

BendStudy bend_study(const sim::SegmentShape& shape, world::Entity segment) {
  constexpr int kSamples = 192;
  BendStudy study;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = double(i) / kSamples;
    const auto frame = curve::frenet(shape.key.cubic, t);
    study.s.push_back(shape.arc.distance(t));
    study.curvature.push_back(curve::curvature_if_any(shape.key.cubic, t).value_or(kNoNumber));
    study.torsion.push_back(frame ? frame->torsion : kNoNumber);
  }
  for (const sim::FrenetBreak& at : sim::frenet_breaks(shape, segment))
    if (at.kind == sim::FrenetBreak::Kind::flip && at.t > 0) study.flips.push_back(shape.arc.distance(at.t));
  return study;
}

void bend_plot(Ui& ui, const Probe& probe, const BendStudy& study, bool torsion, float width, float height) {
  const std::vector<double>& values = torsion ? study.torsion : study.curvature;
  const std::uint32_t tint = torsion ? row_colour(4) : row_colour(0);
  const Series series[] = {{"", study.s, values, tint, SeriesKind::line, 2.0f}};
  std::vector<Spot> spots;
  for (const double s : study.flips) spots.push_back({s, 0, kTangentColour, "flip"});
  const double length = probe.shape->arc.length();
  PlotAxis y{.title = torsion ? "torsion" : "curvature", .unit = "1/m", .least_span = 0.001};
  if (!torsion) y.low = 0;
  const auto drag = plot(ui, torsion ? "Torsion plot" : "Curvature plot",
                         {.x = {"s", "m", AxisScale::linear, 0, length > 0 ? length : 1},
                          .y = y,
                          .series = series,
                          .spots = spots,
                          .cursor = probe.shape->arc.distance(probe.t),
                          .empty = "straight: no torsion",
                          .width = width,
                          .height = height},
                         torsion ? "Torsion, det(B', B'', B''') / |B' \u00D7 B''|\u00B2, by arc length: rotation of "
                                   "the Frenet frame about the tangent. Gaps where the frame is undefined."
                                 : "Curvature, |B' \u00D7 B''| / |B'|\u00B3, by arc length. Where it is 0 the Frenet "
                                   "normal is undefined and may flip. A gap at a cusp, where it is unbounded.");
  if (drag) move_probe(ui, probe, probe.shape->arc.parameter(drag->x));
}

void side(Ui& ui, const Probe& probe) {
  const sim::Derived& derived = ui.session().derived;
  const auto formula = base::row_of(ui.session().settings.frames).formula;
  setting_list<&world::Settings::frames>(
      ui, "Frame method###Turned by", fmt::format("Orients trains and the ride camera along the track. {}", formula));
  for (const world::Layer layer :
       {world::Layer::frames, world::Layer::flips, world::Layer::comb, world::Layer::circle}) {
    (void)beside_last(ui, base::row_of(layer).label);
    layer_box(ui, layer);
  }
  read_out(ui, "Curvature", curve::curvature_if_any(probe.shape->key.cubic, probe.t).value_or(kNoNumber), 5, "1/m",
           "Curvature at the probe: 1 / radius of the osculating circle. Unbounded at a cusp.");
  const auto frame = curve::frenet(probe.shape->key.cubic, probe.t);
  read_out(ui, "Torsion", frame ? frame->torsion : kNoNumber, 5, "1/m",
           "Torsion at the probe. Undefined where curvature is 0.");
  const double left_over = base::degrees(sim::loop_twist(derived));
  read_out(ui, "Closing twist###Twist left over",
           derived.closed && !sim::has_cusp(derived) ? fixed(left_over, 2) : "--", "\u00B0",
           "Rotation of a rotation-minimising frame after one lap of a closed track. It is distributed linearly in arc "
           "length.");
  std::size_t flips = 0, undefined = 0;
  for (const sim::FrenetBreak& at : ui.find.breaks()) ++(at.kind == sim::FrenetBreak::Kind::flip ? flips : undefined);
  read_out(ui, "Frenet flips", std::to_string(flips), "", "Number of places where the Frenet normal flips.");
  read_out(ui, "Undefined", std::to_string(undefined), "",
           "Number of stretches without curvature, where the Frenet normal is undefined.");
}

}  // namespace

void frames_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const BendStudy& study =
      ui.lab.bend.get(probe->shape->shape_build, [&] { return bend_study(*probe->shape, probe->segment); });
  Page page(ui, 240);
  side(ui, *probe);
  two_pictures(
      ui, page, [&](float width, float height) { bend_plot(ui, *probe, study, false, width, height); },
      [&](float width, float height) { bend_plot(ui, *probe, study, true, width, height); });
}

}  // namespace coaster::ui
