#include "sim/plan/force_end_sensitivities.h"

#include <gtest/gtest.h>

#include "sim/force_oracle.h"

namespace coaster::sim {
namespace force_end_sensitivities_test {

// Keys of what is added, at equal distances, with the slopes of parabolas.
void add(ForceTask& task, const std::vector<double>& values, std::size_t nodes) {
  world::ForceProgram& added = task.added.emplace();
  added.over = task.program.over, added.length = task.program.length;
  const double gap = added.length / static_cast<double>(nodes);
  for (std::size_t c = 0; c < 3; ++c) {
    auto& keys = added.channels[c];
    keys.resize(nodes + 1);
    for (std::size_t i = 1; i <= nodes; ++i)
      keys[i].at = i == nodes ? added.length : gap * static_cast<double>(i), keys[i].value = values[c * nodes + i - 1];
    for (std::size_t i = 1; i < nodes; ++i) keys[i].slope = (keys[i + 1].value - keys[i - 1].value) / (2 * gap);
  }
}

std::optional<EndMiss> miss(const ForceRates& rates, const ForceState& s) {
  const glm::dvec3 left = glm::cross(s.up, s.tangent);
  return EndMiss{s.position.x, s.position.y,      s.position.z,      s.tangent.y, s.up.z,
                 left.x,       rates.curvature.y, rates.curvature.x, rates.spin};
}

EndMiss end_of(const ForceTask& task) {
  const ForceLaw law(task);
  ForceState last = law.start();
  follow_law(law, 0.25, 0, last, [&](double, const ForceState& there) { return last = there, true; });
  return *miss(law.rates(task.length(), last), last);
}

void expect_slopes_of_differences(ForceTask task) {
  constexpr std::size_t kNodes = 8;
  constexpr double kBy = 1e-5;
  std::vector<double> values;
  const bool bends = task.program.of == world::ForceQuantity::curvature;
  for (std::size_t k = 0; k < 3 * kNodes; ++k) values.push_back((bends ? 0.003 : 0.1) * std::sin(3.0 * double(k)));
  add(task, values, kNodes);
  const auto slopes = end_slopes(ForceLaw(task), task.length(), kNodes, miss);
  ASSERT_TRUE(slopes);
  ASSERT_EQ(slopes->size(), 3 * kNodes);
  EndMiss most{};
  for (const EndMiss& slope : *slopes)
    for (std::size_t e = 0; e < most.size(); ++e) most[e] = std::max(most[e], std::abs(slope[e]));
  for (std::size_t k = 0; k < 3 * kNodes; ++k) {
    std::vector<double> more = values, less = values;
    more[k] += kBy, less[k] -= kBy;
    add(task, more, kNodes);
    const EndMiss above = end_of(task);
    add(task, less, kNodes);
    const EndMiss below = end_of(task);
    for (std::size_t e = 0; e < most.size(); ++e)
      EXPECT_NEAR((*slopes)[k][e], (above[e] - below[e]) / (2 * kBy), 1e-3 * most[e]) << k << ' ' << e;
  }
}

TEST(force_slopes, are_the_differences_of_integrations) {
  test::RandomForces random(5);
  int tried = 0;
  for (int i = 0; i < 12; ++i) {
    const ForceTask task = random.next(60);
    const auto points = force_path(task).curve.points;
    if (std::ranges::any_of(points, [](const ElementPoint& p) { return glm::length(p.curvature) > 1.0 / 8; })) continue;
    ++tried, expect_slopes_of_differences(task);
  }
  EXPECT_GE(tried, 6);
}

TEST(force_slopes, of_curvature_too) {
  test::RandomCurvature random(5);
  ForceTask task = random.next(60);
  expect_slopes_of_differences(task);
  task.program.over = world::ForceDomain::time, task.program.speed = 20, task.program.length = 3;
  for (auto& keys : task.program.channels) keys = {{0, 0}, {1.4, 0.01}, {3, 0}};
  task.program.channels[2][1].value = 30;
  expect_slopes_of_differences(task);
}

TEST(force_slopes, give_nothing_where_the_train_is_too_slow) {
  ForceTask task;
  task.program.speed = 5, task.program.length = 60;
  task.program.keys(world::ForceChannel::vertical) = {{0, 1}, {10, 2}};
  add(task, std::vector<double>(24, 0.0), 8);
  EXPECT_FALSE(end_slopes(ForceLaw(task), 60, 8, miss));
}

}  // namespace force_end_sensitivities_test
}  // namespace coaster::sim
