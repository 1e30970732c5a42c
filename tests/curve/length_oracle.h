// The length of a cubic by the tanh-sinh rule in long double, split where the curve is slowest: an oracle that shares
// neither nodes, nor subdivision, nor the integrand's form with the code under test. The rule's nodes are dense at the
// ends of each piece, so cusps cost nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

class LengthOracle {
 public:
  explicit LengthOracle(const Cubic& c) {
    for (int a = 0; a < 3; ++a) {
      const long double p0 = c.p0[a], p1 = c.p1[a], p2 = c.p2[a], p3 = c.p3[a];
      d_[0][a] = 3 * (p1 - p0), d_[1][a] = 3 * (p2 - p1), d_[2][a] = 3 * (p3 - p2);
    }
    find_slow_points();
  }

  // Relative error below 1e-15.
  long double length(long double t0 = 0, long double t1 = 1) const {
    long double sum = 0, from = t0;
    for (const long double t : slow_)
      if (t > from && t < t1) sum += piece(from, t), from = t;
    return sum + piece(from, t1);
  }

  // |B'(t)|, by Bernstein's form of the hodograph.
  long double speed(long double t) const {
    const long double s = 1 - t;
    long double sum = 0;
    for (int a = 0; a < 3; ++a) {
      const long double d = s * s * d_[0][a] + 2 * s * t * d_[1][a] + t * t * d_[2][a];
      sum += d * d;
    }
    return sqrtl(sum);
  }

 private:
  struct Node {
    long double q, weight;  // on [0,1/2], mirrored by the user
  };
  static const std::vector<Node>& nodes() {
    static const std::vector<Node> all = [] {
      constexpr long double kStep = 1.0L / 32, pi = 3.14159265358979323846264L;
      std::vector<Node> made;
      for (int k = 0; k <= 112; ++k) {
        const long double u = k * kStep, q = 1 / (1 + expl(pi * sinhl(u)));
        made.push_back({q, (k == 0 ? 0.5L : 1.0L) * kStep * pi * coshl(u) * q * (1 - q)});
      }
      return made;
    }();
    return all;
  }

  long double piece(long double a, long double b) const {
    const long double w = b - a;
    long double sum = 0;
    for (const Node& n : nodes()) sum += n.weight * (speed(a + w * n.q) + speed(b - w * n.q));
    return w * sum;
  }

  void find_slow_points() {
    constexpr int kScan = 200;
    long double v[kScan + 1];
    for (int i = 0; i <= kScan; ++i) v[i] = speed(static_cast<long double>(i) / kScan);
    for (int i = 0; i <= kScan; ++i) {
      if ((i > 0 && v[i] > v[i - 1]) || (i < kScan && v[i] >= v[i + 1])) continue;
      long double low = std::max(0, i - 1) / static_cast<long double>(kScan),
                  high = std::min(kScan, i + 1) / static_cast<long double>(kScan);
      for (int k = 0; k < 100; ++k) {  // by thirds: (2/3)^100 of an interval
        const long double a = low + (high - low) / 3, b = high - (high - low) / 3;
        const bool before = speed(a) < speed(b);
        (before ? high : low) = before ? b : a;
      }
      slow_.push_back((low + high) / 2);
    }
  }

  long double d_[3][3];
  std::vector<long double> slow_;
};

}  // namespace coaster::curve
