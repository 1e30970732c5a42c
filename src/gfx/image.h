// Pictures in memory and as PNG files; comparison with golden pictures.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/files.h"
#include "gfx/gl_objects.h"
#include "gfx/renderer.h"

namespace coaster::gfx {

std::string encode_png(const Image& image);
// Code::bad_file for anything else, and for pictures of more than base::kMaxPixels.
base::Result<Image> decode_png(std::string_view bytes, std::string_view name);

// Returns a texture of the image, linearly filtered, without mipmaps.
GlObject make_texture(const Gl& gl, const Image& image);

// Returns the image at half its size: the mean of 2 x 2 pixels. A last odd row or column is left out.
Image half_size(const Image& picture);

// Returns the pictures in rows of `columns` (at least 1), each centred in a cell of the size of the largest picture,
// with a margin of `gap` px around every cell.
Image contact_sheet(std::span<const Image> pictures, int columns, int gap);

// What a driver may change in a golden picture: a fraction of all pixels, and pixels of one aligned 8x8 block; the
// difference of a channel, of 255, up to which a pixel counts as equal; and by how many pixels an edge may move without
// counting in the fraction (it counts in its block).
struct PictureTolerance {
  double share;
  int block, channel = 16, moved = 0;
};

// The rule of golden pictures: sizes are equal; a pixel differs if a channel differs by more than 16; pictures differ
// if more pixels differ than the tolerance says. This distinguishes drivers from defects: a driver that rounds
// differently changes isolated pixels at edges; a defect is a patch. A patch of 10x10 pixels, wherever it lies, covers
// at least 5x5 of one block. A driver with other samples moves edges by a part of a pixel: all those of a wood, or both
// of a post and what crosses it in a block.
struct PictureDifference {
  static constexpr PictureTolerance kSameSamples{0.0005, 8}, kOtherSamples{0.005, 24, 16, 1};
  bool same_size = true;
  long pixels = 0;       // number of differing pixels that no moved edge explains
  long most_pixels = 0;  // acceptable number
  int worst_block = 0;   // most differing pixels in one block
  bool acceptable = true;
  int largest = 0;                       // difference of a channel
  glm::ivec2 first{-1}, largest_at{-1};  // the first differing pixel, by rows from the top; where `largest` is
  Image picture;                         // differing pixels in red over a grey copy
};
PictureDifference compare(const Image& picture, const Image& golden,
                          PictureTolerance tolerance = PictureDifference::kSameSamples);

}  // namespace coaster::gfx
