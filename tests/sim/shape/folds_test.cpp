// Folds of rails on circles of known radius, and on other curves by stepping along the rails.
#include "sim/shape/folds.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/shape/rails.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace folds_test {

using glm::dvec3;

// A straight, a half circle upright over a crest (or, mirrored, through a valley), and a straight back; `up` is level
// with the outside of the circle, so that it is a crest for the rider. Returns the circle's segments as 4 of 6.
world::Document crest(double radius, bool valley) {
  world::Document d;
  const double step = M_PI / 4;
  const auto handle = static_cast<float>(4.0 / 3.0 * std::tan(step / 4) * radius);
  const auto add = [&](double x, double y, dvec3 along, dvec3 up) {
    world::Knot k = test::skew_knot(glm::vec3(7.3 + x, 20.1 + y, -3.7), glm::vec3(along), handle, handle);
    k.up = glm::vec3(valley ? -up : up);
    world::orthonormalise(k);
    world::append_knot(d, k);
  };
  add(-radius, -5, {0, 1, 0}, {-1, 0, 0});
  for (int i = 0; i <= 4; ++i) {
    const double a = M_PI - step * i;
    const dvec3 out(std::cos(a), std::sin(a), 0), along(std::sin(a), -std::cos(a), 0);
    add(radius * out.x, radius * out.y, along, out);
  }
  add(radius, -5, {0, -1, 0}, {1, 0, 0});
  d.curve = world::TrackCurve::heartline;
  d.heartline = 1.1;
  return d;
}

TEST(folds, are_where_the_radius_is_below_the_height) {
  for (const double radius : {0.3, 0.9, 1.09}) {
    const DerivedTrack derived = test::derived_of(crest(radius, false));
    const std::vector<Fold> found = folds_of(derived, -1.1);
    ASSERT_EQ(found.size(), 1u) << radius;
    EXPECT_NEAR(found[0].from, 5, 0.1 * radius) << radius;
    EXPECT_NEAR(found[0].to - found[0].from, M_PI * radius, 0.2 * radius) << radius;
    EXPECT_NEAR(found[0].radius, radius, 0.03 * radius) << radius;
    EXPECT_GE(found[0].at, found[0].from);
    EXPECT_LE(found[0].at, found[0].to);
    const TrackPlace place = place_at(derived, found[0].at);
    EXPECT_LT(glm::distance(dvec3(found[0].place), rails_at(derived.shape_at(place.index), place.s)), 1e-5);
  }
  for (const double radius : {1.15, 3.0}) EXPECT_TRUE(folds_of(test::derived_of(crest(radius, false)), -1.1).empty());
}

TEST(folds, are_not_where_the_curve_bends_away) {
  const DerivedTrack valley = test::derived_of(crest(0.9, true));
  EXPECT_TRUE(folds_of(valley, -1.1).empty());
  EXPECT_EQ(folds_of(valley, 1.1).size(), 1u);  // of a line above it
  EXPECT_TRUE(folds_of(valley, 0).empty());
}

// Between the folds the rails advance along the curve, within them they do not.
TEST(folds, hold_every_step_backwards) {
  int folded = 0, backward = 0;
  for (int seed = 1; seed <= test::tries(40); ++seed) {
    world::Document d = test::random_document(static_cast<std::uint32_t>(seed));
    d.curve = world::TrackCurve::heartline, d.heartline = 4.7;
    const DerivedTrack derived = test::derived_of(d);
    const std::vector<Fold> found = folds_of(derived, -4.7);
    folded += static_cast<int>(found.size());
    for (std::size_t i = 0; i < derived.order.size(); ++i) {
      const SegmentShape& shape = derived.shape_at(i);
      const double length = shape.arc.length();
      for (int k = 0; k < 2000; ++k) {
        const double s = length * (k + 0.5) / 2000, step = 1e-4 * length;
        const curve::Frame frame = frame_at(shape, s);
        const double ahead =
            glm::dot(rails_at(shape, s + step) - rails_at(shape, s - step), frame.forward) / (2 * step);
        const double along = derived.starts[i] + s, slack = 2 * length / 2000;
        const auto in = [&](double by) {
          return std::any_of(found.begin(), found.end(),
                             [&](const Fold& fold) { return fold.from - by <= along && along <= fold.to + by; });
        };
        backward += ahead < 0;
        if (std::abs(ahead) > 0.02) {
          EXPECT_EQ(in(ahead < 0 ? slack : -slack), ahead < 0) << seed << " at " << along << " m";
        }
      }
    }
  }
  EXPECT_GT(folded, test::tries(10));
  EXPECT_GT(backward, test::tries(100));
}

TEST(folds, are_found_again_only_after_changes) {
  world::Document d = crest(0.9, false);
  DerivedTrack derived = test::derived_of(d);
  Folds folds;
  ASSERT_EQ(folds.update(derived).size(), 1u);
  const double from = folds.update(derived)[0].from;
  d.heartline = 0.8;
  derive(d, {}, {}, derived);
  EXPECT_TRUE(folds.update(derived).empty());
  d.heartline = 1.1;
  d.curve = world::TrackCurve::rails;
  derive(d, {}, {}, derived);
  EXPECT_TRUE(folds.update(derived).empty());
  d.curve = world::TrackCurve::heartline;
  derive(d, {}, {}, derived);
  ASSERT_EQ(folds.update(derived).size(), 1u);
  EXPECT_EQ(folds.update(derived)[0].from, from);
  EXPECT_EQ(fold_text(folds.update(derived)[0], -1.1).substr(0, 3), "at ");
}

}  // namespace folds_test
}  // namespace coaster::sim
