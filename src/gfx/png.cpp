// PNG in memory: written by zlib, read by stb. The caller reads and writes files (base::Files), which allows fault
// injection.
#include <zlib.h>

#include <algorithm>
#include <climits>
#include <functional>
#include <new>

#include <fmt/format.h>

#include "base/text.h"
#include "gfx/image.h"

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

}  // namespace coaster::gfx
