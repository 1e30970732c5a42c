// Pages about the cubic at the probe: Construction, Weights and Hodograph.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "curve/bernstein.h"
#include "ui/lab/page_widgets.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

// Row r holds the 4 - r points of level r; row 3 is B(t).
using Triangle = std::array<std::vector<glm::dvec3>, 4>;

Triangle triangle_at(const curve::Cubic& cubic, double t) {
  const auto controls = curve::controls(cubic);
  const curve::DeCasteljauPoints c = curve::construction(cubic, t);
  return {std::vector(controls.begin(), controls.end()),
          std::vector(c.first.begin(), c.first.end()),
          std::vector(c.second.begin(), c.second.end()),
          {c.point}};
}

constexpr std::uint32_t kLevelColours[] = {kPolygonColour, kConstructionColour, 0x5AA9E6, kPointColour};
constexpr int kTraceSamples = 96;

PlotPoints curve_on(const DrawingPlane& sheet, const curve::Cubic& cubic) {
  PlotPoints trace;
  for (int i = 0; i <= kTraceSamples; ++i) trace.add(sheet.at(curve::point(cubic, double(i) / kTraceSamples)));
  return trace;
}

// Returns the sampled parameter whose point in the picture is nearest to a position in it.
double nearest_t(const PlotPoints& curve, PlotDrag place) {
  std::size_t best = 0;
  const auto distance = [&](std::size_t i) {
    return glm::length(glm::dvec2(curve.x[i] - place.x, curve.y[i] - place.y));
  };
  for (std::size_t i = 1; i < curve.x.size(); ++i)
    if (distance(i) < distance(best)) best = i;
  // Refines between two samples: where the chord is nearest.
  const std::size_t a = best == 0 ? 0 : best - 1, b = std::min(best + 1, curve.x.size() - 1);
  const glm::dvec2 from(curve.x[a], curve.y[a]), to(curve.x[b], curve.y[b]), way = to - from;
  const double length2 = glm::dot(way, way);
  const double part =
      length2 > 0 ? std::clamp(glm::dot(glm::dvec2(place.x, place.y) - from, way) / length2, 0.0, 1.0) : 0.5;
  const double t = (static_cast<double>(a) + part * static_cast<double>(b - a)) / kTraceSamples;
  return std::round(t * 1000) / 1000;
}

void numbers_of(Ui& ui, const Probe& probe, const Triangle& triangle) {
  static constexpr const char* kNames[4][4] = {{"p\u2080", "p\u2081", "p\u2082", "p\u2083"},
                                               {"b\u2080\u00B9", "b\u2081\u00B9", "b\u2082\u00B9", ""},
                                               {"b\u2080\u00B2", "b\u2081\u00B2", "", ""},
                                               {"B(t)", "", "", ""}};
  static constexpr const char* kPaths[4][4] = {{"p0", "p1", "p2", "p3"},
                                               {"b0 level 1", "b1 level 1", "b2 level 1", ""},
                                               {"b0 level 2", "b1 level 2", "", ""},
                                               {"B(t)", "", "", ""}};
  triple_heading(ui, "m");
  for (std::size_t back = 0; back < 4; ++back) {
    const std::size_t r = 3 - back;
    for (std::size_t i = 0; i + r < 4; ++i)
      triple(ui, kPaths[r][i], kNames[r][i], kLevelColours[r], triangle[r][i], 3, "m",
             r == 0 ? "A control point."
                    : "(1 - t) times the previous point of the level above plus t times the next one.");
    if (r == 3)
      triple(ui, "Tangent", "T(t)", kTangentColour, curve::unit_tangent(probe.shape->key.cubic, probe.t), 3, "",
             "The unit tangent, along the last line of the construction.");
  }
}

void picture(Ui& ui, const Probe& probe, const Triangle& triangle, float height) {
  const curve::Cubic& cubic = probe.shape->key.cubic;
  const DrawingPlane sheet = sheet_of(triangle[0]);
  const PlotPoints curve = curve_on(sheet, cubic);
  std::array<PlotPoints, 3> levels;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t i = 0; i + r < 4; ++i) levels[r].add(sheet.at(triangle[r][i]));
  const glm::dvec2 at = sheet.at(triangle[3][0]),
                   tangent = sheet.at(sheet.origin + curve::unit_tangent(cubic, probe.t));
  const double reach = 0.18 * glm::length(glm::dvec3(cubic.p3) - glm::dvec3(cubic.p0));
  PlotPoints arrow;
  arrow.add(at);
  arrow.add(at + reach * tangent);
  const Series series[] = {
      {"control polygon", levels[0].x, levels[0].y, kLevelColours[0], SeriesKind::line_and_points, 1.5f},
      {"level 1", levels[1].x, levels[1].y, kLevelColours[1], SeriesKind::line_and_points, 1.5f},
      {"level 2", levels[2].x, levels[2].y, kLevelColours[2], SeriesKind::line_and_points, 1.5f},
      {"curve", curve.x, curve.y, kCurveColour, SeriesKind::line, 2.2f},
      {"tangent", arrow.x, arrow.y, kTangentColour, SeriesKind::line, 2.2f}};
  const Spot spots[] = {{at.x, at.y, kPointColour, "B(t)"}};
  const auto drag =
      plot(ui, "Construction plot",
           {.x = {"along", "m"},
            .y = {"", "m"},
            .series = series,
            .spots = spots,
            .square = true,
            .drags_point = true,
            .value = significant(probe.t, 6, false),
            .height = height},
           "The four control points, projected onto their best-fit plane. Drag to move the probe along the curve.");
  if (drag) move_probe(ui, probe, nearest_t(curve, *drag));
}

