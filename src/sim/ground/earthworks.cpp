#include "sim/ground/earthworks.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/rails.h"

namespace coaster::sim {
namespace {

bool wants_tunnel(const TrackSample& sample, const TrackRoom& room) {
  switch (sample.wish) {
    case world::Earthwork::none:
    case world::Earthwork::cut: return false;
    case world::Earthwork::tunnel: return sample.cover > room.above + 0.3;
    case world::Earthwork::automatic: break;
  }
  return !sample.station && sample.cover > room.above + kLeastCover;
}

}  // namespace

std::vector<TrackSample> samples_of(const SegmentShape& shape, const Land& land) {
  const double length = shape.arc.length();
  constexpr double kMost = 4000;
  const auto count = static_cast<std::size_t>(std::clamp(std::ceil(length / kSampleSpacing), 1.0, kMost));
  std::vector<TrackSample> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = length * static_cast<double>(i) / static_cast<double>(count);
    const curve::Frame frame = rails_frame_at(shape, s);
    TrackSample& sample = samples[i];
    sample.at = rails_at(shape, s), sample.forward = frame.forward, sample.up = frame.up, sample.distance = s;
    sample.cover = land.height(sample.at.x, sample.at.z) - sample.at.y;
    sample.station = shape.fitted == world::EquipmentKind::station;
  }
  return samples;
}

std::vector<Tunnel> find_tunnels(std::vector<TrackSample>& samples, const TrackRoom& room, bool closed) {
  std::vector<Tunnel> tunnels;
  const std::size_t count = samples.size();
  if (count == 0) return tunnels;
  for (TrackSample& sample : samples) sample.tunnel = wants_tunnel(sample, room);
  // Runs begin where an open sample comes before; on a closed track the first of them is looked for.
  std::size_t start = 0;
  if (closed)
    while (start < count && samples[start].tunnel) ++start;
  if (start == count) start = 0;  // all of it is under earth
  for (std::size_t step = 0; step < count;) {
    const std::size_t first = (start + step) % count;
    if (!samples[first].tunnel) {
      ++step;
      continue;
    }
    std::size_t run = 0;
    bool wished = false;
    double length = 0;
    while (step + run < count && samples[(first + run) % count].tunnel) {
      const TrackSample& sample = samples[(first + run) % count];
      wished = wished || sample.wish == world::Earthwork::tunnel;
      if (run > 0) length += glm::distance(samples[(first + run - 1) % count].at, sample.at);
      ++run;
    }
    if (run >= 2 && (wished || length >= kLeastTunnel))
      tunnels.push_back({first, (first + run - 1) % count, samples[first].distance, length});
    else
      for (std::size_t i = 0; i < run; ++i) samples[(first + i) % count].tunnel = false;
    step += run;
  }
  std::ranges::sort(tunnels, {}, &Tunnel::from);
  return tunnels;
}

}  // namespace coaster::sim
