// Loads of a car's wheels, by statics: the forces with which the rails give the car its felt g (docs/ride.md). A car
// has two bogies. Each side of a bogie has a road wheel above the rail, an up-stop wheel below it and a side wheel
// outside it.
#pragma once

#include <array>

#include "base/enum_names.h"
#include "sim/ride/ride.h"

namespace coaster::sim {

inline constexpr double kBogieShare = 0.6;  // distance between the bogies over the car's length

// A car as a rigid body. Its centre of mass is on the heartline, where felt g is given.
struct CarBody {
  double mass = world::kCarMass;      // kg, with riders
  double length = world::kCarLength;  // m
  double height = 0;                  // m, of the centre of mass above the rails; below 0: under them
};

// Loads in kN, never negative: the rails push road wheels up, up-stop wheels down, side wheels outwards.
struct LoadsByWheelKind {
  double road = 0, up_stop = 0, side = 0;
};

// Sets of wheels: the whole car, a bogie, a side, or one side of a bogie.
enum class WheelSet : std::uint8_t { car, front, rear, left, right, front_left, front_right, rear_left, rear_right };
inline constexpr base::NameRow kWheelSets[] = {{"car", "Car"},
                                               {"front", "Front"},
                                               {"rear", "Rear"},
                                               {"left", "Left"},
                                               {"right", "Right"},
                                               {"front_left", "Front left"},
                                               {"front_right", "Front right"},
                                               {"rear_left", "Rear left"},
                                               {"rear_right", "Rear right"}};
constexpr std::span<const base::NameRow> rows_of(WheelSet) { return kWheelSets; }

struct WheelLoads {
  std::array<LoadsByWheelKind, 4> corners;  // front left, front right, rear left, rear right
  // Returns the sum over a set.
  LoadsByWheelKind of(WheelSet set) const;
};

// Returns the loads of a car: forces sum to mass times felt g up and to the left, and all moments about the centre of
// mass vanish. Forces along the track act at the height of the rails. Both bogies take half of the lateral force.
WheelLoads wheel_loads(const FeltAcceleration& felt, const CarBody& car);
// Return the loads of a train's first car in its present motion, and of a simulated ride's car at an entry of
// SimulatedRide::forces.
WheelLoads wheel_loads(const world::Document& document, const DerivedTrack& derived, world::Entity train,
                       const world::TrainMotion& motion);
WheelLoads wheel_loads(const SimulatedRide& simulated, std::size_t entry, int car);

}  // namespace coaster::sim
