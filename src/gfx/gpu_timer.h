// GPU time of a part of a frame, by timer queries. Results arrive some frames later; nothing waits.
#pragma once

#include <array>

#include "gfx/objects.h"

namespace coaster::gfx {

class GpuTimer {
 public:
  explicit GpuTimer(const Gl& gl);
  // Call around the part, once per frame, not nested. Does nothing if the driver has no timers or all are in use.
  void begin();
  void end();
  // ms of the newest finished part; 0: none yet.
  double ms() const { return ms_; }

 private:
  const Gl* gl_;
  std::array<Object, 4> ring_;          // queries; none without timers
  std::size_t started_ = 0, read_ = 0;  // parts so far
  bool measuring_ = false;
  double ms_ = 0;
};

}  // namespace coaster::gfx
