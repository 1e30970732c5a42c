// Tests the curves of channels (sim/plan/force_path.h).
#include "sim/plan/force_path.h"

#include <gtest/gtest.h>

namespace coaster::sim {
namespace force_curve_test {

using world::ForceChannel;

TEST(force_curve, follows_the_bezier_of_its_keys) {
  world::ForceProgram program;
  program.keys(ForceChannel::vertical) = {{5, 1, 0.4, 2, 3}, {15, 3, -0.2, 6, 0}, {30, 2, 0, 0, 0}};
  program.length = 30;
  const ForceCurve curve(program, ForceChannel::vertical);
  EXPECT_EQ(curve.at(0).value, 1);
  EXPECT_EQ(curve.at(40).value, 2);
  EXPECT_EQ(curve.bend_at(0), 0);
  EXPECT_EQ(curve.bend_at(40), 0);
  world::ForceProgram steep = program;
  steep.keys(ForceChannel::vertical).back().slope = 0.3;
  EXPECT_NEAR(ForceCurve(steep, ForceChannel::vertical).at(30).slope, 0.3, 1e-12) << "up to the end, not 0 there";
  const auto piece =
      world::curve_between(program.keys(ForceChannel::vertical)[1], program.keys(ForceChannel::vertical)[2]);
  for (double u = 0.05; u < 1; u += 0.1) {
    const auto mix = [&](auto a, auto b) { return a + u * (b - a); };
    const auto a = mix(piece[0], piece[1]), b = mix(piece[1], piece[2]), c = mix(piece[2], piece[3]);
    const glm::dvec2 place = mix(mix(a, b), mix(b, c));
    EXPECT_NEAR(curve.at(place.x).value, place.y, 1e-10);
    const double h = 1e-5;
    EXPECT_NEAR(curve.at(place.x).slope, (curve.at(place.x + h).value - curve.at(place.x - h).value) / (2 * h), 1e-6);
    EXPECT_NEAR(curve.bend_at(place.x), (curve.at(place.x + h).slope - curve.at(place.x - h).slope) / (2 * h), 1e-6);
  }
}

TEST(force_curve, keeps_its_shape_where_a_key_is_inserted) {
  world::ForceProgram program;
  program.keys(ForceChannel::vertical) = {{5, 1, 0.4, 2, 3}, {15, 3, -0.2, 6, 0}, {30, 2, 0.1, 0, 0}};
  program.length = 40;
  const ForceCurve before(program, ForceChannel::vertical);
  for (const double at : {2.0, 8.0, 17.0, 25.0, 36.0}) insert_on_curve(program, ForceChannel::vertical, at);
  insert_on_curve(program, ForceChannel::roll, 20);
  EXPECT_EQ(program.keys(ForceChannel::vertical).size(), 8u);
  EXPECT_EQ(program.keys(ForceChannel::roll), (std::vector<world::ForceKey>{{20, 0}}));
  EXPECT_FALSE(world::broken(program));
  const ForceCurve after(program, ForceChannel::vertical);
  for (double x = 0; x <= 40; x += 0.1) EXPECT_NEAR(after.at(x).value, before.at(x).value, 1e-9) << x;
}

}  // namespace force_curve_test
}  // namespace coaster::sim
