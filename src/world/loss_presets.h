// Named sets of losses: those of other programs, and none.
#pragma once

#include <algorithm>
#include <optional>

#include "world/components.h"

namespace coaster::world {

enum class LossSet : std::uint8_t { frictionless, openfvd, kexedit };
struct LossRow {
  std::string_view name, label, help;
  Losses losses;
};
inline constexpr LossRow kLossSets[] = {
    {"frictionless", "Frictionless", "No losses: the train keeps its energy.", {0, 0}},
    {"openfvd", "openFVD", "Rolling 0.03, drag 0.00002 1/m, as in openFVD.", {0.03f, 2e-5f}},
    {"kexedit", "KexEdit", "Rolling 0.021, drag 0.00002 1/m, as in KexEdit.", {0.021f, 2e-5f}}};
constexpr std::span<const LossRow> rows_of(LossSet) { return kLossSets; }

// Returns the set that has exactly these losses, if there is one.
inline std::optional<LossSet> loss_set_of(const Losses& losses) {
  const auto* const row = std::ranges::find(kLossSets, losses, &LossRow::losses);
  if (row == std::end(kLossSets)) return std::nullopt;
  return static_cast<LossSet>(row - kLossSets);
}

}  // namespace coaster::world
