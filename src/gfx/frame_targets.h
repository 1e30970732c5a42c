// The framebuffers of a picture: what the passes draw into, multisampled where asked for, and what it is resolved to.
#pragma once

#include <optional>

#include "gfx/objects.h"
#include "view/camera.h"

namespace coaster::gfx {

class FrameTargets {
 public:
  explicit FrameTargets(const Gl& gl) : gl_(&gl) {}
  // Clamped to what the driver has; 0 or 1: none.
  void set_samples(int samples);
  int samples() const { return samples_; }

  // Makes the framebuffers anew when size or samples changed. A driver that refuses multisampling of this size gets
  // none.
  void fit(int width, int height);
  // Fills the picture with `around` and limits drawing to the viewport; `unseen`: to one pixel.
  void begin(const view::Viewport& viewport, glm::vec3 around, bool unseen);
  // Resolves; the resolved framebuffer is bound, the viewport is the whole picture.
  void finish();

  const Target* resolved() const { return resolved_ ? &*resolved_ : nullptr; }

 private:
  const Gl* gl_;
  int samples_ = 0;
  bool unseen_ = false;
  // `scene_` exists when multisampled; `resolved_` is drawn to directly otherwise.
  std::optional<Target> scene_, resolved_;
};

}  // namespace coaster::gfx
