// Picking of the curve.
#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/ride/ride.h"
#include "sim/tracks.h"
#include "view/pick.h"

namespace coaster::view {
namespace pick_curve_test {

using glm::dvec2;
using glm::dvec3;

const Viewport kViewport{57, 31, 640, 480};

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }
  std::size_t below(std::size_t n) { return bits_() % n; }

 private:
  std::mt19937 bits_;
};

// A track of `count` knots anywhere in a box, which crosses itself on screen from everywhere; some handles are long
// enough for loops, some segments are crumpled to a point nearly.
world::Document knotted_document(Random& random, int count, bool closed) {
  world::Document d;
  const double size = 12 * std::cbrt(count);
  for (int i = 0; i < count; ++i) {
    const double x = random(-size, size), y = random(1, size), z = random(-size, size), dx = random(-1, 1),
                 dy = random(-0.6, 0.6), dz = random(-1, 1);
    const double handle = i % 7 == 3 ? random(15, 60) : i % 11 == 5 ? 0.01 : random(1, 9);
    world::append_knot(d, test::skew_knot(glm::vec3(x, y, z), glm::vec3(dx, dy, dz) + glm::vec3(0, 0, 0.01f),
                                          static_cast<float>(handle), static_cast<float>(handle * random(0.5, 2))));
  }
  if (closed) world::set_closed(d, true);
  return d;
}

// Near, far, on the track itself, with long and with wide lenses.
View random_view(Random& random, const world::Document& d, const sim::DerivedTrack& derived) {
  const world::Entity segment = derived.order[random.below(derived.order.size())];
  const glm::vec3 at(curve::point(world::cubic_of(d, segment), random(0, 1)));
  world::Camera camera{at, static_cast<float>(random(-180, 180)), static_cast<float>(random(-20, 85)),
                       static_cast<float>(std::pow(10.0, random(-1, 3.3)))};
  const std::array<float, 3> lenses{world::kMinFieldOfView, 45, world::kMaxFieldOfView};
  camera.field_of_view_deg = lenses[random.below(3)];
  if (random(0, 1) < 0.7) return orbit_view(camera, kViewport);
  const sim::SegmentShape& shape = derived.shape(segment);
  sim::Pose pose;
  pose.frame = sim::frame_at(shape, 0.4 * shape.arc.length());
  pose.position = curve::point(shape.key.cubic, shape.arc.parameter(0.4 * shape.arc.length()));
  return view_of(ride_eye(pose, camera.field_of_view_deg), kViewport);
}

glm::vec2 random_pixel(Random& random) { return {random(57, 697), random(31, 511)}; }

TEST(pick_curve, the_hierarchy_finds_what_looking_at_every_segment_finds) {
  Random random(71);
  int picks = 0, found_some = 0;
  for (int trial = 0; trial < test::tries(60); ++trial) {
    const bool closed = trial % 3 == 0;
    world::Document d = knotted_document(random, 2 + static_cast<int>(random.below(trial % 5 == 0 ? 400 : 60)), closed);
    sim::DerivedTrack derived = test::derived_of(d);
    for (int i = 0; i < 70; ++i, ++picks) {
      if (i % 10 == 9) {  // the tree is refitted
        const world::Entity e = d.track.knots[random.below(d.track.knots.size())];
        world::Knot knot = world::knot(d, e);
        knot.position += glm::vec3(random(-30, 30), random(-5, 20), random(-30, 30));
        d.entities.put(e, knot);
        sim::derive(d, {}, {}, derived);
      }
      const View view = random_view(random, d, derived);
      const glm::vec2 pixel = random_pixel(random);
      const float reach = std::array{1.0f, 8.0f, 200.0f, 1e6f}[random.below(4)];
      const auto found = pick_curve(derived, view, pixel, reach),
                 of_all = pick_curve_of_all(derived, view, pixel, reach);
      ASSERT_EQ(found.has_value(), of_all.has_value()) << trial << " " << i;
      if (!found) continue;
      ++found_some;
      ASSERT_EQ(found->entity, of_all->entity) << trial << " " << i;
      ASSERT_EQ(found->t, of_all->t) << trial << " " << i;
    }
  }
  EXPECT_EQ(picks, test::tries(60) * 70);
  EXPECT_GT(found_some, test::tries(1500));
}

// What follows does not share a line with the program: distances by samples and golden section.
struct ByHand {
  std::size_t segment;
  double t, distance, depth;
};

