#include "view/pick.h"

#include <gtest/gtest.h>

#include "sim/ride/ride.h"
#include "sim/tracks.h"
#include "view/pick_cone.h"
#include "world/appearance_settings.h"

namespace coaster::view {
namespace pick_test {

const Viewport kViewport{57, 31, 640, 480};

struct Scene {
  world::Document document;
  sim::DerivedTrack derived;
  world::Motion motion;
  world::Settings settings;
  View view;

  explicit Scene(world::Document d, world::Camera camera)
      : document(std::move(d)), derived(test::derived_of(document)) {
    sim::reset(document, derived, motion);
    view = orbit_view(camera, kViewport);
  }
  explicit Scene(world::Document d) : Scene(d, frame_all({}, d, kViewport)) {}
  Pick at(glm::vec3 position) const {
    return pick(document, derived, motion, settings, view, glm::vec2(*project(view, position)));
  }
};

TEST(pick, every_place_of_the_curve_is_found_where_it_is_seen) {
  const Scene scene(test::ring_document(9, 23.1));
  for (const world::Entity e : scene.document.track.segments)
    for (const double t : {0.07, 0.31, 0.5, 0.83}) {
      const glm::vec3 place(curve::point(world::cubic_of(scene.document, e), t));
      const auto found = pick_curve(scene.derived, scene.view, glm::vec2(*project(scene.view, place)), 8);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->entity, e);
      // A pixel's coordinates in float are good to 3e-5, a hundredth of a millimetre here.
      EXPECT_NEAR(found->t, t, 1e-4);
      EXPECT_LT(glm::distance(found->position, place), 2e-3f);
    }
}

// Nearest on screen against 4,000 samples a segment, with eyes inside the track too, where much of it is behind.
TEST(pick, the_curve_is_nearest_on_screen_as_by_brute_force) {
  std::mt19937 bits(37);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  int found_some = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const world::Camera camera{{uniform(100, 150), uniform(3, 20), uniform(-40, 30)},
                               static_cast<float>(uniform(-180, 180)),
                               static_cast<float>(uniform(0, 80)),
                               static_cast<float>(uniform(1, 90))};
    const Scene scene(test::sample_document(), camera);
    const glm::vec2 pixel(uniform(57, 697), uniform(31, 511));
    constexpr float kReach = 150;
    double least = 1e9;
    for (const world::Entity e : scene.document.track.segments)
      for (int i = 0; i <= 4000; ++i) {
        const auto at = project(scene.view, glm::vec3(curve::point(world::cubic_of(scene.document, e), i / 4000.0)));
        if (at && at->z > -1) least = std::min<double>(least, glm::distance(glm::vec2(*at), pixel));
      }
    const auto found = pick_curve(scene.derived, scene.view, pixel, kReach);
    if (std::abs(least - kReach) < 0.5) continue;
    ASSERT_EQ(found.has_value(), least < kReach) << trial << " " << least;
    if (!found) continue;
    ++found_some;
    const auto at = project(scene.view, found->position);
    ASSERT_TRUE(at) << trial;
    // Samples lie up to half a step off: close to the eye a step of 7 mm is some pixels.
    EXPECT_LT(glm::distance(glm::vec2(*at), pixel), least + 0.05) << trial;
    EXPECT_GT(glm::distance(glm::vec2(*at), pixel), least - 2.5) << trial;
  }
  EXPECT_GT(found_some, 15);
}

TEST(pick, a_segment_that_passes_the_eye_is_picked_where_it_is_ahead) {
  // The eye is at z = 10, 2 m over a segment from z = 30 (behind) to z = -30.
  const Scene scene(test::straight_document({1, 5, 30}, {1, 5, -30}), {{1, 7, 0}, 0, 0, 10});
  for (const float z : {5.0f, -3.0f, -21.0f}) {
    const auto found = pick_curve(scene.derived, scene.view, glm::vec2(*project(scene.view, {1, 5, z})), 8);
    ASSERT_TRUE(found) << z;
    EXPECT_NEAR(found->position.z, z, 0.05) << z;
  }
  // Above the horizon a line through the eye's plane has a mirror image that is not there.
  EXPECT_FALSE(pick_curve(scene.derived, scene.view, {57 + 320, 31 + 60}, 8));
}

