#include "sim/solids/conflicts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "base/files.h"
#include "exchange/formats.h"
#include "sim/solids/clearance.h"
#include "sim/solids/coaster_form.h"
#include "sim/solids/conflict_types.h"
#include "sim/tracks.h"
#include "world/topology.h"

namespace coaster::sim {
namespace conflicts_test {

const CoasterForm& kSteel = form_of(world::CoasterKind::steel);
const double kTrainRadius = kSteel.train.radius, kTrainLift = kSteel.train.lift, kTrackRadius = kSteel.track.radius,
             kTrackDrop = -kSteel.track.lift;

using glm::dvec3;

std::vector<Conflict> conflicts_of(const DerivedTrack& derived) {
  Conflicts conflicts;
  return conflicts.update(derived);
}

void add_knot(world::Document& d, glm::vec3 at, glm::vec3 way, float handle = 10) {
  world::append_knot(d, test::skew_knot(at, way, handle, handle));
}

// A level straight along +X at 5 m, a wide turn, and another straight across it at (30, 5 + over, 0).
world::Document crossing(float over) {
  world::Document d;
  add_knot(d, {0, 5, 0}, {1, 0, 0}, 20);
  add_knot(d, {60, 5, 0}, {1, 0, 0}, 20);
  add_knot(d, {80, 5 + 0.5f * over, 25}, {0, 0, 1});
  add_knot(d, {55, 5 + over, 45}, {-1, 0, 0});
  add_knot(d, {30, 5 + over, 25}, {0, 0, -1});
  add_knot(d, {30, 5 + over, -25}, {0, 0, -1});
  return d;
}

// A level straight and, after a wide turn, one back next to it.
world::Document two_tracks(float apart) {
  world::Document d;
  add_knot(d, {0, 5, 0}, {1, 0, 0}, 20);
  add_knot(d, {60, 5, 0}, {1, 0, 0}, 20);
  add_knot(d, {90, 5, 30}, {0, 0, 1}, 15);
  add_knot(d, {75, 5, 30}, {-0.3f, 0, -1}, 12);
  add_knot(d, {58, 5, apart}, {-1, 0, 0}, 12);
  add_knot(d, {2, 5, apart}, {-1, 0, 0}, 18);
  return d;
}

// Knots anywhere in a box of 60 x 20 x 60 m, one wide bend after the other.
world::Document criss_cross(std::uint32_t seed, std::size_t knots) {
  std::mt19937 bits(seed);
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < knots; ++i) places.emplace_back(bits() % 61, 3 + bits() % 21, bits() % 61);
  world::Document d;
  for (std::size_t i = 0; i < knots; ++i)
    add_knot(d, places[i], places[(i + 1) % knots] - places[(i + knots - 1) % knots], 10);
  return d;
}

TEST(conflicts, track_over_track_needs_room_for_heads) {
  const double kEnough = kTrainRadius + kTrackRadius + kTrainLift + kTrackDrop;  // m from rails to rails
  for (const double over : {0.5, 1.5, 2.5, kEnough - 0.05}) {
    const DerivedTrack derived = test::derived_of(crossing(static_cast<float>(over)));
    const auto found = conflicts_of(derived);
    ASSERT_EQ(found.size(), 1u) << over;
    // Lines that cross at right angles: the lower one's train is kTrainLift over its rails, the upper one's spine
    // kTrackDrop under.
    EXPECT_NEAR(found[0].missing, kTrainRadius + kTrackRadius - std::abs(over - kTrainLift - kTrackDrop), 1e-5);
    EXPECT_NEAR(found[0].at, 30, kConflictStep);
    EXPECT_NEAR(found[0].other, derived.length - 25, kConflictStep);
    EXPECT_LT(glm::distance(dvec3(found[0].at_place), dvec3(30, 5, 0)), kConflictStep);
    EXPECT_LT(glm::distance(dvec3(found[0].other_place), dvec3(30, 5 + over, 0)), kConflictStep);
    EXPECT_LT(found[0].from, 30);
    EXPECT_GT(found[0].to, 30);
  }
  EXPECT_TRUE(conflicts_of(test::derived_of(crossing(static_cast<float>(kEnough + 0.05)))).empty());
}

TEST(conflicts, track_beside_track_needs_room_for_elbows) {
  const double enough = std::sqrt(std::pow(kTrainRadius + kTrackRadius, 2) - std::pow(kTrainLift + kTrackDrop, 2));
  const auto found = conflicts_of(test::derived_of(two_tracks(static_cast<float>(enough - 0.05))));
  ASSERT_EQ(found.size(), 1u) << "side by side for 56 m is one conflict";
  EXPECT_GT(found[0].to - found[0].from, 50);
  EXPECT_LT(found[0].missing, 0.06);
  EXPECT_TRUE(conflicts_of(test::derived_of(two_tracks(static_cast<float>(enough + 0.05)))).empty());
}

// Slices of every size, with edits between them, end with what one search finds.
TEST(conflicts, are_found_in_slices) {
  for (const std::size_t most : {std::size_t{1}, std::size_t{5}, std::size_t{1000}}) {
    world::Document d = criss_cross(8, 40);
    DerivedTrack derived = test::derived_of(d);
    Conflicts conflicts;
    std::mt19937 bits(3);
    const auto search = [&](int slices) {
      for (int i = 0; i < slices; ++i) {
        (void)conflicts.update(derived, most);
        EXPECT_LE(conflicts.looked_at(), static_cast<int>(most));
      }
    };
    const auto finish = [&] {
      int slices = 0;
      for (; !conflicts.is_complete(); ++slices) search(1);
      return slices;
    };
    search(1);
    EXPECT_EQ(conflicts.is_complete(), most > derived.order.size());
    const int slices = finish();
    EXPECT_EQ(slices + 1, static_cast<int>((derived.order.size() + most - 1) / most));
    EXPECT_EQ(conflicts.update(derived), conflicts_of(derived));
    for (int edit = 0; edit < 12; ++edit) {
      const std::size_t knot = bits() % d.track.knots.size();
      if (edit % 4 == 1) world::remove_knot(d, d.track.knots[knot]);
      else if (edit % 4 == 3) world::set_closed(d, !d.track.closed);
      else d.entities.get<world::Knot>(d.track.knots[knot]).position += glm::vec3(bits() % 9, bits() % 3, bits() % 9);
      derive(d, {}, {}, derived);
      search(1 + static_cast<int>(bits() % 7));
      if (edit % 3 != 2) continue;
      finish();
      EXPECT_EQ(conflicts.update(derived), conflicts_of(derived)) << "after edit " << edit << " by " << most;
      EXPECT_EQ(conflicts.looked_at(), 0);
    }
  }
}

TEST(conflicts, a_stretch_is_never_in_its_own_way) {
  EXPECT_TRUE(conflicts_of({}).empty());
  EXPECT_TRUE(conflicts_of(test::derived_of(test::straight_document({0, 5, 0}, {100, 5, 0}, 100))).empty());
  EXPECT_TRUE(conflicts_of(test::derived_of(test::ring_document(9, 23.1))).empty());
  EXPECT_TRUE(conflicts_of(test::derived_of(test::circle_document(4, {0, 1, 0}, {1, 0, 0}))).empty())
      << "nor over the closing joint";
}

// Points 0.5 m apart with their frames, the oracle's own way to the track.
struct Sample {
  dvec3 train, track;
  double distance;
};
double worst_of(const DerivedTrack& derived, double same_stretch) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape(derived.order[i]);
    for (double s = 0; s < shape.arc.length(); s += 0.5) {
      const dvec3 at = curve::point(shape.key.cubic, shape.arc.parameter(s)), up = frame_at(shape, s).up;
      samples.push_back({at + kTrainLift * up, at - kTrackDrop * up, derived.starts[i] + s});
    }
  }
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      const Sample &a = samples[i], &b = samples[k];
      const double away = std::abs(a.distance - b.distance);
      if ((derived.closed ? std::min(away, derived.length - away) : away) < same_stretch ||
          glm::distance(a.train, b.track) > nearest + 1)
        continue;
      nearest = std::min(nearest, distance_between(a.train, samples[i + 1].train, b.track, samples[k + 1].track));
    }
  return std::max(0.0, kTrainRadius + kTrackRadius - nearest);
}

