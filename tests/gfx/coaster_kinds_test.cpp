// The look of kinds of coaster and of paint.
#include <cmath>
#include <cstdlib>

#include "gfx/studio.h"
#include "sim/kinds.h"
#include "sim/solids/supports.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::gfx {
namespace coaster_kinds_test {

class CoasterKinds : public test::Studio {
 protected:
  // Returns a picture of a hill with a train before it.
  Image picture_of(const test::Track& track) {
    supports_.update(track.derived);
    const view::View view = look(track);
    carts_ = {sim::pose(track.derived, sim::place_at(track.derived, 22), world::FrameMethod::knots),
              sim::pose(track.derived, sim::place_at(track.derived, 19.6), world::FrameMethod::knots)};
    for (sim::Pose& car : carts_) car.length = static_cast<double>(world::kCarLength);
    carts_.front().leads = true;
    Scene scene{track.derived, view, {}, carts_, false};
    scene.supports = &supports_, scene.document = &track.document;
    renderer_->draw(scene, width_, height_);
    EXPECT_TRUE(renderer_->failure().ok()) << renderer_->failure().message;
    return renderer_->read_pixels();
  }
  sim::Supports supports_;

  static test::Track hill() {
    world::Document d;
    world::append_knot(d, test::skew_knot({0, 5, 0}, {1, 0.2f, 0.1f}, 8, 8));
    world::append_knot(d, test::skew_knot({24, 10, 3}, {1, 0, 0.2f}, 8, 8));
    world::append_knot(d, test::skew_knot({48, 6, 9}, {1, -0.2f, 0.3f}, 8, 8));
    for (const world::Entity e : d.track.knots) world::set_roll(d.entities.get<world::Knot>(e), 0);
    return test::Track(std::move(d));
  }
};

double grey(const std::uint8_t* rgba) { return 0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2]; }

// In black and white and 160 by 90 pixels, as the mean difference over the picture.
TEST_F(CoasterKinds, are_told_apart_in_black_and_white) {
  std::vector<Image> pictures;
  for (const world::CoasterKind kind : test::kinds()) {
    test::Track track = hill();
    track.document.kind = kind, track.document.paint = world::kPalettes[1].paint;
    track.derive();
    pictures.push_back(picture_of(track));
  }
  for (std::size_t a = 0; a < pictures.size(); ++a)
    for (std::size_t b = a + 1; b < pictures.size(); ++b) {
      double sum = 0;
      for (std::size_t i = 0; i < pictures[a].rgba.size(); i += 4)
        sum += std::abs(grey(&pictures[a].rgba[i]) - grey(&pictures[b].rgba[i]));
      EXPECT_GT(sum / (160 * 90), 1.0) << a << " and " << b;
    }
}

TEST_F(CoasterKinds, of_changed_tracks_are_drawn_as_if_they_had_been_so_from_the_start) {
  test::Track changed = hill();
  (void)picture_of(changed);
  for (const world::CoasterKind kind : {world::CoasterKind::wooden, world::CoasterKind::inverted}) {
    changed.document.kind = kind;
    changed.derive();
    const Image after = picture_of(changed);
    renderer_ = fresh();
    EXPECT_EQ(after.rgba, picture_of(changed).rgba) << base::name_of(kind);
  }
}

TEST_F(CoasterKinds, show_the_paint_of_the_track_and_of_its_sections) {
  test::Track track = hill();
  const Image red = picture_of(track);
  track.document.paint.rails = {0x00ff00};
  const Image green = picture_of(track);
  const auto greens = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      const std::uint8_t* p = &image.rgba[i];
      count += p[1] > 150 && p[0] < 110 && p[2] < 110;
    }
    return count;
  };
  EXPECT_EQ(greens(red), 0);
  EXPECT_GT(greens(green), 60);
  // One section alone: the other half stays red.
  track.document.paint = {};
  const world::Entity section = world::make_section(track.document, 1, 1, {});
  track.document.entities.get<world::Section>(section).paint.rails = {0x00ff00};
  track.derive();
  const Image half = picture_of(track);
  track.document.entities.get<world::Section>(section).paint = {};
  const world::Entity other = world::make_section(track.document, 0, 1, {});
  track.document.entities.get<world::Section>(other).paint.rails = {0x00ff00};
  const Image rest = picture_of(track);
  EXPECT_GT(greens(half), 10);
  EXPECT_GT(greens(rest), 10);
  EXPECT_NEAR(greens(half) + greens(rest), greens(green), 0.05 * greens(green));
  track.document.entities.get<world::Section>(other).paint = {};
  track.document.entities.get<world::Section>(section).paint = {};
  EXPECT_EQ(picture_of(track).rgba, red.rgba) << "paint leaves nothing behind";
}

}  // namespace coaster_kinds_test
}  // namespace coaster::gfx
