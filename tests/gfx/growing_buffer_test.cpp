#include "gfx/growing_buffer.h"

#include <cstddef>
#include <numeric>
#include <vector>

#include "gfx/studio.h"
#include "gfx/track_cache.h"
#include "world/evaluation.h"

namespace coaster::gfx {
namespace growing_buffer_test {

using GrowingBuffers = test::Studio;

TEST_F(GrowingBuffers, what_they_hold_survives_growth) {
  GrowingBuffer<float> buffer(gl_);
  std::vector<float> numbers(3000);
  std::iota(numbers.begin(), numbers.end(), 0.5f);
  const std::size_t bytes = numbers.size() * sizeof(float);
  EXPECT_TRUE(buffer.fill(numbers));
  EXPECT_FALSE(buffer.reserve(numbers.size())) << "no growth without need";
  EXPECT_TRUE(buffer.reserve(100 * numbers.size()));
  const float tail = -7.25f;
  buffer.write(100 * numbers.size() - 1, std::span(&tail, 1));

  const auto read = reinterpret_cast<PFNGLGETBUFFERSUBDATAPROC>(surface_->gl_proc("glGetBufferSubData"));
  ASSERT_NE(read, nullptr);
  std::vector<float> back(numbers.size());
  float last = 0;
  gl_.BindBuffer(GL_COPY_READ_BUFFER, buffer.id());
  read(GL_COPY_READ_BUFFER, 0, GLsizeiptr(bytes), back.data());
  read(GL_COPY_READ_BUFFER, GLintptr(100 * bytes - sizeof last), sizeof last, &last);
  EXPECT_EQ(back, numbers);
  EXPECT_EQ(last, tail);
}

TEST_F(GrowingBuffers, segments_that_are_copied_to_a_larger_one_are_no_uploads) {
  test::Track track(test::ring_document(8, 17.3));
  world::set_closed(track.document, false);
  track.settings.evaluation->steps = 64;
  track.derive();
  TrackCache cache(gl_);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 7);
  // One segment at a time from 11 KB of polylines to 245 KB, past the buffer's first 64 KB and the next two sizes.
  for (int i = 0; i < 150; ++i) {
    world::append_knot(track.document,
                       test::skew_knot({13.3f + 7.1f * float(i), 9.7f, -50.3f}, {1, 0.1f, 0.2f}, 3.1f, 3.7f));
    track.derive();
    ASSERT_EQ(cache.sync(track.derived, {}).uploads, 1) << "at segment " << i;
  }
  EXPECT_GT(std::size_t(cache.line_count()) * sizeof(PolylineVertex), std::size_t(200'000));
}

TEST_F(GrowingBuffers, a_track_that_outgrew_them_looks_as_to_a_fresh_renderer) {
  test::Track track(test::ring_document(8, 17.3));
  world::set_closed(track.document, false);
  track.settings.evaluation->steps = 64;
  track.derive();
  draw(track);
  for (int i = 0; i < 150; ++i)
    world::append_knot(track.document,
                       test::skew_knot({13.3f + 7.1f * float(i), 9.7f, -50.3f}, {1, 0.1f, 0.2f}, 3.1f, 3.7f));
  track.derive();
  EXPECT_EQ(draw(track).uploads, 150);
  EXPECT_EQ(renderer_->read_pixels().rgba, picture(*fresh(), track).rgba);
}

}  // namespace growing_buffer_test
}  // namespace coaster::gfx
