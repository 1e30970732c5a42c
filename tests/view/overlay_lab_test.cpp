#include "view/overlay_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "curve/bernstein.h"
#include "sim/study/evaluator_benchmark.h"
#include "sim/tracks.h"
#include "world/evaluation_settings.h"
#include "world/laboratory_settings.h"

namespace coaster::view {
namespace overlay_lab_test {

const Viewport kViewport{57, 31, 1280, 720};

struct Scene {
  world::Document document = test::ring_document(7, 31.7);
  world::Settings settings;
  sim::DerivedTrack derived;
  View view;

  explicit Scene(world::Document d = test::ring_document(7, 31.7)) : document(std::move(d)) { look(); }
  void look() {
    derived = test::derived_of(document, settings);
    view = orbit_view(frame_all(settings.camera, document, kViewport), kViewport);
  }
  const sim::SegmentShape& shape(std::size_t i) const { return derived.shape(derived.order[i]); }
};

glm::dvec3 along(const Line& line) { return glm::dvec3(line.to) - glm::dvec3(line.from); }
double length(const Line& line) { return glm::length(along(line)); }
// Lines are in float: half an ulp of coordinates below 64 m.
constexpr double kFloat = 8e-6;

TEST(overlay_lab, layers_that_are_off_draw_nothing) {
  Scene scene;
  scene.settings.selected = scene.derived.order[2];
  Overlay overlay;
  add_laboratory(scene.document, scene.derived, scene.settings, scene.view, {}, overlay);
  EXPECT_TRUE(overlay == Overlay{});
}

TEST(overlay_lab, the_construction_has_three_lines_that_end_in_the_curves_point) {
  const Scene scene;
  for (const double t : {0.0, 0.31, 0.5, 0.87, 1.0}) {
    const curve::Cubic& c = scene.shape(3).key.cubic;
    Overlay overlay;
    add_construction(scene.shape(3), t, scene.view, 1, overlay);
    ASSERT_GE(overlay.lines.size(), 4u);
    ASSERT_EQ(overlay.marks.size(), 6u);
    // Between the control points by hand, in long double would be the same: three mixes.
    const glm::dvec3 a = glm::mix(glm::dvec3(c.p0), glm::dvec3(c.p1), t),
                     b = glm::mix(glm::dvec3(c.p1), glm::dvec3(c.p2), t);
    EXPECT_LT(glm::length(glm::dvec3(overlay.lines[0].from) - a), kFloat);
    EXPECT_LT(glm::length(glm::dvec3(overlay.lines[0].to) - b), kFloat);
    EXPECT_EQ(overlay.lines[0].to, overlay.lines[1].from);
    // The point divides the second level's line like t, and is the curve's.
    const glm::dvec3 on = glm::mix(glm::dvec3(overlay.lines[2].from), glm::dvec3(overlay.lines[2].to), t),
                     point = curve::point(c, t);
    EXPECT_LT(glm::length(on - point), 2 * kFloat);
    EXPECT_LT(glm::length(glm::dvec3(overlay.marks.back().position) - point), kFloat);
    // The arrow is B'/3.
    EXPECT_LT(glm::length(3.0 * along(overlay.lines[3]) - curve::derivative(c, t)), 6 * kFloat);
  }
}

TEST(overlay_lab, the_circle_has_the_radius_of_curvature_and_touches_the_curve) {
  const Scene scene;
  for (const double t : {0.11, 0.5, 0.93}) {
    const sim::SegmentShape& shape = scene.shape(1);
    Overlay overlay;
    add_circle(shape, t, 1, overlay);
    ASSERT_EQ(overlay.lines.size(), static_cast<std::size_t>(kCircleSides) + 1);
    ASSERT_EQ(overlay.marks.size(), 1u);
    const glm::dvec3 centre = overlay.marks[0].position, touch = curve::point(shape.key.cubic, t),
                     d1 = curve::derivative(shape.key.cubic, t);
    const double radius = 1 / curve::curvature(shape.key.cubic, t);
    for (int i = 0; i < kCircleSides; ++i)
      EXPECT_NEAR(glm::length(glm::dvec3(overlay.lines[static_cast<std::size_t>(i)].to) - centre), radius, 4 * kFloat);
    EXPECT_LT(glm::length(glm::dvec3(overlay.lines[0].from) - touch), kFloat);
    EXPECT_EQ(overlay.lines[0].from, overlay.lines[static_cast<std::size_t>(kCircleSides) - 1].to);
    EXPECT_NEAR(glm::dot(centre - touch, glm::normalize(d1)), 0, 4 * kFloat);
  }
}

TEST(overlay_lab, a_straight_has_neither_circle_nor_teeth_that_show) {
  const Scene scene(test::straight_document({3.7f, 5.1f, -2.3f}, {47.1f, 8.3f, 11.9f}, 2));
  Overlay overlay;
  add_circle(scene.shape(0), 0.4, 1, overlay);
  EXPECT_TRUE(overlay.lines.empty());
  add_comb(scene.derived, scene.settings, scene.view, overlay);
  ASSERT_FALSE(overlay.lines.empty());
  for (const Line& line : overlay.lines) {
    const bool tooth = line.rgba != kCombColour;
    EXPECT_TRUE(!tooth || length(line) < 1e-3);
  }
}

TEST(overlay_lab, teeth_are_curvature_times_scale_long_and_point_away_from_the_centre) {
  Scene scene;
  scene.settings.lab->comb_scale = 83.7;
  Overlay overlay;
  add_comb(scene.derived, scene.settings, scene.view, overlay);
  int teeth = 0;
  for (const Line& line : overlay.lines) {
    if (line.rgba == kCombColour) continue;  // the envelope
    ++teeth;
    double nearest = 1e9, expected = 0;
    glm::dvec3 normal(0);
    for (const world::Entity e : scene.derived.order) {
      const curve::Cubic& c = scene.derived.shape(e).key.cubic;
      const curve::NearestPoint at = curve::nearest_point(c, glm::dvec3(line.from));
      if (at.distance > nearest) continue;
      // At a joint two teeth of different length have one root: the better fit counts.
      const double want = curve::curvature(c, at.t) * scene.settings.lab->comb_scale;
      if (at.distance > nearest - 1e-4 && std::abs(want - length(line)) > std::abs(expected - length(line))) continue;
      nearest = at.distance, expected = want;
      normal = curve::frenet(c, at.t)->normal;
    }
    EXPECT_LT(nearest, kFloat);
    EXPECT_NEAR(length(line), expected, 1e-3 * expected + 2 * kFloat);
    EXPECT_LT(glm::dot(glm::normalize(along(line)), normal), -0.999);
  }
  EXPECT_GT(teeth, 7 * 8);
  EXPECT_LE(teeth, kMaxTeeth);
}

TEST(overlay_lab, arrows_of_a_frame_are_one_length_and_perpendicular) {
  Scene scene;
  for (const auto method :
       {world::FrameMethod::knots, world::FrameMethod::rmf, world::FrameMethod::frenet, world::FrameMethod::world_up}) {
    scene.settings.frames = method;
    Overlay overlay;
    add_frames(scene.derived, scene.settings, scene.view, overlay);
    std::vector<Line> shafts[3];  // barbs start where a shaft ends
    for (std::size_t i = 0; i < overlay.lines.size(); ++i) {
      const Line& line = overlay.lines[i];
      const bool barb =
          i > 0 && (line.from == overlay.lines[i - 1].to || (i > 1 && line.from == overlay.lines[i - 2].to));
      if (barb) continue;
      const std::uint32_t colour = line.rgba & 0xffffff00u;
      shafts[colour == (kTangentColour & 0xffffff00u)  ? 0
             : colour == (kNormalColour & 0xffffff00u) ? 1
                                                       : 2]
          .push_back(line);
    }
    ASSERT_GT(shafts[0].size(), 5u);
    ASSERT_LE(shafts[0].size(), static_cast<std::size_t>(kMaxFrames));
    ASSERT_EQ(shafts[0].size(), shafts[1].size());
    ASSERT_EQ(shafts[0].size(), shafts[2].size());
    for (std::size_t i = 0; i < shafts[0].size(); ++i) {
      const glm::dvec3 t = along(shafts[0][i]), n = along(shafts[1][i]), b = along(shafts[2][i]);
      const double size = glm::length(t);
      EXPECT_NEAR(glm::length(n), size, 2 * kFloat);
      EXPECT_LT(glm::length(glm::cross(t, n) / size - b), 8 * kFloat);
      EXPECT_NEAR(glm::dot(t, n), 0, 8 * kFloat * size);
    }
  }
}

TEST(overlay_lab, rounding_moves_vertices_by_their_error_times_the_magnification) {
  Scene scene;
  scene.settings.evaluation->evaluator = *base::value_named<curve::EvaluatorId>("forward_differences");
  scene.settings.evaluation->steps = 512;
  scene.settings.lab->magnification = 1234.5;
  scene.settings.selected = scene.derived.order[4];
  Overlay overlay;
  add_rounding(scene.document, scene.derived, scene.settings, scene.view, overlay);
  const sim::Rounding r = sim::rounding(scene.shape(4).curve, base::row_of(scene.settings.evaluation->evaluator), 512);
  std::vector<Line> chain;
  for (const Line& line : overlay.lines)
    if (line.rgba == kRoundingColour || line.rgba == kSeamColour) chain.push_back(line);
  ASSERT_EQ(chain.size(), 512u);
  for (std::size_t i = 0; i < chain.size(); ++i)
    EXPECT_LT(glm::length(glm::dvec3(chain[i].from) - (r.exact[i] + 1234.5 * r.error[i])), 2 * kFloat) << i;
  // The seam: red, from what was gathered to the pinned end.
  EXPECT_EQ(chain.back().rgba, kSeamColour);
  EXPECT_EQ(chain.back().to, scene.shape(4).key.cubic.p3);
  EXPECT_GT(length(chain.back()), 1234.5 * sim::seam(r) * 0.9);
}

TEST(overlay_lab, a_flip_has_a_cross_at_its_place) {
  const Scene scene;
  const sim::FrenetBreak flip{sim::FrenetBreak::Kind::flip, scene.derived.order[2], 0.4, 0.4, 3.1};
  Overlay overlay;
  add_breaks(scene.derived, std::span(&flip, 1), scene.view, 1, overlay);
  const glm::dvec3 place = curve::point(scene.shape(2).key.cubic, 0.4);
  int crosses = 0;
  for (const Line& line : overlay.lines)
    crosses += line.rgba == kBreakColour &&
               glm::length(0.5 * (glm::dvec3(line.from) + glm::dvec3(line.to)) - place) < 2 * kFloat;
  EXPECT_EQ(crosses, 2);
}

// The arrows on both sides of a flip stand on the curve within a fortieth of the segment and point along its normals.
TEST(overlay_lab, a_flip_shows_the_normal_just_before_and_just_behind_it) {
  const Scene scene;
  const curve::Cubic& c = scene.shape(2).key.cubic;
  for (const double at : {0.4, 0.0, 1.0})
    for (const float scale : {1.0f, 2.0f}) {
      const sim::FrenetBreak flip{sim::FrenetBreak::Kind::flip, scene.derived.order[2], at, at, 3.1};
      Overlay overlay;
      add_breaks(scene.derived, std::span(&flip, 1), scene.view, scale, overlay);
      int before = 0, behind = 0;
      for (const Line& line : overlay.lines) {
        if (line.rgba == kBreakColour) continue;
        for (int k = -25; k <= 25; ++k) {
          const double t = at + k / 1000.0;
          if (t < 0 || t > 1) continue;
          const auto frame = curve::frenet(c, t);
          if (!frame || glm::distance(glm::dvec3(line.from), curve::point(c, t)) > 0.005) continue;
          if (glm::length(glm::cross(glm::normalize(along(line)), frame->normal)) > 0.01) continue;
          (k < 0 ? before : behind) += k != 0 || at == 0.0 || at == 1.0;
          break;
        }
      }
      EXPECT_GT(before + behind, 1) << at;
      EXPECT_TRUE(at == 0 || before > 0) << at;
      EXPECT_TRUE(at == 1 || behind > 0) << at;
    }
}

TEST(overlay_lab, a_red_span_runs_over_the_rails_from_end_to_end) {
  const Scene scene;
  const double end = scene.derived.length;
  sim::Overload span;
  for (const auto& [from, to] : {std::pair{13.7, 41.2}, {end - 6.5, 9.25}}) {  // the second runs over the closing joint
    span.from_distance = from, span.to_distance = to;
    Overlay overlay;
    add_spans(scene.derived, std::span(&span, 1), 1, overlay);
    double drawn = 0;
    for (std::size_t i = 0; i < overlay.lines.size(); ++i) {
      drawn += length(overlay.lines[i]);
      EXPECT_EQ(overlay.lines[i].rgba, kLimitColour);
      EXPECT_EQ(overlay.lines[i].from, overlay.lines[i == 0 ? 0 : i - 1].*(i == 0 ? &Line::from : &Line::to));
    }
    EXPECT_NEAR(drawn, to > from ? to - from : to - from + end, 0.5);
    const sim::TrackPlace place = sim::place_at(scene.derived, from);
    const sim::SegmentShape& shape = scene.shape(place.index);
    EXPECT_NEAR(glm::distance(glm::dvec3(overlay.lines.front().from),
                              curve::point(shape.key.cubic, shape.arc.parameter(place.s))),
                0.35, 1e-5);
  }
}

TEST(overlay_lab, a_jolt_above_the_limit_has_a_sign_with_a_peak_over_its_knot) {
  Scene scene;
  std::vector<sim::Jolt> jolts(scene.document.track.knots.size());
  jolts[2].total = sim::kJoltLimit * 1.01, jolts[3].total = sim::kJoltLimit * 0.99;
  MarkedFindings findings;
  findings.jolts = jolts;
  scene.settings.lab->layers.set(world::Layer::limits, true);
  Overlay overlay;
  add_laboratory(scene.document, scene.derived, scene.settings, scene.view, findings, overlay);
  ASSERT_EQ(overlay.marks.size(), 10u);  // one disc and the dots of its peak
  EXPECT_EQ(overlay.marks[0].rgba, kLimitColour);
  const glm::vec3 knot = world::knot(scene.document, scene.document.track.knots[2]).position;
  EXPECT_NEAR(glm::distance(overlay.marks[0].position, knot), 1.6, 1e-4);
  EXPECT_GT(overlay.marks[5].position.y, overlay.marks[1].position.y);
  scene.settings.lab->layers.set(world::Layer::limits, false);
  Overlay none;
  add_laboratory(scene.document, scene.derived, scene.settings, scene.view, findings, none);
  EXPECT_TRUE(none == Overlay{});
}

TEST(overlay_lab, no_layer_outgrows_its_limit_on_a_long_track) {
  Scene scene(test::ring_document(1500, 900));
  for (const float distance : {3.0f, 60.0f, 2500.0f}) {
    world::Camera camera = scene.settings.camera;
    camera.target = world::knot(scene.document, scene.document.track.knots[0]).position;
    camera.distance = distance;
    scene.view = orbit_view(camera, kViewport);
    Overlay frames, comb, rounding;
    add_frames(scene.derived, scene.settings, scene.view, frames);
    add_comb(scene.derived, scene.settings, scene.view, comb);
    add_rounding(scene.document, scene.derived, scene.settings, scene.view, rounding);
    EXPECT_GT(frames.lines.size(), 0u);
    EXPECT_LE(frames.lines.size(), 9u * kMaxFrames);
    EXPECT_GT(comb.lines.size(), 0u);
    EXPECT_LE(comb.lines.size(), 2u * kMaxTeeth);
    EXPECT_LE(rounding.lines.size(), 2u * kMaxRoundingVertices);
  }
}

// A segment of n steps has n + 1 vertices; as many segments are shown as have no more than the limit together.
TEST(overlay_lab, rounding_is_shown_of_as_many_segments_as_the_limit_of_vertices_allows) {
  Scene scene(test::ring_document(1500, 900));
  for (const int steps : {6, 7, 64}) {
    scene.settings.evaluation->steps = steps;
    scene.settings.lab->magnification = 1;
    scene.look();
    Overlay rounding;
    add_rounding(scene.document, scene.derived, scene.settings, scene.view, rounding);
    ASSERT_FALSE(rounding.lines.empty());
    const int most = std::min(1500, kMaxRoundingVertices / (steps + 1));
    const glm::dvec3 end(scene.shape(static_cast<std::size_t>(most) - 1).key.cubic.p3);
    EXPECT_LT(glm::distance(glm::dvec3(rounding.lines.back().to), end), 1.0) << "segments are 3.8 m long, " << steps;
  }
}

TEST(overlay_lab, an_empty_track_shows_nothing) {
  Scene scene{world::Document{}};
  for (std::size_t i = 0; i < std::size(world::kLayers); ++i)
    scene.settings.lab->layers.set(static_cast<world::Layer>(i), true);
  Overlay overlay;
  add_laboratory(scene.document, scene.derived, scene.settings, scene.view, {}, overlay);
  EXPECT_TRUE(overlay == Overlay{});
}

TEST(overlay_lab, a_conflict_has_a_band_over_both_stretches_and_a_sign_above_while_nobody_rides) {
  Scene scene;
  const sim::Conflict conflict{.at = 12,
                               .other = 110,
                               .from = 10,
                               .to = 15,
                               .other_from = 107,
                               .other_to = 113,
                               .missing = 1,
                               .at_place = {3, 4, 5},
                               .other_place = {5, 6, 7}};
  MarkedFindings findings;
  findings.conflicts = {&conflict, 1};
  Overlay overlay;
  add_laboratory(scene.document, scene.derived, scene.settings, scene.view, findings, overlay);
  const auto ends_at = [&](double distance) {
    const sim::TrackPlace place = sim::place_at(scene.derived, distance);
    const glm::dvec3 rails =
        curve::point(scene.shape(place.index).key.cubic, scene.shape(place.index).arc.parameter(place.s));
    return std::any_of(overlay.lines.begin(), overlay.lines.end(), [&](const Line& line) {
      return line.rgba == kConflictColour &&
             (glm::distance(glm::dvec3(line.from), rails) < 0.36 || glm::distance(glm::dvec3(line.to), rails) < 0.36);
    });
  };
  for (const double distance : {10.0, 12.5, 15.0, 107.0, 110.0, 113.0}) EXPECT_TRUE(ends_at(distance)) << distance;
  for (const double distance : {5.0, 20.0, 100.0, 120.0}) EXPECT_FALSE(ends_at(distance)) << distance;
  ASSERT_FALSE(overlay.marks.empty());
  EXPECT_EQ(overlay.marks[0].rgba, kConflictColour);
  EXPECT_EQ(overlay.marks[0].position.x, 4);
  EXPECT_GT(overlay.marks[0].position.y, 6);

  for (const bool riding : {true, false}) {
    findings.riding = riding;
    scene.settings.lab->layers.set(world::Layer::conflicts, riding);
    Overlay none;
    add_laboratory(scene.document, scene.derived, scene.settings, scene.view, findings, none);
    EXPECT_TRUE(none == Overlay{}) << riding;
  }
}

}  // namespace overlay_lab_test
}  // namespace coaster::view
