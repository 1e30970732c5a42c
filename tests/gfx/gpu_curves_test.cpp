// Polylines from control points alone: the same picture as from cached vertices, for every stage, without unnecessary
// uploads.
#include "gfx/gpu_curves.h"

#include <array>

#include "gfx/studio.h"
#include "world/evaluation_settings.h"

namespace coaster::gfx {
namespace gpu_curves_test {

using curve::EvaluatedBy;
using test::Track;

curve::EvaluatorId row_of(EvaluatedBy stage) {
  for (std::size_t i = 0; i < curve::evaluators().size(); ++i)
    if (curve::evaluators()[i].evaluated_by == stage) return static_cast<curve::EvaluatorId>(i);
  ADD_FAILURE() << "no row for a stage";
  return {};
}

class Stages : public test::Studio, public testing::WithParamInterface<EvaluatedBy> {
 protected:
  void SetUp() override {
    test::Studio::SetUp();
    if (const std::string why = renderer_->refusal(GetParam()); !why.empty()) GTEST_SKIP() << why;
  }
  void on(Track& track, EvaluatedBy stage) const {
    track.settings.evaluation->evaluator =
        stage == EvaluatedBy::processor ? *base::value_named<curve::EvaluatorId>("horner") : row_of(stage);
    track.derive();
  }
  Image seen(Track& track, EvaluatedBy stage, const world::Camera& camera) {
    on(track, stage);
    const view::Viewport viewport{0, 0, static_cast<float>(width_), static_cast<float>(height_)};
    const view::View view = view::orbit_view(camera, viewport);
    const view::Overlay overlay;
    const DrawStats stats = renderer_->draw(Scene{track.derived, view, overlay, {}}, width_, height_);
    EXPECT_EQ(stats.drawn_by, stage);
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return renderer_->read_pixels();
  }
  void compare_views(Track& track, const char* what) {
    const view::Viewport viewport{0, 0, static_cast<float>(width_), static_cast<float>(height_)};
    world::Camera all = view::frame_all({}, track.document, viewport), close = all, inside = all;
    close.distance *= 0.3f, close.yaw_deg += 77, close.pitch_deg = 61;
    inside.distance = 1.3f, inside.yaw_deg -= 41,
    inside.target = world::knot(track.document, track.document.track.knots[1]).position;
    for (const world::Camera& camera : {all, close, inside}) {
      const Image cached = seen(track, EvaluatedBy::processor, camera), shaded = seen(track, GetParam(), camera);
      long differing = 0;
      for (std::size_t i = 0; i < cached.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
          most = std::max(most, std::abs(int(cached.rgba[i + c]) - int(shaded.rgba[i + c])));
        differing += most > 16;
      }
      EXPECT_LE(differing, long(width_) * height_ / 2000)
          << what << ", " << track.settings.evaluation->steps << " steps, " << camera.distance << " m";
    }
  }
};
INSTANTIATE_TEST_SUITE_P(all, Stages,
                         testing::Values(EvaluatedBy::vertex_shader, EvaluatedBy::geometry_shader,
                                         EvaluatedBy::tessellation_shader));

TEST_P(Stages, draw_the_picture_of_the_cached_vertices) {
  width_ = 320, height_ = 180;
  for (const int steps : {1, 2, 7, 64, 65, 256}) {
    Track closed(test::ring_document(7, 17.3f), steps);
    compare_views(closed, "closed");
  }
  Track open(test::straight_document({1.3f, 5.1f, 2.7f}, {31.7f, 9.3f, -8.1f}, 3), 17);
  compare_views(open, "open");
  Track fine(test::ring_document(3, 7.1f), curve::kMaxSteps);
  compare_views(fine, "finest");
}

TEST_P(Stages, the_pictures_lines_are_there) {
  width_ = 320, height_ = 180;
  Track track(test::ring_document(7, 17.3f), 4);
  on(track, GetParam());
  const Image with = picture(track);
  show_polyline_ = false;
  const Image without = picture(track);
  long differing = 0;
  for (std::size_t i = 0; i < with.rgba.size(); ++i)
    differing += std::abs(int(with.rgba[i]) - int(without.rgba[i])) > 16;
  EXPECT_GT(differing, 1000) << "the comparison with cached vertices would prove nothing";
}

TEST_P(Stages, upload_48_bytes_a_segment_once_and_nothing_for_another_resolution) {
  Track track(test::ring_document(9, 17.3f), 64);
  const DrawStats cached = draw(track);
  EXPECT_EQ(cached.polyline_bytes, 9 * 24 * 66);
  EXPECT_EQ(cached.polyline_upload_bytes, 9 * 24 * 66);
  on(track, GetParam());
  EXPECT_EQ(track.derived.rebuilds, 0);
  const DrawStats first = draw(track);
  EXPECT_EQ(first.uploads, 9);
  EXPECT_EQ(first.upload_bytes, 9 * 48);
  EXPECT_EQ(first.polyline_bytes, 9 * 48);
  for (const int steps : {1, 4096, 63}) {
    track.settings.evaluation->steps = steps;
    track.derive();
    EXPECT_EQ(track.derived.rebuilds, 0);
    EXPECT_EQ(track.derived.vertices, 9 * (steps + 1));
    const DrawStats stats = draw(track);
    EXPECT_EQ(stats.uploads, 0) << steps;
    EXPECT_EQ(stats.upload_bytes, 0) << steps;
  }
  track.move(4, {0.37f, 0.21f, -0.13f});
  EXPECT_EQ(track.derived.rebuilds, 2);
  const DrawStats moved = draw(track);
  EXPECT_EQ(moved.uploads, 2);
  EXPECT_EQ(moved.polyline_upload_bytes, 2 * 48);
  EXPECT_GT(moved.upload_bytes, moved.polyline_upload_bytes) << "the rails are swept anew";
  EXPECT_EQ(draw(track).uploads, 0);
  on(track, row_of(EvaluatedBy::vertex_shader) == track.settings.evaluation->evaluator ? EvaluatedBy::geometry_shader
                                                                                       : EvaluatedBy::vertex_shader);
  EXPECT_EQ(draw(track).uploads, 0) << "another stage needs the same control points";
  on(track, EvaluatedBy::processor);
  EXPECT_EQ(draw(track).uploads, 9);
  on(track, GetParam());
  EXPECT_EQ(draw(track).upload_bytes, 9 * 48);
}

TEST_P(Stages, use_slots_again_and_draw_nothing_in_empty_ones) {
  Track track(test::ring_document(9, 17.3f), 12);
  on(track, GetParam());
  draw(track);
  for (int round = 0; round < 4; ++round) {
    world::remove_knot(track.document, track.document.track.knots[static_cast<std::size_t>(2 + round % 3)]);
    track.derive();
    EXPECT_EQ(draw(track).polyline_bytes, 8 * 48);
    EXPECT_TRUE(picture(track).rgba == picture(*renderer_->sibling(samples_), track).rgba)
        << "removed in round " << round;
    const world::Entity segment = track.document.track.segments[static_cast<std::size_t>(5 - round % 4)];
    test::split_at(track.document, segment, 0.37);
    track.derive();
    const DrawStats stats = draw(track);
    EXPECT_EQ(stats.polyline_bytes, 9 * 48);
    EXPECT_LE(stats.uploads, 3);
    EXPECT_TRUE(picture(track).rgba == picture(*renderer_->sibling(samples_), track).rgba)
        << "split in round " << round;
  }
  EXPECT_TRUE(picture(track).rgba == picture(*fresh(), track).rgba) << "uniforms are left from an earlier picture";
}

TEST_P(Stages, measure_the_deviation_of_what_the_gpu_computes) {
  for (const int steps : {1, 7, 64, 333}) {
    Track track(test::ring_document(9, 170.3f), steps);
    track.move(2, {1000.1f, 3.3f, -777.7f});
    on(track, GetParam());
    const DrawStats stats = draw(track);
    EXPECT_EQ(stats.deviation_pending, 0);
    const curve::Evaluator& row = base::row_of(track.settings.evaluation->evaluator);
    // Contracted or not, each operation rounds by at most half a unit in the last place of the twin's operands;
    // division and the reciprocal of the resolution are allowed 2.5.
    EXPECT_LE(stats.deviation, 3 * row.error_bound(2000, 4000, steps));
    EXPECT_EQ(draw(track).deviation, stats.deviation) << "a still frame keeps it";
    Track twin(test::ring_document(9, 170.3f), steps);
    twin.move(2, {1000.1f, 3.3f, -777.7f});
    on(twin, EvaluatedBy::processor);
    if (steps > 1) {
      EXPECT_GT(stats.deviation, 0) << "float rounds; nothing measured would be 0";
      EXPECT_LT(stats.deviation, 4 * twin.derived.deviation);
    } else {
      EXPECT_EQ(stats.deviation, 0) << "both ends are the control points";
    }
  }
}

TEST_P(Stages, measure_no_more_than_the_budget_in_a_frame) {
  constexpr int kSteps = 20;
  const int segments = GetParam() == EvaluatedBy::vertex_shader ? 5000 : 1900;
  Track track(test::ring_document(segments, 9000), kSteps);
  on(track, GetParam());
  DrawStats stats = draw(track);
  EXPECT_EQ(stats.uploads, segments);
  EXPECT_EQ(stats.polyline_bytes, segments * 48);
  int frames = 1;
  for (int left = stats.deviation_pending; left > 0; left = stats.deviation_pending, ++frames) {
    EXPECT_GT(left, segments - frames * 32'768 / kSteps);
    stats = draw(track);
    EXPECT_EQ(stats.uploads, 0);
    ASSERT_LT(stats.deviation_pending, left);
  }
  EXPECT_EQ(frames, segments / 1560 + 1);  // as many segments a frame
  track.move(segments / 2, {0.3f, 0.7f, -0.2f});
  stats = draw(track);
  EXPECT_EQ(stats.uploads, 2);
  EXPECT_EQ(stats.deviation_pending, 0);
}

TEST_P(Stages, an_empty_track_draws_and_measures_nothing) {
  Track track(test::ring_document(9, 17.3f));
  on(track, GetParam());
  draw(track);
  track.document = world::Document{};
  track.derive();
  const DrawStats stats = draw(track);
  EXPECT_EQ(stats.polyline_bytes, 0);
  EXPECT_EQ(stats.deviation, 0);
  EXPECT_EQ(stats.deviation_pending, 0);
  EXPECT_TRUE(picture(track).rgba == picture(*fresh(), track).rgba);
}

using Driver = test::Studio;

TEST_F(Driver, without_tessellation_the_vertex_shader_draws_and_the_reason_is_told) {
  gl_.PatchParameteri = nullptr;
  renderer_ = fresh();
  EXPECT_EQ(renderer_->refusal(EvaluatedBy::vertex_shader), "");
  EXPECT_EQ(renderer_->refusal(EvaluatedBy::geometry_shader).empty(), !gl_.es);
  EXPECT_NE(renderer_->refusal(EvaluatedBy::tessellation_shader).find("need OpenGL 4.0"), std::string::npos);
  Track track(test::ring_document(9, 17.3f));
  track.settings.evaluation->evaluator = row_of(EvaluatedBy::vertex_shader);
  track.derive();
  const Image by_vertices = picture(track);
  track.settings.evaluation->evaluator = row_of(EvaluatedBy::tessellation_shader);
  track.derive();
  EXPECT_EQ(draw(track).drawn_by, EvaluatedBy::vertex_shader);
  EXPECT_TRUE(picture(track).rgba == by_vertices.rgba);
}

TEST_F(Driver, without_read_back_or_timers_nothing_is_measured) {
  gl_.MapBufferRange = [](GLenum, GLintptr, GLsizeiptr, GLbitfield) -> void* { return nullptr; };
  gl_.GetQueryObjectui64v = nullptr;
  renderer_ = fresh();
  Track track(test::ring_document(9, 17.3f));
  track.settings.evaluation->evaluator = row_of(EvaluatedBy::vertex_shader);
  track.derive();
  const DrawStats stats = draw(track);
  EXPECT_EQ(stats.deviation_pending, 9);
  EXPECT_EQ(stats.gpu_ms, 0);
}

TEST_F(Driver, records_that_were_not_written_are_not_measured) {
  gl_.BeginTransformFeedback = [](GLenum) {};  // so nothing is captured
  gl_.EndTransformFeedback = [] {};
  renderer_ = fresh();
  Track track(test::ring_document(9, 17.3f));
  track.settings.evaluation->evaluator = row_of(EvaluatedBy::vertex_shader);
  track.derive();
  EXPECT_EQ(draw(track).deviation_pending, 9);
}

TEST_F(Driver, opengl_es_refuses_the_stages_that_it_lacks) {
  gl_.es = true, gl_.major = 3, gl_.minor = 0;
  const GpuCurves curves(gl_);
  EXPECT_EQ(curves.refusal(EvaluatedBy::vertex_shader), "");
  EXPECT_EQ(curves.refusal(EvaluatedBy::geometry_shader),
            "geometry shaders need OpenGL 3.3, the driver has OpenGL ES 3.0");
  EXPECT_EQ(curves.refusal(EvaluatedBy::tessellation_shader),
            "tessellation shaders need OpenGL 4.0, the driver has OpenGL ES 3.0");
}

TEST_F(Driver, times_the_polyline_some_frames_later) {
  if (!gl_.has_timers()) GTEST_SKIP() << "needs OpenGL";
  Track track(test::ring_document(9, 17.3f));
  DrawStats stats = draw(track);
  for (int frame = 0; frame < 100 && stats.gpu_ms == 0; ++frame) stats = draw(track);
  EXPECT_GT(stats.gpu_ms, 0);
}

}  // namespace gpu_curves_test
}  // namespace coaster::gfx
