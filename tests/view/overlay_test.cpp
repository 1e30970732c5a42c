#include "view/overlay.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"
#include "view/marks.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/panel_settings.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::view {
namespace overlay_test {

const Viewport kViewport{57, 31, 640, 480};

// Where a point is on screen by trigonometry alone: none of the program's matrices.
struct Eye {
  glm::dvec3 at, forward, right, up;

  explicit Eye(const world::Camera& c) {
    const double yaw = c.yaw_deg * M_PI / 180, pitch = c.pitch_deg * M_PI / 180;
    forward = -glm::dvec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    at = glm::dvec3(c.target) - static_cast<double>(c.distance) * forward;
    right = {std::cos(yaw), 0, -std::sin(yaw)};
    up = glm::cross(right, forward);
  }
  glm::dvec3 pixel_and_depth(glm::dvec3 world) const {
    const glm::dvec3 d = world - at;
    const double depth = glm::dot(d, forward), scale = kViewport.height / (2 * std::tan(M_PI / 8)) / depth;
    return {kViewport.x + kViewport.width / 2 + scale * glm::dot(d, right),
            kViewport.y + kViewport.height / 2 - scale * glm::dot(d, up), depth};
  }
};

struct Candidate {
  PickKind kind;
  world::Entity knot;
  glm::vec3 position;
};

std::vector<Candidate> candidates(const world::Document& d, world::Entity selected) {
  std::vector<Candidate> out;
  for (const world::Entity e : d.track.knots) out.push_back({PickKind::knot, e, world::knot(d, e).position});
  std::vector<world::Entity> with_handles;
  if (d.entities.find<world::Knot>(selected)) with_handles = {selected};
  if (const auto* s = d.entities.find<world::Segment>(selected)) with_handles = {s->from, s->to};
  for (const world::Entity e : with_handles) {
    const world::Knot& k = world::knot(d, e);
    out.push_back({PickKind::handle_in, e, k.position - k.tangent * k.in_length});
    out.push_back({PickKind::handle_out, e, k.position + k.tangent * k.out_length});
  }
  return out;
}

// Distance of a pixel to the border of a mark, negative inside.
double outside(bool square, double radius, glm::dvec2 off) {
  return (square ? std::max(std::abs(off.x), std::abs(off.y)) : glm::length(off)) - radius;
}

TEST(overlay, what_is_painted_last_is_what_is_picked) {
  std::mt19937 bits(71);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  int compared = 0, overlaps = 0, handles = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    world::Document d = test::random_document(static_cast<std::uint32_t>(trial));
    if (d.track.knots.empty()) continue;
    world::Settings settings;
    settings.aids->show_gizmo = false;  // its parts are no marks: view/gizmo_test.cpp
    settings.camera = {{uniform(-90, 90), uniform(0, 60), uniform(-90, 90)},
                       static_cast<float>(uniform(-180, 180)),
                       static_cast<float>(uniform(5, 85)),
                       static_cast<float>(uniform(300, 30000))};
    settings.selected = !d.track.segments.empty() && trial % 2 ? d.track.segments[bits() % d.track.segments.size()]
                                                               : d.track.knots[bits() % d.track.knots.size()];
    const View view = orbit_view(settings.camera, kViewport);
    const Eye eye(settings.camera);
    sim::DerivedTrack nothing;  // no curve and no carts: marks alone
    const Overlay overlay = build_overlay(d, nothing, settings, view, {});
    const std::vector<Candidate> all = candidates(d, settings.selected);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 near = eye.pixel_and_depth(all[bits() % all.size()].position);
      const glm::vec2 pixel(near.x + uniform(-9, 9), near.y + uniform(-9, 9));
      if (near.z < 2 || !kViewport.contains(pixel)) continue;
      // The rule, by brute force; pixels at a border or with nearly equal distances are left out.
      const Candidate* wanted = nullptr;
      bool doubtful = false;
      int covering = 0;
      for (const Candidate& c : all) {
        const glm::dvec3 at = eye.pixel_and_depth(c.position);
        if (at.z < 80) {
          doubtful |= at.z > 0;
          continue;
        }  // about the near plane, which moves with the distance
        const bool square = c.kind != PickKind::knot;
        const double gap = outside(square, square ? kHandleHalf : kKnotRadius, glm::dvec2(pixel) - glm::dvec2(at));
        doubtful |= std::abs(gap) < 0.05;
        if (gap > 0) continue;
        ++covering;
        if (!wanted) {
          wanted = &c;
          continue;
        }
        const bool wanted_handle = wanted->kind != PickKind::knot;
        const double mine = glm::distance(glm::dvec3(c.position), eye.at),
                     its = glm::distance(glm::dvec3(wanted->position), eye.at);
        if (square == wanted_handle) doubtful |= std::abs(mine - its) < 1e-2;
        if (square != wanted_handle ? square : mine < its) wanted = &c;
      }
      if (doubtful) continue;
      // The painter: marks in the list's order, each over the one before.
      const Mark* painted = nullptr;
      for (const Mark& m : overlay.marks) {
        const glm::dvec3 at = eye.pixel_and_depth(m.position);
        if (outside(m.shape == MarkShape::square, m.radius_px, glm::dvec2(pixel) - glm::dvec2(at)) <= 0) painted = &m;
      }
      const Pick picked = pick(d, nothing, {}, settings, view, pixel);
      ASSERT_EQ(picked.kind, wanted ? wanted->kind : PickKind::none) << trial;
      ASSERT_EQ(painted != nullptr, wanted != nullptr) << trial;
      ++compared;
      if (!wanted) continue;
      ASSERT_EQ(picked.entity, wanted->knot) << trial;
      ASSERT_LT(glm::distance(painted->position, wanted->position), 1e-2f) << trial;
      overlaps += covering > 1, handles += wanted->kind != PickKind::knot;
    }
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT(overlaps, 500);
  EXPECT_GT(handles, 500);
}

