#include "sim/ground/lamps.h"

#include <cmath>

namespace coaster::sim {
namespace {

constexpr double kAlongTrack = 18, kAlongStation = 7, kInTunnel = 12;  // m between lamps
constexpr double kBesideStation = 5.2, kPostHeight = 4.4;              // m

glm::dvec3 left_of(const TrackSample& sample) { return glm::normalize(glm::cross(sample.up, sample.forward)); }

void add_posts(std::vector<Lamp>& lamps, const Ground& ground, const TrackSample& sample) {
  glm::dvec3 left = left_of(sample);
  left.y = 0;
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 at = sample.at + side * kBesideStation * left;
    const double foot = ground.height(at.x, at.z), top = std::fmax(foot, sample.at.y - 1.2) + kPostHeight;
    if (foot < ground.water()) continue;
    lamps.push_back({glm::vec3(at.x, top, at.z), 2.2f, static_cast<float>(top - foot)});
  }
}

}  // namespace

std::vector<Lamp> lamps_of(const Ground& ground) {
  std::vector<Lamp> lamps;
  bool left_side = false;
  const TrackSample* before = nullptr;
  for (const TrackSample& sample : ground.samples()) {
    const double every = sample.station ? kAlongStation : sample.tunnel ? kInTunnel : kAlongTrack;
    // A lamp stands where a multiple of the spacing lies between this sample and the one before.
    const bool here = before != nullptr && std::floor(sample.distance / every) != std::floor(before->distance / every);
    before = &sample;
    if (!here) continue;
    if (sample.station) {
      add_posts(lamps, ground, sample);
    } else if (sample.tunnel) {
      const TrackRoom& room = ground.room();
      lamps.push_back({glm::vec3(sample.at + (room.lift + 0.88 * room.tube) * sample.up), 0.7f, 0});
    } else {
      left_side = !left_side;
      lamps.push_back({glm::vec3(sample.at + (left_side ? 1.4 : -1.4) * left_of(sample) - 0.55 * sample.up), 1, 0});
    }
  }
  return lamps;
}

float lamp_light(const Lamp& lamp, glm::vec3 place, glm::vec3 normal) {
  const glm::vec3 to = lamp.at - place;
  const float q = glm::dot(to, to), far = q / (kLampReach * kLampReach);
  if (far >= 1) return 0;
  const float facing = glm::dot(normal, to) / std::sqrt(q + 1e-4f);
  return lamp.strength * 9 / (q + 9) * (1 - far) * (1 - far) * glm::max(facing, 0.2f);
}

}  // namespace coaster::sim
