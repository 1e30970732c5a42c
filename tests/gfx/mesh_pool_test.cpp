// Solids near and far, and supports in buffers of their own.
#include "gfx/mesh_pool.h"

#include "gfx/studio.h"
#include "gfx/support_cache.h"
#include "gfx/track_cache.h"
#include "sim/solids/track_mesh.h"

namespace coaster::gfx {
namespace mesh_pool_test {

using test::Track;
using Pool = test::Studio;

TEST_F(Pool, what_is_far_off_takes_fewer_triangles_and_no_upload) {
  Track track(test::straight_document({0, 9, 0}, {2000, 9, 0}, 200));
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  cache.mesh().look_from({1000, 12, 3}, 1e6f);
  const std::int64_t all = cache.mesh().triangles();
  EXPECT_EQ(cache.mesh().draw(), 1);
  cache.mesh().look_from({1000, 12, 3}, 0.1f);
  const std::int64_t few = cache.mesh().triangles();
  EXPECT_LT(5 * few, 4 * all);  // a straight has few rings to leave out
  // 100 m to both sides in full: a run of them, and two of the others.
  cache.mesh().look_from({1000, 12, 3}, 100);
  EXPECT_EQ(cache.mesh().draw(), 3);
  EXPECT_GT(cache.mesh().triangles(), few + (all - few) / 20);
  EXPECT_LT(cache.mesh().triangles(), few + (all - few) / 5);
  for (float x = 0; x < 2000; x += 100) {
    cache.mesh().look_from({x, 20, 50}, 100);
    const TrackCache::Synced synced = cache.sync(track.derived, {});
    EXPECT_EQ(synced.uploads, 0);
    EXPECT_EQ(synced.bytes, 0);
  }
  EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// A straight of 200 m in one segment that begins 10 m ahead of the eye: its middle is 110 m off.
TEST_F(Pool, a_long_solid_is_as_near_as_its_nearest_part) {
  const Track track(test::straight_document({10, 9, 0}, {210, 9, 0}));
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  const auto triangles = [&](float near) {
    cache.mesh().look_from({0, 9, 0}, near);
    return cache.mesh().triangles();
  };
  const std::int64_t all = triangles(1e6f);
  for (const float near : {12.0f, 50.0f, 105.0f, 150.0f}) EXPECT_EQ(triangles(near), all) << near;
  EXPECT_LT(triangles(5), all);
}

TEST_F(Pool, places_are_used_again_and_gaps_draw_nothing) {
  MeshPool pool(gl_);
  const Track track(test::ring_document(9, 17.3f));
  sim::Mesh mesh;
  std::vector<MeshPool::Id> ids(9, MeshPool::kNone);
  const sim::Clock no_clock;
  Stopwatch watch{no_clock};
  const auto send = [&](std::size_t i) {
    sim::sweep_track(track.derived.shape(track.derived.order[i]), mesh);
    pool.write(mesh, ids[i], watch);
  };
  for (std::size_t i = 0; i < 9; ++i) send(i);
  const std::uint32_t used = pool.index_count();
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = 1; i < 9; i += 2) pool.release(ids[i]);
    pool.look_from({0, 0, 0}, 1e6f);
    const std::int64_t before = pool.triangles();
    for (std::size_t i = 1; i < 9; i += 2) send(i);
    pool.look_from({0, 0, 0}, 1e6f);
    EXPECT_GE(pool.triangles(), before);
  }
  EXPECT_EQ(pool.index_count(), used);
  for (MeshPool::Id& id : ids) pool.release(id);
  pool.look_from({0, 0, 0}, 1e6f);
  EXPECT_EQ(pool.index_count(), 0u);
  EXPECT_EQ(pool.draw(), 0);
}

TEST_F(Pool, supports_are_written_where_they_changed_and_go_when_hidden) {
  Track track(test::ring_document(60, 120.0f));
  sim::Supports supports;
  supports.update(track.derived);
  SupportCache cache(gl_);
  const int first = cache.sync(&supports, {}).uploads;
  EXPECT_GT(first, 30);
  EXPECT_EQ(cache.sync(&supports, {}).uploads, 0);
  track.move(11, {0.3f, 0.7f, -0.4f});
  supports.update(track.derived);
  const int moved = cache.sync(&supports, {}).uploads;
  EXPECT_GE(moved, 1);
  EXPECT_LE(moved, 4);
  EXPECT_EQ(cache.sync(nullptr, {}).uploads, 0);
  EXPECT_EQ(cache.mesh().index_count(), 0u);
  EXPECT_EQ(cache.sync(&supports, {}).uploads, first);
}

TEST_F(Pool, trains_take_as_many_draw_calls_however_long_they_are) {
  Track track(test::ring_document(60, 120.0f));
  const auto calls = [&](int cars) {
    carts_.clear();
    for (int i = 0; i < cars; ++i) {
      carts_.push_back(
          sim::pose(track.derived, sim::TrackPlace{static_cast<std::size_t>(i), 1.0}, world::FrameMethod::knots));
      carts_.back().leads = i % 7 == 0;
    }
    (void)draw(track);
    return draw(track).draw_calls;  // without new shadows
  };
  const int without = calls(0), few = calls(3), many = calls(40);
  EXPECT_EQ(few, many);
  EXPECT_LE(many, without + 3);
  EXPECT_GT(many, without);
}

}  // namespace mesh_pool_test
}  // namespace coaster::gfx
