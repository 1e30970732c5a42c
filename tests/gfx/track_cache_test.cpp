// Uploads: none for a still frame, two segments for a moved knot, for any size of the track.
#include "gfx/track_cache.h"

#include "gfx/studio.h"
#include "sim/lands.h"
#include "world/evaluation_settings.h"

namespace coaster::gfx {
namespace track_cache_test {

using test::Track;
using Cache = test::Studio;

constexpr int kLarge = 5000;

class SizedCache : public test::Studio, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(segments, SizedCache, testing::Values(8, kLarge));

TEST_P(SizedCache, a_still_frame_uploads_nothing_and_a_moved_interior_knot_two_segments) {
  const int segments = GetParam();
  Track track(test::ring_document(segments, 2.0f * static_cast<float>(segments)), 4);
  TrackCache cache(gl_);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, segments);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0);
  GLsizei lines = 0;
  std::int64_t bytes = 0;
  for (int step = 0; step < 40; ++step) {
    const float way = step % 4 < 2 ? 1.0f : -1.0f;  // forth and back: after one round every shape has been seen
    track.move(static_cast<std::size_t>(segments) / 2, way * glm::vec3(0.37f, 0.21f, -0.13f));
    EXPECT_EQ(cache.sync(track.derived, {}).uploads, 2) << step;
    EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0) << step;
    if (step == 3) lines = cache.line_count(), bytes = cache.swept().bytes();
  }
  EXPECT_EQ(cache.line_count(), lines);
  EXPECT_EQ(cache.swept().bytes(), bytes) << "a drag must not eat room";
}

TEST_P(SizedCache, only_changed_segments_are_looked_at) {
  const int segments = GetParam();
  Track track(test::ring_document(segments, 2.0f * static_cast<float>(segments)), 4);
  TrackCache cache(gl_);
  EXPECT_EQ(cache.sync(track.derived, {}).looked_at, segments);
  EXPECT_EQ(cache.sync(track.derived, {}).looked_at, 0);
  track.move(3, {0, 0.5f, 0});
  EXPECT_EQ(cache.sync(track.derived, {}).looked_at, 2);
}

TEST_F(Cache, a_very_long_track_is_held_in_full_near_the_eye_alone_wherever_the_eye_was_before) {
  constexpr int kMany = 24'000, kSteps = 64;
  Track track(test::ring_document(kMany, 2.0f * kMany), kSteps);
  const auto at = [&](std::size_t knot) {
    return world::knot(track.document, track.document.track.knots[knot]).position + glm::vec3(0, 3, 0);
  };
  constexpr float kOff = 1e-5f, kReach = 100;
  TrackCache cache(gl_);
  cache.look_from({at(0), kOff, kReach}, 0);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, kMany) << "each is written once";
  const std::int64_t bytes = cache.held_polyline_bytes();
  const GLsizei lines = cache.line_count();
  const std::int64_t solid_bytes = cache.swept().bytes();
  EXPECT_LT(solid_bytes, 2 * kMany * std::int64_t(sizeof(SweptPiece))) << "one piece for most";
  EXPECT_LE(bytes, kPolylineBudget * std::int64_t(sizeof(PolylineVertex)));
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0);
  cache.look_from({at(0) + glm::vec3(0.1f, 0, 0.1f), kOff, kReach}, 0);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0) << "a small move";
  track.move(1, {0, 0.01f, 0});
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 2);
  cache.look_from({at(kMany / 2), kOff, kReach}, 0);
  const TrackCache::UploadStats flown = cache.sync(track.derived, {});
  EXPECT_GT(flown.uploads, 2);
  EXPECT_LT(flown.uploads, kMany / 10);
  EXPECT_EQ(flown.looked_at, flown.uploads);
  track.move(1, {0, -0.01f, 0});
  cache.look_from({at(0), kOff, kReach}, 0);
  cache.sync(track.derived, {});
  EXPECT_EQ(cache.held_polyline_bytes(), bytes);
  EXPECT_LE(cache.line_count(), lines + lines / 8) << "room is used again";
  EXPECT_LE(cache.swept().bytes(), solid_bytes + solid_bytes / 8);
}

TEST_F(Cache, a_very_long_track_has_ties_and_equipment_near_the_eye_alone) {
  constexpr int kMany = 24'000;
  world::Document document = test::ring_document(kMany, 2.0f * kMany);
  for (const world::Entity segment : document.track.segments)
    document.entities.put(segment, world::Equipment{world::EquipmentKind::lift});
  Track track(std::move(document), 2);
  TrackCache cache(gl_);
  const auto look = [&](std::size_t knot) {
    const glm::vec3 eye = world::knot(track.document, track.document.track.knots[knot]).position + glm::vec3(0, 3, 0);
    cache.look_from({eye, 1e-5f, 50}, 200);
    return cache.sync(track.derived, {}).uploads;
  };
  EXPECT_EQ(look(0), kMany);
  const auto triangles = [&] {
    cache.mesh().look_from({0, 0, 0}, 1e9f);
    return cache.mesh().triangles();
  };
  const std::int64_t first = triangles(), bytes = cache.swept().bytes();
  EXPECT_GT(first, 0);
  EXPECT_EQ(look(0), 0);
  EXPECT_GT(look(kMany / 2), 30) << "those near the eye, and those that were";
  EXPECT_LT(look(kMany / 3), kMany / 20);
  EXPECT_LT(triangles(), 2 * first) << "with the room of those that were";
  track.move(kMany / 3, {0, 0.2f, 0});
  look(kMany / 3);
  look(0);
  EXPECT_EQ(triangles(), first);
  EXPECT_LE(cache.swept().bytes(), bytes + bytes / 8);
  TrackCache without(gl_);
  without.look_from({{0, 900, 0}, 1e-5f, 50}, 200);
  without.sync(track.derived, {});
  EXPECT_EQ(without.mesh().index_count(), 0) << "nobody is near";
}

