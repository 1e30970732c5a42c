#include "sim/ground/tunnel_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

constexpr int kTubeSides = 14;                     // of a tube
constexpr float kReveal = 2.0f;                    // m, depth of a portal's opening
constexpr double kWallSide = 2.8, kWallTop = 2.6;  // m of wall beside and over the tube
constexpr glm::vec3 kLining[] = {{0.30f, 0.28f, 0.25f}, {0.24f, 0.225f, 0.20f}};
constexpr glm::vec3 kEarth{0.30f, 0.23f, 0.15f};
constexpr float kHalfTurn = 3.14159265f;

// Stone of walls and trim by land.
struct Stone {
  glm::vec3 wall, trim;
};
Stone stone_of(world::Land land) {
  switch (land) {
    case world::Land::desert: return {{0.42f, 0.27f, 0.17f}, {0.55f, 0.38f, 0.25f}};
    case world::Land::snow: return {{0.33f, 0.34f, 0.36f}, {0.52f, 0.53f, 0.55f}};
    case world::Land::island: return {{0.46f, 0.41f, 0.31f}, {0.58f, 0.53f, 0.43f}};
    default: return {{0.36f, 0.33f, 0.29f}, {0.50f, 0.46f, 0.40f}};
  }
}

class TunnelBuilder {
 public:
  explicit TunnelBuilder(const Ground& ground)
      : ground_(ground),
        stone_(stone_of(ground.land().park().land)),
        radius_(static_cast<float>(ground.room().tube)),
        lift_(static_cast<float>(ground.room().lift)) {}

  void add_tube(const Tunnel& tunnel) {
    const std::span<const TrackSample> samples = ground_.samples();
    const std::size_t count = samples.size();
    const std::size_t rings = (tunnel.last + count - tunnel.first) % count + 1;
    for (std::size_t i = 0; i + 1 < rings; ++i) {
      const TrackSample &a = samples[(tunnel.first + i) % count], &b = samples[(tunnel.first + i + 1) % count];
      const auto from_end = static_cast<float>(std::min(i, rings - 2 - i));
      const float light = std::max(0.42f - 0.05f * from_end, 0.06f);
      const glm::vec3 paint = kLining[i / 2 % 2];
      for (int side = 0; side < kTubeSides; ++side) {
        const float from = 2 * kHalfTurn * static_cast<float>(side) / kTubeSides,
                    to = 2 * kHalfTurn * static_cast<float>(side + 1) / kTubeSides;
        const std::array<glm::vec3, 4> corners{on_ring(a, from), on_ring(a, to), on_ring(b, to), on_ring(b, from)};
        const glm::vec3 middle = 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
        quad(corners, glm::normalize(axis(a) - middle), paint, {light, light, light, light});
      }
    }
  }

