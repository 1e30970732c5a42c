// Construction: de Casteljau's triangle at the probe, as a picture in the plane of the control points and as numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "curve/bernstein.h"
#include "ui/lab/page_parts.h"
#include "ui/lab/shapes.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

// Row r holds the 4 - r points of level r; row 3 is B(t).
using Triangle = std::array<std::vector<glm::dvec3>, 4>;

Triangle triangle_at(const curve::Cubic& cubic, double t) {
  const auto controls = curve::controls(cubic);
  const curve::Construction c = curve::construction(cubic, t);
  return {std::vector(controls.begin(), controls.end()),
          std::vector(c.first.begin(), c.first.end()),
          std::vector(c.second.begin(), c.second.end()),
          {c.point}};
}

constexpr std::uint32_t kLevelColours[] = {kPolygonColour, kConstructionColour, 0x5AA9E6, kPointColour};
constexpr int kTraceSamples = 96;

Trace curve_on(const Sheet& sheet, const curve::Cubic& cubic) {
  Trace trace;
  for (int i = 0; i <= kTraceSamples; ++i) trace.add(sheet.at(curve::point(cubic, double(i) / kTraceSamples)));
  return trace;
}

// Returns the sampled parameter whose point in the picture is nearest to a position in it.
double nearest_t(const Trace& curve, PlotDrag place) {
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
  const Sheet sheet = sheet_of(triangle[0]);
  const Trace curve = curve_on(sheet, cubic);
  std::array<Trace, 3> levels;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t i = 0; i + r < 4; ++i) levels[r].add(sheet.at(triangle[r][i]));
  const glm::dvec2 at = sheet.at(triangle[3][0]),
                   tangent = sheet.at(sheet.origin + curve::unit_tangent(cubic, probe.t));
  const double reach = 0.18 * glm::length(glm::dvec3(cubic.p3) - glm::dvec3(cubic.p0));
  Trace arrow;
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

}  // namespace

void construction_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const Triangle triangle = triangle_at(probe->shape->key.cubic, probe->t);
  Page page(ui, 220);
  probe_slider(ui, *probe);
  layer_box(ui, world::Layer::construction);
  numbers_of(ui, *probe, triangle);
  picture(ui, *probe, triangle, page.pictures());
}

}  // namespace coaster::ui
