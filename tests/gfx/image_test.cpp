#include "gfx/image.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace coaster::gfx {
namespace image_test {

// Noise in 32..223, so that every channel can move both ways.
Image noise(int width, int height) {
  std::mt19937 bits(71);
  Image image{width, height, std::vector<std::uint8_t>(4 * std::size_t(width) * std::size_t(height))};
  for (std::uint8_t& byte : image.rgba) byte = static_cast<std::uint8_t>(32 + bits() % 192);
  return image;
}
std::uint8_t& channel(Image& image, int x, int y, int c) {
  return image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) + std::size_t(c)];
}
void shift(Image& image, int x, int y, int by, int c = 1) {
  channel(image, x, y, c) = static_cast<std::uint8_t>(channel(image, x, y, c) + by);
}

TEST(image, png_keeps_every_byte) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 7}, {161, 97}}) {
    const Image image = noise(width, height);
    const auto back = decode_png(encode_png(image), "picture");
    ASSERT_TRUE(back.ok()) << back.status().message;
    EXPECT_EQ(back->width, width);
    EXPECT_EQ(back->height, height);
    EXPECT_EQ(back->rgba, image.rgba);
  }
}

TEST(image, broken_png_is_refused_by_name) {
  const std::string png = encode_png(noise(61, 43));
  const std::string broken[] = {"", "not a picture", png.substr(0, png.size() / 2), png.substr(0, 20), png.substr(1)};
  for (const std::string& bytes : broken) {
    const auto image = decode_png(bytes, "golden/loop.png");
    ASSERT_FALSE(image.ok()) << bytes.size() << " bytes";
    EXPECT_EQ(image.status().code, base::Code::bad_file);
    EXPECT_NE(image.status().message.find("golden/loop.png"), std::string::npos) << image.status().message;
  }
}

TEST(image, pictures_over_the_limit_are_refused_before_they_are_decoded) {
  std::string png = encode_png(noise(3, 2));
  const auto set_side = [&](std::size_t at, std::uint32_t side) {  // in the header; big endian
    for (std::size_t i = 0; i < 4; ++i) png[at + i] = static_cast<char>(side >> (24 - 8 * i));
  };
  for (const auto& [width, height] : {std::pair{7680u, 4321u}, {16384u, 16384u}, {1u << 24, 1u << 24}}) {
    set_side(16, width), set_side(20, height);
    EXPECT_NE(decode_png(png, "bomb.png").status().message.find("bomb.png: not a PNG picture"), std::string::npos);
  }
  set_side(16, 7680), set_side(20, 4321);
  EXPECT_NE(decode_png(png, "bomb.png").status().message.find("7680x4321 pixels, more than the limit of 33177600"),
            std::string::npos);
}

TEST(image, sixteen_levels_are_the_same_and_seventeen_are_not) {
  const Image golden = noise(200, 100);
  for (int c = 0; c < 4; ++c)
    for (const int sign : {-1, 1}) {
      Image picture = golden;
      shift(picture, 17, 31, 16 * sign, c);
      EXPECT_EQ(compare(picture, golden).pixels, 0);
      shift(picture, 17, 31, sign, c);
      EXPECT_EQ(compare(picture, golden).pixels, 1);
    }
}

TEST(image, a_comparison_of_every_level_names_the_first_and_the_largest_difference) {
  const Image golden = noise(200, 100);
  Image picture = golden;
  EXPECT_EQ(compare(picture, golden, {0, 0, 0}).largest, 0);
  shift(picture, 150, 20, 1, 2), shift(picture, 3, 71, -9, 3), shift(picture, 199, 99, 4, 0);
  const PictureDifference difference = compare(picture, golden, {.share = 0, .block = 0, .channel = 0});
  EXPECT_EQ(difference.pixels, 3);
  EXPECT_EQ(difference.first, glm::ivec2(150, 20));
  EXPECT_EQ(difference.largest, 9);
  EXPECT_EQ(difference.largest_at, glm::ivec2(3, 71));
  EXPECT_FALSE(difference.acceptable);
  EXPECT_EQ(compare(picture, golden).pixels, 0);
}

