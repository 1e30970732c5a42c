// Draws one picture of a scene into its own framebuffer, multisampled if the driver can, and provides the resolved
// colour.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "gfx/gl.h"
#include "sim/ride/ride.h"
#include "sim/shape/detail_limits.h"
#include "sim/study/colour_values.h"
#include "view/camera.h"
#include "view/draw_stats.h"
#include "view/overlay.h"

namespace coaster::sim {
class Ground;
class Plants;
class Supports;
struct StationBuildings;
}  // namespace coaster::sim

namespace coaster::gfx {

// Water that a car throws up on both sides.
struct Splash {
  glm::vec3 at{0}, forward{1, 0, 0};  // m, on the water below the car; unit, level
  float strength = 0;                 // 0..1
};

// The scene to draw: const views of state that must outlive the call.
struct Scene {
  const sim::DerivedTrack& derived;
  const view::View& view;
  const view::Overlay& overlay;
  std::span<const sim::Pose> carts;
  bool show_polyline = true;
  const sim::TrackValues* values = nullptr;  // values that colour the track; null or plain: painted
  world::Theme theme{};                      // colours the picture around the viewport
  sim::Clock clock = {};                     // for prepare_ms; empty: not measured
  world::Style style{};
  const sim::Supports* supports = nullptr;  // null: not drawn
  bool shadows = true;
  bool unseen = false;                              // true: do everything except drawing pixels
  const world::Document* document = nullptr;        // whose paint shows; null: the usual paint of the track's kind
  const sim::Ground* ground = nullptr;              // null: the plane y = 0
  const sim::Plants* plants = nullptr;              // null: none are drawn
  const sim::StationBuildings* stations = nullptr;  // null: platforms stand alone
  world::Scenery scenery{};
  std::span<const Splash> splashes{};
  float eye_room = 0;  // m about the eye where no plants are drawn, so that none hides the track
  double seconds = 3;  // clock of waves, which only a ride moves on
  float detail = 1;    // factor of the distances from which on the track is coarse
};

// Returns where ties, equipment and supports are near enough to be seen, for scenes of the usual detail.
sim::EyeSurroundings surroundings_of(const view::View& view);

using view::DrawStats;

// 8-bit RGBA, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

class Renderer {
 public:
  // `gl` must outlive the renderer. Shaders (embedded at build time from shaders/) are compiled when they first draw.
  Renderer(const Gl& gl, int samples);
  // Returns a sentence once where a size has fewer samples than wanted, for its memory, otherwise "".
  std::string take_notice();
  // Returns another renderer in the same context. They share only the compiled shaders; either may be destroyed first.
  std::unique_ptr<Renderer> sibling(int samples) const;
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Returns why a stage cannot evaluate polylines on this driver; empty if it can. draw() then uses the vertex shader:
  // the same picture.
  std::string refusal(curve::EvaluatedBy stage) const;

  // Code::graphics with the compiler's log if a shader did not compile: pictures lack what it draws.
  const base::Status& failure() const;

  // 0 or 1: no multisampling; clamped to the driver's maximum.
  void set_samples(int samples);

  // Draws the scene into scene.view.viewport of a width x height picture (both >= 1), clears the rest, resolves it, and
  // leaves the resolved framebuffer bound for drawing (viewport: the whole picture), so that panels can be drawn over
  // it.
  DrawStats draw(const Scene& scene, int width, int height);

  unsigned framebuffer() const;  // the resolved one, for Surface::present
  Image read_pixels() const;     // of the resolved framebuffer

 private:
  struct Parts;
  Renderer(std::unique_ptr<Parts> parts, int samples);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::gfx
