// Level of detail along a flight over a very long track: segment_levels, swept_track, track_cache and near_track
// together. Every picture is compared with one in full detail, so nothing opens, vanishes or jumps on the way.
#include <cmath>

#include "gfx/passes.h"
#include "gfx/studio.h"
#include "sim/solids/supports.h"
#include "world/topology.h"

namespace coaster::gfx {
namespace flight_test {

using test::Track;

constexpr double kTurn = 6.283185307179586, kBetween = 150, kApart = 9;  // m between windings, and between knots
constexpr float kFull = 32;  // times the usual detail: more than anyone could see

// Returns a spiral outwards with hills of 8 m, and lifts on a fifth of it. apart: m between knots.
world::Document spiral(int segments, double apart = kApart) {
  world::Document document;
  double angle = kTurn;
  for (int i = 0; i <= segments; ++i) {
    const double radius = kBetween * angle / kTurn, wave = kTurn * i * apart / 120;
    const glm::dvec2 out(std::cos(angle), std::sin(angle)), along(-out.y, out.x);
    const glm::dvec2 way = kBetween / kTurn * out + radius * along, flat = way / glm::length(way);
    world::Knot knot;
    knot.position = glm::vec3(radius * out.x, 20 + 8 * std::sin(wave), radius * out.y);
    world::set_tangent(knot, glm::vec3(flat.x, 8 * kTurn / 120 * std::cos(wave), flat.y));
    knot.in_length = knot.out_length = static_cast<float>(apart / 3);
    world::append_knot(document, knot);
    angle += apart / glm::length(way);
  }
  for (std::size_t i = 0; i < document.track.segments.size(); ++i)
    if (i % 50 < 10) document.entities.put(document.track.segments[i], world::Equipment{world::EquipmentKind::lift});
  return document;
}

// How much two pictures differ, in levels of 255.
struct Difference {
  double mean = 0;
  int most = 0, pixels = 0;  // the largest of a pixel; pixels that differ by more than 48
};
Difference difference(const Image& a, const Image& b) {
  Difference found;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int channel = std::abs(int(a.rgba[i + k]) - int(b.rgba[i + k]));
      found.mean += channel, off = std::max(off, channel);
    }
    found.most = std::max(found.most, off), found.pixels += off > 48 ? 1 : 0;
  }
  found.mean /= 0.75 * static_cast<double>(a.rgba.size());
  return found;
}

class Flight : public test::Studio {
 protected:
  Flight() { width_ = 320, height_ = 180, samples_ = 4; }
  void SetUp() override {
    Studio::SetUp();
    full_ = fresh();
    supports_.update(track_.derived);
    ASSERT_GT(supports_.count(), 10'000);
  }
  void TearDown() override { full_.reset(), Studio::TearDown(); }

  Image picture(Renderer& renderer, const view::View& view, float detail) {
    const view::Overlay overlay;
    Scene scene{track_.derived, view, overlay, {}, false};
    scene.supports = &supports_, scene.detail = detail;
    scene.shadows = false;  // their map changes in steps
    triangles_ = renderer.draw(scene, width_, height_).triangles;
    return renderer.read_pixels();
  }
  // Compares the pictures of an eye that moves on from picture to picture.
  void fly(int pictures, const auto& eye_at) {
    for (int i = 0; i < pictures; ++i) {
      const view::View view = view::view_of(eye_at(i), {0, 0, float(width_), float(height_)});
      const Image usual = picture(*renderer_, view, 1);
      const std::int64_t usual_triangles = triangles_;
      const Difference off = difference(usual, picture(*full_, view, kFull));
      EXPECT_LT(4 * usual_triangles, 3 * triangles_) << i;
      // Ties and supports end where they cover a pixel by a fifth, outlines move by two thirds of a pixel. A hole, or a
      // piece that is visibly straight, changes whole pixels.
      EXPECT_LT(off.mean, 0.5) << i;
      EXPECT_LT(off.most, 128) << i;
      EXPECT_LT(off.pixels, width_ * height_ / 600) << i;
    }
  }

  Track track_{spiral(20'500), 2};
  sim::Supports supports_;
  std::unique_ptr<Renderer> full_;
  std::int64_t triangles_ = 0;
};

TEST_F(Flight, along_the_track_and_up_looks_as_in_full_detail) {
  const auto place = [&](std::size_t knot) {
    return glm::dvec3(world::knot(track_.document, track_.document.track.knots[knot]).position);
  };
  // The eye `height` m above a knot looks at another one `ahead` knots on.
  const auto eye_above = [&](std::size_t knot, double height, std::size_t ahead) {
    view::Eye eye;
    eye.position = place(knot) + glm::dvec3(0, height, 0);
    eye.forward = glm::normalize(place(knot + ahead) - eye.position);
    return eye;
  };
  fly(8, [&](int i) { return eye_above(9000 + 11 * static_cast<std::size_t>(i), 7, 20); });
  fly(6, [&](int i) { return eye_above(9000, 7 * std::pow(2, i), 20 + 10 * static_cast<std::size_t>(i)); });
}

// Polylines alone: pictures hardly show less than a pixel. Counted for a high picture, in which far segments fit.
TEST_F(Flight, far_polylines_have_fewer_lines_only_where_that_is_off_by_a_quarter_of_a_pixel) {
  Track track(spiral(24'000, 90), 64);
  track.settings.evaluation->evaluator = *base::value_named<curve::EvaluatorId>("gpu_vertex");
  track.derive();
  const glm::dvec3 eye_at =
      glm::dvec3(world::knot(track.document, track.document.track.knots[9000]).position) + glm::dvec3(0, 30, 0);
  view::Eye eye;
  eye.position = eye_at;
  const view::View view = view::view_of(eye, {0, 0, 1600, 900});
  const double pixels_at_1_m = 450 / std::tan(kTurn / 16);  // a field of view of 45 degrees
  const view::Overlay overlay;
  TrackCache cache(gl_);
  choose_levels({track.derived, view, overlay, {}}, cache);
  cache.sync(track.derived, {});
  int full = 0, coarse = 0;
  double worst = 0;  // px
  for (const CurveSlots& run : cache.control_runs())
    for (int slot = run.first; slot < run.first + run.count; ++slot) {
      const curve::Cubic& cubic = track.derived.shape(cache.placed()[static_cast<std::size_t>(slot)].segment).key.cubic;
      ++(run.steps == 64 ? full : coarse);
      for (int k = 0; k < run.steps && run.steps < 64; ++k) {
        const glm::dvec3 from = curve::point(cubic, double(k) / run.steps),
                         to = curve::point(cubic, (k + 1.0) / run.steps),
                         at = curve::point(cubic, (k + 0.5) / run.steps);
        worst = std::max(worst, glm::distance(at, 0.5 * (from + to)) / glm::distance(at, eye_at) * pixels_at_1_m);
      }
    }
  EXPECT_GT(full, 50);
  EXPECT_GT(coarse, 20'000);
  EXPECT_LT(worst, 0.25);
  EXPECT_GT(worst, 0.125) << "finer than anyone sees";
}

}  // namespace flight_test
}  // namespace coaster::gfx
