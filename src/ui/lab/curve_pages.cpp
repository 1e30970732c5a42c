// Pages about the cubic at the probe: Construction, Weights and Hodograph. Pages about frames along the track and the
// joints of its segments: Frames and Joints.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "base/portable_math.h"
#include "curve/bernstein.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_settings.h"
#include "sim/shape/folds.h"
#include "sim/shape/frame_methods.h"
#include "sim/study/jolt.h"
#include "sim/study/track_errata.h"
#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"
#include "ui/lab/page_widgets.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/table.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

using Triangle = std::array<std::vector<glm::dvec3>, 4>;

// Row r holds the 4 - r points of level r; row 3 is B(t).

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

CurvatureStudy bend_study(const sim::SegmentShape& shape, world::Entity segment) {
  constexpr int kSamples = 192;
  CurvatureStudy study;
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

void bend_plot(Ui& ui, const Probe& probe, const CurvatureStudy& study, bool torsion, float width, float height) {
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
  const sim::DerivedTrack& derived = ui.session().derived;
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

// Returns every joint of the track in track order: the start of each segment that has one before it.
std::vector<JointRow> joints_of(const edit::Session& session, std::span<const sim::Jolt> jolts) {
  const sim::DerivedTrack& derived = session.derived;
  std::vector<JointRow> rows;
  const std::size_t count = derived.order.size();
  for (std::size_t i = derived.closed ? 0 : 1; i < count; ++i) {
    const world::Entity before = derived.order[(i + count - 1) % count], after = derived.order[i];
    const world::Entity knot = world::segment(session.document, after).from;
    rows.push_back({knot, world::name_of(session.document, knot),
                    curve::joint(derived.shape(before).key.cubic, derived.shape(after).key.cubic),
                    sim::fastest_step(session.document, jolts, i), i < jolts.size() ? jolts[i].total : 0});
  }
  return rows;
}

// Returns the indices of the rows, largest jolt first. Without a ride curvature decides.
std::vector<std::size_t> by_jolt(const std::vector<JointRow>& rows) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) { return std::pair(rows[i].jolt, rows[i].joint.curvature_jump); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  return order;
}

const JointList& kept_joints(Ui& ui) {
  const edit::Session& session = ui.session();
  const sim::DerivedTrack& derived = session.derived;
  const sim::SimulatedRide* const ridden = ui.find.ride();
  const std::uint64_t ride = ridden != nullptr ? ridden->serial : 0;
  const double cutoff = edit::force_limits(session).cutoff;
  return ui.lab.joints.get({derived.last_build, derived.order, derived.closed, ride, cutoff}, [&] {
    std::vector<JointRow> rows = joints_of(session, ui.find.jolts());
    std::vector<std::size_t> order = by_jolt(rows);
    return JointList{std::move(rows), std::move(order)};
  });
}

constexpr TableColumn kJointColumns[] = {
    {"Knot", "", 52, "Knot of the joint. Click a row to select it."},
    {"Shape", "", 50, "Geometric continuity: G0 meets, G1 one tangent line, G2 one curvature too."},
    {"Param.", "", 56,
     "Parametric continuity: C1 has equal first derivatives, C2 equal second ones. More than G1, G2."},
    {"Angle", "\u00B0", 66, "Angle between the two tangents."},
    {"Ratio", "", 54, "|C'(0)| / |B'(1)|: 1 for C1."},
    {"Jump", "1/m", 76, "Length of the difference between the curvature vectors."},
    {"g-step", "g", 72, "v\u00B2 |\u0394\u03BA| / g: step of the force at the fastest passage of the whole ride."},
    {"Jolt", "g", 62,
     "Largest change of felt g by the jumps of curvature and roll, low-pass filtered, in the whole ride, all cars."},
};

std::uint32_t tint_of(double g) { return g > sim::kJoltLimit ? kBadColour : g > 0.3 ? kPolygonColour : kPlainColour; }

void row_of(Ui& ui, const JointRow& row) {
  const bool selected = ui.session().settings.selected == row.knot;
  const double jolt = ui.find.ride() != nullptr ? row.jolt : NAN;
  const std::string name = world::to_text(row.name), step = row.step ? digits(ui, *row.step, 3, "g") : "--";
  const std::uint32_t tint = row.joint.geometric == curve::GeometricContinuity::g2   ? kGoodColour
                             : row.joint.geometric == curve::GeometricContinuity::g1 ? kPlainColour
                                                                                     : kBadColour;
  const std::string geometric(base::name_of(row.joint.geometric)), parametric(base::name_of(row.joint.parametric));
  const Cell cells[] = {{name, kPlainColour, true},
                        {geometric, tint, true},
                        {parametric, kPlainColour, true},
                        {fixed(base::degrees(row.joint.angle), 3)},
                        {fixed(row.joint.speed_ratio, 3)},
                        {digits(ui, row.joint.curvature_jump, 5, "1/m")},
                        {step, row.step > sim::kStepLimit ? kBadColour : kPlainColour},
                        {digits(ui, jolt, 2, "g"), tint_of(jolt)}};
  if (table_row(ui, "Joint " + name, cells, selected, fmt::format("{} {} {} g", geometric, parametric, step),
                "Click to select the knot.") &&
      !selected)
    ui.emit(edit::Select{{row.name}});
}

void side(Ui& ui, const JointList& list) {
  const edit::Session& session = ui.session();
  const world::EntityName* name = session.document.entities.find<world::EntityName>(session.settings.selected);
  const auto joint = std::find_if(list.rows.begin(), list.rows.end(),
                                  [&](const JointRow& row) { return row.knot == session.settings.selected; });
  const bool mendable =
      name != nullptr && joint != list.rows.end() && joint->joint.geometric < curve::GeometricContinuity::g2;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2);
  if (button(ui, "Make G2",
             "Make curvature continuous at the selected joint with the smallest movement of control points (least "
             "squares). Other joints keep their continuity. If that is impossible, the reason is reported.",
             mendable, width))
    ui.emit(edit::MakeG2{{*name}});
  ImGui::SameLine();
  if (button(ui, "Make all G2", "Make every joint G2, in one undo step.", !list.rows.empty(), width))
    ui.emit(edit::MakeAllG2{});
  const auto smooth = std::count_if(list.rows.begin(), list.rows.end(), [](const JointRow& row) {
    return row.joint.geometric >= curve::GeometricContinuity::g2;
  });
  std::optional<double> largest;
  for (const JointRow& row : list.rows) largest = std::max(largest, row.step);
  read_out(ui, "All joints", std::to_string(list.rows.size()), "", "Number of joints between segments.");
  read_out(ui, "G2 joints###Of them G2", std::to_string(smooth), "", "Joints with continuous curvature.");
  read_out(ui, "Largest g-step", largest ? digits(ui, *largest, 3, "g") : "--", "g",
           "Largest g-step of the whole ride.", false, largest > sim::kStepLimit);
  read_query(ui, "Largest jolt", "ride.jolt_max", "Largest jolt of the whole ride.");
  choose_side(ui, ui.lab.joints_by_jolt, {"Track order", "List the joints in track order."},
              {"Largest first###Hardest first", "List the joints by jolt, largest first."});
}

