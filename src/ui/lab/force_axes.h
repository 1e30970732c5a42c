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

// Between a program's axis (m or s from the section's start) and the track's (m).
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
  // Returns how far the handle of a key reaches to that side; 0 where no key is there.
  double reach(world::ForceChannel channel, std::size_t key, int side) const;
  double asked(std::size_t point) const;
  // m or s: where the keys end, or the track, if its held end is farther.
  double end() const { return std::max(program().length, plan_.path.points.back().at); }

 private:
  const sim::ForcePlan& plan_;
  world::ForceChannel channel_;
  double start_;
};

// A step of a key's place and of its value.
struct KeySteps {
  double at, value;
};
KeySteps steps_of(const world::ForceProgram& program, world::ForceChannel channel);
// Returns the value rounded to a multiple of the step.
double to_step(double value, double step);

// Fills the places and values of what is asked, and for the roll of what there is.
void fill_curves(const sim::Derived& derived, const ForceAxes& axes, ForceKeys& state);
// Returns the ends of both axes: the section with a margin, and what is asked and felt there.
std::array<double, 4> shown_ends(const ForceAxes& axes, const std::optional<RidePlots>& ride, const ForceKeys& state);
// The limits of a channel for the shortest overloads that count, and for lasting ones.
std::vector<Level> limits_of(const sim::Envelope& envelope, world::ForceChannel channel);

}  // namespace coaster::ui
