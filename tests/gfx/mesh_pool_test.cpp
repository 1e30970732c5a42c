// Solids in shared buffers, and supports in separate buffers.
#include "gfx/mesh_pool.h"

#include "gfx/studio.h"
#include "gfx/track_cache.h"
#include "sim/solids/track_mesh.h"

namespace coaster::gfx {
namespace mesh_pool_test {

using test::Track;
using Pool = test::Studio;

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

TEST_F(Pool, a_shadow_map_takes_the_solids_inside_its_square) {
  MeshPool pool(gl_);
  const Track track(test::straight_document({0, 9, 0}, {2000, 9, 0}, 200));
  sim::Mesh mesh;
  const sim::Clock no_clock;
  Stopwatch watch{no_clock};
  for (const world::Entity e : track.derived.order) {
    MeshPool::Id id = MeshPool::kNone;
    sim::sweep_track(track.derived.shape(e), mesh);
    pool.write(mesh, id, watch);
  }
  pool.look_from({0, 0, 0}, 1);
  // From above; half a side of the square about `x` is `half` metres.
  const auto cast = [&](float x, float half) {
    const float flat = 1 / half;
    return pool.cast({{flat, 0, 0, 0}, {0, 0, 1e-4f, 0}, {0, flat, 0, 0}, {-flat * x, 0, 0, 1}}, false).triangles;
  };
  const std::int64_t all = pool.index_count() / 3;
  EXPECT_EQ(cast(1000, 1100), all);
  EXPECT_EQ(cast(1005, 50), all / 200 * 11);  // the first and the last of them by half
  EXPECT_EQ(cast(5000, 50), 0);
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
