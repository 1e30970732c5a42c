// Hodograph: the derivative B'(t) as a curve, and its length by t.
#include <array>

#include "ui/lab/page_parts.h"
#include "ui/lab/shapes.h"

namespace coaster::ui {
namespace {

constexpr int kHodographSamples = 96;

struct Derivative {
  Trace curve;  // B'(t) in its sheet
  std::vector<double> t, size;
  Trace probe;    // from the origin to B'(t) at the probe
  Trace control;  // its control polygon: 3 (p1 - p0), 3 (p2 - p1), 3 (p3 - p2)
};

Derivative derivative_of(const Probe& probe) {
  const curve::Cubic& c = probe.shape->key.cubic;
  const glm::dvec3 p0(c.p0), p1(c.p1), p2(c.p2), p3(c.p3);
  const std::array<glm::dvec3, 4> points{glm::dvec3(0), 3.0 * (p1 - p0), 3.0 * (p2 - p1), 3.0 * (p3 - p2)};
  const Sheet sheet = sheet_of(points);
  Derivative result;
  for (int i = 0; i <= kHodographSamples; ++i) {
    const double t = double(i) / kHodographSamples;
    const glm::dvec3 d = curve::derivative(c, t);
    result.curve.add(sheet.at(d));
    result.t.push_back(t);
    result.size.push_back(glm::length(d));
  }
  for (std::size_t i = 1; i < 4; ++i) result.control.add(sheet.at(points[i]));
  result.probe.add({0, 0});
  result.probe.add(sheet.at(curve::derivative(c, probe.t)));
  return result;
}

void shape_plot(Ui& ui, const Probe& probe, const Derivative& d, float width, float height) {
  const Series series[] = {
      {"control points", d.control.x, d.control.y, kPolygonColour, SeriesKind::line_and_points, 1.3f},
      {"B'", d.curve.x, d.curve.y, kCurveColour, SeriesKind::line, 2.2f},
      {"", d.probe.x, d.probe.y, kTangentColour, SeriesKind::line, 2.0f}};
  const Spot spots[] = {{0, 0, 0x9AA3B2, "0"}, {d.probe.x[1], d.probe.y[1], kPointColour, ""}};
  (void)plot(ui, "Hodograph plot",
             {.x = {"B'", "m"},
              .y = {"B' in its plane", "m"},
              .series = series,
              .spots = spots,
              .square = true,
              .value = significant(probe.t, 6, false),
              .width = width,
              .height = height},
             "The hodograph: B'(t) = 3 [(1-t)\u00B2 (p1-p0) + 2t(1-t) (p2-p1) + t\u00B2 (p3-p2)], drawn from the "
             "origin in its best-fit plane. Where it passes through the origin the curve has a cusp.");
}

void size_plot(Ui& ui, const Probe& probe, const Derivative& d, float width, float height) {
  const Series series[] = {{"", d.t, d.size, kCurveColour, SeriesKind::line, 2.0f}};
  const Spot spots[] = {{probe.t, glm::length(curve::derivative(probe.shape->key.cubic, probe.t)), kPointColour, ""}};
  const Level mean{"mean", probe.shape->arc.length(), kConstructionColour};
  plot_over_t(ui, probe, "Speed plot",
              {.x = {},
               .y = {"|B'(t)|", "m", AxisScale::linear, 0, {}},
               .series = series,
               .levels = {&mean, 1},
               .spots = spots,
               .width = width,
               .height = height},
              "Parametric speed |B'(t)|. Its mean over t is the arc length. Drag the cursor to move the probe.");
}

}  // namespace

void hodograph_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const Derivative d = derivative_of(*probe);
  const glm::dvec3 b = curve::derivative(probe->shape->key.cubic, probe->t);
  Page page(ui, 220);
  probe_slider(ui, *probe);
  triple_heading(ui, "m");
  triple(ui, "B'(t)", "B'(t)", kTangentColour, b, 3, "m", "The derivative with respect to t at the probe.");
  triple(ui, "B''(t)", "B''(t)", kConstructionColour, curve::second_derivative(probe->shape->key.cubic, probe->t), 3,
         "m", "The second derivative at the probe.");
  read_out(ui, "|B'(t)|", glm::length(b), 3, "m", "Length of track per unit of t at the probe.");
  read_out(ui, "Curvature", curve::curvature_if_any(probe->shape->key.cubic, probe->t).value_or(kNoNumber), 5, "1/m",
           "|B' \u00D7 B''| / |B'|\u00B3.");
  two_pictures(
      ui, page, [&](float width, float height) { shape_plot(ui, *probe, d, width, height); },
      [&](float width, float height) { size_plot(ui, *probe, d, width, height); });
}

}  // namespace coaster::ui
