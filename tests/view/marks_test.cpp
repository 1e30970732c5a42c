// The knots on screen: by the segment tree, and by checking each.
#include "view/marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/tracks.h"

namespace coaster::view {
namespace marks_test {

constexpr std::size_t kEvery = 1'000'000;

std::vector<std::size_t> orders_of(const MarksOnScreen& found) {
  std::vector<std::size_t> orders;
  for (const PlacedMark& mark : found.marks) orders.push_back(mark.order);
  std::sort(orders.begin(), orders.end());
  return orders;
}

MarksOnScreen marks_of(const world::Document& d, const sim::DerivedTrack& derived, const View& view, std::size_t most) {
  const world::Settings settings;
  return marks_on_screen(d, derived, settings, view, SelectionLookup(settings), {true, true, {}, most});
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
      const sim::DerivedTrack derived = test::derived_of(d);
      for (int i = 0; i < 60; ++i) {
        world::Camera camera;
        camera.target = world::knot(d, d.track.knots[bits() % d.track.knots.size()]).position;
        camera.yaw_deg = uniform(-180, 180), camera.pitch_deg = uniform(-20, 80), camera.distance = uniform(2, 300);
        const View view = orbit_view(camera, {31, 17, uniform(50, 900), uniform(50, 700)});
        const MarksOnScreen by_tree = marks_of(d, derived, view, kEvery), each = marks_of(d, {}, view, kEvery);
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
  const sim::DerivedTrack derived = test::derived_of(d);
  world::Camera camera;
  camera.target = world::knot(d, d.track.knots[77]).position;
  camera.pitch_deg = 70, camera.distance = 60;
  const MarksOnScreen found = marks_of(d, derived, orbit_view(camera, {0, 0, 640, 360}), kEvery);
  EXPECT_GT(found.marks.size(), 4u);
  EXPECT_LT(found.looked_at, 100u);
}

// Knots with two at each place, on rings about the axis that the eye is on, so that many are equally far.
world::Document twin_knots(int count) {
  world::Document d;
  for (int i = 0; i < count; ++i) {
    world::Knot knot;
    const double angle = 6.283185307179586 * (i / 2) / 50, radius = 20 + 3 * (i / 100);
    knot.position = {radius * std::cos(angle), 4, radius * std::sin(angle)};
    world::append_knot(d, knot);
  }
  return d;
}

TEST(marks, of_too_many_are_the_nearest_and_of_equally_far_ones_the_first) {
  for (const bool closed : {false, true})
    for (const world::Projection projection :
         {world::Projection::perspective, world::Projection::front, world::Projection::top}) {
      world::Document d = twin_knots(1'500);
      world::set_closed(d, closed);
      const sim::DerivedTrack derived = test::derived_of(d);
      for (const float pitch : {89.0f, 35.0f, -10.0f}) {
        world::Camera camera;
        camera.pitch_deg = pitch, camera.distance = 160, camera.projection = projection;
        const View view = orbit_view(camera, {0, 0, 640, 360});
        // All that show, from near to far.
        std::vector<PlacedMark> wanted = marks_of(d, {}, view, kEvery).marks;
        ASSERT_GT(wanted.size(), 900u);
        std::sort(wanted.begin(), wanted.end(), [&](const PlacedMark& a, const PlacedMark& b) {
          const glm::dvec3 eye(view.eye), along(line_of_sight(view));
          const glm::dvec3 to_a = glm::dvec3(a.position) - eye, to_b = glm::dvec3(b.position) - eye;
          const double far_a = view.parallel > 0 ? glm::dot(to_a, along) : glm::dot(to_a, to_a);
          const double far_b = view.parallel > 0 ? glm::dot(to_b, along) : glm::dot(to_b, to_b);
          return far_a != far_b ? far_a < far_b : a.order < b.order;
        });
        for (const std::size_t most : {std::size_t{0}, std::size_t{1}, std::size_t{40}, std::size_t{333}, kEvery}) {
          std::vector<std::size_t> orders;
          for (std::size_t i = 0; i < std::min(most, wanted.size()); ++i) orders.push_back(wanted[i].order);
          std::sort(orders.begin(), orders.end());
          const MarksOnScreen by_tree = marks_of(d, derived, view, most);
          EXPECT_EQ(orders_of(by_tree), orders) << most << " of " << wanted.size();
          EXPECT_EQ(orders_of(marks_of(d, {}, view, most)), orders);
        }
      }
    }
}

TEST(marks, in_sight_of_a_whole_long_track_are_found_without_a_look_at_each) {
  const world::Document d = test::ring_document(20'000, 3'000);
  const sim::DerivedTrack derived = test::derived_of(d);
  world::Camera camera;
  camera.pitch_deg = 60, camera.distance = 9'000;
  const View view = orbit_view(camera, {0, 0, 640, 360});
  ASSERT_GT(marks_of(d, {}, view, kEvery).marks.size(), 5'000u);
  const MarksOnScreen found = marks_of(d, derived, view, 100);
  EXPECT_EQ(found.marks.size(), 100u);
  EXPECT_LT(found.looked_at, 300u);
}

TEST(marks, without_all_are_those_of_the_selection_and_the_hovered_knot) {
  const world::Document d = test::ring_document(60, 30);
  const sim::DerivedTrack derived = test::derived_of(d);
  world::Camera camera;
  camera.pitch_deg = 50, camera.distance = 200;
  const View view = orbit_view(camera, {0, 0, 640, 360});
  const std::vector<world::Entity>& knots = d.track.knots;
  const auto shown = [&](const world::Settings& settings, const Pick& hovered) {
    std::vector<std::size_t> orders;
    for (const PlacedMark& mark :
         marks_on_screen(d, derived, settings, view, SelectionLookup(settings), {false, false, hovered, kEvery}).marks)
      if (mark.kind == PickKind::knot) orders.push_back(mark.order);
    std::sort(orders.begin(), orders.end());
    return orders;
  };
  using Orders = std::vector<std::size_t>;
  world::Settings settings;
  EXPECT_EQ(shown(settings, {}), Orders{});
  EXPECT_EQ(shown(settings, {PickKind::knot, knots[7]}), (Orders{7}));
  settings.selected = knots[5];
  EXPECT_EQ(shown(settings, {}), (Orders{5}));
  EXPECT_EQ(shown(settings, {PickKind::knot, knots[5]}), (Orders{5})) << "once";
  settings.also = {knots[3], knots[40]};
  EXPECT_EQ(shown(settings, {PickKind::knot, knots[7]}), (Orders{3, 5, 7, 40}));
}

}  // namespace marks_test
}  // namespace coaster::view