// Rec. 709's luma of the equal pixels, at half the contrast over mid-grey; red where they differ.
TEST(image, the_picture_of_a_comparison_is_pale_grey_by_luma_and_red_where_pixels_differ) {
  Image picture = noise(23, 17);
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k) channel(picture, c, 0, k) = c == k ? 255 : 0;  // pure red, green and blue
  Image golden = picture;
  shift(golden, 11, 5, 40);
  const Image shown = compare(picture, golden).picture;
  ASSERT_EQ(shown.rgba.size(), picture.rgba.size());
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 23; ++x) {
      const auto at = [&](int c) { return static_cast<int>(shown.rgba[std::size_t(4 * (y * 23 + x) + c)]); };
      const auto was = [&](int c) { return double(channel(picture, x, y, c)); };
      EXPECT_EQ(at(3), 255);
      if (x == 11 && y == 5) {
        EXPECT_EQ(at(0), 255);
        EXPECT_EQ(at(1) + at(2), 0);
        continue;
      }
      EXPECT_NEAR(at(0), 128 + (0.2126 * was(0) + 0.7152 * was(1) + 0.0722 * was(2)) / 2, 1.5) << x << ' ' << y;
      EXPECT_TRUE(at(0) == at(1) && at(1) == at(2));
    }
}

TEST(image, one_in_two_thousand_may_differ_and_no_more) {
  const Image golden = noise(200, 100);  // 0.05 % are 10 pixels
  Image picture = golden;
  for (int i = 0; i < 10; ++i) shift(picture, 19 * i, 9 * i, 25);
  EXPECT_EQ(compare(picture, golden).pixels, 10);
  EXPECT_TRUE(compare(picture, golden).acceptable);
  EXPECT_EQ(compare(picture, golden).most_pixels, 10);
  shift(picture, 199, 99, -25);
  EXPECT_FALSE(compare(picture, golden).acceptable);
  EXPECT_TRUE(compare(picture, golden, PictureDifference::kOtherSamples).acceptable) << "up to 100";
}

TEST(image, nine_in_a_block_are_a_defect_and_eight_are_not) {
  const Image golden = noise(403, 301);  // 0.05 % are 60 pixels
  Image picture = golden;
  for (int i = 0; i < 8; ++i) shift(picture, 40 + i, 80 + (3 * i) % 8, 30);
  EXPECT_EQ(compare(picture, golden).worst_block, 8);
  EXPECT_TRUE(compare(picture, golden).acceptable);
  shift(picture, 40, 87, 30);
  EXPECT_EQ(compare(picture, golden).worst_block, 9);
  EXPECT_FALSE(compare(picture, golden).acceptable);
}

// A picture with a light post on a dark ground, and a bar across it.
Image post_and_bar(int left, int wide, int top) {
  Image picture{400, 300, std::vector<std::uint8_t>(std::size_t{4} * 400 * 300, 40)};
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      if ((x >= left && x < left + wide) || (y >= top && y < top + 3)) shift(picture, x, y, 150);
  return picture;
}

TEST(image, other_samples_may_move_edges_by_a_pixel_and_no_more) {
  const Image golden = post_and_bar(122, 4, 170);
  const auto by_others = [&](const Image& picture) {
    return compare(picture, golden, PictureDifference::kOtherSamples);
  };
  for (const auto& [left, wide, top] : {std::array{121, 4, 170}, {122, 5, 171}, {123, 3, 169}}) {
    const Image moved = post_and_bar(left, wide, top);
    EXPECT_FALSE(compare(moved, golden).acceptable);
    EXPECT_EQ(by_others(moved).pixels, 0) << left;
    EXPECT_TRUE(by_others(moved).acceptable) << by_others(moved).worst_block;
  }
  for (const auto& [left, wide, top] : {std::array{120, 4, 170}, {122, 4, 172}}) {
    EXPECT_GT(by_others(post_and_bar(left, wide, top)).pixels, 200) << left;
    EXPECT_FALSE(by_others(post_and_bar(left, wide, top)).acceptable) << left;
  }
  EXPECT_FALSE(by_others(post_and_bar(400, 0, 170)).acceptable) << "a post that is gone";
}

