// Pictures in memory and as PNG files; comparison with a golden picture.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/files.h"
#include "gfx/objects.h"
#include "gfx/renderer.h"

namespace coaster::gfx {

std::string encode_png(const Image& image);
base::Result<Image> decode_png(std::string_view bytes, std::string_view name);

// A texture of it, smoothly filtered, without mipmaps.
Object make_texture(const Gl& gl, const Image& image);

// At half the size: the mean of 2 x 2 pixels. Odd rows and columns at the end are left out.
Image half_size(const Image& picture);

// Pictures in rows of `columns` (at least 1), each in the middle of a cell as large as the largest of them, with a
// margin of `gap` px around every cell.
Image contact_sheet(std::span<const Image> pictures, int columns, int gap);

// The rule of golden pictures: sizes equal; a pixel differs where a channel differs by more than 16; too different when
// over 0.05 % of the pixels differ or any aligned 8x8 block has more than 8 differing pixels.
struct Difference {
  bool same_size = true;
  long pixels = 0;      // that differ
  int worst_block = 0;  // most differing pixels in a block
  bool acceptable = true;
  Image picture;  // differing pixels red over a grey copy
};
Difference compare(const Image& picture, const Image& golden);

}  // namespace coaster::gfx
