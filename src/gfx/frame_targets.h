// The framebuffers of a picture: the target of the passes, multisampled if requested, and the resolved one.
#pragma once

#include <optional>

#include "gfx/objects.h"
#include "view/camera.h"

namespace coaster::gfx {

class FrameTargets {
 public:
  explicit FrameTargets(const Gl& gl) : gl_(&gl) {}
  // Clamped to the driver's maximum; 0 or 1: none.
  void set_samples(int samples);
  int samples() const { return samples_; }

  // Recreates the framebuffers if size or samples changed. Turns multisampling off if the driver rejects it for this
  // size.
  void fit(int width, int height);
  // Fills the picture with `around` and limits drawing to the viewport; with `unseen` to one pixel.
  void begin(const view::Viewport& viewport, glm::vec3 around, bool unseen);
  // Resolves, binds the resolved framebuffer, and sets the viewport to the whole picture.
  void finish();

  const Target* resolved() const { return resolved_ ? &*resolved_ : nullptr; }

 private:
  const Gl* gl_;
  int samples_ = 0;
  bool unseen_ = false;
  // `scene_` exists if multisampled; otherwise the passes draw into `resolved_`.
  std::optional<Target> scene_, resolved_;
};

}  // namespace coaster::gfx
