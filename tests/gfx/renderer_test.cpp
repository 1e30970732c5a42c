// Pictures of a small track: their contents, and that they depend only on the scene, not on the renderer's earlier
// pictures.
#include "gfx/per_frame_instances.h"

#include <cmath>
#include <map>
#include <random>

#include <glm/gtx/component_wise.hpp>

#include "gfx/studio.h"
#include "world/evaluation_settings.h"
#include "world/laboratory.h"

namespace coaster::gfx {
namespace renderer_test {

using test::colour_at;
using test::count;
using test::Track;
using Pictures = test::Studio;

// Rails and spine: much more red than green. Nothing else in a scene is.
bool red(glm::ivec3 c) { return c.x > c.y + 40 && c.x > c.z + 40; }
bool blue(glm::ivec3 c) { return c.z > c.x + 40 && c.z > c.y + 25 && c.x < 110; }
bool green(glm::ivec3 c) { return c.y > c.x && c.y > c.z; }

Track ring() { return Track(test::ring_document(9, 17.3f)); }

TEST_F(Pictures, show_track_sky_and_ground) {
  width_ = 320, height_ = 180, show_polyline_ = false;
  const Image image = picture(ring());
  EXPECT_GT(count(image, red), 150);
  EXPECT_GT(count(image, green), 320 * 180 / 3);
  EXPECT_EQ(count(image, [](glm::ivec3 c) { return c == glm::ivec3(255) || c == glm::ivec3(0); }), 0)
      << "no pure black or white";
}

// A train may go into the ground: from there neither sky nor grass is seen, whichever way the eye looks.
TEST_F(Pictures, below_the_ground_there_is_earth_all_around) {
  const Track track(test::straight_document({0, 5, 0}, {30, 5, 0}));
  for (const glm::dvec3 forward : {glm::dvec3(0, 0, -1), glm::dvec3(0, 0.6, -0.8), glm::dvec3(0, -0.6, -0.8)}) {
    eye_ = view::Eye{.position = {15, -3, 9'000}, .forward = forward};
    const Image image = picture(track);
    const glm::ivec3 middle = colour_at(image, width_ / 2, height_ / 2);
    const auto other = [&](glm::ivec3 c) { return glm::any(glm::greaterThan(glm::abs(c - middle), glm::ivec3(12))); };
    EXPECT_EQ(count(image, other), 0) << forward.y;
    EXPECT_GE(middle.x, middle.z) << "earth is not blue";
  }
}

// By the ray of each pixel: those that go up show sky, the others ground, in a corner of any number of sides too.
TEST_F(Pictures, the_horizon_is_where_rays_are_level_however_the_eye_is_turned) {
  width_ = 96, height_ = 64, show_polyline_ = false, shadows_ = false;
  const Track track(test::straight_document({0, 1, 900}, {9, 1, 900}));  // behind the eye
  int corners = 0;
  std::map<std::pair<int, int>, glm::ivec3> skies;  // by direction, from the first pictures
  for (const double pitch : {0.45, 0.3, -0.45, -0.2, 0.0})
    for (const double roll : {0.0, 0.6, -0.8, 2.4}) {
      const glm::dvec3 forward(0, std::sin(pitch), -std::cos(pitch)), level(0, std::cos(pitch), std::sin(pitch));
      const glm::dvec3 up = std::cos(roll) * level + std::sin(roll) * glm::dvec3(1, 0, 0);
      eye_ = view::Eye{.position = {3, 6, 40}, .forward = forward, .up = up};
      const Image image = picture(track);
      const glm::dvec3 right = glm::cross(forward, up);
      const double tall = std::tan(45.0 / 2 * M_PI / 180), wide = tall * width_ / height_;
      int sky = 0, wrong = 0, off = 0;
      for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
          const double across = (2 * (x + 0.5) / width_ - 1) * wide, high = (1 - 2 * (y + 0.5) / height_) * tall;
          const glm::dvec3 ray = glm::normalize(forward + across * right + high * up);
          const double rise = ray.y;
          if (std::abs(rise) < 0.05) continue;  // haze
          const glm::ivec3 c = colour_at(image, x, y);
          sky += rise > 0;
          wrong += (c.z > c.y) != (rise > 0);
          if (rise < 0) continue;
          const auto known =
              skies.try_emplace({static_cast<int>(100 * (2 + ray.x)), static_cast<int>(100 * rise)}, c).first->second;
          off += glm::compMax(glm::abs(c - known));
        }
      EXPECT_EQ(wrong, 0) << pitch << ' ' << roll;
      EXPECT_LT(off, 8 * sky + 1) << "clouds of the same direction, " << pitch << ' ' << roll;
      corners += sky > 0 && sky < width_ * height_ / 6;
    }
  EXPECT_GT(corners, 2);
}

TEST_F(Pictures, values_colour_the_track_and_are_written_where_they_change) {
  width_ = 320, height_ = 180, show_polyline_ = false;
  const Track track = ring();
  const auto yellow = [](glm::ivec3 c) { return c.x > 200 && c.y > 170 && c.z < 130; };
  const auto navy = [](glm::ivec3 c) { return c.z > c.x + 30 && c.x < 70; };
  sim::TrackValues values{world::Colouring::speed, std::vector<float>(9 * sim::kValuesPerSegment, 20.0f), 0, 20};
  values_ = &values;
  gfx::DrawStats stats = draw(track);
  EXPECT_EQ(stats.recolours, 9);
  EXPECT_EQ(stats.uploads, 9);
  const Image fast = renderer_->read_pixels();
  EXPECT_GT(count(fast, yellow), 150);
  EXPECT_EQ(count(fast, red), 0);
  std::fill_n(values.values.begin() + 4 * sim::kValuesPerSegment, sim::kValuesPerSegment, 0.0f);
  stats = draw(track);
  EXPECT_EQ(stats.recolours, 1);
  EXPECT_EQ(stats.uploads, 0);
  const Image slow = renderer_->read_pixels();
  EXPECT_GT(count(slow, navy), count(fast, navy) + 10);
  EXPECT_LT(count(slow, yellow), count(fast, yellow));
  stats = draw(track);
  EXPECT_EQ(stats.recolours, 0);
  std::fill(values.values.begin(), values.values.end(), sim::kUnknownValue);
  draw(track);
  const Image unknown = renderer_->read_pixels();
  EXPECT_EQ(count(unknown, yellow) + count(unknown, navy),
            count(picture(*fresh(), track), yellow) + count(picture(*fresh(), track), navy));
  EXPECT_EQ(count(unknown, yellow), 0);
  // Painted again, as if there had never been values.
  values_ = nullptr;
  EXPECT_EQ(picture(track).rgba, picture(*fresh(), track).rgba);
}

TEST_F(Pictures, the_shadow_is_on_the_ground_and_darkens_once) {
  width_ = 320, height_ = 180, show_polyline_ = false;
  Track track = ring();
  const Image with = picture(track);
  const view::View view = look(track);
  const sim::DerivedTrack nothing;
  const view::Overlay overlay;
  renderer_->draw(Scene{nothing, view, overlay, {}}, width_, height_);
  const Image without = renderer_->read_pixels();
  int darker = 0, darkest = 255;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const glm::ivec3 a = colour_at(with, x, y), b = colour_at(without, x, y);
      if (a == b || a.y < a.x + 12 || a.y < a.z + 12) continue;  // the track itself
      ++darker;
      darkest = std::min(darkest, a.y);
    }
  EXPECT_GT(darker, 80);
  // Without the sun the ground's green 168 is about 117; a second shadow over it would take it to 80.
  EXPECT_GT(darkest, 100);
}

TEST_F(Pictures, a_cart_is_blue_and_where_its_pose_is) {
  width_ = 320, height_ = 180, show_polyline_ = false;
  Track track = ring();
  world::add_cart(track.document, track.document.track.segments[2], 0.43);
  track.derive();
  world::Motion motion;
  sim::reset(track.document, track.derived, motion);
  EXPECT_EQ(count(picture(track), blue), 0);
  carts_ = {sim::pose(track.derived, motion.carts.items()[0], world::FrameMethod::knots)};
  const Image image = picture(track);
  const auto middle = view::project(look(track), glm::vec3(carts_[0].position + 0.55 * carts_[0].frame.up));
  ASSERT_TRUE(middle);
  int near = 0;
  for (int y = -5; y <= 5; ++y)
    for (int x = -5; x <= 5; ++x) near += blue(colour_at(image, int(middle->x) + x, int(middle->y) + y));
  EXPECT_GT(near, 4);
  EXPECT_EQ(near, count(image, blue)) << "blue elsewhere";
}

TEST_F(Pictures, of_many_cars_those_far_from_the_eye_are_blocks) {
  Track track = ring();
  const auto triangles = [&](std::size_t cars) {
    carts_.clear();
    for (std::size_t i = 0; i < cars; ++i) {
      sim::Pose car = sim::pose(track.derived, sim::TrackPlace{0, 0.1}, world::FrameMethod::knots);
      car.position.y += 3.0 * static_cast<double>(i);  // ever farther
      carts_.push_back(car);
    }
    std::reverse(carts_.begin(), carts_.end());
    const view::View view = look(track);
    const view::Overlay overlay;
    return renderer_->draw(Scene{track.derived, view, overlay, carts_}, width_, height_).triangles;
  };
  const std::int64_t none = triangles(0), full = triangles(CarInstances::kFullCars) - none;
  EXPECT_GT(full, std::int64_t{1000} * static_cast<std::int64_t>(CarInstances::kFullCars));
  const std::int64_t more = triangles(CarInstances::kFullCars + 9488) - none - full;
  EXPECT_GE(more, std::int64_t{12} * 9488);
  EXPECT_LE(more, std::int64_t{12} * 9488 * 3);  // in the picture and in shadow maps
}

TEST_F(Pictures, a_lines_width_is_in_pixels_and_its_ends_are_where_they_project) {
  view::Overlay overlay;
  Track track = ring();
  const glm::vec3 from = track.derived.shape(track.derived.order[0]).key.cubic.p0,
                  to = track.derived.shape(track.derived.order[4]).key.cubic.p0;
  overlay.lines.push_back({from, to, 5.0f, 0xff00ffff});
  const Image image = picture(track, overlay);
  const auto a = view::project(look(track), from), b = view::project(look(track), to);
  ASSERT_TRUE(a && b);
  const double length = glm::distance(glm::vec2(*a), glm::vec2(*b));
  const int painted = count(image, [](glm::ivec3 c) { return c.x > 170 && c.z > 170 && c.y < 110; });
  EXPECT_NEAR(painted, 5 * length, 5 + length);  // the feather is within half a pixel of each side
}

TEST_F(Pictures, marks_are_drawn_in_the_lists_order_over_everything) {
  Track track = ring();
  const glm::vec3 place = track.derived.shape(track.derived.order[3]).key.cubic.p0;
  view::Overlay overlay;
  overlay.marks = {{place, 8, 0xff0000ff, view::MarkShape::disc}, {place, 5, 0x0000ffff, view::MarkShape::square}};
  const auto pixel = view::project(look(track), place);
  ASSERT_TRUE(pixel);
  const auto middle = [&](const Image& image) { return colour_at(image, int(pixel->x), int(pixel->y)); };
  EXPECT_EQ(middle(picture(track, overlay)), glm::ivec3(0, 0, 255));
  std::swap(overlay.marks[0], overlay.marks[1]);
  EXPECT_EQ(middle(picture(track, overlay)), glm::ivec3(255, 0, 0));
}

TEST_F(Pictures, only_the_viewport_is_drawn_into) {
  viewport_ = {40, 20, 80, 50};
  const Image image = picture(ring());
  const glm::ivec3 background(27, 31, 39);
  for (const auto& [x, y] : {std::pair{39, 30}, {120, 30}, {60, 19}, {60, 70}, {0, 0}, {159, 89}})
    EXPECT_EQ(colour_at(image, x, y), background) << x << "," << y;
  for (const auto& [x, y] : {std::pair{40, 20}, {119, 20}, {40, 69}, {119, 69}})
    EXPECT_NE(colour_at(image, x, y), background) << x << "," << y;
}

TEST_F(Pictures, a_viewport_without_area_or_outside_draws_nothing) {
  const Track track = ring();
  view::View view = look(track);
  const view::Overlay overlay = view::build_overlay(track.document, track.derived, track.settings, view, {});
  ASSERT_FALSE(overlay.marks.empty());
  for (const view::Viewport viewport :
       {view::Viewport{40, 40, 0, 0}, {40, 40, 50, 0}, {500, 40, 30, 30}, {-90, -90, 40, 40}}) {
    view.viewport = viewport;
    renderer_->draw(Scene{track.derived, view, overlay, {}}, width_, height_);
    const Image image = renderer_->read_pixels();
    EXPECT_EQ(count(image, [](glm::ivec3 c) { return c != glm::ivec3(27, 31, 39); }), 0)
        << viewport.x << " " << viewport.width;
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST_F(Pictures, a_resized_picture_is_that_of_a_fresh_renderer) {
  const Track track = ring();
  for (const auto& [width, height] : {std::pair{160, 90}, {33, 71}, {1, 1}, {200, 40}, {160, 90}}) {
    width_ = width, height_ = height;
    const Image image = picture(track);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.rgba, picture(*renderer_->sibling(samples_), track).rgba) << width << "x" << height;
  }
}

TEST_F(Pictures, samples_are_clamped_and_can_be_switched) {
  const Track track = ring();
  const Image plain = picture(track);
  renderer_->set_samples(10'000);
  EXPECT_LE(draw(track).samples, gl_.max_samples);
  renderer_->set_samples(4);
  const DrawStats stats = draw(track);
  if (gl_.max_samples >= 4) {
    EXPECT_EQ(stats.samples, 4);
    EXPECT_NE(renderer_->read_pixels().rgba, plain.rgba);
  }
  EXPECT_EQ(stats.uploads, 0);
  renderer_->set_samples(1);
  EXPECT_EQ(picture(track).rgba, plain.rgba);
}

// A random edit: a knot moved, added behind, or taken away.
void edit(std::mt19937& bits, Track& track) {
  const std::vector<world::Entity>& knots = track.document.track.knots;
  const std::size_t at = bits() % knots.size();
  const auto shift = [&] { return static_cast<float>(bits() % 1000) / 250.0f - 2.0f; };
  switch (bits() % 4) {
    case 0: world::remove_knot(track.document, knots[knots.size() > 5 ? at : 0]); break;
    case 1: {
      const world::Entity segment = track.document.track.segments[bits() % track.document.track.segments.size()];
      test::split_at(track.document, segment, 0.37);
      break;
    }
    case 2: track.settings.evaluation->steps = 3 + static_cast<int>(bits() % 60); break;
    default: track.document.entities.get<world::Knot>(knots[at]).position += glm::vec3(shift(), shift(), shift());
  }
  if (track.document.track.knots.size() < 4) track.document = test::ring_document(9, 17.3f);
  track.derive();
}

TEST_F(Pictures, of_siblings_are_alike_and_each_has_buffers_of_its_own) {
  Track first = ring(), second(test::ring_document(5, 11.7f));
  const Image one = picture(first);
  auto sibling = renderer_->sibling(samples_);
  const DrawStats stats = draw(*sibling, first);
  EXPECT_EQ(stats.uploads, static_cast<int>(first.document.track.segments.size()));
  EXPECT_EQ(sibling->read_pixels().rgba, one.rgba);
  const Image other = picture(*sibling, second);
  EXPECT_EQ(draw(first).uploads, 0) << "what the sibling draws is not this one's";
  EXPECT_EQ(renderer_->read_pixels().rgba, one.rgba);
  renderer_.reset();
  EXPECT_EQ(picture(*sibling, second).rgba, other.rgba) << "either may go first";
}

TEST_F(Pictures, after_any_edits_are_those_of_a_fresh_renderer) {
  std::mt19937 bits(20260);
  Track track = ring();
  for (int i = 0; i < 40; ++i) {
    edit(bits, track);
    const Image incremental = picture(track);
    if (i % 4 != 3) continue;
    const Image expected = picture(*renderer_->sibling(samples_), track);
    const PictureDifference difference = compare(incremental, expected);
    ASSERT_TRUE(incremental.rgba == expected.rgba)
        << "after edit " << i << ": " << difference.pixels << " pixels differ by much";
  }
  EXPECT_TRUE(picture(track).rgba == picture(*fresh(), track).rgba) << "uniforms are left from an earlier picture";
}

}  // namespace renderer_test
}  // namespace coaster::gfx
