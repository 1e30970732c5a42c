// Checks of a mesh: whether it is closed, whether it faces outwards, and its volume.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/solids/mesh.h"

namespace coaster::test {

inline bool finite(const sim::Mesh& mesh) {
  for (const sim::MeshVertex& v : mesh.vertices)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(v.position[i]) || !std::isfinite(v.normal[i])) return false;
  return true;
}

// Volume enclosed by the triangles of one part, by the divergence theorem: negative when they are turned inside out.
inline double volume(const sim::Mesh& mesh, sim::Material part, const std::vector<std::uint32_t>& indices) {
  double sum = 0;
  const glm::dvec3 origin(mesh.vertices.at(0).position);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const sim::MeshVertex& a = mesh.vertices.at(indices[i]);
    if (a.part != static_cast<float>(part)) continue;
    const glm::dvec3 b(mesh.vertices.at(indices[i + 1]).position), c(mesh.vertices.at(indices[i + 2]).position);
    sum += glm::dot(glm::dvec3(a.position) - origin, glm::cross(b - origin, c - origin)) / 6;
  }
  return sum;
}
inline double volume(const sim::Mesh& mesh, sim::Material part) { return volume(mesh, part, mesh.indices); }

// Edges that are not gone along as often in one direction as in the other: a closed surface has none. Vertices are the
// same where their positions are, bit for bit.
inline int open_edges(const sim::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
  using G2Unknowns = std::array<float, 3>;
  const auto point = [&](std::uint32_t i) {
    return G2Unknowns{mesh.vertices.at(i).position.x, mesh.vertices.at(i).position.y, mesh.vertices.at(i).position.z};
  };
  std::map<std::pair<G2Unknowns, G2Unknowns>, int> balance;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const G2Unknowns a = point(indices[i + k]), b = point(indices[i + (k + 1) % 3]);
      if (a < b) ++balance[{a, b}];
      if (b < a) --balance[{b, a}];
    }
  int open = 0;
  for (const auto& [edge, count] : balance) open += count != 0;
  return open;
}
inline int open_edges(const sim::Mesh& mesh) { return open_edges(mesh, mesh.indices); }

// Connected solids of a mesh whose faces look inwards: by the sign of the volume of each.
inline int inside_out(const sim::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
  using G2Unknowns = std::array<float, 4>;  // with the part: solids of two parts may touch
  std::map<G2Unknowns, std::size_t> places;
  std::vector<std::size_t> place(mesh.vertices.size()), parent;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const sim::MeshVertex& v = mesh.vertices[i];
    place[i] = places.try_emplace({v.position.x, v.position.y, v.position.z, v.part}, places.size()).first->second;
  }
  parent.resize(places.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i < indices.size(); i += 3)
    for (std::size_t k = 1; k < 3; ++k) parent[root(place[indices[i + k]])] = root(place[indices[i]]);
  std::map<std::size_t, std::pair<glm::dvec3, double>> volumes;  // with a point of each, for precision
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.vertices.at(indices[i + k]).position); };
    auto& [origin, sum] = volumes.try_emplace(root(place[indices[i]]), at(0), 0.0).first->second;
    sum += glm::dot(at(0) - origin, glm::cross(at(1) - origin, at(2) - origin)) / 6;
  }
  int wrong = 0;
  for (const auto& [solid, volume] : volumes) wrong += volume.second < -1e-7;
  return wrong;
}

// Corners whose normal points to the side from which their triangle is clockwise, or whose length is not 1.
inline int wrong_normals(const sim::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
  int wrong = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const sim::MeshVertex *a = &mesh.vertices.at(indices[i]), *b = &mesh.vertices.at(indices[i + 1]),
                          *c = &mesh.vertices.at(indices[i + 2]);
    const glm::vec3 face = glm::cross(b->position - a->position, c->position - a->position);
    for (const sim::MeshVertex* v : {a, b, c}) {
      // Fans over the ends of tubes use the tube's own normals, which are at right angles to them; thin slivers of
      // float positions have any normal.
      if (glm::dot(face, v->normal) < -2e-3f * glm::length(face) - 1e-6f ||
          std::abs(glm::length(v->normal) - 1) > 1e-5f)
        ++wrong;
    }
  }
  return wrong;
}
inline int wrong_normals(const sim::Mesh& mesh) { return wrong_normals(mesh, mesh.indices); }

}  // namespace coaster::test
