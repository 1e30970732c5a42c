// Frames as scripts need them: knows when the picture is older than the state, and draws a frame without ticks then.
#pragma once

#include "script/host.h"

namespace coaster::script {

// A frame of a script is 1/60 s.
inline constexpr int kTicksPerFrame = 2;

class Stage {
 public:
  explicit Stage(Host& host) : host_(host) {}

  Host& host() { return host_; }
  base::Status set_environment(const Environment& environment);
  base::Status set_home(const std::filesystem::path& folder);
  base::Status apply(const edit::Command& command);
  // One frame with these events, and those put off.
  base::Status frame(platform::Events events, int ticks = kTicksPerFrame);
  // Events that join the next frame.
  void put_off(platform::Events events);
  void advance(std::int64_t ticks);

  // Draws a frame without ticks when something changed since the last one: then values of the last frame are those of
  // the state.
  base::Status settle();
  // Draws until the panels show the state too: they show what was before a frame's commands, and lay out new contents a
  // frame later.
  base::Status settle_panels();

  std::uint64_t commands() const { return host_.commands ? host_.commands() : 0; }

 private:
  Host& host_;
  platform::Events put_off_;
  bool picture_stale_ = true;
  bool panels_stale_ = true;
};

}  // namespace coaster::script
