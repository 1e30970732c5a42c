// Rails, spine and ties near and far: numbers of triangles and uploads, and that pictures do not jump between levels.
#include "gfx/swept_track.h"

#include <cmath>

#include "gfx/studio.h"
#include "gfx/track_cache.h"

namespace coaster::gfx {
namespace swept_track_test {

using test::Track;
using Swept = test::Studio;

constexpr SweptTrack::DetailDistances kEverything{1e6f, 1e6f};

TEST_F(Swept, what_is_far_off_takes_fewer_triangles_and_no_upload) {
  Track track(test::straight_document({0, 9, 0}, {2000, 9, 0}, 200));
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  SweptTrack& swept = cache.swept();
  swept.look_from({1000, 12, 3}, kEverything);
  const std::int64_t all = swept.triangles();
  EXPECT_EQ(swept.draw_calls(), 3);  // tubes, caps, ties
  swept.look_from({1000, 12, 3}, {0.1f, 1e6f});
  const std::int64_t tied = swept.triangles();
  EXPECT_LT(5 * tied, 4 * all);
  swept.look_from({1000, 12, 3}, {0.1f, 0.1f});
  const std::int64_t few = swept.triangles();
  EXPECT_LT(10 * few, all);
  // 100 m to both sides in full: a run of tubes, caps and ties each, and two of distant tubes.
  swept.look_from({1000, 12, 3}, {100, 100});
  swept.draw();
  EXPECT_EQ(swept.draw_calls(), 5);
  EXPECT_GT(swept.triangles(), few + (all - few) / 20);
  EXPECT_LT(swept.triangles(), few + (all - few) / 5);
  for (float x = 0; x < 2000; x += 100) {
    swept.look_from({x, 20, 50}, {100, 100});
    const TrackCache::UploadStats synced = cache.sync(track.derived, {});
    EXPECT_EQ(synced.uploads, 0);
    EXPECT_EQ(synced.bytes, 0);
  }
  EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// A choice goes over runs of far segments, not over each.
TEST_F(Swept, far_segments_of_a_very_long_track_cost_a_choice_little) {
  constexpr int kSegments = 24'000;
  Track track(test::ring_document(kSegments, 2.0f * kSegments), 2);
  const glm::vec3 eye = world::knot(track.document, track.document.track.knots[0]).position + glm::vec3(0, 3, 0);
  TrackCache cache(gl_);
  cache.look_from({eye, 1e-5f, 100}, 0);
  cache.sync(track.derived, {});
  SweptTrack& swept = cache.swept();
  const auto triangles_after = [&](std::size_t knot) {
    track.move(knot, {0, 0.01f, 0});
    EXPECT_EQ(cache.sync(track.derived, {}).uploads, 2);
    swept.look_from(eye, {100, 100});
    EXPECT_LT(swept.part_count(), kSegments / 20u);
    return swept.triangles();
  };
  const std::int64_t triangles = triangles_after(1);
  EXPECT_GE(triangles, kSegments);
  EXPECT_EQ(triangles_after(kSegments / 2), triangles);
}

TEST_F(Swept, a_far_segment_that_moves_casts_its_shadow_where_it_is) {
  constexpr int kSegments = 24'000;
  constexpr std::size_t kKnot = kSegments / 2;
  Track track(test::ring_document(kSegments, 2.0f * kSegments), 2);
  TrackCache cache(gl_);
  cache.look_from({world::knot(track.document, track.document.track.knots[0]).position, 0.01f, 100}, 0);
  cache.sync(track.derived, {});
  const glm::vec3 place =
      world::knot(track.document, track.document.track.knots[kKnot]).position + glm::vec3(0, 450, 0);
  const auto cast_there = [&] {  // in a cube of 4 m
    glm::mat4 light(0.5f);
    light[3] = glm::vec4(-0.5f * place, 1);
    return cache.swept().cast(light, 100, true).triangles;
  };
  EXPECT_EQ(cast_there(), 0);
  track.move(kKnot, {0, 450, 0});
  cache.sync(track.derived, {});
  EXPECT_GT(cast_there(), 0);
}

// A straight of 200 m in one segment that begins 10 m ahead of the eye: its middle is 110 m off.
TEST_F(Swept, a_long_segment_is_as_near_as_its_nearest_part) {
  const Track track(test::straight_document({10, 9, 0}, {210, 9, 0}));
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  const auto triangles = [&](float near) {
    cache.swept().look_from({0, 9, 0}, {near, 1e6f});
    return cache.swept().triangles();
  };
  const std::int64_t all = triangles(1e6f);
  for (const float near : {12.0f, 50.0f, 105.0f, 150.0f}) EXPECT_EQ(triangles(near), all) << near;
  EXPECT_LT(triangles(5), all);
}

TEST_F(Swept, an_orbit_of_a_large_track_stays_within_the_budget_and_uploads_nothing) {
  constexpr int kSegments = 12000;
  constexpr float kRadius = 19000;
  const Track track(test::ring_document(kSegments, kRadius, 900), 2);
  TrackCache cache(gl_);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, kSegments);
  SweptTrack& swept = cache.swept();
  swept.look_from({0, 0, 0}, {-1, -1});
  const std::int64_t fewest = swept.triangles();
  EXPECT_LT(4 * fewest, kTriangleBudget);
  std::int64_t most = 0;
  for (int i = 0; i < 12; ++i) {
    const float a = 0.52f * static_cast<float>(i);
    swept.look_from({kRadius * std::cos(a), 40, kRadius * std::sin(a)}, kEverything);
    EXPECT_LE(swept.triangles(), kTriangleBudget) << i;
    EXPECT_LE(swept.draw_calls(), 4 * 96) << i;
    most = std::max(most, swept.triangles());
    EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0);
  }
  EXPECT_GT(most, fewest) << "what is near is in full";
  // A shadow map casts what is in its square, here 256 m wide about the start.
  const glm::vec3 start = track.derived.shape_at(0).key.cubic.p0;
  const float flat = 1.0f / 128;
  const glm::mat4 light{glm::vec4(flat, 0, 0, 0), glm::vec4(0, 0, 1e-4f, 0), glm::vec4(0, flat, 0, 0),
                        glm::vec4(-flat * start.x, -flat * start.z, 0, 1)};
  const ShadowDrawStats cast = swept.cast(light, 0.125f, true);
  EXPECT_GT(cast.triangles, 0);
  EXPECT_LT(cast.triangles, 60 * 600);  // 600 triangles in each of the segments in 256 m and a bit
}

// Flies away from a track. Where the number of triangles changes, the pictures just before and after differ only in
// outlines: where a rail is two pixels wide, its outline moves by at most 0.29 px and the spine's by 0.68 px, and a
// pixel changes by at most that fraction of their contrast.
TEST_F(Swept, pictures_do_not_jump_where_the_detail_changes) {
  width_ = 320, height_ = 180, samples_ = 4, show_polyline_ = false;
  renderer_ = fresh();
  const Track track(test::ring_document(60, 90.0, 6.0));
  const view::Overlay overlay;
  const view::Viewport viewport{0, 0, 320, 180};
  world::Camera camera = view::frame_all({}, track.document, viewport);
  const auto at = [&](double distance) {
    camera.distance = distance;
    const view::View view = view::orbit_view(camera, viewport);
    Scene scene{track.derived, view, overlay, {}, false};
    scene.shadows = false;  // their map changes in steps
    return renderer_->draw(scene, width_, height_);
  };
  int changes = 0;
  double before = 60;
  (void)at(before);
  for (double distance = 75; distance < 1400; distance *= 1.25) {
    double near = before, far = distance;
    const std::int64_t few = at(far).triangles;
    if (few == at(near).triangles) continue;
    for (int i = 0; i < 24; ++i) {
      const double middle = 0.5 * (near + far);
      (at(middle).triangles == few ? far : near) = middle;
    }
    (void)at(near);
    const Image nearer = renderer_->read_pixels();
    (void)at(far);
    const Image farther = renderer_->read_pixels();
    double sum = 0;
    int most = 0;
    for (std::size_t i = 0; i < nearer.rgba.size(); ++i) {
      const int off = std::abs(int(nearer.rgba[i]) - int(farther.rgba[i]));
      sum += off, most = std::max(most, off);
    }
    EXPECT_LT(sum / static_cast<double>(nearer.rgba.size()), 0.1) << far;
    EXPECT_LT(most, 100) << far;
    ++changes;
    before = distance;
  }
  EXPECT_GT(changes, 3);
}

TEST_F(Swept, ranges_are_used_again) {
  const Track track(test::ring_document(9, 17.3f));
  SweptTrack swept(gl_);
  std::vector<SweptTrack::Id> ids(9, SweptTrack::kNone);
  const auto send = [&](std::size_t i) {
    swept.stage(track.derived.shape_at(i), {}, std::uint32_t(i));
    EXPECT_GT(swept.write(ids[i]), 0);
  };
  for (std::size_t i = 0; i < 9; ++i) send(i);
  const std::int64_t used = swept.bytes();
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = 1; i < 9; i += 2) swept.release(ids[i]);
    swept.look_from({0, 0, 0}, kEverything);
    const std::int64_t before = swept.triangles();
    for (std::size_t i = 1; i < 9; i += 2) send(i);
    swept.look_from({0, 0, 0}, kEverything);
    EXPECT_GE(swept.triangles(), before);
  }
  EXPECT_EQ(swept.bytes(), used);
  for (SweptTrack::Id& id : ids) swept.release(id);
  swept.look_from({0, 0, 0}, kEverything);
  EXPECT_EQ(swept.bytes(), 0);
  EXPECT_EQ(swept.draw_calls(), 0);
}

}  // namespace swept_track_test
}  // namespace coaster::gfx
