#include "sim/ground/fixtures.h"

#include <array>
#include <cmath>

#include "sim/ground/tunnel_mesh.h"

namespace coaster::sim {
namespace {

// Adds an upright box without a bottom.
void add_post_box(EarthMesh& mesh, glm::vec3 low, glm::vec3 high, glm::vec3 paint) {
  const auto corner = [&](int i) {
    return glm::vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  };
  struct Side {
    glm::vec3 normal;
    std::array<int, 4> corners;  // counter-clockwise from outside
  };
  const std::array<Side, 5> sides{{{{1, 0, 0}, {1, 3, 7, 5}},
                                   {{-1, 0, 0}, {0, 4, 6, 2}},
                                   {{0, 0, 1}, {4, 5, 7, 6}},
                                   {{0, 0, -1}, {0, 2, 3, 1}},
                                   {{0, 1, 0}, {2, 6, 7, 3}}}};
  for (const auto& [normal, c] : sides)
    mesh.add_quad({corner(c[0]), corner(c[1]), corner(c[2]), corner(c[3])}, normal, paint, {0.9f, 0.9f, 0.9f, 0.9f});
}

// Adds the earth below and beside the cells that are left open at a portal, so that no sky shows through them.
void add_pit(EarthMesh& mesh, const Ground& ground, const TunnelGate& gate) {
  constexpr glm::vec3 kPitEarth{0.30f, 0.23f, 0.15f};
  constexpr int kReach = 6;  // cells about the gate
  const TrackRoom& room = ground.room();
  const double cell = world::kGroundCell, floor = gate.at.y + room.lift - room.tube - 0.5;
  const auto add = [&](const std::array<glm::vec3, 4>& corners, glm::vec3 normal, float ambient) {
    mesh.add_quad(corners, normal, kPitEarth, {ambient, ambient, ambient, ambient});
  };
  const int column = static_cast<int>(std::floor(gate.at.x / cell)),
            row = static_cast<int>(std::floor(gate.at.z / cell));
  for (int z = row - kReach; z <= row + kReach; ++z) {
    for (int x = column - kReach; x <= column + kReach; ++x) {
      if (!is_open(ground, {x, z})) continue;
      const auto corner = [&](int dx, int dz) { return glm::dvec2(cell * (x + dx), cell * (z + dz)); };
      const auto at = [&](glm::dvec2 p, double y) { return glm::vec3(p.x, y, p.y); };
      add({at(corner(0, 0), floor), at(corner(0, 1), floor), at(corner(1, 1), floor), at(corner(1, 0), floor)},
          {0, 1, 0}, 0.35f);
      // Walls to the cells around, down to the tube where it passes.
      const std::array<std::array<int, 6>, 4> sides{
          {{-1, 0, 0, 0, 0, 1}, {1, 0, 1, 0, 1, 1}, {0, -1, 0, 0, 1, 0}, {0, 1, 0, 1, 1, 1}}};
      for (const auto& [dx, dz, ax, az, bx, bz] : sides) {
        if (is_open(ground, {x + dx, z + dz})) continue;
        const glm::dvec2 a = corner(ax, az), b = corner(bx, bz), middle = 0.5 * (a + b);
        const double low = gate.aside(middle) < room.tube + 0.3 ? gate.at.y + room.lift + room.tube : floor;
        const double high_a = ground.height(a.x, a.y), high_b = ground.height(b.x, b.y);
        if (std::fmin(high_a, high_b) <= low) continue;
        add({at(a, low), at(b, low), at(b, high_b), at(a, high_a)}, glm::vec3(-dx, 0, -dz), 0.55f);
      }
    }
  }
}

}  // namespace

FixtureMesh fixture_mesh(const Ground& ground, std::span<const Lamp> posts, std::span<const Lamp> lit) {
  constexpr glm::vec3 kPost{0.045f, 0.055f, 0.060f}, kGlass{0.75f, 0.70f, 0.55f};
  EarthMesh earth = tunnel_mesh(ground);
  for (const TunnelGate& gate : ground.gates()) add_pit(earth, ground, gate);
  for (const Lamp& lamp : posts) {
    if (lamp.post <= 0) continue;
    const glm::vec3 foot = lamp.at - glm::vec3(0, lamp.post + 0.3f, 0);
    add_post_box(earth, foot - glm::vec3(0.07f, 0, 0.07f), lamp.at + glm::vec3(0.07f, -0.2f, 0.07f), kPost);
    add_post_box(earth, lamp.at - glm::vec3(0.18f, 0.2f, 0.18f), lamp.at + glm::vec3(0.18f, 0.2f, 0.18f), kGlass);
    add_post_box(earth, lamp.at + glm::vec3(-0.26f, 0.2f, -0.26f), lamp.at + glm::vec3(0.26f, 0.3f, 0.26f), kPost);
  }
  FixtureMesh mesh;
  mesh.indices = std::move(earth.indices);
  for (const EarthVertex& vertex : earth.vertices) {
    mesh.vertices.push_back({vertex.position, land_finish(vertex.normal, vertex.paint, vertex.ambient)});
    float sum = 0;
    for (const Lamp& lamp : lit) sum += lamp_light(lamp, vertex.position, vertex.normal);
    mesh.light.push_back({static_cast<std::uint8_t>(vertex.ambient < 0.5f ? 0 : 255), byte_of(0.5f * sum)});
  }
  return mesh;
}

std::vector<std::uint8_t> lamp_map(const Ground& ground, std::span<const Lamp> lamps, glm::vec2 heights) {
  const int side = static_cast<int>(ground.tiles_across() * world::kGroundTileCells * world::kGroundCell / kLampCell);
  const auto cells = static_cast<std::size_t>(side * side);
  std::vector<float> light(cells), height(cells);
  const auto half = 0.5f * static_cast<float>(side);
  const auto cell = static_cast<float>(kLampCell);
  for (const Lamp& lamp : lamps) {
    const glm::vec2 middle(lamp.at.x / cell + half, lamp.at.z / cell + half);
    constexpr float kReach = 16;  // m
    const auto low = glm::ivec2(glm::max(middle - kReach / cell, glm::vec2(0))),
               high = glm::ivec2(glm::min(middle + kReach / cell, glm::vec2(static_cast<float>(side - 1))));
    for (int z = low.y; z <= high.y; ++z) {
      for (int x = low.x; x <= high.x; ++x) {
        const float metres = cell * glm::distance(glm::vec2(x, z) + 0.5f, middle), q = metres * metres;
        if (metres >= kReach) continue;
        const float edge = 1 - metres / kReach, much = lamp.strength * edge * 30 / (q + 30);
        const auto i = static_cast<std::size_t>(z * side + x);
        light[i] += much, height[i] += much * lamp.at.y;
      }
    }
  }
  std::vector<std::uint8_t> texels;
  texels.reserve(2 * cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const float high = light[i] > 0 ? height[i] / light[i] : heights.x;
    texels.push_back(byte_of(0.5f * light[i]));
    texels.push_back(byte_of((high - heights.x) / heights.y));
  }
  return texels;
}

}  // namespace coaster::sim
