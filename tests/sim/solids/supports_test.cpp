#include "sim/solids/supports.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/kinds.h"
#include "sim/solids.h"
#include "sim/solids/track_mesh.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace supports_test {

using glm::dvec3;

const double kSpineDrop = -form_of(world::CoasterKind::steel).hold;

Supports supports_of(const DerivedTrack& derived) {
  Supports supports;
  supports.update(derived);
  return supports;
}

// A knot on a level helix about the vertical through (11, 0, -7): winds over itself, `rise` metres a turn.
world::Document helix_document(int turns, double radius, double rise, int knots = 8) {
  world::Document d;
  const double bottom = 4, step = 2 * M_PI / knots, handle = 4.0 / 3.0 * std::tan(step / 4) * radius;
  for (int i = 0; i <= turns * knots; ++i) {
    const double a = step * i + 0.21, h = bottom + rise * i / knots;
    const glm::vec3 tangent(-std::sin(a), rise / (2 * M_PI * radius), -std::cos(a));
    world::append_knot(d, test::skew_knot({11 + radius * std::cos(a), h, -7 - radius * std::sin(a)}, tangent,
                                          static_cast<float>(handle), static_cast<float>(handle)));
  }
  return d;
}

// A document of random hills, turns and rolls that crosses itself.
world::Document tangle(std::uint32_t seed, int knots) {
  std::mt19937 bits(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  world::Document d;
  double heading = 0.3;
  glm::dvec3 at(3.1, 8, -2.7);
  for (int i = 0; i < knots; ++i) {
    heading += uniform(-1.1, 1.3);
    const glm::dvec3 way(std::cos(heading), uniform(-0.3, 0.3), -std::sin(heading));
    at += uniform(8, 18) * way;
    at.y = std::clamp(at.y, 2.0, 30.0);
    const auto handle = static_cast<float>(uniform(3, 6));
    world::append_knot(d, test::skew_knot(glm::vec3(at), glm::vec3(way), handle, handle, world::JointKind::smooth));
    world::set_roll(d.entities.get<world::Knot>(d.track.knots.back()), uniform(-70, 70));
  }
  return d;
}

// Points of the track with their frames, closely spaced: the oracle's own way to it.
struct Sample {
  dvec3 place, up, left;
  double distance;  // along the track
};
std::vector<Sample> samples_of(const DerivedTrack& derived, double spacing) {
  std::vector<Sample> out;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape(derived.order[i]);
    const int steps = std::max(1, static_cast<int>(std::ceil(shape.arc.length() / spacing)));
    for (int k = 0; k <= steps; ++k) {
      const double s = shape.arc.length() * k / steps;
      const curve::Frame frame = frame_at(shape, s);
      out.push_back(
          {curve::point(shape.key.cubic, shape.arc.parameter(s)), frame.up, frame.left(), derived.starts[i] + s});
    }
  }
  return out;
}

