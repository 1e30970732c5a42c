// How long the GPU works on a part of a frame, by timer queries. Results are taken when they are there, frames later:
// nothing waits.
#pragma once

#include <array>

#include "gfx/objects.h"

namespace coaster::gfx {

class GpuTimer {
 public:
  explicit GpuTimer(const Gl& gl);
  // Around the part, once a frame, not nested. Does nothing where the driver has no timers or all are still under way.
  void begin();
  void end();
  // ms of the newest part that is known; 0: none yet.
  double ms() const { return ms_; }

 private:
  void take_results();

  struct Pending {
    Object query;
    bool under_way = false;
  };
  const Gl* gl_;
  std::array<Pending, 4> ring_;
  std::size_t next_ = 0, oldest_ = 0;
  bool able_ = false, begun_ = false;
  double ms_ = 0;
};

}  // namespace coaster::gfx
