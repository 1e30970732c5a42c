// The steps by which keys of force sections move: those of snapping, and the units in which a search counts changes.
#pragma once

#include "world/force.h"

namespace coaster::world {

struct KeySteps {
  double at, value;  // m or s; the channel's unit
};
inline KeySteps steps_of(const ForceProgram& program, ForceChannel channel) {
  const bool metres = program.over == ForceOver::distance, roll = channel == ForceChannel::roll;
  const double at = metres ? 1.0 : 0.1;
  if (program.of == ForceOf::curvature) return {at, roll ? 5.0 : 0.001};
  return {at, !roll ? 0.1 : metres ? 1.0 : 5.0};
}

}  // namespace coaster::world
