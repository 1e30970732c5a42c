// A renderer on an off-screen surface, and a track to draw.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "gfx/image.h"
#include "platform/surface.h"
#include "sim/tracks.h"
#include "world/evaluation_settings.h"

namespace coaster::test {

// A document with what is derived from it.
struct Track {
  world::Document document;
  world::Settings settings;
  sim::DerivedTrack derived;

  explicit Track(world::Document from, int steps = 24) : document(std::move(from)) {
    settings.evaluation->steps = steps;
    derive();
  }
  void derive() {
    world::settle_joints(document);
    sim::derive(document, settings, {}, derived);
  }
  void move(std::size_t knot, glm::vec3 by) {
    document.entities.get<world::Knot>(document.track.knots[knot]).position += by;
    derive();
  }
};

class Studio : public testing::Test {
 protected:
  void SetUp() override {
    auto surface = platform::make_offscreen({.size = {64, 48}});
    ASSERT_TRUE(surface.ok()) << surface.status().message;
    surface_ = std::move(*surface);
    auto gl = gfx::load_gl([&](const char* name) { return surface_->gl_proc(name); });
    ASSERT_TRUE(gl.ok()) << gl.status().message;
    gl_ = *gl;
    renderer_ = fresh();
  }
  void TearDown() override { renderer_.reset(); }

  // Returns a renderer that has drawn nothing. For many, take siblings of one: compiling shaders takes longest.
  std::unique_ptr<gfx::Renderer> fresh() { return std::make_unique<gfx::Renderer>(gl_, samples_); }
  // From the eye if there is one, else from the side and above with all of the track in sight; the viewport is the
  // whole picture unless set.
  view::View look(const Track& track) const {
    const view::Viewport viewport =
        viewport_.width > 1 ? viewport_ : view::Viewport{0, 0, static_cast<float>(width_), static_cast<float>(height_)};
    return eye_ ? view::view_of(*eye_, viewport)
                : view::orbit_view(view::frame_all({}, track.document, viewport), viewport);
  }
  gfx::DrawStats draw(gfx::Renderer& renderer, const Track& track, const view::Overlay& overlay = {}) {
    const view::View view = look(track);
    gfx::Scene scene{track.derived, view, overlay, carts_, show_polyline_, values_, {}, {}, style_};
    scene.shadows = shadows_;
    const gfx::DrawStats stats = renderer.draw(scene, width_, height_);
    EXPECT_TRUE(renderer.failure().ok()) << renderer.failure().message;
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return stats;
  }
  gfx::DrawStats draw(const Track& track) { return draw(*renderer_, track); }
  gfx::Image picture(gfx::Renderer& renderer, const Track& track, const view::Overlay& overlay = {}) {
    draw(renderer, track, overlay);
    return renderer.read_pixels();
  }
  gfx::Image picture(const Track& track, const view::Overlay& overlay = {}) {
    return picture(*renderer_, track, overlay);
  }

  int width_ = 160, height_ = 90, samples_ = 0;
  bool show_polyline_ = true, shadows_ = true;
  world::Style style_{};
  view::Viewport viewport_;
  std::optional<view::Eye> eye_;
  std::vector<sim::Pose> carts_;
  const sim::TrackValues* values_ = nullptr;
  std::unique_ptr<platform::Surface> surface_;
  gfx::Gl gl_;
  std::unique_ptr<gfx::Renderer> renderer_;
};

inline glm::ivec3 colour_at(const gfx::Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
  return {p[0], p[1], p[2]};
}

// How many pixels satisfy a rule.
template <class Rule>
int count(const gfx::Image& image, const Rule& rule) {
  int found = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) found += rule(colour_at(image, x, y)) ? 1 : 0;
  return found;
}

}  // namespace coaster::test