constexpr int kLargestDegree = 8;

std::string subscript(std::size_t digit) {
  std::string text = "\u2080";
  text.back() = static_cast<char>(text.back() + static_cast<char>(digit));
  return text;
}

BasisStudy basis_study(int degree) {
  constexpr int kSamples = 160;
  BasisStudy study;
  study.y.resize(static_cast<std::size_t>(degree) + 1);
  std::vector<double> weights(study.y.size());
  for (int k = 0; k <= kSamples; ++k) {
    const double t = double(k) / kSamples;
    study.t.push_back(t);
    curve::bernstein_basis<double>(t, weights);
    for (std::size_t i = 0; i < weights.size(); ++i) study.y[i].push_back(weights[i]);
  }
  return study;
}

void weights_plot(Ui& ui, const Probe& probe, int degree, const std::vector<double>& weights, float height) {
  const BasisStudy& study = ui.lab.basis.get(degree, [&] { return basis_study(degree); });
  std::vector<Series> series;
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    series.push_back({"B" + subscript(i), study.t, study.y[i], row_colour(i), SeriesKind::line, 2.0f});
    spots.push_back({probe.t, weights[i], row_colour(i), ""});
  }
  plot_over_t(
      ui, probe, "Weights plot",
      {.x = {}, .y = {"weight", "", AxisScale::linear, 0, 1}, .series = series, .spots = spots, .height = height},
      "B_i,n(t) = C(n,i) t^i (1-t)^(n-i): never negative, with sum 1 for every t. Drag the cursor to move the probe.");
}

constexpr int kHodographSamples = 96;

struct Derivative {
  PlotPoints curve;  // B'(t) in its sheet
  std::vector<double> t, size;
  PlotPoints probe;    // from the origin to B'(t) at the probe
  PlotPoints control;  // its control polygon: 3 (p1 - p0), 3 (p2 - p1), 3 (p3 - p2)
};

Derivative derivative_of(const Probe& probe) {
  const curve::Cubic& c = probe.shape->key.cubic;
  const glm::dvec3 p0(c.p0), p1(c.p1), p2(c.p2), p3(c.p3);
  const std::array<glm::dvec3, 4> points{glm::dvec3(0), 3.0 * (p1 - p0), 3.0 * (p2 - p1), 3.0 * (p3 - p2)};
  const DrawingPlane sheet = sheet_of(points);
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
  const LevelLine mean{"mean", probe.shape->arc.length(), kConstructionColour};
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

void construction_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const Triangle triangle = triangle_at(probe->shape->key.cubic, probe->t);
  PageLayout page(ui, 220);
  probe_slider(ui, *probe);
  layer_box(ui, world::Layer::construction);
  numbers_of(ui, *probe, triangle);
  picture(ui, *probe, triangle, page.pictures());
}

void weights_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const int degree = ui.lab.degree;
  std::vector<double> weights(static_cast<std::size_t>(degree) + 1);
  curve::bernstein_basis<double>(probe->t, weights);
  PageLayout page(ui, 200);
  probe_slider(ui, *probe);
  if (const auto to = slider(ui, "Degree n", degree, 1, kLargestDegree, false,
                             "Degree of the basis, 1 to 8. The track's curves are cubic: n = 3."))
    ui.lab.degree = std::clamp(*to, 1, kLargestDegree);
  for (std::size_t i = 0; i < weights.size(); ++i)
    colour_value(ui, row_colour(i), fmt::format("B{}", i),
                 fmt::format("B{}{}{}", subscript(i), degree == 3 ? " weighs p" : "", degree == 3 ? subscript(i) : ""),
                 fixed(weights[i], 4),
                 "C(n,i) t^i (1-t)^(n-i) at the probe: the weight of this control point in B(t).");
  weights_plot(ui, *probe, degree, weights, page.pictures());
}

void hodograph_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const Derivative d = derivative_of(*probe);
  const glm::dvec3 b = curve::derivative(probe->shape->key.cubic, probe->t);
  PageLayout page(ui, 220);
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
