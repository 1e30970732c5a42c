#include "gfx/frame_targets.h"

#include <algorithm>
#include <cmath>
#include <new>

#include <fmt/format.h>

namespace coaster::gfx {
namespace {

// Ends as a failed `new` does: every driver makes framebuffers of the screen's size unless memory is exhausted.
[[noreturn]] void no_memory() {
  if (const std::new_handler handler = std::get_new_handler()) handler();
  throw std::bad_alloc();
}

// Pixels with their origin at the bottom left, inside the picture.
struct Rectangle {
  int x, y, width, height;
};
Rectangle pixels_of(const view::Viewport& v, int width, int height) {
  const auto pixel = [](float place, int limit) { return std::clamp(int(std::lround(place)), 0, limit); };
  const int left = pixel(v.x, width), right = pixel(v.x + v.width, width);
  const int top = pixel(v.y, height), bottom = pixel(v.y + v.height, height);
  return {left, height - bottom, right - left, bottom - top};
}

}  // namespace

void FrameTargets::set_samples(int samples) {
  const int clamped = std::clamp(samples, 0, gl_->max_samples);
  samples_ = clamped > 1 ? clamped : 0;
}

void FrameTargets::fit(int width, int height) {
  constexpr std::int64_t kSample = 8;  // bytes of colour and depth
  const auto bytes = [&](int samples) { return kSample * width * height * (samples + 1); };
  int affordable = samples_;
  while (affordable > 1 && bytes(affordable) > kMostBytes) affordable /= 2;
  if (affordable < 2) affordable = 0;
  if (resolved_ && resolved_->width == width && resolved_->height == height && asked_ == samples_) return;
  asked_ = samples_;
  scene_.reset();
  resolved_.reset();
  auto plain = make_target(*gl_, width, height, 0);
  if (!plain.ok()) no_memory();
  resolved_ = std::move(*plain);
  if (affordable < samples_)
    notice_ = fmt::format("Antialiasing {}: {}x{} pixels with {} samples would take {:.1f} GB.",
                          affordable == 0 ? "is off" : fmt::format("uses {} samples", affordable), width, height,
                          samples_, static_cast<double>(bytes(samples_)) * 1e-9);
  if (affordable == 0) return;
  if (auto target = make_target(*gl_, width, height, affordable)) scene_ = std::move(*target);
}

void FrameTargets::begin(const view::Viewport& viewport, glm::vec3 around, bool unseen) {
  const int width = resolved_->width, height = resolved_->height;
  unseen_ = unseen;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, scene_ ? scene_->framebuffer.id() : resolved_->framebuffer.id());
  gl_->Viewport(0, 0, width, height);
  gl_->Scissor(0, 0, unseen ? 1 : width, unseen ? 1 : height);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->DepthMask(GL_TRUE);
  gl_->ClearColor(around.x, around.y, around.z, 1);
  gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Rectangle r = pixels_of(viewport, width, height);
  gl_->Viewport(r.x, r.y, r.width, r.height);
  if (!unseen) gl_->Scissor(r.x, r.y, r.width, r.height);
}

void FrameTargets::finish() {
  const int width = resolved_->width, height = resolved_->height;
  blend(*gl_, false);
  gl_->Disable(GL_SCISSOR_TEST);  // it would clip the copy
  gl_->BindVertexArray(0);
  gl_->UseProgram(0);
  if (scene_ && !unseen_) {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, scene_->framebuffer.id());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_->framebuffer.id());
    gl_->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  gl_->BindFramebuffer(GL_FRAMEBUFFER, resolved_->framebuffer.id());
  gl_->Viewport(0, 0, width, height);
}

}  // namespace coaster::gfx
