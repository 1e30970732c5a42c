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
