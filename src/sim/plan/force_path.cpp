#include "sim/plan/force_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kForceStep = 0.25;    // m
constexpr double kLongestPath = 5000;  // m, longest section over time

class Integration {
 public:
  explicit Integration(const ForceTask& task) : task_(task), law_(task), above_(rails_height_of(law_.start()) >= 0) {}

  ForcePath run() {
    ForcePath path;
    path.ramp = law_.ramp();
    add(path, law_.start(), 0);
    follow_law(law_, kForceStep, 0, law_.start(), [&](double x, const ForceState& state) {
      path.stopped = stop(path, x, state);
      if (path.stopped.empty()) add(path, state, x);
      return path.stopped.empty();
    });
    return closed(std::move(path));
  }

 private:
  double rails_height_of(const ForceState& s) const { return s.position.y + task_.rails * s.up.y; }

  void add(ForcePath& path, const ForceState& s, double x) const {
    const ForceWanted wanted = law_.wanted(x);
    const ForceRates r = law_.rates_for(wanted, s);
    FeltG felt{wanted.up.value, wanted.side.value};
    if (task_.program.of == world::ForceOf::curvature) felt = felt_on(s, r, task_.riders);
    path.curve.points.push_back({s.length, s.position, s.tangent, r.curvature, s.up, r.spin});
    path.points.push_back({x, s.time, s.square, r.along, felt.up, felt.side, wanted.asked, wanted.added});
  }

  static ForcePath closed(ForcePath path) {
    path.curve.breaks = {0, path.curve.points.size() - 1};
    return path;
  }

  // Returns why the path cannot continue to that point; empty if it can.
  std::string stop(const ForcePath& path, double x, const ForceState& s) const {
    if (law_.too_slow(s)) return fmt::format("the train falls below {} m/s", world::kSlowestForce);
    const ForceRates r = law_.rates(x, s);
    if (r.folded || !(glm::length(r.curvature) * kTightestForce <= 1))
      return fmt::format("the turn would be tighter than a radius of {} m", kTightestForce);
    if (!(std::abs(r.spin) <= world::kMaxSpin)) return "the roll would be faster than the limit";
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(s.position[axis]) <= world::kMaxCoordinate))
        return fmt::format("the track would leave the world, {} m from its middle",
                           base::to_text(double{world::kMaxCoordinate}));
    if (above_ && rails_height_of(s) < 0) return "the track would run into the ground";
    if (s.length > kLongestPath) return fmt::format("a section is at most {} m long", kLongestPath);
    return own_rails(path, s);
  }

  std::string own_rails(const ForcePath& path, const ForceState& s) const {
    constexpr double kApart = 8;              // m along the track, within which it cannot collide with itself
    constexpr double kMost = 2 * kForceStep;  // m, largest distance of successive points along the rails
    const std::vector<ElementPoint>& points = path.curve.points;
    const dvec3 here = s.position + task_.rails * s.up;
    for (std::size_t i = 0; i < points.size() && points[i].s < s.length - kApart;) {
      const double off = glm::distance(points[i].position + task_.rails * points[i].up, here);
      if (off < kOwnRails) return "the track would run through itself";
      i += 1 + static_cast<std::size_t>((off - kOwnRails) / kMost);
    }
    return {};
  }

  const ForceTask& task_;
  ForceLaw law_;
  bool above_;
};

}  // namespace

ForcePath force_path(const ForceTask& task) { return Integration(task).run(); }

}  // namespace coaster::sim
