// Pictures of a park: what they show, that they depend on the scene alone, and what they upload.
#include "gfx/park_passes.h"

#include "gfx/studio.h"
#include "sim/ground/ground.h"
#include "sim/ground/plants.h"
#include "sim/solids/coaster_form.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace park_passes_test {

using test::colour_at;
using test::count;

class Park : public test::Studio {
 protected:
  void SetUp() override {
    Studio::SetUp();
    width_ = 160, height_ = 90;
    settle(world::Land::hills);
  }
  void settle(world::Land land) {
    track_.document.park = world::usual_park(land, 7);
    update();
  }
  void update() {
    track_.derive();
    ground_.update(track_.document, track_.derived, sim::track_room(sim::form_of(track_.document.kind)));
    plants_.update(ground_);
  }
  DrawStats show(Renderer& renderer, bool unseen = false) {
    const view::View view = look(track_);
    const view::Overlay none;
    Scene scene{track_.derived, view, none, carts_, false};
    scene.style = style_, scene.shadows = shadows_, scene.scenery = scenery_, scene.seconds = seconds_;
    scene.document = &track_.document, scene.ground = &ground_, scene.unseen = unseen;
    if (scenery_ != world::Scenery::plain) scene.plants = &plants_;
    scene.splashes = splashes_;
    const DrawStats stats = renderer.draw(scene, width_, height_);
    EXPECT_TRUE(renderer.failure().ok()) << renderer.failure().message;
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return stats;
  }
  Image shot(Renderer& renderer) {
    show(renderer);
    return renderer.read_pixels();
  }
  Image shot() { return shot(*renderer_); }

  test::Track track_{test::ring_document(12, 95, 9)};
  sim::Ground ground_;
  sim::Plants plants_;
  world::Scenery scenery_ = world::Scenery::park;
  double seconds_ = 3;
  std::vector<Splash> splashes_;
};

// By rays: land and sky are told apart by colour, where the air leaves any.
TEST_F(Park, shows_land_where_a_ray_meets_it) {
  scenery_ = world::Scenery::plain, shadows_ = false;
  width_ = 96, height_ = 54;
  int land = 0, sky = 0, wrong = 0;
  for (const double turn : {0.0, 2.1, 4.2}) {
    const double x = 60 * std::sin(turn), z = 60 * std::cos(turn);
    eye_ = view::Eye{.position = {x, ground_.surface(x, z) + 9, z},
                     .forward = glm::normalize(glm::dvec3(std::sin(turn + 0.4), 0.05, std::cos(turn + 0.4)))};
    const view::View view = look(track_);
    const Image image = shot();
    for (int y = 0; y < height_; ++y) {
      for (int x_pixel = 0; x_pixel < width_; ++x_pixel) {
        const glm::vec2 pixel(static_cast<float>(x_pixel) + 0.5f, static_cast<float>(y) + 0.5f);
        const auto meets = [&](glm::vec2 at) {
          const view::Ray ray = view::ray_through(view, at);
          return ground_.meet(glm::dvec3(ray.origin), glm::dvec3(ray.direction), 2000);
        };
        const auto met = meets(pixel);
        // The horizon itself, and what is in the mist, are left out.
        if (meets(pixel + glm::vec2(0, 2)).has_value() != met.has_value() ||
            meets(pixel - glm::vec2(0, 2)).has_value() != met.has_value() || (met && *met > 250))
          continue;
        const view::Ray ray = view::ray_through(view, pixel);
        if (!met && ray.direction.y < 0.12f) continue;
        if (met && ground_.height(double{ray.origin.x} + *met * double{ray.direction.x},
                                  double{ray.origin.z} + *met * double{ray.direction.z}) < ground_.water() + 0.3)
          continue;
        const glm::ivec3 c = colour_at(image, x_pixel, y);
        (met ? land : sky) += 1;
        wrong += (c.z > c.y) == met.has_value();
      }
    }
  }
  EXPECT_GT(land, 1'000);
  EXPECT_GT(sky, 600);
  EXPECT_LT(wrong, (land + sky) / 50) << "track and trains, which are red, and their supports";
}

TEST_F(Park, uploads_nothing_in_a_still_frame_and_near_patches_after_a_move) {
  const DrawStats first = show(*renderer_);
  EXPECT_EQ(first.park_uploads, 144);
  EXPECT_GT(first.park_upload_bytes, 144 * 33 * 33 * 14);
  EXPECT_LT(first.park_upload_bytes, 8'000'000);
  const DrawStats still = show(*renderer_);
  EXPECT_EQ(still.park_uploads, 0);
  EXPECT_EQ(still.park_upload_bytes, 0);
  EXPECT_EQ(still.shadow_maps, 0);
  track_.move(3, {0.5f, -1, 0.5f});
  update();
  const DrawStats moved = show(*renderer_);
  EXPECT_GT(moved.park_uploads, 0);
  EXPECT_LE(moved.park_uploads, 24);
  EXPECT_EQ(moved.uploads, 2);
}

TEST_F(Park, trees_cast_shadows_before_there_is_a_track) {
  track_.document.track = {};
  track_.document.entities = {};
  settle(world::Land::hills);
  carts_.clear();
  eye_ = view::Eye{.position = {0, ground_.surface(0, 0) + 60, 0}, .forward = glm::normalize(glm::dvec3(0.6, -1, 0.3))};
  shadows_ = false;
  const Image bright = shot();
  shadows_ = true;
  const Image shaded = shot();
  int darker = 0, brighter = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const int change = colour_at(shaded, x, y).y - colour_at(bright, x, y).y;
      darker += change<-15, brighter += change> 2;
    }
  EXPECT_GT(darker, 100);
  EXPECT_EQ(brighter, 0);
}

