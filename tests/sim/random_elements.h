// Elements with parameters anywhere within their limits, and ends of tracks with any direction, curvature and roll.
#pragma once

#include <cmath>
#include <random>

#include "sim/plan/element_plan.h"
#include "world/element_rows.h"

namespace coaster::test {

class RandomElements {
 public:
  explicit RandomElements(std::uint32_t seed) : bits_(seed) {}
  std::uint32_t below(std::uint32_t n) { return bits_() % n; }
  double uniform(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }

  // Each parameter is the usual one, a limit, or anything between the limits (more often small than large).
  world::Element of_kind(world::ElementKind kind) {
    world::Element element = world::usual_element(kind);
    const world::ElementRow& row = base::row_of(kind);
    element.right = row.sided && below(2) == 1;
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
      const world::ElementParameter& p = row.parameters[i];
      const std::uint32_t choice = below(6);
      const double share = uniform(0, 1);
      if (choice == 0) element.values[i] = below(2) ? p.low : p.high;
      else if (choice < 4) element.values[i] = p.low + (p.high - p.low) * share * share;
    }
    return element;
  }
  world::Element any() {
    return of_kind(static_cast<world::ElementKind>(below(static_cast<std::uint32_t>(world::elements().size()))));
  }

  // Up to 60 degrees up or down, up to 1/8 m of curvature, rolled anyhow. One in four is straight, level and upright.
  sim::TrackEnd end() {
    sim::TrackEnd end;
    end.position = {uniform(-300, 300), uniform(5, 60), uniform(-300, 300)};
    const double yaw = uniform(-3.2, 3.2), pitch = uniform(-1, 1) * M_PI / 3;
    const bool plain = below(4) == 0;
    end.forward = plain ? glm::dvec3(std::cos(yaw), 0, std::sin(yaw))
                        : glm::dvec3(std::cos(yaw) * std::cos(pitch), std::sin(pitch), std::sin(yaw) * std::cos(pitch));
    end.up = curve::perpendicular(
        end.forward, plain ? glm::dvec3(0, 1, 0) : glm::dvec3(uniform(-1, 1), uniform(-0.3, 1), uniform(-1, 1)));
    if (!plain)
      end.curvature =
          uniform(0, 0.125) * curve::perpendicular(end.forward, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    return end;
  }

 private:
  std::mt19937 bits_;
};

}  // namespace coaster::test