// Returns the number of samples within the envelope of a bar, which is tested point by point.
int disturbed(const DerivedTrack& derived, const Supports& supports) {
  const CoasterForm& form = form_of(derived.made.kind);
  const std::vector<Sample> track = samples_of(derived, 0.25);
  int found = 0;
  for (const world::Entity e : derived.order) {
    const SegmentSupports& mine = *supports.of(e);
    for (const Bar& bar : mine.bars) {
      const double radius = static_cast<double>(std::min(bar.from_radius, bar.to_radius));
      // The bar's own support: the hold that is nearest to its upper end.
      double least = 1e9, held = 0;
      for (const Ring& hold : mine.holds) {
        const dvec3 spine = hold.position + form.hold * hold.frame.up;
        for (const glm::vec3 end : {bar.from, bar.to}) {
          const double apart = glm::distance(dvec3(end), spine);
          const double start = derived.starts[static_cast<std::size_t>(
              std::find(derived.order.begin(), derived.order.end(), e) - derived.order.begin())];
          if (apart < least)
            least = apart, held = start + static_cast<double>(hold.along) * derived.shape(e).arc.length();
        }
      }
      const dvec3 from(bar.from), to(bar.to);
      const int steps = std::max(1, static_cast<int>(glm::distance(from, to) / 0.25));
      for (int k = 0; k <= steps; ++k) {
        const dvec3 p = glm::mix(from, to, static_cast<double>(k) / steps);
        for (const Sample& s : track) {
          double apart = std::abs(s.distance - held);
          if (derived.closed) apart = std::min(apart, derived.length - apart);
          // A strut's own support may be any of the segment's: what is near one of them is left to its legs.
          if (apart < kHeldReach + 0.3) {
            found += glm::distance(p, s.place + form.riders.lift * s.up) < form.riders.radius + radius - 0.01;
            continue;
          }
          found += glm::distance(p, s.place + form.envelope.lift * s.up) < form.envelope.radius + radius - 0.01;
        }
      }
    }
  }
  return found;
}

TEST(supports, keep_out_of_the_room_of_trains_everywhere) {
  for (int seed = 1; seed <= test::tries(4); ++seed) {
    const DerivedTrack derived = test::derived_of(tangle(static_cast<std::uint32_t>(seed), 40));
    const Supports supports = supports_of(derived);
    EXPECT_GT(supports.count(), 15) << seed;
    EXPECT_EQ(disturbed(derived, supports), 0) << seed;
  }
  const DerivedTrack helix = test::derived_of(helix_document(4, 9.3, 4.1));
  const Supports supports = supports_of(helix);
  EXPECT_GT(supports.count(), 8);
  EXPECT_EQ(disturbed(helix, supports), 0);
}

class SupportsOfKind : public testing::TestWithParam<world::CoasterKind> {};
INSTANTIATE_TEST_SUITE_P(all, SupportsOfKind, testing::ValuesIn(test::kinds()), test::kind_name);

TEST_P(SupportsOfKind, hold_the_track_and_keep_out_of_the_room_of_its_trains) {
  for (int seed = 1; seed <= test::tries(2); ++seed) {
    world::Document d = tangle(static_cast<std::uint32_t>(seed), 30);
    d.kind = GetParam();
    const DerivedTrack derived = test::derived_of(d);
    const Supports supports = supports_of(derived);
    EXPECT_GT(supports.count(), 10) << seed;
    EXPECT_EQ(disturbed(derived, supports), 0) << seed;
    for (const world::Entity e : derived.order) {
      const SegmentSupports& mine = *supports.of(e);
      for (const Bar& bar : mine.bars)
        if (bar.grounded) EXPECT_LT(std::abs(bar.to.y), 1e-5f);
      // Nothing floats: each brace ends at legs of this segment's bents, or where the next segment begins.
      for (const Brace& brace : mine.braces) {
        const auto off = [&](glm::vec3 p) {
          double least = 1e9;
          for (const Bar& leg : mine.bars)
            least = std::min(least, distance_between(dvec3(leg.from), dvec3(leg.to), dvec3(p), dvec3(p)));
          return least;
        };
        const SegmentShape& shape = derived.shape(e);
        const Ring next = ring_at(shape, shape.arc.length());
        const bool onward = glm::distance(dvec3(brace.to), next.position) < 2 + next.position.y;
        EXPECT_LT(off(brace.from), 0.01);
        EXPECT_TRUE(off(brace.to) < 0.01 || onward);
      }
      Mesh mesh;
      build_support_mesh(mine, form_of(GetParam()), mesh);
      EXPECT_TRUE(test::finite(mesh));
    }
  }
}

