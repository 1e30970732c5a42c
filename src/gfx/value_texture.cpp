#include "gfx/value_texture.h"

#include <algorithm>
#include <cstring>

namespace coaster::gfx {

// Grows in powers of two; existing rows are written again.
void ValueTexture::fit(int rows) {
  if (rows <= rows_) return;
  rows_ = std::max(rows_, 1);
  while (rows_ < rows) rows_ *= 2;
  held_.resize(static_cast<std::size_t>(rows_) * kWidth, sim::kUnknownValue);
  texture_ = make_texture(*gl_, GL_NEAREST, GL_NEAREST);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kWidth, rows_, 0, GL_RED, GL_FLOAT, held_.data());
}

ValueTexture::UploadStats ValueTexture::sync(const sim::DerivedTrack& derived, const sim::TrackValues& values) {
  UploadStats synced;
  if (values.values.empty()) return synced;
  std::uint32_t last = 0;
  for (const world::Entity segment : derived.order) last = std::max(last, segment.index);
  gl_->ActiveTexture(GL_TEXTURE0);
  fit(static_cast<int>(last / kSegmentsInRow) + 1);
  gl_->BindTexture(GL_TEXTURE_2D, texture_.id());
  changed_.assign(static_cast<std::size_t>(rows_), false);
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const std::size_t index = derived.order[i].index;
    float* const held = &held_[index * sim::kValuesPerSegment];
    const std::span<const float> now = values.of(i);
    if (std::memcmp(held, now.data(), now.size_bytes()) == 0) continue;
    std::copy(now.begin(), now.end(), held);
    changed_[index / kSegmentsInRow] = true;
    ++synced.recolours;
  }
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (int row = 0; row < rows_; ++row) {
    int end = row;
    while (end < rows_ && changed_[static_cast<std::size_t>(end)]) ++end;
    if (end == row) continue;
    gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, row, kWidth, end - row, GL_RED, GL_FLOAT,
                       &held_[static_cast<std::size_t>(row) * kWidth]);
    synced.bytes += std::int64_t(end - row) * kWidth * std::int64_t(sizeof(float));
    row = end;
  }
  return synced;
}

void ValueTexture::bind() {
  fit(1);
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, texture_.id());
}

}  // namespace coaster::gfx