struct Scene {
  world::Document document = test::sample_document();
  sim::DerivedTrack derived = test::derived_of(document);
  world::Settings settings;
  View view = orbit_view(frame_all({}, document, kViewport), kViewport);
  Overlay overlay(const Pick& hovered = {}) const { return build_overlay(document, derived, settings, view, hovered); }
};

TEST(overlay, nothing_selected_shows_knots_alone) {
  Scene scene;
  const Overlay overlay = scene.overlay();
  EXPECT_EQ(overlay.marks.size(), 5u);
  EXPECT_TRUE(overlay.lines.empty());
  for (const Mark& m : overlay.marks) {
    EXPECT_EQ(m.shape, MarkShape::disc);
    EXPECT_EQ(m.rgba, 0xffffffffu);
    EXPECT_EQ(m.radius_px, kKnotRadius);
  }
}

TEST(overlay, knots_beside_the_picture_have_no_marks) {
  Scene scene;
  world::Camera camera = frame_all({}, scene.document, kViewport);
  camera.target = world::knot(scene.document, scene.document.track.knots[0]).position;
  camera.distance = 4;
  scene.view = orbit_view(camera, kViewport);
  const Overlay overlay = scene.overlay();
  ASSERT_EQ(overlay.marks.size(), 1u);
  EXPECT_EQ(overlay.marks[0].position, camera.target);
}

TEST(overlay, a_selected_knot_is_orange_with_handles_and_polygons) {
  Scene scene;
  scene.settings.selected = scene.document.track.knots[2];
  scene.settings.aids->show_gizmo = false;
  const Overlay overlay = scene.overlay();
  ASSERT_EQ(overlay.marks.size(), 7u);
  EXPECT_EQ(
      std::count_if(overlay.marks.begin(), overlay.marks.end(), [](const Mark& m) { return m.rgba == 0xff8a1fffu; }),
      1);
  EXPECT_EQ(overlay.marks[5].shape, MarkShape::square);
  EXPECT_EQ(overlay.marks[6].shape, MarkShape::square);
  EXPECT_EQ(overlay.marks[6].rgba, 0xf2b84bffu);
  EXPECT_EQ(overlay.lines.size(), 6u);  // two control polygons of three sides
  scene.settings.selected = scene.document.track.knots[0];
  EXPECT_EQ(scene.overlay().lines.size(), 4u);  // one polygon, and the handle that leads nowhere
}

TEST(overlay, a_selected_segment_shows_its_polygon_and_the_picked_place) {
  Scene scene;
  scene.settings.selected = scene.document.track.segments[1];
  scene.settings.selected_t = 0.37;
  const Overlay overlay = scene.overlay();
  EXPECT_EQ(overlay.marks.size(), 5u + 4u + 1u);
  const glm::vec3 place(curve::point(world::cubic_of(scene.document, scene.settings.selected), 0.37));
  EXPECT_LT(glm::distance(overlay.marks.front().position, place), 1e-4f);
  EXPECT_EQ(overlay.lines.size(), 5u);  // the polygon's three sides, and the other handle at either end
}

TEST(overlay, what_is_under_the_cursor_is_larger) {
  Scene scene;
  const world::Entity knot = scene.document.track.knots[3];
  int larger = 0;
  for (const Mark& m : scene.overlay({PickKind::knot, knot}).marks) {
    if (m.radius_px == kKnotRadius) continue;
    ++larger;
    EXPECT_FLOAT_EQ(m.radius_px, 1.35f * kKnotRadius);
    EXPECT_EQ(m.position, world::knot(scene.document, knot).position);
  }
  EXPECT_EQ(larger, 1);
}

TEST(overlay, sizes_follow_the_scale) {
  Scene scene;
  scene.settings.look->ui_scale = 2;
  for (const Mark& m : scene.overlay().marks) EXPECT_EQ(m.radius_px, 2 * kKnotRadius);
}

TEST(overlay, a_selection_that_is_gone_is_ignored) {
  Scene scene;
  scene.settings.selected = {4711, 3};
  EXPECT_EQ(scene.overlay().marks.size(), 5u);
}

