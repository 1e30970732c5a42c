// Draws one picture of a scene into a framebuffer of its own, multisampled where the driver can, and hands out the
// resolved colour.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gfx/gl.h"
#include "sim/ride/ride.h"
#include "sim/solids/supports.h"
#include "sim/study/track_values.h"
#include "view/camera.h"
#include "view/overlay.h"

namespace coaster::gfx {

// What is drawn: const views of state that outlive the call.
struct Scene {
  const sim::Derived& derived;
  const view::View& view;
  const view::Overlay& overlay;
  std::span<const sim::Pose> carts;
  bool show_polyline = true;
  const sim::TrackValues* values = nullptr;  // what the track is coloured by; null or plain: painted
  world::Theme theme = world::Theme::dark;   // of the picture beside the viewport
  sim::Clock clock = {};                     // to measure cpu_ms with; empty: not measured
  world::Style style = world::Style::day;
  const sim::Supports* supports = nullptr;  // what holds the track; null: not drawn
  bool shadows = true;
  bool unseen = false;  // everything of a picture but its pixels, which nobody is going to look at
};

// Of the last draw.
struct DrawStats {
  int uploads = 0;          // segments whose slots were written
  int recolours = 0;        // segments whose values were written, counted apart
  int support_uploads = 0;  // segments whose supports were written, counted apart
  int draw_calls = 0;
  std::int64_t triangles = 0;  // sent by these calls, in shadow maps too
  int shadow_maps = 0;  // drawn anew: 0 unless track, trains, light or the part of a large track in sight changed
  int samples = 0;
  double cpu_ms = 0;  // spent by the cache on preparing what is uploaded, outside GL
  double gpu_ms =
      0;  // the GPU's work on the polyline in the newest frame that is known (a few frames ago); 0: not measured
  std::int64_t upload_bytes = 0;  // written to the track's buffers
  std::int64_t polyline_upload_bytes =
      0;                            // of these, to polylines: vertices, or control points for the GPU's evaluators
  std::int64_t polyline_bytes = 0;  // held for all polylines
  curve::Stage drawn_by{};          // what evaluated the polyline: derived.stage, or the vertex shader in its place
  double deviation = 0;  // m, of vertices that the GPU computed, see CurveDeviation; 0 where the processor evaluates
  int deviation_pending = 0;  // segments whose deviation is still to be measured, in the next frames
};

// 8-bit RGBA, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

class Renderer {
 public:
  // Compiles the shaders (embedded at build from shaders/). Code::graphics with the compiler's log on failure. `gl`
  // must outlive it.
  static base::Result<std::unique_ptr<Renderer>> make(const Gl& gl, int samples);
  // Another one in the same context: they share the compiled shaders and nothing else. Either may go first.
  std::unique_ptr<Renderer> sibling(int samples) const;
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Why a stage cannot evaluate polylines on this driver; empty when it can. draw() then lets the vertex shader do it:
  // the same picture.
  std::string refusal(curve::Stage stage) const;
  bool supports(curve::Stage stage) const { return refusal(stage).empty(); }

  // 0 or 1: no multisampling; clamped to what the driver has.
  void set_samples(int samples);

  // Draws the scene into scene.view.viewport of a width x height picture (both >= 1), clears the rest, resolves it, and
  // leaves the resolved framebuffer bound for drawing (viewport: the whole picture) so that panels can be drawn over
  // it.
  DrawStats draw(const Scene& scene, int width, int height);

  unsigned framebuffer() const;  // the resolved one, for Surface::present
  Image read_pixels() const;     // of the resolved framebuffer

 private:
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::gfx
