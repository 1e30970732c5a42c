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
  using Place = std::array<float, 3>;
  const auto point = [&](std::uint32_t i) {
    return Place{mesh.vertices.at(i).position.x, mesh.vertices.at(i).position.y, mesh.vertices.at(i).position.z};
  };
  std::map<std::pair<Place, Place>, int> balance;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = point(indices[i + k]), b = point(indices[i + (k + 1) % 3]);
      if (a < b) ++balance[{a, b}];
      if (b < a) --balance[{b, a}];
    }
  int open = 0;
  for (const auto& [edge, count] : balance) open += count != 0;
  return open;
}
inline int open_edges(const sim::Mesh& mesh) { return open_edges(mesh, mesh.indices); }

// Sets of numbers below `size`, which can be joined.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

// The connected solid that each vertex belongs to, as one of its vertices.
inline std::vector<std::size_t> solids_of(const sim::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
  std::map<std::array<float, 4>, std::size_t> places;  // with the part: solids of two parts may touch
  DisjointSets sets(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const sim::MeshVertex& v = mesh.vertices[i];
    sets.join(i, places.try_emplace({v.position.x, v.position.y, v.position.z, v.part}, i).first->second);
  }
  for (std::size_t i = 0; i < indices.size(); i += 3)
    for (std::size_t k = 1; k < 3; ++k) sets.join(indices[i + k], indices[i]);
  std::vector<std::size_t> solids;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) solids.push_back(sets.root(i));
  return solids;
}

// Groups of connected solids that do not touch each other, by the boxes around them with `gap` m: 1 if nothing floats.
inline int separate_groups(const sim::Mesh& mesh, float gap) {
  struct Box {
    glm::vec3 low{1e9f}, high{-1e9f};
  };
  const std::vector<std::size_t> solids = solids_of(mesh, mesh.indices);
  std::map<std::size_t, Box> by_solid;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    Box& box = by_solid[solids[i]];
    box.low = glm::min(box.low, mesh.vertices[i].position);
    box.high = glm::max(box.high, mesh.vertices[i].position);
  }
  std::vector<Box> boxes;
  for (const auto& [solid, box] : by_solid) boxes.push_back(box);
  DisjointSets groups(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (glm::all(glm::lessThan(boxes[i].low - gap, boxes[k].high)) &&
          glm::all(glm::lessThan(boxes[k].low - gap, boxes[i].high)))
        groups.join(i, k);
  int separate = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) separate += groups.root(i) == i;
  return separate;
}

// Connected solids of a mesh whose faces look inwards: by the sign of the volume of each.
inline int inside_out(const sim::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
  const std::vector<std::size_t> solids = solids_of(mesh, indices);
  std::map<std::size_t, std::pair<glm::dvec3, double>> volumes;  // with a point of each, for precision
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.vertices.at(indices[i + k]).position); };
    auto& [origin, sum] = volumes.try_emplace(solids[indices[i]], at(0), 0.0).first->second;
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