class Eye {
 public:
  Eye(const View& view, glm::vec2 pixel)
      : matrix_(glm::dmat4(view.projection) * glm::dmat4(view.view)), port_(view.viewport), pixel_(pixel) {}
  // Pixels from the pixel and depth; infinitely far when it cannot be seen.
  std::pair<double, double> operator()(dvec3 p) const {
    const glm::dvec4 clip = matrix_ * glm::dvec4(p, 1);
    if (!(clip.w > 1e-4) || std::abs(clip.z) > clip.w) return {INFINITY, clip.w};
    const dvec2 at(port_.x + (clip.x / clip.w + 1) / 2 * port_.width,
                   port_.y + (1 - clip.y / clip.w) / 2 * port_.height);
    return {glm::distance(at, pixel_), clip.w};
  }

 private:
  glm::dmat4 matrix_;
  Viewport port_;
  dvec2 pixel_;
};

// Every least distance along the whole track that 2,000 samples a segment show, refined.
std::vector<ByHand> places_by_hand(const world::Document& d, const Eye& eye) {
  constexpr int kSamples = 2000;
  std::vector<ByHand> samples, places;
  for (std::size_t s = 0; s < d.track.segments.size(); ++s) {
    const curve::Cubic cubic = world::cubic_of(d, d.track.segments[s]);
    for (int i = s == 0 && !d.track.closed ? 0 : 1; i <= kSamples; ++i) {
      const double t = i / double(kSamples);
      const auto [distance, depth] = eye(curve::point(cubic, t));
      samples.push_back({s, t, distance, depth});
    }
  }
  const std::size_t n = samples.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0 && !d.track.closed, last = i + 1 == n && !d.track.closed;
    if (std::isinf(samples[i].distance)) continue;
    if (!first && samples[(i + n - 1) % n].distance < samples[i].distance) continue;
    if (!last && samples[(i + 1) % n].distance < samples[i].distance) continue;
    const curve::Cubic cubic = world::cubic_of(d, d.track.segments[samples[i].segment]);
    double low = std::max(0.0, samples[i].t - 1.0 / kSamples), high = std::min(1.0, samples[i].t + 1.0 / kSamples);
    const auto at = [&](double t) { return eye(curve::point(cubic, t)).first; };
    for (int k = 0; k < 60; ++k) {
      const double a = low + 0.381966 * (high - low), b = low + 0.618034 * (high - low);
      const bool nearer = at(a) <= at(b);
      (nearer ? high : low) = nearer ? b : a;
    }
    ByHand best = samples[i];
    const double t = (low + high) / 2;
    if (at(t) < best.distance) best = {samples[i].segment, t, at(t), eye(curve::point(cubic, t)).second};
    places.push_back(best);
  }
  return places;
}

TEST(pick_curve, of_the_places_within_a_pixel_of_the_nearest_the_front_one_is_found_as_by_hand) {
  Random random(23);
  int found_some = 0, front_ones = 0;
  for (int trial = 0; trial < test::tries(400); ++trial) {
    const world::Document d = knotted_document(random, 9, trial % 2 == 0);
    const sim::DerivedTrack derived = test::derived_of(d);
    const View view = orbit_view({{random(-5, 5), random(5, 20), random(-5, 5)},
                                  static_cast<float>(random(-180, 180)),
                                  static_cast<float>(random(0, 80)),
                                  static_cast<float>(random(25, 120))},
                                 kViewport);
    // On the track, where another passes before or behind it more often.
    const std::size_t aimed = random.below(derived.order.size());
    const auto seen = project(view, glm::vec3(curve::point(derived.tree.cubics[aimed], random(0, 1))));
    if (!seen) continue;
    const glm::vec2 pixel = glm::vec2(*seen) + glm::vec2(random(-6, 6), random(-6, 6));
    const Eye eye(view, pixel);
    constexpr double kReach = 40;
    double least = INFINITY, front = INFINITY;
    const std::vector<ByHand> places = places_by_hand(d, eye);
    for (const ByHand& p : places) least = std::min(least, p.distance);
    const auto found = pick_curve(derived, view, pixel, kReach);
    if (std::abs(least - kReach) < 0.01) continue;
    ASSERT_EQ(found.has_value(), least < kReach) << trial;
    if (!found) continue;
    ++found_some;
    const ByHand* meant = nullptr;
    bool clear = true;
    for (const ByHand& p : places) {
      clear = clear && std::abs(p.distance - least - kOneBehindAnother) > 0.01;
      if (p.distance <= least + kOneBehindAnother && p.depth < front) front = p.depth, meant = &p;
    }
    for (const ByHand& p : places) clear = clear && (&p == meant || p.distance > least + 1 || p.depth > 1.002 * front);
    if (!clear) continue;
    front_ones += meant->distance > least + 0.02;
    const auto [distance, depth] = eye(curve::point(world::cubic_of(d, found->entity), found->t));
    EXPECT_NEAR(distance, meant->distance, 1e-3) << trial;
    EXPECT_NEAR(depth, meant->depth, 2e-3 * front) << trial;
    if (meant->t > 1e-3 && meant->t < 1 - 1e-3) {
      EXPECT_EQ(found->entity, d.track.segments[meant->segment]) << trial;
      EXPECT_NEAR(found->t, meant->t, 2e-5) << trial;  // golden section on a flat minimum knows no better
    }
  }
  EXPECT_GT(found_some, test::tries(250));
  EXPECT_GT(front_ones, test::tries(5) - 1);
}

