// The cart: a tub with a raised nose, two seat backs, a stripe and four wheels on the rails. Flat-shaded but for the wheels.
#include <algorithm>
#include <array>
#include <span>

#include "base/portable_math.h"
#include "sim/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::vec2;
using glm::vec3;

// Counter-clockwise as seen from outside.
void add_face(std::span<const vec3> corners, Part part, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const vec3 corner : corners) mesh.vertices.push_back({corner, normal, static_cast<float>(part)});
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) mesh.indices.insert(mesh.indices.end(), {first, first + i, first + i + 1});
}

// A cross-section of the body: a rectangle with its corners cut off.
struct Section {
  float x, low, high, half_width;
};
std::array<vec3, 8> outline(const Section& s) {
  const float cut = 0.25f * s.half_width, side = s.half_width - cut, drop = 0.22f * (s.high - s.low);
  // Counter-clockwise as seen from the front (+X towards the eye, so +Z is to the left and -Z to the right).
  return {vec3{s.x, s.low, side},          vec3{s.x, s.low, -side},          vec3{s.x, s.low + drop, -s.half_width},
          vec3{s.x, s.high - drop, -s.half_width}, vec3{s.x, s.high, -side}, vec3{s.x, s.high, side},
          vec3{s.x, s.high - drop, s.half_width},  vec3{s.x, s.low + drop, s.half_width}};
}

// Sections from back to front.
void add_loft(std::span<const Section> sections, Part part, Mesh& mesh) {
  for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
    const auto back = outline(sections[i]), front = outline(sections[i + 1]);
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t next = (k + 1) % 8;
      add_face(std::array{back[k], back[next], front[next], front[k]}, part, mesh);
    }
  }
  add_face(outline(sections.back()), part, mesh);
  auto back = outline(sections.front());
  std::reverse(back.begin(), back.end());
  add_face(back, part, mesh);
}

// A block with its upper face moved by `lean` along X.
void add_block(vec3 low, vec3 high, float lean, Part part, Mesh& mesh) {
  const auto corner = [&](int i) {
    return vec3{(i & 1 ? high.x : low.x) + (i & 2 ? lean : 0.0f), i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  };
  for (const auto& face : {std::array{1, 3, 7, 5}, std::array{0, 4, 6, 2}, std::array{2, 6, 7, 3}, std::array{0, 1, 5, 4},
                           std::array{4, 5, 7, 6}, std::array{0, 2, 3, 1}})
    add_face(std::array{corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])}, part, mesh);
}

// A wheel about an axis along Z.
void add_wheel(vec2 centre, float radius, float z_low, float z_high, Mesh& mesh) {
  constexpr std::uint32_t kSides = 16;
  std::array<vec3, kSides> rim_low, rim_high;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const base::SinCos turn = base::sin_cos(2.0 * base::kPi * k / kSides);
    const vec3 normal(turn.cos, turn.sin, 0), at = vec3(centre, 0) + radius * normal;
    rim_low[k] = {at.x, at.y, z_low}, rim_high[k] = {at.x, at.y, z_high};
    for (const vec3 corner : {rim_low[k], rim_high[k]}) mesh.vertices.push_back({corner, normal, static_cast<float>(Part::wheel)});
    const std::uint32_t a = first + 2 * k, b = first + 2 * ((k + 1) % kSides);
    mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, b, b + 1, a + 1});
  }
  add_face(rim_high, Part::wheel, mesh);
  std::reverse(rim_low.begin(), rim_low.end());
  add_face(rim_low, Part::wheel, mesh);
}

}  // namespace

Mesh cart_mesh() {
  Mesh mesh;
  // The tub: low behind the nose, where the riders sit.
  add_loft(std::array{Section{-1.10f, 0.30f, 0.60f, 0.44f}, Section{-1.00f, 0.24f, 0.66f, 0.54f}, Section{0.38f, 0.24f, 0.64f, 0.56f},
                      Section{0.56f, 0.24f, 0.82f, 0.55f}, Section{0.80f, 0.24f, 0.78f, 0.50f}, Section{1.02f, 0.28f, 0.58f, 0.38f},
                      Section{1.10f, 0.34f, 0.46f, 0.24f}},
           Part::body, mesh);
  // Two rows of two seats: backs that lean backwards.
  for (const float x : {-0.34f, -0.92f})
    for (const float z : {-0.26f, 0.26f}) add_block({x, 0.62f, z - 0.20f}, {x + 0.13f, 1.10f, z + 0.20f}, -0.10f, Part::wheel, mesh);
  for (const float z : {-0.570f, 0.555f}) add_block({-0.98f, 0.42f, z}, {0.52f, 0.50f, z + 0.015f}, 0.0f, Part::stripe, mesh);
  add_block({0.575f, 0.795f, -0.09f}, {0.78f, 0.835f, 0.09f}, 0.0f, Part::stripe, mesh);
  // Wheels stand on the rails, whose upper edge is a rail's radius above the plane of their axes.
  constexpr float kWheelRadius = 0.15f;
  for (const float x : {-0.68f, 0.68f})
    for (const float z : {-0.60f, 0.60f})
      add_wheel({x, static_cast<float>(kRailRadius) + kWheelRadius}, kWheelRadius, z - 0.05f, z + 0.05f, mesh);
  return mesh;
}

}  // namespace coaster::sim
