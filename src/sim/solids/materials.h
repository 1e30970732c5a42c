// The look of materials.
#pragma once

#include <array>
#include <optional>

#include <glm/glm.hpp>

#include "sim/solids/mesh.h"
#include "world/paint.h"

namespace coaster::sim {

struct MaterialRow {
  glm::vec3 colour;                         // sRGB, 0..1
  float gloss;                              // how much of the surface is varnish, which reflects sun and sky, 0..1
  std::optional<world::PaintPart> painted;  // whose paint replaces the colour
};
inline constexpr std::size_t kMaterialCount = static_cast<std::size_t>(Material::chassis) + 1;
// By Material.
inline constexpr std::array<MaterialRow, kMaterialCount> kMaterials{{
    {{0.851f, 0.271f, 0.184f}, 0.6f, world::PaintPart::rails},     // rail
    {{0.659f, 0.204f, 0.149f}, 0.6f, world::PaintPart::spine},     // spine
    {{0.227f, 0.247f, 0.278f}, 0.12f, world::PaintPart::spine},    // tie
    {{0.180f, 0.369f, 0.667f}, 0.9f, world::PaintPart::train},     // body
    {{0.957f, 0.773f, 0.259f}, 0.9f, {}},                          // stripe
    {{0.150f, 0.160f, 0.180f}, 0.06f, {}},                         // wheel
    {{0.894f, 0.906f, 0.922f}, 0.6f, world::PaintPart::supports},  // support
    {{0.710f, 0.722f, 0.706f}, 0.04f, {}},                         // concrete
    {{0.420f, 0.441f, 0.471f}, 0.3f, {}},                          // chain
    {{0.788f, 0.816f, 0.847f}, 0.6f, {}},                          // fin
    {{0.165f, 0.545f, 0.655f}, 0.6f, {}},                          // stator
    {{0.545f, 0.573f, 0.608f}, 0.04f, {}},                         // deck
    {{0.170f, 0.185f, 0.215f}, 0.04f, {}},                         // seat
    {{0.850f, 0.660f, 0.525f}, 0.04f, {}},                         // skin
    {{0.240f, 0.560f, 0.525f}, 0.04f, {}},                         // teal
    {{0.851f, 0.773f, 0.560f}, 0.04f, {}},                         // sand
    {{0.480f, 0.360f, 0.600f}, 0.04f, {}},                         // plum
    {{0.910f, 0.895f, 0.860f}, 0.04f, {}},                         // linen
    {{0.260f, 0.200f, 0.160f}, 0.04f, {}},                         // hair
    {{0.455f, 0.325f, 0.205f}, 0.04f, {}},                         // timber
    {{0.545f, 0.455f, 0.345f}, 0.04f, {}},                         // plank
    {{0.886f, 0.867f, 0.812f}, 0.1f, world::PaintPart::supports},  // handrail
    {{0.227f, 0.247f, 0.278f}, 0.12f, {}}                          // chassis
}};

}  // namespace coaster::sim
