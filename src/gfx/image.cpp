// Pictures: PNG in memory, written by zlib and read by stb, and the comparison with golden pictures. The caller reads
// and writes files (base::Files), which allows fault injection.
#include "gfx/image.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <functional>
#include <new>

#include <fmt/format.h>

#include "base/text.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace coaster::gfx {
namespace {

std::string big_endian(std::size_t n) { return {char(n >> 24), char(n >> 16), char(n >> 8), char(n)}; }

// Appends a chunk: its length, its name and data, their checksum.
void add_chunk(std::string& png, const std::string& name_and_data) {
  const auto* const bytes = reinterpret_cast<const Bytef*>(name_and_data.data());
  png += big_endian(name_and_data.size() - 4) + name_and_data;
  png += big_endian(crc32(0, bytes, static_cast<uInt>(name_and_data.size())));
}

constexpr int kBlock = 8;

// Returns the largest difference of a channel.
int between(const std::uint8_t* a, const std::uint8_t* b) {
  int most = 0;
  for (int c = 0; c < 4; ++c) most = std::max(most, std::abs(int(a[c]) - int(b[c])));
  return most;
}

// Returns whether each channel of a pixel lies within those of the pixels around it in another picture of its size.
bool is_around(const Image& picture, const Image& other, int x, int y, PictureTolerance tolerance) {
  const auto channel_of = [&](const Image& image, int column, int row, int c) {
    return int(image.rgba[4 * (std::size_t(row) * std::size_t(image.width) + std::size_t(column)) + std::size_t(c)]);
  };
  for (int c = 0; c < 4; ++c) {
    int low = 255, high = 0;
    for (int row = std::max(0, y - tolerance.moved); row <= std::min(other.height - 1, y + tolerance.moved); ++row)
      for (int column = std::max(0, x - tolerance.moved); column <= std::min(other.width - 1, x + tolerance.moved);
           ++column) {
        const int value = channel_of(other, column, row, c);
        low = std::min(low, value), high = std::max(high, value);
      }
    const int is = channel_of(picture, x, y, c);
    if (is < low - tolerance.channel || is > high + tolerance.channel) return false;
  }
  return true;
}

}  // namespace

// Row by row: a large picture is in memory only once.
std::string encode_png(const Image& image) {
  const std::size_t width = std::size_t(image.width), stride = 4 * width;
  COASTER_CHECK(image.width >= 1 && image.height >= 1 && image.rgba.size() == stride * std::size_t(image.height),
                "a picture has four bytes for each pixel");
  std::string png = "\x89PNG\r\n\x1a\n", packed(1 << 16, 0);
  add_chunk(png, "IHDR" + big_endian(width) + big_endian(std::size_t(image.height)) + std::string("\x08\x06\0\0\0", 5));
  z_stream stream{};
  if (deflateInit(&stream, Z_DEFAULT_COMPRESSION) != Z_OK) throw std::bad_alloc();
  std::vector<std::uint8_t> line(stride + 1, 2), above(stride, 0);  // 2: each byte less that above it
  for (std::size_t y = 0; y < std::size_t(image.height); ++y) {
    const std::uint8_t* const row = &image.rgba[y * stride];
    std::transform(row, row + stride, above.begin(), line.begin() + 1, std::minus<std::uint8_t>());
    above.assign(row, row + stride);
    stream.next_in = line.data(), stream.avail_in = static_cast<uInt>(line.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(packed.data()), stream.avail_out = static_cast<uInt>(packed.size());
      (void)deflate(&stream, y + 1 < std::size_t(image.height) ? Z_NO_FLUSH : Z_FINISH);
      if (const std::size_t size = packed.size() - stream.avail_out; size > 0)
        add_chunk(png, "IDAT" + packed.substr(0, size));
    } while (stream.avail_out == 0);
  }
  (void)deflateEnd(&stream);
  add_chunk(png, "IEND");
  return png;
}

