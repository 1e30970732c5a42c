// The kinds of equipment as data: what panels, menus and the sound need to know of each. A new kind is an enumerator of
// world/components.h and its row here; what it does to trains is in sim/ride/equipment.cpp, how it is built in
// sim/solids/track_mesh.cpp. Who only compares kinds needs world/components.h alone.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/enum_names.h"
#include "world/components.h"

namespace coaster::world {

struct EquipmentRow {
  std::string_view name, label, help;             // as base::NameRow
  std::string_view action, action_help;           // of the menu: makes sections this
  bool drives = false;                            // gives trains their speed
  bool has_chain = false;                         // its dogs are heard
  bool has_hysteresis = false, has_wait = false;  // uses Equipment::hysteresis, Equipment::seconds
};

// Returns the row of a kind; one without a name for other values.
constexpr EquipmentRow equipment_row(EquipmentKind kind) {
  switch (kind) {
    case EquipmentKind::station:
      return {.name = "station",
              .label = "Station",
              .help = "Stops a train, waits, then dispatches it at its speed.",
              .action = "Make station",
              .action_help = "Make the selected sections a station.",
              .has_wait = true};
    case EquipmentKind::lift:
      return {.name = "lift",
              .label = "Lift",
              .help = "A chain lift with anti-rollback: pulls the train at its speed.",
              .action = "Make lift",
              .action_help = "Make the selected sections a lift.",
              .drives = true,
              .has_chain = true};
    case EquipmentKind::launch:
      return {.name = "launch",
              .label = "Launch",
              .help = "Accelerates the train to its speed.",
              .action = "Make launch",
              .action_help = "Make the selected sections a launch.",
              .drives = true};
    case EquipmentKind::brake:
      return {.name = "brake",
              .label = "Brake",
              .help = "Slows the train to its speed.",
              .action = "Make brake",
              .action_help = "Make the selected sections a brake.",
              .has_hysteresis = true};
    case EquipmentKind::block:
      return {.name = "block",
              .label = "Block",
              .help = "A brake that holds a train until the block ahead is free.",
              .action = "Make block",
              .action_help = "Make the selected sections a block.",
              .has_hysteresis = true};
  }
  return {};
}

inline constexpr std::size_t kEquipmentCount = [] {
  std::size_t count = 0;
  while (!equipment_row(static_cast<EquipmentKind>(count)).name.empty()) ++count;
  return count;
}();
inline constexpr std::array<EquipmentRow, kEquipmentCount> kEquipmentKinds = [] {
  std::array<EquipmentRow, kEquipmentCount> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = equipment_row(static_cast<EquipmentKind>(i));
  return rows;
}();
constexpr std::span<const EquipmentRow> rows_of(EquipmentKind) { return kEquipmentKinds; }

}  // namespace coaster::world