TEST_F(Cache, another_evaluator_uploads_everything_once_and_another_stage_of_the_gpu_nothing) {
  Track track(test::ring_document(9, 17.3f));
  EXPECT_EQ(draw(track).uploads, 9);
  for (std::size_t row = curve::evaluators().size(); row-- > 0;) {
    const auto id = static_cast<curve::EvaluatorId>(row);
    const bool was_on_gpu = track.derived.evaluated_by != curve::EvaluatedBy::processor,
               is_on_gpu = base::row_of(id).evaluated_by != curve::EvaluatedBy::processor;
    const int expected = id == track.settings.evaluation->evaluator || (was_on_gpu && is_on_gpu) ? 0 : 9;
    track.settings.evaluation->evaluator = id;
    track.derive();
    EXPECT_EQ(draw(track).uploads, expected) << row;
    EXPECT_EQ(draw(track).uploads, 0) << row;
  }
}

TEST_F(Cache, the_resolution_sets_how_many_lines_there_are) {
  Track track(test::ring_document(9, 17.3f), 24);
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  EXPECT_EQ(cache.line_count(), 9 * 26 - 1);  // 25 vertices and a break each
  for (const int steps : {96, 3, 24}) {
    track.settings.evaluation->steps = steps;
    track.derive();
    EXPECT_EQ(cache.sync(track.derived, {}).uploads, 9);
  }
  EXPECT_LE(cache.line_count(), 9 * 98 - 1) << "room is used again";
}

TEST_F(Cache, equipment_uploads_its_own_segment_and_builds_no_shape_anew) {
  Track track(test::ring_document(9, 17.3f, 0.3));
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  EXPECT_EQ(cache.mesh().index_count(), 0u);
  const world::Entity segment = track.document.track.segments[4];
  track.document.entities.put(segment, world::Equipment{world::EquipmentKind::brake});
  track.derive();
  EXPECT_EQ(track.derived.rebuilds, 0);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 1);
  EXPECT_GT(cache.mesh().index_count(), 0u);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0);
  track.document.entities.put(segment,
                              world::Equipment{world::EquipmentKind::block});  // looks the same, yet may not have
  track.derive();
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 1);
  track.document.entities.pool<world::Equipment>().erase(segment);
  track.derive();
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 1);
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0);
}

TEST_F(Cache, platforms_over_changed_ground_are_written_again_and_nothing_else_is) {
  Track track(test::straight_document({-100, 8, 3}, {100, 8, 3}, 10), 4);
  track.document.entities.put(track.document.track.segments[7],
                              world::Equipment{.kind = world::EquipmentKind::station});
  test::shape_land(track.document, [](double, double) { return 0.0; });
  track.derive();
  sim::Ground ground;
  TrackCache cache(gl_);
  const auto uploads = [&](const sim::Ground* on) {
    ground.update(track.document, track.derived, sim::track_room(sim::form_of(track.document.kind)));
    return cache.sync(track.derived, {}, on).uploads;
  };
  EXPECT_EQ(uploads(&ground), 10);
  EXPECT_EQ(uploads(&ground), 0);
  const auto stroke = [&](std::int16_t x) {
    world::GroundTile tile;
    tile.heights.fill(32);
    const std::pair<world::TilePlace, world::GroundTile> tiles[] = {{{x, 0}, tile}};
    track.document.park.tiles.put(tiles);
  };
  stroke(-2);
  EXPECT_EQ(uploads(&ground), 0) << "far from it";
  stroke(0);
  EXPECT_EQ(uploads(&ground), 1) << "under it";
  EXPECT_EQ(uploads(&ground), 0);
  EXPECT_EQ(uploads(nullptr), 1) << "the plane again";
}

TEST_F(Cache, an_emptied_track_has_nothing_to_draw) {
  Track track(test::ring_document(9, 17.3f));
  TrackCache cache(gl_);
  cache.sync(track.derived, {});
  track.document = world::Document{};
  track.derive();
  EXPECT_EQ(cache.sync(track.derived, {}).uploads, 0);
  EXPECT_EQ(cache.line_count(), 0);
  EXPECT_EQ(cache.swept().bytes(), 0);
}

TEST_F(Cache, preparing_is_measured_by_the_clock_that_is_passed) {
  Track track(test::ring_document(9, 17.3f));
  TrackCache cache(gl_);
  double now = 0;
  const sim::Clock clock = [&] { return now += 0.25; };
  EXPECT_GT(cache.sync(track.derived, clock).cpu_seconds, 9 * 0.25 - 1e-9);
  EXPECT_EQ(cache.sync(track.derived, {}).cpu_seconds, 0);
}

}  // namespace track_cache_test
}  // namespace coaster::gfx