base::Result<Image> decode_png(std::string_view bytes, std::string_view name) {
  const auto fail = [&](const std::string& why) {
    return base::Status{base::Code::bad_file, fmt::format("{}: not a PNG picture: {}", name, why)};
  };
  if (bytes.size() > std::size_t(INT_MAX)) return fail("too large");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) return fail(stbi_failure_reason());
  if (width < 1 || height < 1 || std::int64_t{width} * height > base::kMaxPixels)
    return fail(fmt::format("{}x{} pixels, more than the limit of {}", width, height, base::kMaxPixels));
  stbi_uc* pixels = stbi_load_from_memory(data, size, &width, &height, &channels, 4);
  if (pixels == nullptr) return fail(stbi_failure_reason());
  Image image{width, height, std::vector<std::uint8_t>(pixels, pixels + 4 * std::size_t(width) * std::size_t(height))};
  stbi_image_free(pixels);
  return image;
}

PictureDifference compare(const Image& picture, const Image& golden, PictureTolerance tolerance) {
  PictureDifference result;
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
      const int by = between(p, &golden.rgba[at]);
      if (by > result.largest) result.largest = by, result.largest_at = {x, y};
      if (by > tolerance.channel) {
        if (!is_around(picture, golden, x, y, tolerance) || !is_around(golden, picture, x, y, tolerance))
          if (++result.pixels == 1) result.first = {x, y};
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
  result.most_pixels = static_cast<long>(tolerance.share * double(width) * double(height));
  result.acceptable = result.pixels <= result.most_pixels && result.worst_block <= tolerance.block;
  return result;
}

GlObject make_texture(const Gl& gl, const Image& image) {
  gl.ActiveTexture(GL_TEXTURE0);
  GlObject texture = make_texture(gl, GL_LINEAR, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

Image half_size(const Image& picture) {
  Image half{picture.width / 2, picture.height / 2, {}};
  half.rgba.resize(std::size_t(half.width) * std::size_t(half.height) * 4);
  const auto at = [&](int x, int y, int c) {
    return int(picture.rgba[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 4 + std::size_t(c)]);
  };
  std::size_t next = 0;
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < 4; ++c)
        half.rgba[next++] = std::uint8_t((at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                                          at(2 * x + 1, 2 * y + 1, c) + 2) /
                                         4);
  return half;
}

Image contact_sheet(std::span<const Image> pictures, int columns, int gap) {
  COASTER_CHECK(columns >= 1 && gap >= 0, "a sheet has at least one column");
  constexpr std::array<std::uint8_t, 4> kGround{0x1B, 0x1F, 0x27, 0xFF};
  int width = 0, height = 0;
  for (const Image& picture : pictures)
    width = std::max(width, picture.width), height = std::max(height, picture.height);
  const int count = static_cast<int>(pictures.size()), used = std::min(columns, std::max(count, 1)),
            rows = (count + columns - 1) / columns;
  Image sheet{used * (width + gap) + gap, rows * (height + gap) + gap, {}};
  sheet.rgba.resize(std::size_t(sheet.width) * std::size_t(sheet.height) * 4);
  for (std::size_t i = 0; i < sheet.rgba.size(); ++i) sheet.rgba[i] = kGround[i % 4];
  for (int i = 0; i < count; ++i) {
    const Image& picture = pictures[std::size_t(i)];
    const int left = gap + i % columns * (width + gap) + (width - picture.width) / 2,
              top = gap + i / columns * (height + gap) + (height - picture.height) / 2;
    for (int y = 0; y < picture.height; ++y)
      std::copy_n(&picture.rgba[std::size_t(y) * std::size_t(picture.width) * 4], std::size_t(picture.width) * 4,
                  &sheet.rgba[(std::size_t(top + y) * std::size_t(sheet.width) + std::size_t(left)) * 4]);
  }
  return sheet;
}

}  // namespace coaster::gfx
