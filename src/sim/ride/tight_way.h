// A car's way between two entries of the ghost's forces, over the cells of tight bends. For ghost.cpp.
#pragma once

#include "sim/ride/ghost.h"

namespace coaster::sim {

class TightWay {
 public:
  // Speed and acceleration of the train change linearly from `then` to `now`.
  TightWay(const GhostSample& then, const GhostSample& now, double seconds)
      : then_(then), now_(now), seconds_(seconds) {}

  // Adds the part of the way within one segment, from s0 to s1 m along it: shares u0 to u1 of the time.
  void add(const SegmentTable& table, double s0, double s1, double u0, double u1);
  // True if the way leads over cells, and a straight line between the entries `before` and `after` (felt g) misses more
  // than noise; over a joint always.
  bool is_needed(const glm::dvec3& before, const glm::dvec3& after, bool joint) const;
  // Returns the passage without car and entry; its time counts from the entry before.
  BendPassage passage() const;

 private:
  struct Moment {
    double speed, a;  // m/s, m/s^2
  };
  Moment at(double share) const;
  // Notes what the bend around a place adds, if that is most so far.
  void take_peak(const SegmentTable& table, double peak, double share);

  const GhostSample &then_, &now_;
  double seconds_;
  bool tight_ = false;
  glm::dvec3 before_{0}, after_{0};  // g s
  glm::dvec3 impulse_{0};            // g s, of the peak
  double peak_share_ = 1;
};

}  // namespace coaster::sim
