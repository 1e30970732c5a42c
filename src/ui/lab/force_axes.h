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

inline constexpr std::uint32_t kForceColour = 0xFF8A1F, kActualColour = 0x4C9AFF, kFeltColour = 0xB58CFF,
                               kRampColour = 0x39424D;

// Converts between a program's axis (m or s from the section's start) and the track's (m).
class ForceAxes {
 public:
  // `first`: index of the section's first segment, which begins `start` m from the track's start.
  ForceAxes(const sim::ForcePlan& plan, world::ForceChannel channel, std::size_t first, double start)
      : plan_(plan), channel_(channel), first_(first), start_(start) {}
  const sim::ForcePlan& plan() const { return plan_; }
  const world::ForceProgram& program() const { return plan_.task.program; }
  world::ForceChannel channel() const { return channel_; }
  std::size_t first() const { return first_; }
  double start() const { return start_; }
  bool of_curvature() const { return program().of == world::ForceOf::curvature; }
  // Returns the value of the ride that is felt where the channel's keys act; nothing for roll.
  std::optional<sim::RideValue> felt() const;
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
  std::size_t first_;
  double start_;
};

// Returns the value rounded to a multiple of the step.
double to_step(double value, double step);

// Fills the positions and values of the target curve, and of the actual curve unless it comes from the ride.
void fill_curves(const sim::Derived& derived, const ForceAxes& axes, ForceKeys& state);
// Returns the ends of the axes: the section with a margin, the range of target and actual values, and at the right edge
// that of g felt where keys are curvature.
ForceEnds shown_ends(const ForceAxes& axes, const std::optional<RidePlots>& ride, const ForceKeys& state);
// Returns the limits of g within the plot, for the shortest overloads that count and for lasting ones, at their heights
// on the channel's axis.
std::vector<Level> shown_limits(const sim::Envelope& envelope, const ForceAxes& axes, const ForceEnds& ends);

}  // namespace coaster::ui