// The same in orthographic views, where depth is the distance along the line of sight, before and behind the eye.
TEST(pick_curve, orthographic_views_find_the_front_one_as_by_hand) {
  Random random(29);
  int found_some = 0, front_ones = 0;
  for (int trial = 0; trial < test::tries(240); ++trial) {
    const world::Document d = knotted_document(random, 9, trial % 2 == 0);
    const sim::DerivedTrack derived = test::derived_of(d);
    world::Camera camera{{random(-5, 5), random(5, 20), random(-5, 5)}, 0, 0, static_cast<float>(random(5, 120))};
    camera.projection = static_cast<world::Projection>(1 + trial % 3);
    const View view = orbit_view(camera, kViewport);
    const std::size_t aimed = random.below(derived.order.size());
    const auto seen = project(view, glm::vec3(curve::point(derived.tree.cubics[aimed], random(0, 1))));
    ASSERT_TRUE(seen);
    const glm::vec2 pixel = glm::vec2(*seen) + glm::vec2(random(-6, 6), random(-6, 6));
    const dvec3 forward(line_of_sight(view));
    const auto depth_of = [&](const ByHand& p) {
      return glm::dot(forward, curve::point(world::cubic_of(d, d.track.segments[p.segment]), p.t));
    };
    constexpr double kReach = 40;
    double least = INFINITY, front = INFINITY;
    const std::vector<ByHand> places = places_by_hand(d, Eye(view, pixel));
    for (const ByHand& p : places) least = std::min(least, p.distance);
    const auto found = pick_curve(derived, view, pixel, kReach),
               of_all = pick_curve_of_all(derived, view, pixel, kReach);
    ASSERT_EQ(found.has_value(), of_all.has_value());
    if (std::abs(least - kReach) < 0.01) continue;
    ASSERT_EQ(found.has_value(), least < kReach) << trial;
    if (!found) continue;
    ++found_some;
    EXPECT_EQ(found->entity, of_all->entity);
    EXPECT_EQ(found->t, of_all->t);
    const ByHand* meant = nullptr;
    bool clear = true;
    for (const ByHand& p : places) {
      clear = clear && std::abs(p.distance - least - kOneBehindAnother) > 0.01;
      if (p.distance <= least + kOneBehindAnother && depth_of(p) < front) front = depth_of(p), meant = &p;
    }
    for (const ByHand& p : places)
      clear = clear && (&p == meant || p.distance > least + 1 || depth_of(p) > front + 0.002 * camera.distance);
    if (!clear) continue;
    front_ones += meant->distance > least + 0.02;
    if (meant->t > 1e-3 && meant->t < 1 - 1e-3) {
      EXPECT_EQ(found->entity, d.track.segments[meant->segment]) << trial;
      EXPECT_NEAR(found->t, meant->t, 2e-5) << trial;
    }
  }
  EXPECT_GT(found_some, test::tries(150));
  EXPECT_GT(front_ones, test::tries(3) - 1);
}

// t is as good as double has it: at a place aimed at exactly, from any distance with any lens.
TEST(pick_curve, the_parameter_is_good_to_a_millionth) {
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const world::Document d = knotted_document(random, 8, true);
    const sim::DerivedTrack derived = test::derived_of(d);
    const View view = random_view(random, d, derived);
    const auto found = pick_curve(derived, view, random_pixel(random), 1e6f);
    if (!found || found->t < 1e-5 || found->t > 1 - 1e-5) continue;
    // The distance grows both ways, to rounding.
    const curve::Cubic cubic = world::cubic_of(d, found->entity);
    const auto seen = project(view, glm::vec3(curve::point(cubic, found->t)));
    ASSERT_TRUE(seen);
    const auto again = pick_curve(derived, view, glm::vec2(*seen), 8);
    ASSERT_TRUE(again);
    if (again->entity != found->entity) continue;  // another passes before it
    const double metres = glm::distance(curve::point(cubic, again->t), curve::point(cubic, found->t));
    const double depth = Eye(view, *seen)(curve::point(cubic, found->t)).second;
    // Pixels are floats: 3e-5 px, and clip coordinates in float besides; far less than this share of the picture.
    EXPECT_LT(metres, 0.02 * depth + 1e-3) << trial;
  }
}

}  // namespace pick_curve_test
}  // namespace coaster::view
