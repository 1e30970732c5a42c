// The values that colour the track, in a separate texture: changing them changes no vertex. A segment's row is its
// entity's index, which its mesh contains.
#pragma once

#include <cstdint>
#include <vector>

#include "gfx/gl_objects.h"
#include "sim/study/colour_values.h"

namespace coaster::gfx {

class ValueTexture {
 public:
  static constexpr int kSegmentsInRow = 32, kWidth = kSegmentsInRow * sim::kValuesPerSegment;
  explicit ValueTexture(const Gl& gl) : gl_(&gl) {}

  struct UploadStats {
    int recolours = 0;       // segments whose values changed
    std::int64_t bytes = 0;  // written
  };
  // Writes the rows that changed. Equal values cost a comparison of 128 bytes per segment; plain values cost nothing.
  UploadStats sync(const sim::DerivedTrack& derived, const sim::TrackValues& values);
  // Binds to texture unit 0; binds a texture of one row if nothing was ever written.
  void bind();

 private:
  void fit(int rows);

  const Gl* gl_;
  GlObject texture_;
  int rows_ = 0;
  std::vector<float> held_;
  std::vector<bool> changed_;  // by row; kept for its capacity
};

}  // namespace coaster::gfx