TEST_F(Park, looks_the_same_whatever_was_drawn_before) {
  const Image before = shot();
  style_ = world::Style::night;
  shot();
  settle(world::Land::snow);
  scenery_ = world::Scenery::plain;
  shot();
  style_ = world::Style::day, scenery_ = world::Scenery::park;
  settle(world::Land::hills);
  track_.move(5, {3, -4, 2});
  update();
  shot();
  track_.move(5, {-3, 4, -2});
  update();
  const auto other = renderer_->sibling(0);
  const Image kept = shot(), fresh = shot(*other);
  EXPECT_EQ(kept.rgba, fresh.rgba);
  (void)before;  // the moves round to other floats
}

TEST_F(Park, counts_unseen_frames_as_seen_ones) {
  for (const world::Style style : {world::Style::day, world::Style::night, world::Style::blueprint}) {
    style_ = style;
    const auto a = renderer_->sibling(0), b = renderer_->sibling(0);
    const DrawStats unseen = show(*a, true), seen = show(*b);
    EXPECT_EQ(unseen.draw_calls, seen.draw_calls) << base::name_of(style);
    EXPECT_EQ(unseen.triangles, seen.triangles) << base::name_of(style);
  }
}

TEST_F(Park, has_every_land_in_every_style_and_scenery) {
  width_ = 64, height_ = 36;
  std::vector<Image> all;
  for (std::size_t land = 1; land < base::count_of<world::Land>(); ++land) {
    settle(static_cast<world::Land>(land));
    for (std::size_t style = 0; style < base::count_of<world::Style>(); ++style) {
      for (const world::Scenery scenery : {world::Scenery::plain, world::Scenery::park}) {
        style_ = static_cast<world::Style>(style), scenery_ = scenery;
        all.push_back(shot());
      }
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(i / 2 == j / 2 || all[i].rgba != all[j].rgba) << i << " " << j;
}

TEST_F(Park, has_water_with_waves_that_only_its_clock_moves) {
  settle(world::Land::valley);
  // Straight down on the deepest place.
  glm::dvec2 deepest(0);
  for (double x = -200; x <= 200; x += 4)
    for (double z = -200; z <= 200; z += 4)
      if (ground_.height(x, z) < ground_.height(deepest.x, deepest.y)) deepest = {x, z};
  ASSERT_LT(ground_.height(deepest.x, deepest.y), ground_.water() - 1);
  eye_ = view::Eye{.position = {deepest.x, ground_.water() + 14, deepest.y}, .forward = {0, -1, 0}, .up = {0, 0, -1}};
  const Image wavy = shot();
  const glm::ivec3 middle = colour_at(wavy, width_ / 2, height_ / 2);
  EXPECT_GT(middle.z, middle.x + 20);
  EXPECT_EQ(shot().rgba, wavy.rgba);
  seconds_ = 4;
  EXPECT_NE(shot().rgba, wavy.rgba);
  scenery_ = world::Scenery::plain;
  const Image flat = shot();
  seconds_ = 5;
  EXPECT_EQ(shot().rgba, flat.rgba);
}

TEST_F(Park, is_rich_near_the_eye_at_a_bounded_cost) {
  settle(world::Land::meadow);
  eye_ = view::Eye{.position = {60, ground_.height(60, 70) + 1.7, 70}, .forward = {0.6, -0.1, 0.79}};
  const DrawStats park = show(*renderer_);
  const Image usual = renderer_->read_pixels();
  scenery_ = world::Scenery::rich;
  const DrawStats rich = show(*renderer_);
  EXPECT_GT(rich.triangles, park.triangles + 500);
  EXPECT_LT(rich.triangles, park.triangles + 60'000);
  EXPECT_LE(rich.draw_calls, park.draw_calls + 40);
  EXPECT_NE(shot().rgba, usual.rgba);
  EXPECT_EQ(shot().rgba, shot(*renderer_->sibling(0)).rgba);
  EXPECT_EQ(show(*renderer_, true).triangles, rich.triangles);
}

TEST_F(Park, shows_spray_where_cars_pass_over_water) {
  eye_ = view::Eye{.position = {0, ground_.height(0, 30) + 20, 30}, .forward = {0, -0.5, -1}};
  const float high = static_cast<float>(ground_.height(0, 0)) + 8;
  const Image dry = shot();
  splashes_ = {{{0, high, 0}, {1, 0, 0}, 1}};
  const Image wet = shot();
  int brighter = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) brighter += colour_at(wet, x, y).x > colour_at(dry, x, y).x + 8;
  EXPECT_GT(brighter, 15);
  EXPECT_EQ(shot().rgba, wet.rgba);
  seconds_ = 3.1;
  EXPECT_NE(shot().rgba, wet.rgba) << "it moves with the clock";
  splashes_.clear();
  seconds_ = 3;
  EXPECT_EQ(shot().rgba, dry.rgba);
}

TEST_F(Park, is_lit_by_lamps_at_night) {
  style_ = world::Style::night;
  eye_.reset();
  const auto bright = [](glm::ivec3 c) { return c.x > 170 && c.x > c.z + 20; };
  EXPECT_GT(count(shot(), bright), 10);
  style_ = world::Style::day;
  const DrawStats day = show(*renderer_);
  style_ = world::Style::night;
  EXPECT_GT(show(*renderer_).triangles, day.triangles);
}

TEST_F(Park, darkens_land_below_the_track) {
  scenery_ = world::Scenery::plain;
  eye_ = view::Eye{.position = {0, 260, 0}, .forward = {0, -1, 0}, .up = {0, 0, -1}};
  width_ = 320, height_ = 180;
  const Image with = shot();
  shadows_ = false;
  const Image without = shot();
  int darker = 0, brighter = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const int change = colour_at(with, x, y).y - colour_at(without, x, y).y;
      darker += change<-8, brighter += change> 8;
    }
  EXPECT_GT(darker, 60);
  EXPECT_EQ(brighter, 0);
}

}  // namespace park_passes_test
}  // namespace coaster::gfx