TEST(conflicts, the_worst_is_that_of_a_search_through_all_places) {
  int some = 0;
  for (const std::uint32_t seed : {7u, 8u, 9u, 10u, 11u, 12u}) {
    world::Document d = criss_cross(seed, 14);
    world::set_closed(d, seed % 2 == 0);
    const DerivedTrack derived = test::derived_of(d);
    double worst = 0;
    for (const Conflict& conflict : conflicts_of(derived)) worst = std::max(worst, conflict.missing), ++some;
    // Chords of 2 m cut corners, and end in between places that are kSameStretch apart.
    EXPECT_GT(worst, worst_of(derived, kSameStretch + 2 * kConflictStep) - 0.15) << seed;
    EXPECT_LT(worst, worst_of(derived, kSameStretch) + 0.15) << seed;
  }
  EXPECT_GT(some, 10);
}

TEST(conflicts, follow_from_the_track_alone_however_it_came_to_be_so) {
  world::Document d = criss_cross(8, 40);
  DerivedTrack derived = test::derived_of(d);
  Conflicts kept;
  std::mt19937 bits(3);
  std::size_t most = 0;
  const world::Document first = d;
  for (int step = 0; step < 120; ++step) {
    const world::Entity k = d.track.knots[bits() % d.track.knots.size()];
    switch (bits() % 8) {
      case 0: world::remove_knot(d, k); break;
      case 1: world::set_closed(d, !d.track.closed); break;
      case 2: test::split_at(d, d.track.segments[bits() % d.track.segments.size()], 0.3); break;
      case 3: d.entities.get<world::Knot>(k).position.y += 300; break;  // the segments beside it grow long
      case 4:
        if (step % 3 == 0) d = first;
        break;
      default:
        d.entities.get<world::Knot>(k).position += glm::vec3(
            static_cast<int>(bits() % 9) - 4, static_cast<int>(bits() % 5) - 2, static_cast<int>(bits() % 9) - 4);
    }
    world::settle_joints(d);
    derive(d, {}, {}, derived);
    const std::vector<Conflict>& found = kept.update(derived);
    ASSERT_EQ(found, conflicts_of(derived)) << step;
    most = std::max(most, found.size());
  }
  EXPECT_GT(most, 5u);
}

