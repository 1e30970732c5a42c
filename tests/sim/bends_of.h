// The curvature of a fitted track between the rows that it was fitted to, sampled finely on the document; independent
// of the fit.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/fit/sample_interpolation.h"
#include "world/document.h"

namespace coaster::test {

struct Bends {
  int folds = 0;      // samples that go against the step of the rows that they lie on
  double excess = 0;  // largest curvature over 1.5 times the rows' largest within 2 m plus 0.005/m; fits have at most 1
  double at = 0;      // m along the rows, of that
  double handle = 0;  // longest, over its segment's length
};

// Knots must be in the order of the rows, at them or between.
inline Bends bends_of(const world::Document& document, const std::vector<sim::FitRow>& rows) {
  const bool closed = document.track.closed;
  const std::size_t n = rows.size(), steps = closed ? n : n - 1;
  std::vector<double> along{0}, turn;  // turn: rows' curvature
  for (std::size_t i = 0; i < steps; ++i) {
    const sim::FitRow &a = rows[i], &b = rows[(i + 1) % n];
    const double length = glm::distance(a.position, b.position), chord = glm::distance(a.forward, b.forward);
    along.push_back(along.back() + length);
    turn.push_back(2 * std::asin(std::min(1.0, chord / 2)) / length);
  }
  const auto largest_near = [&](double s) {
    double most = 0;
    for (const double lap : {-along.back(), 0.0, along.back()}) {
      if (lap != 0 && !closed) continue;
      const auto after = std::upper_bound(along.begin(), along.end(), s - 2 - lap);
      for (std::size_t i = after == along.begin() ? 0 : static_cast<std::size_t>(after - along.begin()) - 1;
           i < steps && along[i] + lap <= s + 2; ++i)
        most = std::max(most, turn[i]);
    }
    return most;
  };
  Bends bends;
  // Returns the place on the rows' polyline that is nearest to a point, between two places.
  const auto place_of = [&](glm::dvec3 point, double low, double high) {
    double nearest = 1e9, place = low;
    for (std::size_t i = 0; i < steps; ++i) {
      if (along[i + 1] <= low || along[i] >= high) continue;
      const glm::dvec3 a = rows[i].position, chord = rows[(i + 1) % n].position - a;
      const double share = std::clamp(glm::dot(point - a, chord) / glm::dot(chord, chord), 0.0, 1.0);
      const double distance = glm::distance(a + share * chord, point);
      if (distance < nearest) nearest = distance, place = along[i] + share * (along[i + 1] - along[i]);
    }
    return place;
  };
  double from = 0;
  for (const world::Entity e : document.track.segments) {
    const curve::Cubic c = world::cubic_of(document, e);
    const double reach = glm::distance(c.p0, c.p1) + glm::distance(c.p1, c.p2) + glm::distance(c.p2, c.p3);
    const double to =
        e == document.track.segments.back() ? along.back() : place_of(glm::dvec3(c.p3), from, from + reach + 1e-3);
    const int samples = std::max(300, static_cast<int>((to - from) / 0.02));
    std::vector<double> length{0};
    for (int i = 1; i <= samples; ++i)
      length.push_back(length.back() +
                       glm::distance(curve::point(c, (i - 1.0) / samples), curve::point(c, i / (samples + 0.0))));
    for (const float handle : {glm::distance(c.p0, c.p1), glm::distance(c.p2, c.p3)})
      bends.handle = std::max(bends.handle, handle / length.back());
    std::size_t step = 0;
    for (int i = 0; i <= samples; ++i) {
      const double s = from + length[i] / length.back() * (to - from);
      while (step + 1 < steps && along[step + 1] < s) ++step;
      const glm::dvec3 d = curve::derivative(c, i / (samples + 0.0)),
                       dd = curve::second_derivative(c, i / (samples + 0.0));
      bends.folds += glm::dot(d, rows[(step + 1) % n].position - rows[step].position) <= 0;
      const double speed = glm::length(d), curvature = glm::length(glm::cross(d, dd)) / (speed * speed * speed);
      const double limit = 1.5 * largest_near(s) + 0.005;
      if (curvature / limit > bends.excess) bends.excess = curvature / limit, bends.at = s;
    }
    from = to;
  }
  return bends;
}

}  // namespace coaster::test
