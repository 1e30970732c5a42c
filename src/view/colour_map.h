// The map from values to colours: cividis, which looks alike with and without red-green colour blindness (Nunez,
// Anderton and Renslow 2018, doi 10.1371/journal.pone.0199239). The track's shader and the legend read the same table.
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace coaster::view {

// sRGB, 0..1, uniform from 0 to 1; linear in between.
inline constexpr std::array<glm::vec3, 10> kColourStops{
    glm::vec3{0.000f, 0.125f, 0.302f}, {0.000f, 0.200f, 0.435f}, {0.224f, 0.282f, 0.420f}, {0.341f, 0.361f, 0.427f},
    {0.439f, 0.443f, 0.451f},          {0.541f, 0.529f, 0.475f}, {0.651f, 0.616f, 0.459f}, {0.769f, 0.710f, 0.424f},
    {0.894f, 0.812f, 0.357f},          {1.000f, 0.918f, 0.275f}};
inline constexpr glm::vec3 kUnknownColour{0.60f, 0.58f, 0.62f};  // no value

}  // namespace coaster::view