constexpr TableColumn kTightColumns[] = {
    {"Tight bend", "m", 70, "Distance along the track, of the curve of the knots. Click a row to go there."},
    {"Radius", "m", 70, "Least radius of the bend; 0 where the direction reverses."},
    {"Kind", "", 70, "A bend with a radius below 0.5 m, or a reversal of the direction.", true}};

// Draws the tight bends of the track, if there are any, and returns the height that is left.
float tight_bends(Ui& ui, float height) {
  const std::span<const sim::TightBend> bends = ui.find.tight_bends();
  constexpr std::size_t kMostRows = 4;
  const float own = std::min(0.5f * height, ImGui::GetFrameHeight() * (1.5f + std::min(bends.size(), kMostRows)));
  if (bends.empty()) return height;
  if (begin_table(ui, "Tight bends table", kTightColumns, own)) {
    each_row_in_sight(bends.size(), [&](std::size_t i) {
      const sim::TightBend& bend = bends[i];
      const std::string radius = digits(ui, bend.radius, 4, "m"), kind = bend.radius > 0 ? "bend" : "reversal";
      const Cell cells[] = {{digits(ui, bend.at, 1, "m")}, {radius, kBadColour}, {kind, kPlainColour, true}};
      if (table_row(ui, fmt::format("Tight bend {}", i + 1), cells, false, kind + " " + radius, "Click to go there."))
        show_place(ui, bend.at);
    });
    end_table();
  }
  return height - own - ImGui::GetStyle().ItemSpacing.y;
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

void frames_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const CurvatureStudy& study =
      ui.lab.bend.get(probe->shape->shape_build, [&] { return bend_study(*probe->shape, probe->segment); });
  PageLayout page(ui, 240);
  side(ui, *probe);
  two_pictures(
      ui, page, [&](float width, float height) { bend_plot(ui, *probe, study, false, width, height); },
      [&](float width, float height) { bend_plot(ui, *probe, study, true, width, height); });
}

void joints_page(Ui& ui) {
  const JointList& list = kept_joints(ui);
  PageLayout page(ui, 230);
  side(ui, list);
  const float height = tight_bends(ui, page.pictures());
  if (list.rows.empty()) return small_note("No joints yet. A joint connects two segments.");
  if (!begin_table(ui, "Joints table", kJointColumns, height)) return;
  each_row_in_sight(list.rows.size(),
                    [&](std::size_t i) { row_of(ui, list.rows[ui.lab.joints_by_jolt ? list.by_jolt[i] : i]); });
  end_table();
}

}  // namespace coaster::ui