TEST(supports, of_an_inverted_coaster_hold_the_spine_over_the_train_from_beside_it) {
  world::Document d = test::straight_document({1.7f, 9.3f, 2.1f}, {21.7f, 9.3f, 17.1f});
  d.kind = world::CoasterKind::inverted;
  const DerivedTrack derived = test::derived_of(d);
  const Supports supports = supports_of(derived);
  const SegmentSupports& found = *supports.of(derived.order[0]);
  ASSERT_GE(found.holds.size(), 2u);
  for (const Bar& bar : found.bars) {
    if (!bar.grounded) EXPECT_NEAR(bar.from.y, 9.3 + form_of(d.kind).hold, 1e-5);
    else EXPECT_GT(std::abs(0.6f * (bar.to.x - 1.7f) - 0.8f * (bar.to.z - 2.1f)), 1.9f) << "beside the riders' legs";
  }
}

TEST(supports, the_oracle_sees_a_column_that_stands_in_the_way) {
  // Two levels of a helix, one over the other: straight down from the upper one meets the lower.
  const DerivedTrack derived = test::derived_of(helix_document(2, 9.3, 5.0));
  const SegmentShape& upper = derived.shape(derived.order[11]);
  const Ring at = ring_at(upper, 0.5 * upper.arc.length());
  const dvec3 top = at.position - kSpineDrop * at.frame.up;
  const Bar column{glm::vec3(top), {top.x, 0, top.z}, 0.2f, 0.2f, true};
  SegmentClearance lanes[16];
  std::vector<const SegmentClearance*> all;
  for (std::size_t i = 0; i < 16; ++i) {
    const SegmentShape& shape = derived.shape(derived.order[i]);
    lanes[i] = {rings_of(shape), tight_box(shape.key.cubic)};
    all.push_back(&lanes[i]);
  }
  EXPECT_FALSE(is_clear(derived, all, column, {11, 0.5 * upper.arc.length()}));
  Bar aside = column;
  aside.from += 3.5f * glm::normalize(glm::vec3(top.x - 11, 0, top.z + 7)), aside.to = {aside.from.x, 0, aside.from.z};
  EXPECT_TRUE(is_clear(derived, all, aside, {11, 0.5 * upper.arc.length()}));
}

TEST(supports, distance_between_lines_is_the_least_of_all_pairs_of_points) {
  std::mt19937 bits(5);
  const auto point = [&] { return dvec3(bits() % 1000, bits() % 1000, bits() % 1000) / 100.0; };
  for (int i = 0; i < 60; ++i) {
    const dvec3 a = point(), b = i % 7 ? point() : a, c = point(), d = i % 5 ? point() : c + 0.7 * (b - a);
    double least = 1e9;
    for (int s = 0; s <= 200; ++s)
      for (int t = 0; t <= 200; ++t)
        least = std::min(least, glm::distance(glm::mix(a, b, s / 200.0), glm::mix(c, d, t / 200.0)));
    const double found = distance_between(a, b, c, d);
    EXPECT_LE(found, least + 1e-12);
    EXPECT_NEAR(found, least, 0.1);
  }
}

TEST(supports, stand_about_ten_metres_apart_under_a_free_straight) {
  for (const int segments : {1, 4, 10, 40}) {  // of 120 m, 30 m, 12 m, 3 m
    const DerivedTrack derived =
        test::derived_of(test::straight_document({1.7f, 9.3f, 2.1f}, {97.7f, 9.3f, 74.1f}, segments));
    const Supports supports = supports_of(derived);
    std::vector<double> feet;
    for (const world::Entity e : derived.order)
      for (const Bar& bar : supports.of(e)->bars) {
        EXPECT_TRUE(bar.grounded);
        EXPECT_EQ(bar.to.y, 0);
        EXPECT_NEAR(bar.from.x, bar.to.x, 1e-5);  // straight down
        feet.push_back(glm::distance(bar.to, glm::vec3(1.7f, 0, 2.1f)));
      }
    ASSERT_GE(feet.size(), 8u) << segments;
    for (std::size_t i = 0; i + 1 < feet.size(); ++i) EXPECT_NEAR(feet[i + 1] - feet[i], 10.5, 3.6) << segments;
  }
}

