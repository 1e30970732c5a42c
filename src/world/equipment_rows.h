// The kinds of equipment.
#pragma once

#include <cstdint>
#include <span>

#include "base/names.h"

namespace coaster::world {

// station: stops a train at its end, or where it can bring a short one to its speed; waits `seconds`, and dispatches it
//          at up to `speed`.
// lift:    a chain that pulls up to `speed`, prevents rollback, and does not slow faster trains.
// launch:  accelerates with `acceleration` until `speed` is reached.
// brake:   decelerates with `acceleration`, from above speed + hysteresis until below speed - hysteresis.
// block:   a brake that stops a train at its end until the section after it is free.
enum class EquipmentKind : std::uint8_t { station, lift, launch, brake, block };
inline constexpr base::NameRow kEquipmentKinds[] = {
    {"station", "Station", "Stops a train, waits, then dispatches it at its speed."},
    {"lift", "Lift", "A chain lift with anti-rollback: pulls the train at its speed."},
    {"launch", "Launch", "Accelerates the train to its speed."},
    {"brake", "Brake", "Slows the train to its speed."},
    {"block", "Block", "A brake that holds a train until the block ahead is free."}};
constexpr std::span<const base::NameRow> rows_of(EquipmentKind) { return kEquipmentKinds; }

}  // namespace coaster::world
