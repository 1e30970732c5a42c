// Draws frames for scripts: knows whether the picture is older than the state, and then draws a frame without ticks.
#pragma once

#include "script/host.h"

namespace coaster::script {

using base::Status;

// Errors of statements that run: an expectation that does not hold or a target that cannot be used, and wrong use.
inline Status failed(std::string message) { return {base::Code::expectation, std::move(message)}; }
inline Status wrong(std::string message) { return {base::Code::usage, std::move(message)}; }

// A frame of a script is 1/60 s.
inline constexpr int kTicksPerFrame = 2;

class FrameDriver {
 public:
  explicit FrameDriver(Host& host) : host_(host) {}

  Host& host() const { return host_; }
  // Takes note that the state changed otherwise than by the functions below.
  void changed() { picture_stale_ = panels_stale_ = true; }
  base::Status apply(const edit::Command& command);
  // Draws one frame with these events and the postponed ones.
  base::Status frame(platform::Events events, int ticks = kTicksPerFrame);
  // Adds events to the next frame.
  void put_off(platform::Events events);
  bool has_put_off() const { return !put_off_.empty(); }
  // Ends early where a signal asks the program to end.
  void advance(std::int64_t ticks);
  bool interrupted() const { return host_.interrupted && host_.interrupted(); }

  // Draws a frame without ticks if anything changed since the last one, so that the last frame's values match the
  // state.
  base::Status settle();
  // Draws until the panels show the state, too: in a frame with commands they show the state before them, and new
  // contents are laid out one frame later.
  base::Status settle_panels();

  std::uint64_t commands() const { return host_.commands ? host_.commands() : 0; }

 private:
  Host& host_;
  platform::Events put_off_;
  bool picture_stale_ = true;
  bool panels_stale_ = true;
};

}  // namespace coaster::script
