#include "gfx/growing_buffer.h"

#include <cstddef>
#include <map>
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

  gl_.BindBuffer(GL_COPY_READ_BUFFER, buffer.id());
  const auto* const held =
      static_cast<const float*>(gl_.MapBufferRange(GL_COPY_READ_BUFFER, 0, GLsizeiptr(100 * bytes), GL_MAP_READ_BIT));
  ASSERT_NE(held, nullptr);
  EXPECT_EQ(std::vector<float>(held, held + numbers.size()), numbers);
  EXPECT_EQ(held[100 * numbers.size() - 1], tail);
  EXPECT_EQ(gl_.UnmapBuffer(GL_COPY_READ_BUFFER), GLboolean(GL_TRUE));
}

// The rule of WebGL: a buffer is for indices if it was bound as such first, and for nothing else then but copies.
TEST_F(GrowingBuffers, index_buffers_are_bound_as_such_first) {
  static PFNGLBINDBUFFERPROC bind;
  static std::map<GLuint, GLenum> first_bound;
  static std::vector<std::string> wrong;
  bind = gl_.BindBuffer;
  first_bound.clear(), wrong.clear();
  gl_.BindBuffer = [](GLenum target, GLuint id) {
    if (id != 0) {
      const GLenum first = first_bound.try_emplace(id, target).first->second;
      const bool copies = target == GL_COPY_READ_BUFFER || target == GL_COPY_WRITE_BUFFER;
      if ((target == GL_ELEMENT_ARRAY_BUFFER) != (first == GL_ELEMENT_ARRAY_BUFFER) && !copies)
        wrong.push_back(std::to_string(id) + " is bound to " + std::to_string(target) + " after " +
                        std::to_string(first));
    }
    bind(target, id);
  };
  {
    const auto renderer = fresh();
    test::Track track(test::ring_document(8, 17.3f));
    carts_ = {sim::Pose{}};
    draw(*renderer, track);
    for (int i = 0; i < 3; ++i) {
      test::split_at(track.document, track.document.track.segments[std::size_t(i)], 0.37);
      track.derive();
      draw(*renderer, track);
    }
    GrowingBuffer<std::uint32_t> indices(gl_);
    const std::vector<std::uint32_t> corners(40'000, 1);
    indices.reserve(10), indices.fill(corners);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  }
  EXPECT_GE(std::ranges::count_if(first_bound, [](const auto& row) { return row.second == GL_ELEMENT_ARRAY_BUFFER; }),
            6);
  EXPECT_EQ(wrong, std::vector<std::string>{});
  gl_.BindBuffer = bind;
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
