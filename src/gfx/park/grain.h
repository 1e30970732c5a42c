// The grain of grass, rock and waves: noise that repeats without a seam.
#pragma once

#include <cstdint>
#include <vector>

namespace coaster::gfx {

inline constexpr int kGrainSide = 256;  // texels

// Returns two bytes for each texel: coarse grain, and fine grain.
std::vector<std::uint8_t> make_grain();

}  // namespace coaster::gfx
