// Comparison of pictures with golden ones; PNG reading and writing is in png.cpp.
#include "gfx/image.h"

#include <algorithm>
#include <cstdlib>

namespace coaster::gfx {
namespace {

constexpr int kChannelTolerance = 16;      // of 255
constexpr double kPixelTolerance = 0.0005;  // of all pixels
constexpr int kBlock = 8, kBlockTolerance = 8;

bool differs(const std::uint8_t* a, const std::uint8_t* b) {
  for (int c = 0; c < 4; ++c)
    if (std::abs(int(a[c]) - int(b[c])) > kChannelTolerance) return true;
  return false;
}

}  // namespace

Difference compare(const Image& picture, const Image& golden) {
  Difference result;
  result.same_size = picture.width == golden.width && picture.height == golden.height;
  if (!result.same_size) {
    result.acceptable = false;
    result.picture = picture;
    return result;
  }
  const int width = picture.width, height = picture.height, columns = (width + kBlock - 1) / kBlock;
  result.picture = Image{width, height, std::vector<std::uint8_t>(picture.rgba.size())};
  std::vector<int> blocks(std::size_t(columns) * std::size_t((height + kBlock - 1) / kBlock), 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t at = 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
      const std::uint8_t* p = &picture.rgba[at];
      std::uint8_t* out = &result.picture.rgba[at];
      if (differs(p, &golden.rgba[at])) {
        ++result.pixels;
        const int count = ++blocks[std::size_t(y / kBlock) * std::size_t(columns) + std::size_t(x / kBlock)];
        result.worst_block = std::max(result.worst_block, count);
        out[0] = 255, out[1] = out[2] = 0;
      } else {
        const int grey = (54 * p[0] + 183 * p[1] + 19 * p[2]) / 256;
        out[0] = out[1] = out[2] = static_cast<std::uint8_t>(128 + grey / 2);  // pale, so that red stands out
      }
      out[3] = 255;
    }
  }
  const double allowed = kPixelTolerance * double(width) * double(height);
  result.acceptable = double(result.pixels) <= allowed && result.worst_block <= kBlockTolerance;
  return result;
}

}  // namespace coaster::gfx
