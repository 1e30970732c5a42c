#include "gfx/frame_targets.h"

#include <new>

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

}  // namespace frame_targets_test
}  // namespace coaster::gfx
