// PNG in memory, by stb. The caller reads and writes files (base::Files), which allows fault injection.
#include <climits>

#include <fmt/format.h>

#include "base/words.h"
#include "gfx/image.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace coaster::gfx {

std::string encode_png(const Image& image) {
  COASTER_CHECK(image.width >= 1 && image.height >= 1 &&
                    image.rgba.size() == 4 * std::size_t(image.width) * std::size_t(image.height),
                "a picture has four bytes for each pixel");
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), std::size_t(size));
  };
  stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(), 4 * image.width);
  return bytes;
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
