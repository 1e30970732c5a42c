#include "gfx/frame_targets.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <string>

#include "gfx/studio.h"

namespace coaster::gfx {
namespace frame_targets_test {

using Targets = test::Studio;

TEST_F(Targets, a_driver_without_memory_for_them_ends_as_a_failed_allocation_does) {
  Gl poor = gl_;
  poor.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_UNSUPPORTED; };
  FrameTargets targets(poor);
  EXPECT_THROW(targets.fit(64, 36), std::bad_alloc);
  FrameTargets good(gl_);
  EXPECT_NO_THROW(good.fit(64, 36));
}

// The bytes that a driver would take, counted where they are asked for.
std::int64_t& taken() {
  static std::int64_t bytes = 0;
  return bytes;
}

TEST_F(Targets, no_picture_takes_more_than_the_limit_and_fewer_samples_are_told_once) {
  Gl counting = gl_;
  counting.max_samples = 64;
  counting.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_COMPLETE; };
  counting.RenderbufferStorageMultisample = [](GLenum, GLsizei samples, GLenum, GLsizei width, GLsizei height) {
    taken() += std::int64_t{4} * std::max(samples, 1) * width * height;
  };
  constexpr int kWidest = 7680;
  for (const int width : {64, 1280, 1920, 2560, 3840, 5120, 6144, kWidest})
    for (const int samples : {0, 2, 4, 8, 16, 64}) {
      FrameTargets targets(counting);
      targets.set_samples(samples);
      taken() = 0;
      targets.fit(width, width * 9 / 16);
      EXPECT_LE(taken(), FrameTargets::kMostBytes) << width << " with " << samples;
      const std::string notice = targets.take_notice();
      EXPECT_EQ(notice.empty(), targets.samples() == samples) << notice;
      targets.fit(width, width * 9 / 16);
      EXPECT_EQ(targets.take_notice(), "") << "once";
      if (width <= 1920 && samples <= 16) {
        EXPECT_EQ(targets.samples(), samples) << width;
      }
      if (width == kWidest) {
        EXPECT_EQ(targets.samples(), 0);
      }
    }
  FrameTargets large(counting);
  large.set_samples(16);
  large.fit(kWidest, 4320);
  EXPECT_EQ(large.take_notice(), "Antialiasing is off: 7680x4320 pixels with 16 samples would take 4.5 GB.");
}

}  // namespace frame_targets_test
}  // namespace coaster::gfx
