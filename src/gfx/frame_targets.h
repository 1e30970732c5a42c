// The framebuffers of a picture: the target of the passes, multisampled if requested, and the resolved one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "gfx/gl_objects.h"
#include "view/camera.h"

namespace coaster::gfx {

class FrameTargets {
 public:
  explicit FrameTargets(const Gl& gl) : gl_(&gl) {}
  // Clamped to the driver's maximum; 0 or 1: none.
  void set_samples(int samples);
  int samples() const { return scene_ ? scene_->samples : 0; }  // of the last fit()

  // Recreates the framebuffers if size or samples changed. Takes fewer samples, or none, where the driver rejects them
  // or all of a picture would take more than kMostBytes.
  static constexpr std::int64_t kMostBytes = 400'000'000;
  void fit(int width, int height);
  // Returns a sentence once for each size that has fewer samples for its memory, otherwise "".
  std::string take_notice() { return std::exchange(notice_, {}); }
  // Fills the picture with `around` and limits drawing to the viewport; with `unseen` to one pixel.
  void begin(const view::Viewport& viewport, glm::vec3 around, bool unseen);
  // Resolves, binds the resolved framebuffer, and sets the viewport to the whole picture.
  void finish();

  const RenderTarget* resolved() const { return resolved_ ? &*resolved_ : nullptr; }

 private:
  const Gl* gl_;
  int samples_ = 0, asked_ = 0;  // wanted; at the last fit()
  std::string notice_;
  bool unseen_ = false;
  // `scene_` exists if multisampled; otherwise the passes draw into `resolved_`.
  std::optional<RenderTarget> scene_, resolved_;
};

}  // namespace coaster::gfx
