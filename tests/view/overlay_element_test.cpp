// The preview of an element in the view.
#include "view/overlay.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/random_elements.h"
#include "sim/solids/track_mesh.h"
#include "view/camera.h"
#include "world/element_rows.h"

namespace coaster::view {
namespace overlay_element_test {

View view_of_all() {
  world::Camera camera;
  camera.target = {0, 5, 0};
  camera.distance = 300;
  return orbit_view(camera, {0, 0, 640, 480});
}

Overlay drawn(const sim::ElementPlan& plan, std::span<const sim::LineConflict> narrow = {}, double rails = 0) {
  Overlay overlay;
  add_element(plan, narrow, rails, view_of_all(), 1, overlay);
  return overlay;
}

TEST(overlay_element, rails_lie_half_a_gauge_beside_the_ideal_curve_or_below_it_and_knots_are_marked) {
  test::RandomElements random(51);
  for (int i = 0; i < test::tries(40); ++i) {
    const world::Element element = random.any();
    const sim::ElementPlan plan = sim::plan_element(element, random.end());
    if (!plan.refusal.empty() || plan.length > 400) continue;
    // Rails below a fast roll wind about it, so the nearest point may be one of another place.
    const bool fast = std::any_of(plan.ideal.points.begin(), plan.ideal.points.end(),
                                  [](const sim::ElementPoint& p) { return std::abs(p.spin) > 0.3; });
    const double height = i % 2 == 0 || fast ? 0 : -1.3;
    const Overlay overlay = drawn(plan, {}, height);
    double apart = 0;  // m between neighbouring points
    for (std::size_t k = 1; k < plan.ideal.points.size(); ++k)
      apart = std::max(apart, glm::distance(plan.ideal.points[k - 1].position, plan.ideal.points[k].position));
    const double farthest = std::hypot(sim::kGauge / 2, apart / 2);
    std::size_t rails = 0;
    for (const Line& line : overlay.lines) {
      if (line.width_px != 2.0f) continue;
      double nearest = 1e9;
      for (const sim::ElementPoint& p : plan.ideal.points)
        nearest = std::min(nearest, glm::distance(glm::dvec3(line.to), p.position + height * p.up));
      EXPECT_LT(nearest, farthest + (height == 0 ? 0.02 : 0.1)) << "from points that are " << apart << " m apart";
      EXPECT_GT(nearest, sim::kGauge / 2 - 0.15) << "or of another turn nearby";
      ++rails;
    }
    EXPECT_GT(rails, plan.length);
    EXPECT_EQ(overlay.marks.size(), 2 * plan.spans());
    EXPECT_EQ(overlay.marks.back().position, plan.fit.knots.back().position);
  }
}

TEST(overlay_element, a_long_element_is_drawn_with_as_few_lines_as_a_short_one_may_have) {
  world::Element helix = world::usual_element(world::ElementKind::helix);
  helix.values[0] = 1000, helix.values[1] = 12;
  const sim::ElementPlan plan = sim::plan_element(helix, sim::TrackEnd{});
  ASSERT_GT(plan.length, 13'000);
  EXPECT_LT(drawn(plan).lines.size(), 9u * kMaxElementSteps);
}

TEST(overlay_element, what_lacks_room_is_yellow) {
  sim::TrackEnd end;
  end.position.y = 30;
  const sim::ElementPlan plan = sim::plan_element(world::usual_element(world::ElementKind::straight), end);
  const sim::LineConflict part{0.25 * plan.length, 0.5 * plan.length, 1};
  const Overlay overlay = drawn(plan, {&part, 1});
  int yellow = 0;
  for (const Line& line : overlay.lines) {
    if (line.width_px != 2.0f) continue;
    const double s = glm::distance(glm::dvec3(line.to), plan.ideal.points.front().position) / plan.length;
    const bool is_yellow = (line.rgba | 0xffu) == kNarrowColour;
    const bool at_an_end = std::abs(s - 0.25) < 0.02 || std::abs(s - 0.5) < 0.02;
    EXPECT_TRUE(at_an_end || is_yellow == (s > 0.25 && s < 0.5)) << s;
    yellow += is_yellow;
  }
  EXPECT_GT(yellow, 4);
}

TEST(overlay_element, what_is_in_the_ground_is_red_and_what_cannot_be_placed_is_not_drawn) {
  const auto red = [](const Overlay& overlay) {
    return std::count_if(overlay.lines.begin(), overlay.lines.end(),
                         [](const Line& line) { return (line.rgba | 0xffu) == kBuriedColour; });
  };
  sim::TrackEnd end;
  EXPECT_GT(red(drawn(sim::plan_element(world::usual_element(world::ElementKind::dive), end))), 20);
  end.position.y = 30;
  EXPECT_EQ(red(drawn(sim::plan_element(world::usual_element(world::ElementKind::dive), end))), 0);
  end.forward = {0, 1, 0}, end.up = {1, 0, 0};
  const Overlay none = drawn(sim::plan_element(world::usual_element(world::ElementKind::loop), end));
  EXPECT_TRUE(none.lines.empty() && none.marks.empty());
}

}  // namespace overlay_element_test
}  // namespace coaster::view
