// Cubics for the tests: off the origin, skew, with coordinates that are not exact in float.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

// Braces, not parentheses, around the draws: they fix their order, so every compiler gets the same cubics.
// Track-like: about `size` metres long, within `reach` metres of the origin in each coordinate, handles about a third
// of the chord.
inline std::vector<Cubic> random_cubics(int count, unsigned seed, float reach = 200, float size = 20) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-reach, reach), bend(-0.35f, 0.35f), stretch(0.4f, 1.6f);
  const auto direction = [&] { return glm::normalize(glm::vec3{1.1f + bend(random), bend(random), bend(random)}); };
  std::vector<Cubic> all;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 p{place(random), place(random), place(random)};
    const float length = size * stretch(random);
    const glm::vec3 q = p + length * direction();
    const float first = length / 3 * stretch(random), second = length / 3 * stretch(random);
    const glm::vec3 a = first * direction(), b = second * direction();
    all.push_back({p, p + a, q - b, q});
  }
  return all;
}

// Shapes at which formulas break. None may give NaN or take unbounded work.
inline std::vector<Cubic> degenerate_cubics() {
  const glm::vec3 a(13.3f, -4.7f, 21.9f), x(7.1f, 0, 0), y(0, 5.3f, 0);
  return {
      {a, a, a, a},                                                          // four equal points
      {a, a, a + y, a + x},                                                  // handle on its anchor
      {a, a + x, a + x, a + x},                                              // handle on the far anchor
      {a, a + x + y, a + y, a + x},                                          // crossed handles
      {a, a + x + 2.0f * y, a + 2.0f * y - x, a + x},                        // loop
      {a, a + x + y, a + y, a + x},                                          // near a cusp
      {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}},                          // exact interior cusp at t = 1/2
      {a, a + y, a + 2.0f * y, a + 3.0f * y},                                // vertical, straight, even speed
      {a, a + 0.1f * x, a + 2.9f * x, a + 3.0f * x},                         // straight, uneven speed
      {a, a + 2.0f * x, a - x, a + x},                                       // straight, backwards and forwards
      {a, a + x, a - x, a},                                                  // closed, opposed ends
      {a, a + x + y, a + x - y, a + 2.0f * x},                               // inflection
      {a, a + 1e-9f * x, a + 2e-9f * x, a + 3e-9f * x},                      // a few nanometres: rounds to a point
      {{1e-10f, 0, 0}, {3e-10f, 1e-10f, 0}, {6e-10f, 0, 0}, {1e-9f, 0, 0}},  // a nanometre
      {{1e5f, 1e5f, -1e5f}, {100010.0f, 1e5f, -1e5f}, {100020.0f, 100005.0f, -1e5f}, {100030.0f, 100005.0f, -99990.0f}},
  };
}

// A family of cubics that shares what makes it hard.
struct CubicSet {
  const char* name;
  std::vector<Cubic> cubics;
};

// `count` of each: track-like; all four points anywhere; nearly straight, with uneven speed and turning back; loops
// with handles longer than the chord; a cusp (B' = 0 at some t in (0,1), up to the rounding of float); and nearly a
// cusp.
inline std::vector<CubicSet> cubic_sets(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-90, 90), near(-20, 20), share(-0.4f, 1.4f), unit(0, 1);
  const auto offset = [&] { return glm::vec3{near(random), near(random), near(random)}; };
  std::vector<CubicSet> sets{{"track", random_cubics(count, seed + 1)},
                             {"random", {}},
                             {"near_straight", {}},
                             {"looping", {}},
                             {"cusped", {}},
                             {"near_cusp", {}}};
  for (int i = 0; i < count; ++i) {
    const glm::vec3 p{place(random), place(random), place(random)}, d = offset(), e = offset(), f = offset();
    sets[1].cubics.push_back({p, p + d, p + e, p + f});

    const float waver = std::pow(10.0f, -6.0f * unit(random)) * 0.1f, a = share(random), b = share(random);
    sets[2].cubics.push_back({p, p + a * d + waver * e, p + b * d + waver * f, p + d});

    const float first = 1.2f + unit(random), second = 1.2f + unit(random);
    sets[3].cubics.push_back({p, p + first * d + 0.3f * e, p + first * 0.4f * d + 0.3f * e + second * f, p + 0.5f * f});

    // B'(t) = 0 where s^2 (p1-p0) + 2 s t (p2-p1) + t^2 (p3-p2) = 0, with s = 1 - t: solved for p2 - p1.
    const float t = 0.1f + 0.8f * unit(random), s = 1 - t;
    const glm::vec3 g = -(s * s * d + t * t * e) / (2 * s * t);
    sets[4].cubics.push_back({p, p + d, p + d + g, p + d + g + e});
    const glm::vec3 gap = std::pow(10.0f, -1.0f - 4.0f * unit(random)) * f;
    sets[5].cubics.push_back({p, p + d, p + d + g + gap, p + d + g + gap + e});
  }
  return sets;
}

// `count` random cubics of each degenerate kind, anywhere within 90 m of the origin unless the kind says otherwise.
inline std::vector<CubicSet> degenerate_sets(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-90, 90), near(-20, 20), share(0.02f, 0.98f), far(-1e5f, 1e5f);
  const auto offset = [&] { return glm::vec3{near(random), near(random), near(random)}; };
  std::vector<CubicSet> sets{
      {"point", {}},        {"handle_on_anchor", {}}, {"crossed", {}},         {"vertical", {}},  {"closed", {}},
      {"out_and_back", {}}, {"inflection", {}},       {"uneven_straight", {}}, {"nanometre", {}}, {"far", {}}};
  for (int i = 0; i < count; ++i) {
    const glm::vec3 p{place(random), place(random), place(random)}, d = offset(), e = offset(), f = offset();
    const glm::vec3 up{0, near(random), 0};
    const float a = share(random), b = share(random);
    sets[0].cubics.push_back({p, p, p, p});
    sets[1].cubics.push_back(i % 3 == 0   ? Cubic{p, p, p + d, p + e}
                             : i % 3 == 1 ? Cubic{p, p + d, p + e, p + e}
                                          : Cubic{p, p, p + e, p + e});
    sets[2].cubics.push_back({p, p + 1.7f * d + e, p + e - 0.6f * d, p + d});
    sets[3].cubics.push_back({p, p + a * up, p + b * up, p + up});
    sets[4].cubics.push_back({p, p + d, p + e, p});
    sets[5].cubics.push_back({p, p + d, p - a * d, p + (b - 0.5f) * d});
    sets[6].cubics.push_back({p, p + d + e, p + d - e, p + 2.0f * d});
    sets[7].cubics.push_back({p, p + 0.1f * a * d, p + 0.9f * d, p + d});
    sets[8].cubics.push_back({1e-10f * p, 1e-10f * (p + d), 1e-10f * (p + e), 1e-10f * (p + f)});
    const glm::vec3 q{far(random), far(random), far(random)};
    sets[9].cubics.push_back({q, q + d, q + e, q + f});
  }
  return sets;
}

}  // namespace coaster::curve
