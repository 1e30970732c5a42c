// The paint of sections that have their own, in a texture: changing it changes no vertex. A segment's texels are at its
// entity's index, which its mesh contains.
#pragma once

#include <cstdint>
#include <vector>

#include "gfx/gl_objects.h"
#include "sim/shape/derived_track.h"

namespace coaster::gfx {

class SectionPaint {
 public:
  explicit SectionPaint(const Gl& gl) : gl_(&gl) {}
  // Writes the whole texture if a colour changed. Looks at every segment if any section is painted, else at none.
  void sync(const sim::DerivedTrack& derived, const world::Document* document);
  bool any() const { return any_; }
  // Binds the texture to a unit; an empty one if no section ever had its own paint.
  void bind(int unit);

 private:
  static constexpr std::size_t kSegmentsInRow = 32, kTexels = 4, kRowBytes = kSegmentsInRow * kTexels * 4;
  void write(std::vector<std::uint8_t> texels);  // binds the texture to the active unit

  const Gl* gl_;
  GlObject texture_;
  bool any_ = false;
  std::vector<std::uint8_t> held_;
};

}  // namespace coaster::gfx
