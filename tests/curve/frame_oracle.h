// Rotation-minimising frames by another way than double reflection: u' = -(u . T') T by the classical Runge-Kutta
// method in long double, with steps so small against |B'| / |B''| that the error is below 1e-9 rad.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

class FrameOracle {
 public:
  explicit FrameOracle(const Cubic& c) {
    const Vec d0 = Vec(c.p1) - Vec(c.p0), d1 = Vec(c.p2) - Vec(c.p1), d2 = Vec(c.p3) - Vec(c.p2);
    a_ = 3.0L * d0, b_ = 6.0L * (d1 - d0), c_ = 3.0L * (d2 - 2.0L * d1 + d0);
  }
  // Carries `up` from t to `end`.
  glm::dvec3 carried(glm::dvec3 up, long double t, long double end, long double share = 0.01L) const {
    Vec u(up);
    while (t < end) {
      const Real h = std::min({share * glm::length(slope(t)) / glm::length(second(t)), 0.002L, end - t});
      const Vec k1 = change(t, u), k2 = change(t + h / 2, u + h / 2 * k1), k3 = change(t + h / 2, u + h / 2 * k2),
                k4 = change(t + h, u + h * k3);
      u += h / 6 * (k1 + 2.0L * k2 + 2.0L * k3 + k4);
      t += h;
    }
    return glm::dvec3(u);
  }
  // The least speed as a share of the largest, of 20,001 places and where the hodograph is nearest to its origin.
  double least_speed() const {
    Real low = 1e30L, high = 0, at = 0;
    for (int i = 0; i <= 20'000; ++i) {
      const Real speed = glm::length(slope(i / 20'000.0L));
      if (speed < low) low = speed, at = i / 20'000.0L;
      high = std::max(high, speed);
    }
    for (Real span = 1e-4L; span > 1e-18L; span /= 4)
      for (int k = -4; k <= 4; ++k)
        if (const Real t = std::clamp(at + k * span / 4, 0.0L, 1.0L); glm::length(slope(t)) < low)
          low = glm::length(slope(t)), at = t;
    return static_cast<double>(low / high);
  }

 private:
  using Real = long double;
  using Vec = glm::vec<3, Real>;
  Vec slope(Real t) const { return a_ + t * (b_ + t * c_); }
  Vec second(Real t) const { return b_ + 2.0L * t * c_; }
  Vec change(Real t, Vec u) const {
    const Vec d = slope(t), dd = second(t);
    const Real speed = glm::length(d);
    const Vec tangent = d / speed;
    return -glm::dot(u, (dd - glm::dot(dd, tangent) * tangent) / speed) * tangent;
  }
  Vec a_, b_, c_;
};

// Spatial cubics that nearly have a cusp: the hodograph passes its origin at a distance of 1e-4 to 1e-1 of its size.
inline std::vector<Cubic> near_cusps(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  const auto any = [&] {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return glm::dvec3(x, y, z);
  };
  std::vector<Cubic> all;
  while (static_cast<int>(all.size()) < count) {
    const glm::dvec3 along = 60.0 * glm::normalize(any()), bend = 60.0 * any();
    const double miss = 60.0 * std::pow(10.0, uniform(-3.6, -0.8)), at = uniform(0.05, 0.95);
    const glm::dvec3 aside = miss * glm::normalize(glm::cross(along, any()));
    const auto slope = [&](double t) { return along * (t - at) + bend * (t - at) * (t - at) + aside; };
    const glm::dvec3 h0 = slope(0), h1 = h0 + 0.5 * (along - 2.0 * at * bend), h2 = slope(1), p(13.3, -4.7, 21.9);
    const Cubic c{glm::vec3(p), glm::vec3(p + h0 / 3.0), glm::vec3(p + (h0 + h1) / 3.0),
                  glm::vec3(p + (h0 + h1 + h2) / 3.0)};
    if (FrameOracle(c).least_speed() > 1e-4) all.push_back(c);
  }
  return all;
}

}  // namespace coaster::curve
