// Pages about frames along the track and the joints of its segments: Frames and Joints.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/portable_math.h"
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
