// Rows along known curves, and a check of a fitted track against rows that is independent of sim/fit/fit_check.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "sim/fit/fit_track.h"
#include "sim/shape/derived_track.h"
#include "world/evaluation_settings.h"

namespace coaster::test {

// Rows at the parameters begin, begin + step, ... (count of them) of a curve, looking along it, `up` as near to the
// wish as can be.
inline std::vector<sim::FitRow> rows_along(const std::function<glm::dvec3(double)>& place,
                                           const std::function<glm::dvec3(double)>& up, double step, int count,
                                           double begin = 0) {
  std::vector<sim::FitRow> rows;
  for (int i = 0; i < count; ++i) {
    const double s = begin + step * i, h = 1e-4;
    const glm::dvec3 forward = glm::normalize(place(s + h) - place(s - h));
    const glm::dvec3 wish = up(s);
    rows.push_back({place(s), forward, glm::normalize(wish - glm::dot(wish, forward) * forward)});
  }
  return rows;
}

// Whether the frame at each row counts: no step of over 5 degrees (and 100 degrees/m, and twice the rates of the steps
// beside it) begins or ends within 0.5 m, along the rows.
inline std::vector<bool> counted_rows(const std::vector<sim::FitRow>& rows, bool closed) {
  const std::size_t n = rows.size();
  std::vector<double> along{0};
  for (std::size_t i = 0; i < n; ++i)
    along.push_back(along.back() + glm::distance(rows[i].position, rows[(i + 1) % n].position));
  std::vector<bool> counted(n, true);
  const auto angle_of = [&](std::size_t i) {
    const sim::FitRow &a = rows[i], &b = rows[(i + 1) % n];
    const glm::dvec3 left_a = glm::cross(a.up, a.forward), left_b = glm::cross(b.up, b.forward);
    const double trace = glm::dot(a.forward, b.forward) + glm::dot(a.up, b.up) + glm::dot(left_a, left_b);
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / M_PI;
  };
  const std::size_t steps = closed ? n : n - 1;
  const auto rate_of = [&](std::size_t i, bool exists) {
    return exists ? angle_of(i % steps) / (along[i % steps + 1] - along[i % steps]) : 0;
  };
  for (std::size_t i = 0; i < steps; ++i) {
    const double angle = angle_of(i), rate = rate_of(i, true);
    if (rate <= 2 * rate_of(i + steps - 1, closed || i > 0) || rate <= 2 * rate_of(i + 1, closed || i + 1 < steps))
      continue;
    if (angle <= 5 || angle <= 100 * (along[i + 1] - along[i])) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const double whole = along[n], middle = 0.5 * (along[i] + along[i + 1]);
      double apart = std::abs(along[k] - middle);
      if (closed) apart = std::min(apart, whole - apart);
      if (apart <= 0.5) counted[k] = false;
    }
  }
  return counted;
}

struct Misses {
  double distance = 0, angle_deg = 0;          // the worst
  double distance_rms = 0, angle_rms_deg = 0;  // root mean squares
};

// The distances of rows from the whole track, and the angles at the counted rows from the frame at a place within 1 cm
// of them.
inline Misses misses_of(const world::Document& document, const std::vector<sim::FitRow>& rows) {
  sim::DerivedTrack derived;
  world::Settings settings;
  settings.evaluation->steps = 1;
  sim::derive(document, settings, {}, derived);
  const std::vector<bool> counted = counted_rows(rows, document.track.closed);
  Misses worst;
  double angles = 0;  // number
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double nearest = 1e9, angle = 180;
    for (const world::Entity e : derived.order) {
      const sim::SegmentShape& shape = derived.shape(e);
      const curve::Box box = curve::control_box(shape.key.cubic);
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
        inside =
            inside && rows[i].position[axis] > box.low[axis] - 0.02 && rows[i].position[axis] < box.high[axis] + 0.02;
      if (!inside) continue;
      const curve::NearestPoint found = curve::nearest_point(shape.key.cubic, rows[i].position);
      nearest = std::min(nearest, found.distance);
      if (found.distance > 0.0101) continue;
      const curve::Frame frame = sim::frame_at(shape, shape.arc.distance(found.t));
      const double trace = glm::dot(frame.forward, rows[i].forward) + glm::dot(frame.up, rows[i].up) +
                           glm::dot(frame.left(), glm::cross(rows[i].up, rows[i].forward));
      angle = std::min(angle, std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / M_PI);
    }
    worst.distance = std::max(worst.distance, nearest), worst.distance_rms += nearest * nearest;
    if (!counted[i]) continue;
    worst.angle_deg = std::max(worst.angle_deg, angle), worst.angle_rms_deg += angle * angle, ++angles;
  }
  worst.distance_rms = std::sqrt(worst.distance_rms / static_cast<double>(rows.size()));
  worst.angle_rms_deg = std::sqrt(worst.angle_rms_deg / std::max(angles, 1.0));
  return worst;
}

}  // namespace coaster::test
