#include "sim/solids/flooded_track.h"

namespace coaster::sim {

std::vector<FloodedTrack> flooded_track(const Ground& ground) {
  std::vector<FloodedTrack> found;
  bool before = false;
  for (const TrackSample& sample : ground.samples()) {
    const double depth = ground.water() - sample.at.y;
    const bool wet = depth > 0 && !sample.tunnel && ground.height(sample.at.x, sample.at.z) < ground.water();
    if (wet && !before) found.push_back({sample.distance, sample.distance, 0, {}});
    before = wet;
    if (!wet) continue;
    FloodedTrack& stretch = found.back();
    stretch.to = sample.distance;
    if (depth > stretch.depth) stretch.depth = depth, stretch.place = glm::vec3(sample.at);
  }
  return found;
}

}  // namespace coaster::sim
