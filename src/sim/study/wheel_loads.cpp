#include "sim/study/wheel_loads.h"

#include <algorithm>

#include "sim/solids/track_mesh.h"

namespace coaster::sim {

LoadsByWheelKind WheelLoads::of(WheelSet set) const {
  constexpr std::array<unsigned, base::count_of<WheelSet>()> kMembers{0b1111, 0b0011, 0b1100, 0b0101, 0b1010,
                                                                      0b0001, 0b0010, 0b0100, 0b1000};
  LoadsByWheelKind sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if ((kMembers[static_cast<std::size_t>(set)] >> i & 1u) == 0) continue;
    sum.road += corners[i].road, sum.up_stop += corners[i].up_stop, sum.side += corners[i].side;
  }
  return sum;
}

WheelLoads wheel_loads(const FeltAcceleration& felt, const CarBody& car) {
  const double weight = 1e-3 * car.mass * world::kGravity;                      // kN per g
  const double pitch = felt.forward * car.height / (kBogieShare * car.length),  // g from front to rear,
      roll = felt.left * car.height / kGauge;                                   // from left to right
  WheelLoads loads;
  for (std::size_t i = 0; i < loads.corners.size(); ++i) {
    const double ahead = i < 2 ? 1 : -1, left = i % 2 == 0 ? 1 : -1;
    const double up = weight * (0.25 * felt.up - 0.5 * ahead * pitch - 0.5 * left * roll);
    loads.corners[i] = {std::max(up, 0.0), std::max(-up, 0.0), std::max(0.5 * left * weight * felt.left, 0.0)};
  }
  return loads;
}

WheelLoads wheel_loads(const world::Document& document, const DerivedTrack& derived, world::Entity train,
                       const world::TrainMotion& motion) {
  const world::Train& design = document.entities.get<world::Train>(train);
  return wheel_loads(felt(document, derived, train, motion), {design.mass, design.body(), document.heartline});
}

WheelLoads wheel_loads(const SimulatedRide& simulated, std::size_t entry, int car) {
  return wheel_loads(simulated.felt(entry, car), {simulated.start.mass, simulated.start.length, simulated.heartline});
}

}  // namespace coaster::sim
