// Decides when a script draws a frame.
#include "script/frame_stepper.h"

#include <algorithm>

#include "world/motion.h"

namespace coaster::script {

base::Status FrameDriver::apply(const edit::Command& command) {
  changed();  // a rejected command shows a notice
  return host_.apply(command);
}

base::Status FrameDriver::frame(platform::Events events, int ticks) {
  events.insert(events.begin(), put_off_.begin(), put_off_.end());
  put_off_.clear();
  const std::uint64_t before = commands();
  const base::Status status = host_.frame(events, ticks);
  picture_stale_ = false;
  panels_stale_ = !events.empty() || commands() != before;
  return status;
}

void FrameDriver::put_off(platform::Events events) {
  put_off_.insert(put_off_.end(), events.begin(), events.end());
  panels_stale_ = true;
}

void FrameDriver::advance(std::int64_t ticks) {
  if (ticks > 0) picture_stale_ = true;
  constexpr std::int64_t kSlice = world::kTicksPerSecond;
  while (ticks > 0 && !interrupted()) {
    const auto some = static_cast<int>(std::min(ticks, kSlice));
    host_.advance(some);
    ticks -= some;
  }
}

base::Status FrameDriver::settle() { return picture_stale_ ? frame({}, 0) : base::Status{}; }

base::Status FrameDriver::settle_panels() {
  if (!picture_stale_ && !panels_stale_) return {};
  for (int i = 0; i < 2; ++i)
    if (const base::Status status = frame({}, 0); !status) return status;
  return {};
}

}  // namespace coaster::script
