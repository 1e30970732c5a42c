// The names of the kinds of equipment. Who only compares kinds needs world/components.h alone.
#pragma once

#include <span>

#include "base/names.h"
#include "world/components.h"

namespace coaster::world {

inline constexpr base::NameRow kEquipmentKinds[] = {
    {"station", "Station", "Stops a train, waits, then dispatches it at its speed."},
    {"lift", "Lift", "A chain lift with anti-rollback: pulls the train at its speed."},
    {"launch", "Launch", "Accelerates the train to its speed."},
    {"brake", "Brake", "Slows the train to its speed."},
    {"block", "Block", "A brake that holds a train until the block ahead is free."}};
constexpr std::span<const base::NameRow> rows_of(EquipmentKind) { return kEquipmentKinds; }

}  // namespace coaster::world
