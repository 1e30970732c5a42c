#include "curve/tight_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "curve/random_cubics.h"

namespace coaster::curve {
namespace tight_places_test {

// The radius from the definition, in long double.
long double radius(const Cubic& c, long double t) {
  using Vec = glm::tvec3<long double>;
  const Vec d0 = Vec(c.p1) - Vec(c.p0), d1 = Vec(c.p2) - Vec(c.p1), d2 = Vec(c.p3) - Vec(c.p2);
  const Vec first = 3.0L * ((1 - t) * (1 - t) * d0 + 2 * t * (1 - t) * d1 + t * t * d2),
            second = 6.0L * ((1 - t) * (d1 - d0) + t * (d2 - d1));
  const long double speed = glm::length(first), bend = glm::length(glm::cross(first, second));
  return bend > 0 ? speed * speed * speed / bend : 1e300L;
}

// The least radius by brute force: the best of many samples, then again around it.
long double least_radius(const Cubic& c, double from = 0, double to = 1) {
  long double best = 1e300L, low = from, high = to;
  for (int round = 0; round < 12; ++round) {
    constexpr int kSteps = 4000;
    long double at = low;
    for (int i = 0; i <= kSteps; ++i) {
      const long double t = low + (high - low) * i / kSteps;
      if (const long double r = radius(c, t); r < best) best = r, at = t;
    }
    const long double half = (high - low) / kSteps;
    low = std::max<long double>(from, at - 2 * half), high = std::min<long double>(to, at + 2 * half);
  }
  return best;
}

double least_of(const std::vector<TightPlace>& places) {
  double least = 1e300;
  for (const TightPlace& place : places) least = std::min(least, place.radius);
  return least;
}

Cubic wild(std::mt19937& random) {
  std::uniform_real_distribution<float> place(-20, 20);
  const auto point = [&] { return glm::vec3{place(random), place(random), place(random)}; };
  return {point(), point(), point(), point()};
}

TEST(TightPlaces, LeastRadiusIsThatOfBruteForce) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    Cubic c = wild(random);
    if (i % 2 == 0) c.p0.y = c.p1.y = c.p2.y = c.p3.y = 4.25f;  // plane ones have inflections and near cusps
    const std::vector<TightPlace> places = tight_places(c, 1e9);
    const auto right = static_cast<double>(least_radius(c));
    EXPECT_NEAR(least_of(places), right, 1e-6 * right) << i;
    EXPECT_LE(places.size(), 7u);
    for (const TightPlace& place : places) {
      EXPECT_NEAR(place.radius, static_cast<double>(radius(c, place.t)), 1e-9 * place.radius);
      for (const double beside :
           {place.t - std::min(1e-4, 1e-4 * place.radius), place.t + std::min(1e-4, 1e-4 * place.radius)})
        if (beside > 0 && beside < 1) {
          EXPECT_GE(static_cast<double>(radius(c, beside)), place.radius * (1 - 1e-9));
        }
    }
  }
}

TEST(TightPlaces, FindsEveryMinimumBelowTheLimit) {
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    Cubic c = wild(random);
    if (i % 2 == 0) c.p0.y = c.p1.y = c.p2.y = c.p3.y = 4.25f;
    constexpr double kLimit = 5;
    const std::vector<TightPlace> places = tight_places(c, kLimit);
    constexpr int kSteps = 20'000;
    std::vector<double> samples;
    for (int k = 0; k <= kSteps; ++k) samples.push_back(static_cast<double>(radius(c, (long double)k / kSteps)));
    for (int k = 1; k < kSteps; ++k) {
      if (!(samples[k] < samples[k - 1] && samples[k] <= samples[k + 1] && samples[k] < kLimit)) continue;
      EXPECT_TRUE(std::ranges::any_of(places,
                                      [&](const TightPlace& place) {
                                        return std::abs(place.t * kSteps - k) <= 1.5 &&
                                               place.radius <= samples[k] * (1 + 1e-9);
                                      }))
          << i << " at " << static_cast<double>(k) / kSteps;
    }
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      double apart = 0;
      for (int j = 0; j <= kSteps; ++j)
        if (const double t = static_cast<double>(j) / kSteps; t >= places[k].t && t <= places[k + 1].t)
          apart = std::max(apart, samples[static_cast<std::size_t>(j)]);
      EXPECT_GE(places[k].apart, apart * (1 - 1e-6));
    }
  }
}

