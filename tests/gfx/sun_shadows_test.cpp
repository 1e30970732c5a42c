// Shadows in pictures, compared with geometry: where they fall, and when their maps are drawn.
#include "gfx/sun_shadows.h"

#include <cmath>

#include "gfx/studio.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace sun_shadows_test {

using test::colour_at;
using test::Track;
using Shadows = test::Studio;

int brightness(glm::ivec3 c) { return c.x + c.y + c.z; }

// Where the light through a place meets the ground.
glm::vec3 on_ground(glm::vec3 at, world::Style style) {
  const glm::vec3 sun = glm::normalize(scenery_of(style).sun);
  return at - sun * (at.y / sun.y);
}

TEST_F(Shadows, fall_where_the_light_through_the_track_meets_the_ground) {
  width_ = 320, height_ = 180, show_polyline_ = false;
  const Track track(test::straight_document({-21, 2.6f, 1}, {19, 3.1f, 4}, 4));
  const sim::DerivedTrack nothing;
  const view::Overlay overlay;
  for (const world::Style style : {world::Style::day, world::Style::dusk, world::Style::blueprint}) {
    style_ = style;
    const Image with = picture(track);
    // The same view with nothing in it.
    const view::View view = look(track);
    renderer_->draw(Scene{nothing, view, overlay, {}, false, nullptr, {}, {}, style}, width_, height_);
    const Image without = renderer_->read_pixels();
    int seen = 0, darker = 0;
    for (const world::Entity e : track.derived.order) {
      const sim::SegmentShape& shape = track.derived.shape(e);
      for (const glm::vec3 p : test::polyline_of(shape)) {
        const auto pixel = view::project(view, on_ground(p, style));
        if (!pixel || pixel->x < 1 || pixel->y < 1 || pixel->x > 318 || pixel->y > 178) continue;
        // Searches around that pixel, because the spine is half a metre below the rails.
        int least = 0;
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x)
            least = std::min(least, brightness(colour_at(with, int(pixel->x) + x, int(pixel->y) + y)) -
                                        brightness(colour_at(without, int(pixel->x) + x, int(pixel->y) + y)));
        ++seen;
        darker += least < -8;
      }
    }
    EXPECT_GT(seen, 50) << int(style);
    EXPECT_GT(darker, seen * 9 / 10) << int(style);
  }
}

TEST_F(Shadows, of_a_train_fall_on_the_rails_below_it) {
  width_ = 320, height_ = 180, show_polyline_ = false;
  const Track track(test::straight_document({-20, 6, 1}, {20, 6, 1}, 4));
  const glm::vec3 rail(0, 6, 1);
  const Image lit = picture(track);
  sim::Pose high;
  high.position = glm::dvec3(rail + 12.0f * glm::normalize(scenery_of(world::Style::day).sun));
  high.frame.forward = {1, 0, 0}, high.frame.up = {0, 1, 0};
  carts_ = {high};
  const Image shaded = picture(track);
  const auto pixel = view::project(look(track), rail);
  ASSERT_TRUE(pixel);
  int darker = 0;
  for (int y = -4; y <= 4; ++y)
    for (int x = -4; x <= 4; ++x) {
      const glm::ivec3 a = colour_at(lit, int(pixel->x) + x, int(pixel->y) + y),
                       b = colour_at(shaded, int(pixel->x) + x, int(pixel->y) + y);
      darker += a.x > a.y + 60 && b.x < a.x - 25;  // paint in the sun before
    }
  EXPECT_GT(darker, 3);
}

TEST_F(Shadows, are_drawn_anew_only_when_something_changed) {
  Track track(test::ring_document(9, 17.3f));
  world::add_cart(track.document, track.document.track.segments[2], 0.43);
  track.derive();
  world::Motion motion;
  sim::reset(track.document, track.derived, motion);
  carts_ = {sim::pose(track.derived, motion.carts.items()[0], world::FrameMethod::knots)};
  EXPECT_EQ(draw(track).shadow_maps, 2);
  EXPECT_EQ(draw(track).shadow_maps, 0);
  carts_[0].position += glm::dvec3(0.1, 0, 0);
  EXPECT_EQ(draw(track).shadow_maps, 1) << "the train's";
  track.move(3, {0.2f, 0.1f, 0});
  EXPECT_EQ(draw(track).shadow_maps, 1) << "the track's";
  style_ = world::Style::dusk;
  EXPECT_EQ(draw(track).shadow_maps, 2) << "another sun";
  carts_.clear();
  EXPECT_EQ(draw(track).shadow_maps, 1) << "nothing is left of the train";
  EXPECT_EQ(draw(track).shadow_maps, 0);
  // Another eye sees the same maps.
  const view::Overlay overlay;
  view::View view =
      view::orbit_view({.target = {13, 20, -8}, .yaw_deg = 140, .pitch_deg = 40, .distance = 60}, {0, 0, 160, 90});
  const Scene scene{track.derived, view, overlay, {}, true, nullptr, {}, {}, style_};
  EXPECT_EQ(renderer_->draw(scene, 160, 90).shadow_maps, 0);
}

TEST_F(Shadows, switched_off_none_is_drawn_and_on_again_they_are_as_they_were) {
  Track track(test::ring_document(9, 17.3f), 12);
  const Image shaded = picture(track);
  shadows_ = false;
  const DrawStats stats = draw(track);
  EXPECT_EQ(stats.shadow_maps, 2) << "both emptied, once";
  EXPECT_EQ(draw(track).shadow_maps, 0);
  const Image lit = picture(track);
  long darker = 0, brighter = 0;
  for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
    darker += lit.rgba[i] + 8 < shaded.rgba[i];
    brighter += lit.rgba[i] > shaded.rgba[i] + 8;
  }
  EXPECT_GT(brighter, 500);
  EXPECT_EQ(darker, 0);
  EXPECT_TRUE(lit.rgba == picture(*fresh(), track).rgba);
  shadows_ = true;
  EXPECT_TRUE(picture(track).rgba == shaded.rgba);
}

TEST_F(Shadows, a_running_train_uploads_nothing_and_a_larger_track_takes_no_more_calls) {
  const auto calls = [&](int knots, double radius) {
    Track track(test::ring_document(knots, radius), 8);
    world::add_cart(track.document, track.document.track.segments[2], 0.43);
    track.derive();
    world::Motion motion;
    sim::reset(track.document, track.derived, motion);
    renderer_ = fresh();
    for (int i = 0; i < 3; ++i) {
      carts_ = {sim::pose(track.derived, motion.carts.items()[0], world::FrameMethod::knots)};
      carts_[0].position += glm::dvec3(0.2 * i, 0, 0);
      const DrawStats stats = draw(track);
      EXPECT_EQ(stats.uploads, i == 0 ? knots : 0);
      EXPECT_EQ(stats.upload_bytes > 0, i == 0);
      EXPECT_LE(stats.shadow_maps, i == 0 ? 2 : 1);
      if (i == 2) return stats.draw_calls;
    }
    return 0;
  };
  // Near and far take a call each, for the track and what holds it.
  EXPECT_LE(calls(1000, 1600), calls(9, 17.3) + 4);
}

}  // namespace sun_shadows_test
}  // namespace coaster::gfx