TEST(pick, beyond_its_reach_the_curve_is_not_picked) {
  const Scene scene(test::straight_document({-20, 5, 1}, {20, 5, 1}), {{0, 5, 1}, 0, 0, 60});
  const glm::vec2 middle = glm::vec2(*project(scene.view, {3.7f, 5, 1}));
  EXPECT_TRUE(pick_curve(scene.derived, scene.view, middle + glm::vec2(0, 7.9f), 8));
  EXPECT_FALSE(pick_curve(scene.derived, scene.view, middle + glm::vec2(0, 8.1f), 8));
  EXPECT_EQ(
      pick(scene.document, scene.derived, scene.motion, scene.settings, scene.view, middle + glm::vec2(0, 7.5f)).kind,
      PickKind::curve);
  EXPECT_EQ(
      pick(scene.document, scene.derived, scene.motion, scene.settings, scene.view, middle + glm::vec2(0, 50)).kind,
      PickKind::none);
}

TEST(pick, outside_the_viewport_is_nothing) {
  const Scene scene(test::ring_document(9, 23.1));
  EXPECT_EQ(pick(scene.document, scene.derived, scene.motion, scene.settings, scene.view, {20, 20}).kind,
            PickKind::none);
}

// As large as they are drawn: 5 px about a knot's middle at UI scale 1, beyond them the curve has 8 px.
TEST(pick, knots_reach_as_far_as_their_discs_in_every_direction) {
  Scene scene(test::straight_document({-20, 5, 1}, {20, 5, 1}, 2), {{0, 5, 1}, 0, 0, 60});
  const world::Entity knot = scene.document.track.knots[1];
  const glm::vec2 middle(*project(scene.view, world::knot(scene.document, knot).position));
  for (const float scale : {1.0f, 1.5f}) {
    scene.settings.look->ui_scale = scale;
    for (int k = 0; k < 16; ++k) {
      const float a = 0.3f + static_cast<float>(M_PI) / 8 * static_cast<float>(k);
      for (const auto& [reach, kind] : {std::pair(4.9f, PickKind::knot), {5.1f, PickKind::curve}}) {
        const glm::vec2 pixel = middle + scale * reach * glm::vec2(std::cos(a), std::sin(a));
        EXPECT_EQ(pick(scene.document, scene.derived, scene.motion, scene.settings, scene.view, pixel).kind, kind)
            << scale << " " << k << " " << reach;
      }
    }
  }
}

TEST(pick, handles_can_be_picked_of_the_selection_alone) {
  Scene scene(test::sample_document());
  const world::Entity knot = scene.document.track.knots[2];
  const glm::vec3 handle = world::out_handle(world::knot(scene.document, knot));
  EXPECT_NE(scene.at(handle).kind, PickKind::handle_out);
  for (const world::Entity selected : {knot, scene.document.track.segments[2], scene.document.track.segments[1]}) {
    scene.settings.selected = selected;
    EXPECT_EQ(scene.at(handle), (Pick{PickKind::handle_out, knot}));
  }
  scene.settings.selected = scene.document.track.segments[0];
  EXPECT_NE(scene.at(handle).kind, PickKind::handle_out);
}

TEST(pick, carts_are_boxes_on_the_rails) {
  // Seen from the side (along -Z): the rails run along X, so the body's box covers 2.2 m by 1.1 m of the picture, the
  // heads' 1.35 m by 0.35 m.
  world::Document d = test::straight_document({-20, 5, 1}, {20, 5, 1});
  world::add_cart(d, d.track.segments[0], 0.6);  // at x = 4
  const Scene scene(d, {{4, 5.5f, 1}, 0, 0, 20});
  const world::Entity cart = d.entities.pool<world::Train>().entities()[0];
  // On the near side, z = 1 + 0.65.
  for (const auto& [x, y, hit] :
       {std::tuple(4.0f, 5.55f, true), std::tuple(5.05f, 6.05f, true), std::tuple(2.95f, 5.05f, true),
        std::tuple(5.15f, 5.55f, false), std::tuple(2.85f, 5.55f, false), std::tuple(5.0f, 6.15f, false),
        std::tuple(4.0f, 4.7f, false)})
    EXPECT_EQ(scene.at({x, y, 1.65f}) == (Pick{PickKind::cart, cart}), hit) << x << " " << y;
  EXPECT_NEAR(scene.at({4.2f, 5.55f, 1.65f}).position.z, 1.65, 1e-3);
  // Heads, z = 1 + 0.4.
  for (const auto& [x, y, hit] : {std::tuple(4.2f, 6.4f, true), std::tuple(2.95f, 6.4f, true),
                                  std::tuple(4.3f, 6.4f, false), std::tuple(4.2f, 6.5f, false)})
    EXPECT_EQ(scene.at({x, y, 1.4f}) == (Pick{PickKind::cart, cart}), hit) << x << " " << y;
  EXPECT_NEAR(scene.at({4.2f, 6.3f, 1.4f}).position.z, 1.4, 1e-3);
}