TEST(overlay_riding, only_the_chosen_knot_is_marked_while_the_eye_rides) {
  const world::Document d = test::ring_document(7, 31.7);
  const sim::DerivedTrack derived = test::derived_of(d);
  const Viewport viewport{0, 0, 640, 360};
  const View view = orbit_view(frame_all({}, d, viewport), viewport);
  MarkedFindings findings;
  findings.riding = true;
  EXPECT_TRUE(build_overlay(d, derived, {}, view, {}, findings).marks.empty());
  world::Settings settings;
  settings.selected = d.track.knots[3];
  EXPECT_EQ(build_overlay(d, derived, settings, view, {}, findings).marks.size(), 3u);  // with its handles
}

TEST(overlay_riding, knots_that_are_neither_chosen_nor_hovered_show_in_every_workspace_but_ride) {
  Scene scene;
  for (const world::Workspace one :
       {world::Workspace::all, world::Workspace::build, world::Workspace::ride, world::Workspace::laboratory}) {
    scene.settings.panels->workspace = one;
    EXPECT_EQ(scene.overlay().marks.size(), one == world::Workspace::ride ? 0u : 5u);
  }
  scene.settings.panels->workspace = world::Workspace::ride;
  EXPECT_EQ(scene.overlay({PickKind::knot, scene.document.track.knots[3]}).marks.size(), 1u);
}

TEST(overlay_failure, a_failed_ride_is_marked_where_it_failed_and_one_that_goes_on_is_not) {
  const world::Document d = test::ring_document(7, 31.7);
  const sim::DerivedTrack derived = test::derived_of(d);
  const Viewport viewport{0, 0, 640, 360};
  const View view = orbit_view(frame_all({}, d, viewport), viewport);
  const Overlay without = build_overlay(d, derived, {}, view, {});
  MarkedFindings findings;
  findings.failure = {world::FailureKind::stall, {}, 0.3 * derived.length, 0};
  const Overlay with = build_overlay(d, derived, {}, view, {}, findings);
  ASSERT_GT(with.marks.size(), without.marks.size());
  const sim::TrackPlace place = sim::place_at(derived, findings.failure.distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[place.index]);
  const glm::dvec3 at = curve::point(shape.key.cubic, shape.arc.parameter(place.s));
  EXPECT_LT(glm::distance(glm::dvec3(with.marks[without.marks.size()].position), at), 2.0);
}

TEST(overlay, marks_of_very_many_knots_are_those_of_the_nearest_and_of_the_active_one) {
  constexpr int kKnots = 12'000;
  world::Document d;
  for (int i = 0; i < kKnots; ++i) {
    world::Knot knot;
    knot.position = {2.0f * static_cast<float>(i % 100), 5, -3.0f * static_cast<float>(i / 100)};
    world::append_knot(d, knot);
  }
  world::Settings settings;
  settings.camera.target = {100, 5, 0};
  settings.camera.distance = 300;
  const View view = orbit_view(settings.camera, kViewport);
  const auto far = [&](world::Entity e) { return glm::distance(world::knot(d, e).position, view.eye); };
  std::vector<world::Entity> by_distance = d.track.knots;
  std::sort(by_distance.begin(), by_distance.end(), [&](auto a, auto b) { return far(a) < far(b); });
  const MarkChoice every{true, true, {}, by_distance.size()};
  ASSERT_EQ(marks_on_screen(d, {}, settings, view, SelectionLookup(settings), every).marks.size(), by_distance.size())
      << "all are on screen";
  const Overlay overlay = build_overlay(d, {}, settings, view, {});
  ASSERT_EQ(overlay.marks.size(), kMostMarks);
  const float border = far(by_distance[kMostMarks]);
  for (const Mark& mark : overlay.marks) EXPECT_LE(glm::distance(mark.position, view.eye), border * 1.0001f);
  EXPECT_TRUE(std::is_sorted(overlay.marks.begin(), overlay.marks.end(), [&](const Mark& a, const Mark& b) {
    return glm::distance(a.position, view.eye) > glm::distance(b.position, view.eye) * 1.0001f;
  }));
  // The farthest one shows once it is active, or hovered.
  const world::Entity last = by_distance.back();
  const glm::vec3 place = world::knot(d, last).position;
  const auto shows = [&](const Overlay& marks) {
    return std::any_of(marks.marks.begin(), marks.marks.end(), [&](const Mark& m) { return m.position == place; });
  };
  EXPECT_FALSE(shows(overlay));
  EXPECT_TRUE(shows(build_overlay(d, {}, settings, view, Pick{PickKind::knot, last, 0, place})));
  settings.selected = last;
  const Overlay active = build_overlay(d, {}, settings, view, {});
  EXPECT_TRUE(shows(active));
  EXPECT_LE(active.marks.size(), kMostMarks + 10u) << "and those of its gizmo";
}

}  // namespace overlay_test
}  // namespace coaster::view
