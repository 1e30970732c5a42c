#include "sim/study/force_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace coaster::sim {
namespace force_limits_test {

// A ride of one car at 10 m/s whose riders feel up(t).
template <class Up>
SimulatedRide ride_of(double seconds, Up up) {
  SimulatedRide simulated;
  simulated.track_length = 1e4;
  const auto ticks = static_cast<std::size_t>(seconds * world::kTicksPerSecond);
  for (std::size_t i = 0; i <= ticks; ++i) {
    simulated.samples.push_back({10.0 * static_cast<double>(i) * world::kTick, 10, 0, 0});
    if (i % kForceEvery == 0)
      simulated.forces.push_back({0, 0, static_cast<float>(up(static_cast<double>(i) * world::kTick))});
  }
  return simulated;
}

TEST(envelope, limits_are_linear_between_their_points_and_constant_beyond) {
  const EnvelopeCurve& down = default_envelope().curves[0];
  EXPECT_EQ(limit(down, 0.01), 6);
  EXPECT_NEAR(limit(down, 1.5), 5, 1e-12);
  EXPECT_NEAR(limit(down, 11.9), 2.5, 1e-9);
  EXPECT_EQ(limit(down, 100), 2);
}

TEST(envelope, the_low_pass_has_half_power_at_its_cutoff_and_four_poles) {
  const double rate = 60, cutoff = 5;
  for (const auto& [hertz, gain] : {std::pair{0.5, 1.0}, {5.0, std::sqrt(0.5)}}) {
    std::vector<float> values;
    for (int i = 0; i < 1200; ++i) values.push_back(static_cast<float>(std::sin(2 * M_PI * hertz * i / rate)));
    low_pass(values, rate, cutoff);
    EXPECT_NEAR(*std::max_element(values.begin() + 600, values.end()), gain, 0.01) << hertz;
  }
  // An octave above it falls by about 24 dB and more near half the rate.
  std::vector<float> values;
  for (int i = 0; i < 1200; ++i) values.push_back(static_cast<float>(std::sin(2 * M_PI * 10.0 * i / rate)));
  low_pass(values, rate, cutoff);
  EXPECT_LT(*std::max_element(values.begin() + 600, values.end()), 0.07);
  std::vector<float> still(100, 3.7f);
  low_pass(still, rate, cutoff);
  EXPECT_NEAR(still.back(), 3.7f, 1e-5f);
}

TEST(envelope, a_plateau_is_red_when_it_lasts_longer_than_it_may) {
  // 4.5 g may last 1.75 s.
  const auto plateau = [](double seconds) {
    return ride_of(10, [=](double t) { return t > 3 && t < 3 + seconds ? 4.5 : 1.0; });
  };
  EXPECT_TRUE(red_spans(plateau(1.5), default_envelope()).empty());
  const auto red = red_spans(plateau(2.4), default_envelope());
  ASSERT_EQ(red.size(), 1u);
  EXPECT_EQ(red[0].axis, ForceAxis::down);
  EXPECT_NEAR(red[0].from, 3, 0.3);
  EXPECT_NEAR(red[0].to, 5.4, 0.3);
  EXPECT_NEAR(red[0].from_distance, 10 * red[0].from, 1e-6);
  EXPECT_GT(red[0].worst, red[0].allowed);
}

TEST(envelope, what_is_shorter_than_a_fifth_of_a_second_does_not_count) {
  const SimulatedRide simulated = ride_of(10, [](double t) { return t > 3 && t < 3.1 ? 9.0 : 1.0; });
  ForceLimitCurves envelope = default_envelope();
  envelope.cutoff = 25;
  EXPECT_TRUE(red_spans(simulated, envelope).empty());
}

// The definition, by brute force over levels and moments: a moment is red when some level is not left for longer than
// it may last.
TEST(envelope, finds_the_same_red_moments_as_brute_force) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> step(-0.9, 0.9);
  for (int trial = 0; trial < 20; ++trial) {
    double value = 3;
    std::vector<double> walk;
    for (int i = 0; i < 600; ++i) walk.push_back(value = std::clamp(value + step(random), -3.0, 7.0));
    const SimulatedRide simulated = ride_of(
        600.0 / 60, [&](double t) { return walk[std::min<std::size_t>(599, static_cast<std::size_t>(t * 60 + 0.5))]; });
    const ForceLimitCurves& envelope = default_envelope();
    const std::vector<float> values = pressed(simulated, 0, ForceAxis::down, envelope.cutoff);
    std::vector<bool> expected(values.size(), false), found(values.size(), false);
    std::vector<double> excess(values.size(), 0.0), allowed(values.size(), 0.0);
    for (std::size_t own = 0; own < values.size(); ++own) {
      const float level = values[own];
      for (std::size_t i = 0; i < values.size();) {
        if (values[i] < level) {
          ++i;
          continue;
        }
        std::size_t j = i;
        while (j + 1 < values.size() && values[j + 1] >= level) ++j;
        const double seconds = static_cast<double>(j - i) / 60;
        if (seconds >= envelope.shortest && level > limit(envelope.curves[0], seconds))
          std::fill(expected.begin() + static_cast<std::ptrdiff_t>(i),
                    expected.begin() + static_cast<std::ptrdiff_t>(j) + 1, true);
        if (i <= own && own <= j && seconds >= envelope.shortest)
          allowed[own] = limit(envelope.curves[0], seconds), excess[own] = std::max(0.0, level - allowed[own]);
        i = j + 1;
      }
    }
    for (const Overload& span : red_spans(simulated, envelope)) {
      if (span.axis != ForceAxis::down) continue;
      const auto place = [](double seconds) { return static_cast<std::size_t>(seconds * 60 + 0.5); };
      std::size_t worst = place(span.from);
      for (std::size_t k = place(span.from); k <= place(span.to); ++k) {
        found[k] = true;
        if (excess[k] > excess[worst]) worst = k;
      }
      EXPECT_EQ(place(span.at), worst) << trial;
      EXPECT_EQ(span.worst, static_cast<double>(values[worst])) << trial;
      EXPECT_EQ(span.allowed, allowed[worst]) << trial;
      EXPECT_NEAR(span.from_distance, 10 * span.from, 1e-6);
      EXPECT_NEAR(span.to_distance, 10 * span.to, 1e-6);
    }
    EXPECT_EQ(found, expected) << trial;
  }
}

}  // namespace force_limits_test
}  // namespace coaster::sim