TEST(supports, are_closer_where_the_track_is_bent_and_where_it_is_high) {
  const auto per_metre = [](const world::Document& d) {
    const DerivedTrack derived = test::derived_of(d);
    int places = 0;
    const Supports supports = supports_of(derived);
    for (const world::Entity e : derived.order) places += supports.of(e)->places;
    return places / derived.length;
  };
  const double straight = per_metre(test::straight_document({1.7f, 9.3f, 2.1f}, {97.7f, 9.3f, 74.1f}));
  EXPECT_GT(per_metre(test::straight_document({1.7f, 59.3f, 2.1f}, {97.7f, 59.3f, 74.1f})), 1.15 * straight);
  EXPECT_GT(per_metre(helix_document(1, 14, 0.1, 4)), 1.15 * straight);
}

TEST(supports, high_track_stands_on_two_legs) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.7f, 39.3f, 2.1f}, {25.7f, 39.3f, 20.1f}));
  const Supports supports = supports_of(derived);
  const SegmentSupports& found = *supports.of(derived.order[0]);
  EXPECT_EQ(found.bars.size(), 3 * found.holds.size());
  int feet = 0;
  for (const Bar& bar : found.bars) feet += bar.grounded;
  EXPECT_EQ(feet, 2 * supports.count());
}

TEST(supports, track_on_its_head_is_held_from_beside_it) {
  world::Document d = test::straight_document({1.7f, 12.3f, 2.1f}, {25.7f, 12.3f, 20.1f});
  for (const world::Entity k : d.track.knots) world::set_roll(d.entities.get<world::Knot>(k), 180);
  const DerivedTrack derived = test::derived_of(d);
  ASSERT_LT(derived.shape(derived.order[0]).ups[16].y, -0.99);
  const Supports supports = supports_of(derived);
  const SegmentSupports& found = *supports.of(derived.order[0]);
  ASSERT_GE(supports.count(), 2);
  EXPECT_EQ(disturbed(derived, supports), 0);
  for (const Bar& bar : found.bars) {
    if (!bar.grounded) continue;
    const dvec3 foot = dvec3(bar.to) - dvec3(1.7, 0, 2.1);
    EXPECT_GT(std::abs(0.6 * foot.x - 0.8 * foot.z), 2.0);  // sideways
  }
}

TEST(supports, none_for_track_in_or_on_the_ground) {
  for (const float height : {-5.3f, 0.1f, 1.0f}) {
    const DerivedTrack derived =
        test::derived_of(test::straight_document({1.7f, height, 2.1f}, {97.7f, height, 74.1f}));
    EXPECT_EQ(supports_of(derived).count(), 0) << height;
  }
}

TEST(supports, follow_from_the_track_alone_however_it_came_to_be_so) {
  world::Document d = tangle(7, 30);
  DerivedTrack derived = test::derived_of(d);
  Supports kept;
  std::mt19937 bits(3);
  for (int step = 0; step < 12; ++step) {
    kept.update(derived);
    if (step == 5) world::remove_knot(d, d.track.knots[9]);
    if (step == 8) world::set_closed(d, true);
    const world::Entity k = d.track.knots[bits() % d.track.knots.size()];
    d.entities.get<world::Knot>(k).position +=
        glm::vec3(static_cast<int>(bits() % 9) - 4, static_cast<int>(bits() % 5) - 2, static_cast<int>(bits() % 9) - 4);
    world::settle_joints(d);
    derive(d, {}, {}, derived);
    kept.update(derived);
    const Supports fresh = supports_of(derived);
    EXPECT_EQ(kept.count(), fresh.count());
    for (const world::Entity e : derived.order) ASSERT_EQ(kept.of(e)->bars, fresh.of(e)->bars) << step;
  }
}