// Cusps and near cusps of a known radius: handles that cross by a given part.
TEST(TightPlaces, FindsSharpBendsOfAnyRadius) {
  for (const double wanted : {1e-6, 2e-4, 0.019, 0.4}) {
    const double width = 20, a = width - std::sqrt(6 * width * wanted / 2.25);
    const glm::vec3 o(3.3f, 4.4f, 5.5f);
    const Cubic c{o, o + glm::vec3(a, 0, width), o + glm::vec3(width - a, 0, width), o + glm::vec3(width, 0, 0)};
    const std::vector<TightPlace> places = tight_places(c, 0.5);
    ASSERT_EQ(places.size(), 1u) << wanted;
    EXPECT_FALSE(places[0].reversal);
    EXPECT_NEAR(places[0].radius, static_cast<double>(least_radius(c, 0.49, 0.51)), 1e-6 * wanted);
    EXPECT_NEAR(places[0].radius, wanted, 0.01 * wanted + 1e-7);
  }
}

TEST(TightPlaces, ReversalsAreThoseOfStraightsAndCusps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> part(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 o = 100.0f * glm::vec3{part(random), part(random), part(random)},
                    along = 20.0f * glm::normalize(glm::vec3{part(random), part(random), part(random)});
    const std::vector<TightPlace> twice = tight_places({o, o + 0.5f * along, o - 0.5f * along, o + along}, 0.5);
    ASSERT_EQ(twice.size(), 2u) << i;
    // B' = 0 where 0.5 - 3 t + 4.5 t^2 - ... : the roots of 0.5 (1-t)^2 - 2 t (1-t) + 1.5 t^2.
    for (int k = 0; k < 2; ++k) {
      EXPECT_TRUE(twice[k].reversal);
      EXPECT_EQ(twice[k].radius, 0);
      const double t = twice[k].t;
      EXPECT_NEAR(0.5 * (1 - t) * (1 - t) - 2 * t * (1 - t) + 1.5 * t * t, 0, 1e-5);
    }
    // A straight that only goes on has none, nor has one that stands still for a moment.
    EXPECT_TRUE(tight_places({o, o + 0.3f * along, o + 0.6f * along, o + along}, 0.5).empty());
    EXPECT_TRUE(tight_places({o, o + 0.5f * along, o + 0.5f * along, o + along}, 0.5).empty());
  }
  // The cusp of crossed handles of the chord's length.
  const std::vector<TightPlace> cusp = tight_places({{0, 0, 0}, {20, 0, 20}, {0, 0, 20}, {20, 0, 0}}, 0.5);
  ASSERT_EQ(cusp.size(), 1u);
  EXPECT_TRUE(cusp[0].reversal);
  EXPECT_NEAR(cusp[0].t, 0.5, 1e-12);
}

TEST(TightPlaces, DegenerateCubicsGiveFiniteNumbers) {
  for (const Cubic& c : degenerate_cubics())
    for (const TightPlace& place : tight_places(c, 1e9)) {
      EXPECT_TRUE(std::isfinite(place.radius) && place.radius >= 0);
      EXPECT_TRUE(place.t >= 0 && place.t <= 1);
    }
}

TEST(TightPlaces, GentleSegmentsHaveNone) {
  for (const Cubic& c : random_cubics(2000, 6)) EXPECT_TRUE(tight_places(c, 0.5).empty());
}

}  // namespace tight_places_test
}  // namespace coaster::curve
