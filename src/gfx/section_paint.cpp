#include "gfx/section_paint.h"

#include <algorithm>
#include <utility>

#include "world/sections.h"

namespace coaster::gfx {
namespace {

constexpr world::PaintPart kOfTrack[] = {world::PaintPart::rails, world::PaintPart::spine, world::PaintPart::supports};

}  // namespace

void SectionPaint::write(std::vector<std::uint8_t> texels) {
  if (texture_.id() != 0 && texels == held_) return;
  held_ = std::move(texels);
  texture_ = make_texture(*gl_, GL_NEAREST, GL_NEAREST);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GLsizei(kSegmentsInRow * kTexels), GLsizei(held_.size() / kRowBytes), 0,
                  GL_RGBA, GL_UNSIGNED_BYTE, held_.data());
}

void SectionPaint::sync(const sim::DerivedTrack& derived, const world::Document* document) {
  const auto is_painted = [](const world::Section& section) { return !(section.paint == world::Paint{}); };
  any_ = document != nullptr && std::ranges::any_of(document->entities.pool<world::Section>().items(), is_painted);
  if (!any_) return;
  std::uint32_t last = 0;
  for (const world::Entity segment : derived.order) last = std::max(last, segment.index);
  std::vector<std::uint8_t> texels((last / kSegmentsInRow + 1) * kRowBytes);
  for (const world::Entity segment : derived.order) {
    const world::Entity section = world::segment(*document, segment).section;
    if (!section.valid()) continue;
    const world::Paint& paint = world::section(*document, section).paint;
    std::uint8_t* texel = &texels[segment.index * kTexels * 4];
    for (const world::PaintPart part : kOfTrack) {
      const world::Colour colour = paint.of(part);
      for (int shift = 16; shift >= 0; shift -= 8) *texel++ = static_cast<std::uint8_t>(colour.rgb >> shift & 255);
      *texel++ = colour.own() ? 255 : 0;
    }
  }
  gl_->ActiveTexture(GL_TEXTURE0);
  write(std::move(texels));
}

void SectionPaint::bind(int unit) {
  gl_->ActiveTexture(GL_TEXTURE0 + GLenum(unit));
  if (texture_.id() == 0) write(std::vector<std::uint8_t>(kRowBytes));
  gl_->BindTexture(GL_TEXTURE_2D, texture_.id());
  gl_->ActiveTexture(GL_TEXTURE0);
}

}  // namespace coaster::gfx