TEST(pick, the_nearer_cart_wins_and_knots_beat_carts) {
  world::Document d = test::straight_document({1, 5, 20}, {1, 5, -20});
  world::add_cart(d, d.track.segments[0], 0.3);
  world::add_cart(d, d.track.segments[0], 0.6);
  const Scene scene(d, {{1, 5.5f, 0}, 0, 0, 60});  // along the rails
  EXPECT_EQ(scene.at({1, 5.9f, 8}).entity, d.entities.pool<world::Train>().entities()[0]);
  Scene on_knot(d, {{1, 5.5f, 0}, 0, 2, 60});
  EXPECT_EQ(on_knot.at({1, 5, 20}).kind, PickKind::knot);
}

TEST(pick, the_cart_that_the_eye_rides_on_is_not_picked) {
  world::Document d = test::straight_document({-20, 5, 1}, {20, 5, 1});
  world::add_cart(d, d.track.segments[0], 0.3);
  Scene scene(d);
  const sim::Pose seat = sim::pose(scene.derived, scene.motion.carts.items()[0], world::FrameMethod::knots);
  scene.view = view_of(ride_eye(seat, 45), kViewport);
  for (float x = 60; x < 690; x += 37)
    for (float y = 35; y < 500; y += 31)
      EXPECT_NE(pick(scene.document, scene.derived, scene.motion, scene.settings, scene.view, {x, y}).kind,
                PickKind::cart);
}

TEST(pick, positions_of_things_lead_back_to_them) {
  Scene scene(test::sample_document());
  scene.settings.selected = scene.document.track.knots[1];
  for (const auto& [kind, entity, t] :
       {std::tuple(PickKind::knot, scene.document.track.knots[3], 0.0),
        std::tuple(PickKind::handle_in, scene.settings.selected, 0.0),
        std::tuple(PickKind::handle_out, scene.settings.selected, 0.0),
        std::tuple(PickKind::curve, scene.document.track.segments[2], 0.41),
        std::tuple(PickKind::cart, scene.document.entities.pool<world::Train>().entities()[0], 0.0)}) {
    const auto position = position_of(scene.document, scene.derived, scene.motion, kind, entity, t);
    ASSERT_TRUE(position);
    const Pick found = scene.at(*position);
    EXPECT_EQ(found, (Pick{kind, entity}));
    if (kind == PickKind::curve) {
      EXPECT_NEAR(found.t, t, 1e-3);
    }
  }
  EXPECT_FALSE(
      position_of(scene.document, scene.derived, scene.motion, PickKind::knot, scene.document.track.segments[0], 0));
  EXPECT_FALSE(position_of(scene.document, scene.derived, scene.motion, PickKind::cart, {}, 0));
}

TEST(pick, of_five_thousand_segments_a_few_are_looked_at) {
  const Scene scene(test::ring_document(5000, 8000));
  std::size_t most_nodes = 0, most_segments = 0;
  for (std::size_t i = 0; i < scene.derived.order.size(); i += 7) {
    const glm::vec2 pixel(*project(scene.view, test::polyline_of(scene.derived.shape(scene.derived.order[i]))[20]));
    std::size_t segments = 0;
    bool seen = false;
    const std::size_t nodes = visit_near(
        scene.derived.tree, PixelBeam(scene.view, pixel), [] { return 0.25; },
        [&](std::size_t s) { ++segments, seen |= s == i; });
    ASSERT_TRUE(seen) << i;
    most_nodes = std::max(most_nodes, nodes), most_segments = std::max(most_segments, segments);
  }
  EXPECT_GT(scene.derived.tree.nodes.size(), 400u);
  EXPECT_LE(most_nodes, 20u) << "a way down, five deep, and a neighbour or two";
  EXPECT_LE(most_segments, 12u);
}

}  // namespace pick_test
}  // namespace coaster::view
