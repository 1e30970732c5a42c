// Kinds of coaster: what the rest of the program takes from a kind before it looks at solids
// (sim/solids/coaster_form.h).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/enum_names.h"
#include "world/components.h"
#include "world/paint.h"

namespace coaster::world {

enum class CoasterKind : std::uint8_t { steel, wooden, inverted, mine, kiddie };

struct CoasterKindRow {
  std::string_view name, label, help;
  double heartline;  // m above the rails; negative where riders hang below them
  Losses losses;     // usual ones; those of steel are none, so that a new track is frictionless
  double limits;     // factor of the default force limits
  double rumble;     // of the wheels, 0..1: 1 on rails of wood
  Paint paint;       // usual colours; those of steel are the materials' own (sim/solids/materials.h)
};

// Usual colours of the kinds.
inline constexpr Paint kWood{{0x8c8f94}, {0x855c38}, {0xdbccae}, {0x9e1f1a}};
inline constexpr Paint kHanging{{0x2f3f8f}, {0x2a4fb0}, {0xe9c23a}, {0xd9a62e}};
inline constexpr Paint kMine{{0x7a4a32}, {0x8c5a3a}, {0x8a6a48}, {0x2f4f3a}};
inline constexpr Paint kSmall{{0xf2c72e}, {0x3a9bd0}, {0xe85a94}, {0x3fa65a}};

inline constexpr CoasterKindRow kCoasterKinds[] = {
    {"steel", "Steel", "Tubular rails on a spine, with columns.", 1.1, {}, 1, 0, {}},
    {"wooden", "Wooden", "Stacks of planks with steel straps, on timber bents.", 1.1, {0.028f, 2.4e-5f}, 1, 1, kWood},
    {"inverted", "Inverted", "Riders hang below the rails, feet free.", -1.2, {0.022f, 2.2e-5f}, 1, 0, kHanging},
    {"mine", "Mine train", "Wooden ties on tubes, a train drawn by a locomotive.", 1, {0.026f, 2e-5f}, 0.9, 0.6, kMine},
    {"kiddie", "Kiddie", "A box beam, small cars, and lower limits of force.", 0.9, {0.024f, 2.0e-5f}, 0.6, 0, kSmall}};
constexpr std::span<const CoasterKindRow> rows_of(CoasterKind) { return kCoasterKinds; }

}  // namespace coaster::world