// Low track that comes below a high straight, in the way of its supports, and leaves again.
TEST(supports, make_room_for_track_far_below_and_take_it_back) {
  world::Document d = test::straight_document({-30, 34, 2}, {30, 34, 2});
  DerivedTrack derived = test::derived_of(d);
  Supports kept;
  kept.update(derived);
  const world::Entity high = derived.order[0];
  const std::vector<Bar> free = kept.of(high)->bars;
  const float feet = std::find_if(free.begin(), free.end(), [](const Bar& bar) { return bar.grounded; })->to.z;
  world::append_knot(d, test::skew_knot({130, 18, feet}, {0, -1, 0}, 12, 12));
  for (const float x : {80.f, -80.f}) world::append_knot(d, test::skew_knot({x, 4, feet}, {-1, 0, 0}, 12, 12));
  derive(d, {}, {}, derived);
  kept.update(derived);
  EXPECT_NE(kept.of(high)->bars, free);
  EXPECT_EQ(disturbed(derived, kept), 0);
  for (const std::size_t k : {3, 4}) d.entities.get<world::Knot>(d.track.knots[k]).position.z += 60;
  derive(d, {}, {}, derived);
  kept.update(derived);
  EXPECT_EQ(kept.of(high)->bars, free);
}

TEST(supports, a_still_track_costs_nothing_and_a_moved_knot_its_neighbourhood) {
  world::Document d = test::ring_document(200, 400, 0.0);
  DerivedTrack derived = test::derived_of(d);
  Supports supports;
  supports.update(derived);
  EXPECT_EQ(supports.rebuilds(), 200);
  supports.update(derived);
  EXPECT_EQ(supports.rebuilds(), 0);
  const std::uint64_t far = supports.of(derived.order[150])->build;
  d.entities.get<world::Knot>(d.track.knots[20]).position += glm::vec3(0.7f, 0.9f, -0.3f);
  world::settle_joints(d);
  derive(d, {}, {}, derived);
  ASSERT_EQ(derived.rebuilds, 2);
  supports.update(derived);
  EXPECT_GE(supports.rebuilds(), 2);
  EXPECT_LE(supports.rebuilds(), 6);
  EXPECT_EQ(supports.of(derived.order[150])->build, far);
  EXPECT_GE(supports.of(derived.order[20])->build, far);
}

TEST(supports, of_degenerate_and_random_tracks_are_finite) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const DerivedTrack derived = test::derived_of(test::random_document(seed));
    const Supports supports = supports_of(derived);
    Mesh mesh;
    for (const world::Entity e : derived.order) {
      build_support_mesh(*supports.of(e), form_of(world::CoasterKind::steel), mesh);
      EXPECT_TRUE(test::finite(mesh));
      EXPECT_EQ(test::wrong_normals(mesh), 0);
    }
  }
}

TEST(supports, are_closed_solids_with_a_footing_for_every_foot) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.7f, 29.3f, 2.1f}, {25.7f, 29.3f, 20.1f}));
  const Supports supports = supports_of(derived);
  Mesh mesh;
  build_support_mesh(*supports.of(derived.order[0]), form_of(world::CoasterKind::steel), mesh);
  EXPECT_EQ(test::open_edges(mesh), 0);
  EXPECT_EQ(test::open_edges(mesh, mesh.coarse), 0);
  EXPECT_GT(test::volume(mesh, Material::concrete), 0);
  for (const MeshVertex& v : mesh.vertices) ASSERT_GE(v.position.y, -1e-6f);
  // The sky is hidden from what stands on the ground, and not from what is two metres above it.
  for (const MeshVertex& v : mesh.vertices) {
    if (v.part == static_cast<float>(Material::tie)) continue;
    EXPECT_EQ(v.along > 0.9f, v.position.y < 0.16f) << v.position.y;
    EXPECT_EQ(v.along <= 0, v.position.y >= 1.6f) << v.position.y;
  }
}

}  // namespace supports_test
}  // namespace coaster::sim