  // A wall with an arched opening in the gate's plane; `ring`: the first ring of the tube.
  void add_portal(const TunnelGate& gate, const TrackSample& ring) {
    const glm::vec3 in(static_cast<float>(gate.inwards.x), 0, static_cast<float>(gate.inwards.y)), up(0, 1, 0);
    const glm::vec3 left = glm::cross(up, in);
    const glm::vec3 middle = glm::vec3(gate.at) + lift_ * glm::vec3(ring.up);
    const float inner = radius_ * 0.97f, outer = inner * 1.17f;
    const float side = radius_ + static_cast<float>(kWallSide), top = radius_ + static_cast<float>(kWallTop),
                low = -radius_ - 1.4f;
    constexpr int kParts = 18;
    const float half = 2.35f;  // rad from the top, where the arch ends
    const auto on_arch = [&](float angle, float r, float out) {
      return middle + r * (std::sin(angle) * left + std::cos(angle) * up) - out * in;
    };
    // From the arch to the wall's edge along the same direction.
    const auto on_edge = [&](float angle, float out) {
      const float s = std::sin(angle), c = std::cos(angle);
      float reach = side / std::max(std::fabs(s), 1e-4f);
      reach = std::min(reach, c > 0 ? top / std::max(c, 1e-4f) : low / std::min(c, -1e-4f));
      return middle + reach * (s * left + c * up) - out * in;
    };
    for (int i = 0; i < kParts; ++i) {
      const float from = half * (2.0f * static_cast<float>(i) / kParts - 1),
                  to = half * (2.0f * static_cast<float>(i + 1) / kParts - 1);
      const float shade = 0.9f + 0.2f * static_cast<float>(random_at(i, 3, 1));
      const std::array<float, 4> lit{0.85f, 0.85f, 0.85f, 0.85f}, dark{0.5f, 0.5f, 0.42f, 0.42f};
      quad({on_arch(from, outer, 0), on_arch(to, outer, 0), on_edge(to, 0), on_edge(from, 0)}, -in, shade * stone_.wall,
           lit);
      quad({on_arch(from, inner, 0.25f), on_arch(to, inner, 0.25f), on_arch(to, outer, 0.25f),
            on_arch(from, outer, 0.25f)},
           -in, shade * stone_.trim, {0.95f, 0.95f, 0.95f, 0.95f});
      const glm::vec3 out_of = glm::normalize(on_arch(0.5f * (from + to), 1, 0) - middle);
      quad({on_arch(from, outer, 0.25f), on_arch(to, outer, 0.25f), on_arch(to, outer, 0), on_arch(from, outer, 0)},
           out_of, shade * stone_.trim, {0.9f, 0.9f, 0.7f, 0.7f});
      quad({on_arch(from, inner, 0.25f), on_arch(to, inner, 0.25f), on_arch(to, inner, -kReveal),
            on_arch(from, inner, -kReveal)},
           -out_of, stone_.wall, dark);
    }
    // The wall's edges go back into the hill.
    const std::array<glm::vec2, 4> corners{glm::vec2(-side, low), glm::vec2(-side, top), glm::vec2(side, top),
                                           glm::vec2(side, low)};
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 a = middle + corners[i].x * left + corners[i].y * up,
                      b = middle + corners[i + 1].x * left + corners[i + 1].y * up;
      const glm::vec3 normal = i == 1 ? up : (i == 0 ? -left : left);
      quad({a, b, b + 2.4f * in, a + 2.4f * in}, normal, stone_.wall, {0.9f, 0.9f, 0.7f, 0.7f});
    }
    // A coping stone over the wall.
    const float coping = top + 0.35f, out = 0.3f;
    const auto at = [&](float x, float y, float z) { return middle + x * left + y * up - z * in; };
    const float wide = side + 0.3f;
    quad({at(-wide, top, out), at(wide, top, out), at(wide, coping, out), at(-wide, coping, out)}, -in, stone_.trim,
         {0.95f, 0.95f, 1, 1});
    quad({at(-wide, coping, out), at(wide, coping, out), at(wide, coping, -2.4f), at(-wide, coping, -2.4f)}, up,
         stone_.trim, {1, 1, 0.9f, 0.9f});
    quad({at(-wide, top, out), at(-wide, coping, out), at(-wide, coping, -2.4f), at(-wide, top, -2.4f)}, -left,
         stone_.trim, {0.9f, 1, 0.9f, 0.8f});
    quad({at(wide, top, out), at(wide, coping, out), at(wide, coping, -2.4f), at(wide, top, -2.4f)}, left, stone_.trim,
         {0.9f, 1, 0.9f, 0.8f});
    // Level earth under the track, so that no sky shows through the cells that are left out.
    const auto floor = static_cast<float>(-ground_.room().below);
    const glm::vec3 base = glm::vec3(gate.at) + floor * up;
    const auto apron = [&](float along, float across) { return base + along * in + across * left; };
    const float width = radius_ + 1.1f;
    quad({apron(-4.6f, -width), apron(-4.6f, width), apron(7, width), apron(7, -width)}, up, kEarth,
         {0.9f, 0.9f, 0.2f, 0.2f});
  }

  EarthMesh take() { return std::move(mesh_); }

 private:
  glm::vec3 axis(const TrackSample& sample) const { return glm::vec3(sample.at) + lift_ * glm::vec3(sample.up); }
  glm::vec3 on_ring(const TrackSample& sample, float angle) const {
    const glm::vec3 forward(sample.forward), up(sample.up), left = glm::cross(up, forward);
    return axis(sample) + radius_ * (std::sin(angle) * left + std::cos(angle) * up);
  }
  // Corners in any order around; the quad faces along `normal`.
  void quad(std::array<glm::vec3, 4> corners, glm::vec3 normal, glm::vec3 paint, std::array<float, 4> ambient) {
    const glm::vec3 face = glm::cross(corners[2] - corners[0], corners[3] - corners[1]);
    if (glm::dot(face, normal) < 0) std::swap(corners[1], corners[3]), std::swap(ambient[1], ambient[3]);
    mesh_.add_quad(corners, normal, paint, ambient);
  }

  const Ground& ground_;
  Stone stone_;
  float radius_, lift_;
  EarthMesh mesh_;
};

}  // namespace

void EarthMesh::add_quad(const std::array<glm::vec3, 4>& corners, glm::vec3 normal, glm::vec3 paint,
                         const std::array<float, 4>& ambient) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  for (std::size_t i = 0; i < 4; ++i) vertices.push_back({corners[i], normal, paint, ambient[i]});
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
}

EarthMesh tunnel_mesh(const Ground& ground) {
  TunnelBuilder builder(ground);
  for (std::size_t i = 0; i < ground.tunnels().size(); ++i) {
    const Tunnel& tunnel = ground.tunnels()[i];
    builder.add_tube(tunnel);
    builder.add_portal(ground.gates()[2 * i], ground.samples()[tunnel.first]);
    builder.add_portal(ground.gates()[2 * i + 1], ground.samples()[tunnel.last]);
  }
  return builder.take();
}

bool is_open(const Ground& ground, GroundVertex cell) {
  const glm::dvec2 at = world::kGroundCell * glm::dvec2(cell.x + 0.5, cell.z + 0.5);
  const double tube = ground.room().tube, lift = ground.room().lift;
  for (const TunnelGate& gate : ground.gates()) {
    const double behind = gate.behind(at);
    if (behind < -0.4 || behind > 7 || gate.aside(at) > tube + 0.7) continue;
    double low = 1e9, high = -1e9;
    for (int dz = 0; dz < 2; ++dz) {
      for (int dx = 0; dx < 2; ++dx) {
        const double h =
            ground.height(world::kGroundCell * (cell.x + dx), world::kGroundCell * (cell.z + dz)) - gate.at.y;
        low = std::min(low, h), high = std::max(high, h);
      }
    }
    if (high > lift - tube && low < lift + tube + 0.5) return true;
  }
  return false;
}

}  // namespace coaster::sim
