#include "sim/solids/mesh.h"

#include <algorithm>

#include "base/check.h"
#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;
using Indices = std::vector<std::uint32_t>;

std::uint32_t next_vertex(const Mesh& mesh) { return static_cast<std::uint32_t>(mesh.vertices.size()); }

void add_vertex(dvec3 position, dvec3 normal, Material part, float along, Mesh& mesh) {
  mesh.vertices.push_back({glm::vec3(position), glm::vec3(normal), static_cast<float>(part), along});
}

// Returns the unit circle, counter-clockwise when looking against the direction of travel: x to the left, y up.
std::vector<dvec2> circle(int sides) {
  std::vector<dvec2> out;
  for (int k = 0; k < sides; ++k) {
    const base::SinCos turn = base::sin_cos(2.0 * base::kPi * (k + 0.5) / sides);
    out.push_back({turn.cos, turn.sin});
  }
  return out;
}

// Adds the sides between rings of `count` vertices, of which every `step`-th is used, and a fan over each closed end.
void add_sides(std::span<const std::uint32_t> rings, std::uint32_t count, std::uint32_t step, Caps caps, Indices& out) {
  for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring)
    for (std::uint32_t k = 0; k < count; k += step) {
      const std::uint32_t next = (k + step) % count, a = rings[ring] + k, b = rings[ring] + next,
                          c = rings[ring + 1] + k, d = rings[ring + 1] + next;
      out.insert(out.end(), {a, b, c, b, d, c});
    }
  for (std::uint32_t k = step; k + step < count; k += step) {
    if (caps.first) out.insert(out.end(), {rings.front(), rings.front() + k + step, rings.front() + k});
    if (caps.last) out.insert(out.end(), {rings.back(), rings.back() + k, rings.back() + k + step});
  }
}

}  // namespace

void add_tube(std::span<const Ring> rings, const Tube& tube, Mesh& mesh) {
  COASTER_CHECK(rings.size() >= 2 && tube.sides % tube.coarse_sides == 0,
                "a tube has two rings, and its coarse sides divide its sides");
  const std::vector<dvec2> unit = circle(tube.sides);
  Indices all, every_other;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Ring& at = rings[i];
    all.push_back(next_vertex(mesh));
    if (i % 2 == 0 || i + 1 == rings.size()) every_other.push_back(all.back());
    const dvec3 left = at.frame.left(), up = at.frame.up, centre = at.place(tube.offset);
    for (const dvec2 u : unit) {
      const dvec3 normal = u.x * left + u.y * up;
      add_vertex(centre + tube.radius * normal, normal, tube.part, at.along, mesh);
    }
  }
  const auto sides = static_cast<std::uint32_t>(tube.sides);
  add_sides(all, sides, 1, tube.caps, mesh.indices);
  add_sides(every_other, sides, sides / static_cast<std::uint32_t>(tube.coarse_sides), tube.caps, mesh.coarse);
}

void add_face(std::span<const dvec3> corners, Material part, bool from_afar, Mesh& mesh, float along) {
  dvec3 area(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  const double size = glm::length(area);
  const std::uint32_t first = next_vertex(mesh);
  for (const dvec3& corner : corners)
    add_vertex(corner, size > 1e-12 ? area / size : dvec3(0, 1, 0), part, along, mesh);
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i)
    mesh.add_triangles({first, first + i, first + i + 1}, from_afar);
}

void add_extrusion(std::span<const Ring> rings, std::span<const dvec2> outline, Material part, bool from_afar,
                   Mesh& mesh, Caps caps) {
  const auto place = [&](const Ring& ring, std::size_t k) { return ring.place(outline[k % outline.size()]); };
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const dvec2 side = outline[(k + 1) % outline.size()] - outline[k], out = glm::normalize(dvec2(side.y, -side.x));
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      const dvec3 normal = out.x * rings[i].frame.left() + out.y * rings[i].frame.up;
      const std::uint32_t at = next_vertex(mesh);
      for (const std::size_t end : {k, k + 1}) add_vertex(place(rings[i], end), normal, part, rings[i].along, mesh);
      if (i > 0) mesh.add_triangles({before, before + 1, at, before + 1, at + 1, at}, from_afar);
      before = at;
    }
  }
  std::vector<dvec3> end;
  for (std::size_t k = 0; k < outline.size(); ++k) end.push_back(place(rings.back(), k));
  if (caps.last) add_face(end, part, from_afar, mesh, rings.back().along);
  end.clear();
  for (std::size_t k = outline.size(); k-- > 0;) end.push_back(place(rings.front(), k));
  if (caps.first) add_face(end, part, from_afar, mesh, rings.front().along);
}

void add_beam(std::span<const Ring> rings, dvec2 a, dvec2 b, Material part, bool from_afar, Mesh& mesh, Caps caps) {
  const dvec2 low = glm::min(a, b), high = glm::max(a, b);
  add_extrusion(rings, std::array{low, dvec2(high.x, low.y), high, dvec2(low.x, high.y)}, part, from_afar, mesh, caps);
}

void add_prism(const std::array<dvec3, 4>& near, const std::array<dvec3, 4>& far, Material part, bool from_afar,
               Mesh& mesh, float along) {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    add_face(std::array{near[next], near[k], far[k], far[next]}, part, from_afar, mesh, along);
  }
  add_face(near, part, from_afar, mesh, along);
  add_face(std::array{far[3], far[2], far[1], far[0]}, part, from_afar, mesh, along);
}

void add_box(dvec3 middle, const curve::Frame& frame, dvec3 half, Material part, bool from_afar, Mesh& mesh) {
  const auto corner = [&](double f, double u, double l) {
    return middle + f * half.x * frame.forward + u * half.y * frame.up + l * half.z * frame.left();
  };
  add_prism({corner(1, -1, -1), corner(1, -1, 1), corner(1, 1, 1), corner(1, 1, -1)},
            {corner(-1, -1, -1), corner(-1, -1, 1), corner(-1, 1, 1), corner(-1, 1, -1)}, part, from_afar, mesh);
}

void add_bar(dvec3 from, dvec3 to, double from_radius, double to_radius, int sides, Material part, bool from_afar,
             Mesh& mesh) {
  const double length = glm::length(to - from);
  if (!(length > 1e-6)) return;
  const dvec3 forward = (to - from) / length, up = curve::perpendicular(forward, {0, 1, 0}),
              left = glm::cross(up, forward);
  const double slope = (from_radius - to_radius) / length, shrink = 1 / glm::length(dvec2(1, slope));
  std::vector<dvec3> front, back;
  const std::uint32_t first = next_vertex(mesh), count = static_cast<std::uint32_t>(sides);
  for (const bool at_end : {false, true})
    for (const dvec2 u : circle(sides)) {
      const dvec3 out = u.x * left + u.y * up, place = at_end ? to + to_radius * out : from + from_radius * out;
      add_vertex(place, shrink * (out + slope * forward), part, 0, mesh);
      (at_end ? front : back).push_back(place);
    }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count, a = first + k, b = first + next, c = a + count, d = b + count;
    mesh.add_triangles({a, b, c, b, d, c}, from_afar);
  }
  std::reverse(back.begin(), back.end());
  add_face(front, part, from_afar, mesh);
  add_face(back, part, from_afar, mesh);
}

}  // namespace coaster::sim