TEST(image, other_samples_may_change_24_in_a_block_and_no_more) {
  const Image golden = noise(403, 301);
  Image picture = golden;
  for (int i = 0; i < 8; ++i)
    for (const int column : {2, 4, 6}) shift(picture, 40 + column, 80 + i, 30);
  EXPECT_EQ(compare(picture, golden).worst_block, 24);
  EXPECT_TRUE(compare(picture, golden, PictureDifference::kOtherSamples).acceptable);
  shift(picture, 40, 83, 30);
  EXPECT_FALSE(compare(picture, golden, PictureDifference::kOtherSamples).acceptable);
}

TEST(image, a_defect_of_ten_by_ten_is_found_anywhere) {
  const Image golden = noise(1280, 720);  // 0.05 % are 460 pixels: the count alone would let it pass
  for (const auto& [left, top] : {std::pair{0, 0}, {3, 5}, {641, 363}, {1270, 710}, {7, 707}}) {
    Image picture = golden;
    for (int y = top; y < top + 10; ++y)
      for (int x = left; x < left + 10; ++x) shift(picture, x, y, 32);
    PictureDifference difference = compare(picture, golden);
    EXPECT_EQ(difference.pixels, 100);
    EXPECT_FALSE(difference.acceptable) << "at " << left << ", " << top;
    EXPECT_FALSE(compare(picture, golden, PictureDifference::kOtherSamples).acceptable) << "at " << left << ", " << top;
    EXPECT_EQ(channel(difference.picture, left, top, 0), 255) << "differing pixels are red";
    EXPECT_EQ(channel(difference.picture, left, top, 1), 0);
  }
}

TEST(image, pictures_of_different_sizes_are_different) {
  const PictureDifference difference = compare(noise(30, 20), noise(20, 30));
  EXPECT_FALSE(difference.same_size);
  EXPECT_FALSE(difference.acceptable);
}

TEST(image, half_the_size_is_the_mean_of_four) {
  Image picture{5, 2, std::vector<std::uint8_t>(5 * 2 * 4, 0)};
  const int values[2][5] = {{10, 20, 1, 2, 9}, {30, 41, 3, 5, 9}};
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 5; ++x) picture.rgba[std::size_t((y * 5 + x) * 4 + 2)] = std::uint8_t(values[y][x]);
  const Image half = half_size(picture);
  ASSERT_EQ(half.width, 2);
  ASSERT_EQ(half.height, 1);
  EXPECT_EQ(half.rgba[2], 25) << "101 / 4, rounded";
  EXPECT_EQ(half.rgba[6], 3) << "11 / 4, rounded";
  EXPECT_EQ(half.rgba[0], 0);
}

TEST(image, a_contact_sheet_has_every_picture_in_its_cell_and_ground_between) {
  const auto plain = [](int width, int height, std::uint8_t value) {
    return Image{width, height, std::vector<std::uint8_t>(std::size_t(width * height * 4), value)};
  };
  const std::vector<Image> pictures{plain(4, 3, 10), plain(2, 1, 200), plain(4, 3, 90)};
  const Image sheet = contact_sheet(pictures, 2, 5);
  ASSERT_EQ(sheet.width, 2 * 4 + 3 * 5);
  ASSERT_EQ(sheet.height, 2 * 3 + 3 * 5);
  const auto red = [&](int x, int y) { return int(sheet.rgba[std::size_t((y * sheet.width + x) * 4)]); };
  EXPECT_EQ(red(5, 5), 10);
  EXPECT_EQ(red(8, 7), 10);
  EXPECT_EQ(red(9, 7), 0x1B);
  EXPECT_EQ(red(14 + 1, 5 + 1), 200) << "in the middle of its cell";
  EXPECT_EQ(red(14, 5), 0x1B);
  EXPECT_EQ(red(5, 13), 90);
  EXPECT_EQ(red(14, 13), 0x1B) << "the last cell is empty";
}

}  // namespace image_test
}  // namespace coaster::gfx
