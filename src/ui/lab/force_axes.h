// The curves, axes and limits of a force section's plot. Private to force_keys.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "sim/plan/force_plan.h"
#include "ui/lab/cache.h"
#include "ui/plots/plot.h"

namespace coaster::ui {

inline constexpr std::uint32_t kForceColour = 0xFF8A1F, kActualColour = 0x4C9AFF, kRampColour = 0x39424D;

// Converts between a program's axis (m or s from the section's start) and the track's (m).
class ForceAxes {
 public:
  ForceAxes(const sim::ForcePlan& plan, world::ForceChannel channel, double start)
      : plan_(plan), channel_(channel), start_(start) {}
  const sim::ForcePlan& plan() const { return plan_; }
  const world::ForceProgram& program() const { return plan_.task.program; }
  world::ForceChannel channel() const { return channel_; }
  double start() const { return start_; }
  double x_of(double at) const;
  double at_of(double x) const;
  // Returns the length of a key's handle on that side; 0 if there is no key.
  double reach(world::ForceChannel channel, std::size_t key, int side) const;
  double asked(std::size_t point) const;
  // m or s: where the keys end, or the track, if its held end is farther.
  double end() const { return std::max(program().length, plan_.path.points.back().at); }

 private:
  const sim::ForcePlan& plan_;
  world::ForceChannel channel_;
  double start_;
};

// Steps of a key's position and value.
struct KeySteps {
  double at, value;
};
KeySteps steps_of(const world::ForceProgram& program, world::ForceChannel channel);
// Returns the value rounded to a multiple of the step.
double to_step(double value, double step);

// Fills the positions and values of the target curve and, for roll, of the actual one.
void fill_curves(const sim::Derived& derived, const ForceAxes& axes, ForceKeys& state);
// Returns the ends of both axes: the section with a margin, and the range of target and actual values.
std::array<double, 4> shown_ends(const ForceAxes& axes, const std::optional<RidePlots>& ride, const ForceKeys& state);
// Returns the limits of a channel for the shortest overloads that count, and for lasting ones.
std::vector<Level> limits_of(const sim::Envelope& envelope, world::ForceChannel channel);

}  // namespace coaster::ui
