// Lamps of the park at night: on posts along stations, at the side of the track, and in tunnels. They follow from the
// track.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/ground.h"

namespace coaster::sim {

struct Lamp {
  glm::vec3 at{0};  // m
  float strength = 1;
  float post = 0;  // m of post below it; 0: it hangs on the track
  friend bool operator==(const Lamp&, const Lamp&) = default;
};
inline constexpr float kLampReach = 26;  // m

std::vector<Lamp> lamps_of(const Ground& ground);

// Returns the light of a lamp at a place with a unit normal; 0 beyond kLampReach.
float lamp_light(const Lamp& lamp, glm::vec3 place, glm::vec3 normal);

}  // namespace coaster::sim