TEST(conflicts, a_still_track_costs_nothing_and_a_moved_knot_its_neighbourhood) {
  world::Document d = test::ring_document(200, 400, 0.0);
  DerivedTrack derived = test::derived_of(d);
  Conflicts conflicts;
  (void)conflicts.update(derived);
  EXPECT_EQ(conflicts.looked_at(), 200);
  (void)conflicts.update(derived);
  EXPECT_EQ(conflicts.looked_at(), 0);
  d.entities.get<world::Knot>(d.track.knots[50]).position.y += 1;
  derive(d, {}, {}, derived);
  (void)conflicts.update(derived);
  EXPECT_EQ(conflicts.looked_at(), 4) << "the two that changed and one beside each";
}

TEST(conflicts, track_in_a_heap_is_looked_at_in_bounds) {
  world::Document d;
  std::mt19937 bits(5);
  for (int i = 0; i < 600; ++i)
    add_knot(d, glm::vec3(bits() % 40, bits() % 40, bits() % 40) * 0.1f,
             glm::vec3(1, static_cast<float>(bits() % 7) - 3, static_cast<float>(bits() % 7) - 3), 1);
  const auto found = conflicts_of(test::derived_of(d));
  EXPECT_GT(found.size(), 10u);
  for (const Conflict& conflict : found)
    EXPECT_TRUE(conflict.missing > 0 && conflict.missing <= kTrainRadius + kTrackRadius &&
                conflict.at < conflict.other);
}

TEST(conflicts, of_degenerate_and_random_tracks_are_within_the_track) {
  DerivedTrack derived;  // of one document after the other
  Conflicts kept;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    derive(test::random_document(seed), {}, {}, derived);
    const auto found = kept.update(derived);
    EXPECT_EQ(found, conflicts_of(derived)) << seed;
    for (const Conflict& c : found) {
      EXPECT_TRUE(0 <= c.from && c.from <= c.at && c.at <= c.to && c.to <= derived.length) << seed;
      EXPECT_TRUE(0 <= c.other_from && c.other_from <= c.other && c.other <= c.other_to && c.other_to <= derived.length)
          << seed;
      EXPECT_TRUE(c.missing > 0 && std::isfinite(glm::length(c.at_place)) && std::isfinite(glm::length(c.other_place)))
          << seed;
    }
  }
}

TEST(conflicts, what_comes_with_the_game_has_none) {
  base::Files files;
  int tracks = 0;
  for (const char* folder : {"tracks", "challenges/tracks"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".json") continue;
      const auto loaded = exchange::load_track(files, entry.path());
      ASSERT_TRUE(loaded.ok()) << entry.path() << loaded.status().message;
      for (const Conflict& conflict : conflicts_of(test::derived_of(loaded->document)))
        ADD_FAILURE() << entry.path().filename() << " at " << conflict.at << " m and " << conflict.other << " m lacks "
                      << conflict.missing << " m";
      ++tracks;
    }
  EXPECT_GE(tracks, 8);
}

}  // namespace conflicts_test
}  // namespace coaster::sim
