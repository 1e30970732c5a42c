#include "gfx/growing_buffer.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

#include "gfx/studio.h"
#include "gfx/track_cache.h"
#include "world/evaluation_settings.h"

namespace coaster::gfx {
namespace growing_buffer_test {

using GrowingBuffers = test::Studio;

// What a buffer of floats holds.
std::vector<float> held_by(const Gl& gl, const GrowingBuffer<float>& buffer, std::size_t count) {
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer.id());
  const auto* const held = static_cast<const float*>(
      gl.MapBufferRange(GL_COPY_READ_BUFFER, 0, GLsizeiptr(count * sizeof(float)), GL_MAP_READ_BIT));
  const std::vector<float> numbers = held ? std::vector<float>(held, held + count) : std::vector<float>();
  gl.UnmapBuffer(GL_COPY_READ_BUFFER);
  return numbers;
}

TEST_F(GrowingBuffers, what_they_hold_survives_growth) {
  GrowingBuffer<float> buffer(gl_);
  std::vector<float> numbers(3000);
  std::iota(numbers.begin(), numbers.end(), 0.5f);
  EXPECT_TRUE(buffer.fill(numbers));
  EXPECT_FALSE(buffer.reserve(numbers.size())) << "no growth without need";
  EXPECT_TRUE(buffer.reserve(100 * numbers.size()));
  const float tail = -7.25f;
  buffer.write(100 * numbers.size() - 1, std::span(&tail, 1));

  const std::vector<float> held = held_by(gl_, buffer, 100 * numbers.size());
  ASSERT_EQ(held.size(), 100 * numbers.size());
  EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), held.begin()));
  EXPECT_EQ(held.back(), tail);
}

// A write just after growth overlaps what is copied, which drivers may still be doing.
TEST_F(GrowingBuffers, what_is_written_after_growth_is_not_overwritten_by_the_copy) {
  constexpr std::size_t kStep = 999;
  GrowingBuffer<float> buffer(gl_);
  std::vector<float> wanted;
  for (int step = 0; step < 700; ++step) {
    const std::vector<float> items(kStep, 0.5f + static_cast<float>(step));
    const std::size_t first = wanted.size() - wanted.size() / 9;
    wanted.resize(first + kStep);
    std::copy(items.begin(), items.end(), wanted.begin() + std::ptrdiff_t(first));
    buffer.reserve(wanted.size());
    buffer.write(first, items);
  }
  EXPECT_TRUE(held_by(gl_, buffer, wanted.size()) == wanted);
}

TEST_F(GrowingBuffers, wait_for_the_copy_before_the_next_write) {
  static std::string done;
  static PFNGLCOPYBUFFERSUBDATAPROC copy;
  static PFNGLBUFFERSUBDATAPROC write;
  static PFNGLFINISHPROC finish;
  done.clear(), copy = gl_.CopyBufferSubData, write = gl_.BufferSubData, finish = gl_.Finish;
  gl_.CopyBufferSubData = [](GLenum from, GLenum to, GLintptr read, GLintptr at, GLsizeiptr size) {
    done += "copy ", copy(from, to, read, at, size);
  };
  gl_.BufferSubData = [](GLenum target, GLintptr at, GLsizeiptr size, const void* data) {
    done += "write ", write(target, at, size, data);
  };
  gl_.Finish = [] { done += "finish ", finish(); };
  GrowingBuffer<float> buffer(gl_);
  const std::vector<float> few(10, 1.0f), many(100'000, 2.0f);
  buffer.fill(few);
  buffer.fill(many);
  buffer.fill(few);
  EXPECT_EQ(done, "write copy finish write write ");
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
