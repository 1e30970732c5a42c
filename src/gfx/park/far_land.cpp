#include "gfx/park/far_land.h"

#include <cmath>

#include "sim/ground/land_paint.h"

namespace coaster::gfx {
namespace {

constexpr std::array<float, 9> kRings{1, 1.06f, 1.25f, 1.6f, 2.2f, 3.2f, 5, 9, kFarthestLand};
constexpr int kAroundSide = 48;  // vertices along a side of all rings but the first
constexpr int kBorder = 4;       // cells between the first ring's vertices

// Point i of n along side 0..3 of the square with corners at -1 and 1.
glm::vec2 on_side(int side, float along) {
  const float t = 2 * along - 1;
  switch (side) {
    case 0: return {t, -1};
    case 1: return {1, t};
    case 2: return {-t, 1};
    default: return {-1, -t};
  }
}

sim::LandVertex vertex_at(const sim::Ground& ground, glm::vec2 at, float height) {
  const world::Park& park = ground.land().park();
  const double x = double{at.x}, z = double{at.y}, e = 6;
  const sim::Land& land = ground.land();
  const glm::dvec3 slope(land.seeded(x - e, z) - land.seeded(x + e, z), 2 * e,
                         land.seeded(x, z - e) - land.seeded(x, z + e));
  const glm::vec3 normal(glm::normalize(slope));
  const float wood = sim::far_woods(park, x, z);
  const glm::vec3 paint = sim::land_paint(park, {x, z, height, normal.y, wood, 0});
  sim::LandVertex vertex;
  vertex.position = {at.x, height, at.y};
  for (int i = 0; i < 3; ++i) {
    vertex.normal[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(127 * normal[i]));
    vertex.paint[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(255 * std::sqrt(glm::clamp(paint[i], 0.0f, 1.0f))));
  }
  vertex.paint[3] = static_cast<std::uint8_t>(std::lround(255 * 0.94f * (1 - 0.35f * wood)));
  return vertex;
}

}  // namespace

FarLand far_land(const sim::Ground& ground, const sim::LandField& field) {
  FarLand far;
  const int first_side = field.across / kBorder;  // of the first ring
  const float half = 0.5f * static_cast<float>(field.across) * static_cast<float>(world::kGroundCell);
  std::vector<std::uint32_t> begins;
  for (std::size_t ring = 0; ring < kRings.size(); ++ring) {
    begins.push_back(static_cast<std::uint32_t>(far.vertices.size()));
    const int along = ring == 0 ? first_side : kAroundSide;
    for (int i = 0; i < 4 * along; ++i) {
      const glm::vec2 way = on_side(i / along, static_cast<float>(i % along) / static_cast<float>(along));
      const auto column = static_cast<int>(std::lround(0.5f * (way.x + 1) * static_cast<float>(field.across))),
                 row = static_cast<int>(std::lround(0.5f * (way.y + 1) * static_cast<float>(field.across)));
      // On the border exactly where the patches' vertices are.
      const auto cell = static_cast<float>(world::kGroundCell);
      const glm::vec2 at =
          ring == 0 ? glm::vec2(cell * static_cast<float>(column) - half, cell * static_cast<float>(row) - half)
                    : half * kRings[ring] * way;
      const float height =
          ring == 0 ? field.height(column, row) : static_cast<float>(ground.land().seeded(double{at.x}, double{at.y}));
      far.vertices.push_back(vertex_at(ground, at, height));
      far.low = std::min(far.low, height), far.high = std::max(far.high, height);
    }
  }
  for (int side = 0; side < 4; ++side) {
    far.sides[static_cast<std::size_t>(side)] = static_cast<std::uint32_t>(far.indices.size());
    for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring) {
      const int inner = ring == 0 ? first_side : kAroundSide, fan = inner / kAroundSide;
      const auto in = [&](int i) { return static_cast<std::uint16_t>(begins[ring] + std::uint32_t(i % (4 * inner))); };
      const auto out = [&](int i) {
        return static_cast<std::uint16_t>(begins[ring + 1] + std::uint32_t(i % (4 * kAroundSide)));
      };
      // A fan of the inner vertices to the nearer of two outer ones, and a triangle between the fans.
      for (int j = side * kAroundSide; j < (side + 1) * kAroundSide; ++j) {
        for (int i = 0; i < fan; ++i)
          far.indices.insert(far.indices.end(),
                             {in(j * fan + i), in(j * fan + i + 1), out(i < (fan + 1) / 2 ? j : j + 1)});
        far.indices.insert(far.indices.end(), {in(j * fan + (fan + 1) / 2), out(j + 1), out(j)});
      }
    }
  }
  far.sides[4] = static_cast<std::uint32_t>(far.indices.size());
  return far;
}

}  // namespace coaster::gfx
