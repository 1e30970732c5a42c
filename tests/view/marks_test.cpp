// The knots on screen: by the segment tree, and by checking each.
#include "view/marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/tracks.h"

namespace coaster::view {
namespace marks_test {

std::vector<std::size_t> orders_of(const MarksOnScreen& found) {
  std::vector<std::size_t> orders;
  for (const PlacedMark& mark : found.marks) orders.push_back(mark.order);
  std::sort(orders.begin(), orders.end());
  return orders;
}

TEST(marks, are_those_of_all_knots_that_a_look_at_each_shows) {
  std::mt19937 bits(11);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(bits() / 4294967296.0);
  };
  std::size_t shown = 0, looked_at = 0, all = 0;
  for (const int count : {1, 2, 5, 700}) {
    world::Document d = test::ring_document(count, 0.9 * count + 5);
    for (const bool closed : {false, count > 1}) {
      world::set_closed(d, closed);
      const sim::Derived derived = test::derived_of(d);
      for (int i = 0; i < 60; ++i) {
        world::Camera camera;
        camera.target = world::knot(d, d.track.knots[bits() % d.track.knots.size()]).position;
        camera.yaw_deg = uniform(-180, 180), camera.pitch_deg = uniform(-20, 80), camera.distance = uniform(2, 300);
        const View view = orbit_view(camera, {31, 17, uniform(50, 900), uniform(50, 700)});
        const MarksOnScreen by_tree = marks_on_screen(d, derived, {}, view), each = marks_on_screen(d, {}, {}, view);
        EXPECT_EQ(orders_of(by_tree), orders_of(each));
        EXPECT_EQ(each.looked_at, d.track.knots.size());
        shown += by_tree.marks.size(), looked_at += by_tree.looked_at, all += each.looked_at;
      }
    }
  }
  EXPECT_GT(shown, all / 20);
  EXPECT_LT(looked_at, shown + all / 10) << "few are looked at in vain";
}

TEST(marks, of_a_very_long_track_are_found_without_a_look_at_each) {
  const world::Document d = test::ring_document(20'000, 31'000);
  const sim::Derived derived = test::derived_of(d);
  world::Camera camera;
  camera.target = world::knot(d, d.track.knots[77]).position;
  camera.pitch_deg = 70, camera.distance = 60;
  const MarksOnScreen found = marks_on_screen(d, derived, {}, orbit_view(camera, {0, 0, 640, 360}));
  EXPECT_GT(found.marks.size(), 4u);
  EXPECT_LT(found.looked_at, 100u);
}

}  // namespace marks_test
}  // namespace coaster::view
