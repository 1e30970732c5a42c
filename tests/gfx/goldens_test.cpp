// The golden pictures themselves: each would show a small defect, wherever it is.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "gfx/image.h"

namespace coaster::gfx {
namespace goldens_test {

// Every channel of a square is moved by as much, away from the end it is nearer to.
void spoil(Image& image, int left, int top, int side, int by) {
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        std::uint8_t& byte = image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) + c];
        byte = static_cast<std::uint8_t>(byte < 128 ? byte + by : byte - by);
      }
}

TEST(goldens, show_a_defect_of_ten_by_ten_pixels_anywhere) {
  base::Files files;
  int pictures = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / "tests/scripts/golden")) {
    const auto bytes = files.read(entry.path());
    ASSERT_TRUE(bytes.ok()) << bytes.status().message;
    const auto golden = decode_png(*bytes, entry.path().string());
    ASSERT_TRUE(golden.ok()) << golden.status().message;
    EXPECT_TRUE(compare(*golden, *golden).acceptable);
    const int right = golden->width - 10, bottom = golden->height - 10;
    for (const auto& [left, top] :
         {std::pair{0, 0}, {right, bottom}, {right / 2, bottom / 2}, {right / 3 + 1, 3}, {5, bottom / 4 + 2}}) {
      Image spoilt = *golden;
      spoil(spoilt, left, top, 10, 24);
      EXPECT_FALSE(compare(spoilt, *golden, PictureDifference::kOtherSamples).acceptable)
          << entry.path().filename() << " at " << left << ", " << top;
    }
    ++pictures;
  }
  EXPECT_GE(pictures, 27) << "three styles and nine ways to colour";
}

}  // namespace goldens_test
}  // namespace coaster::gfx
