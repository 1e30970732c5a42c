// Triangle meshes and the basic solids that they consist of. Pure functions, independent of the track.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "curve/frames.h"

namespace coaster::sim {

// The material of a triangle: a row of kMaterials (sim/solids/materials.h).
enum class Material : std::uint8_t {
  rail,
  spine,
  tie,
  body,
  stripe,
  wheel,
  support,
  concrete,
  chain,
  fin,
  stator,
  deck,
  seat,
  skin,
  teal,
  sand,
  plum,
  linen,
  hair,
  timber,
  plank,
  handrail,
  chassis
};

struct MeshVertex {
  glm::vec3 position;
  glm::vec3 normal;  // unit
  float part;        // static_cast<float>(Part): the shader selects the colour
  // Of swept track the position on the segment, arc length over length, 0..1. Of other solids how much of the sky is
  // hidden from it, 1 where nothing is left of it; negative values, which make it fall off sooner, count as 0.
  float along = 0;
  float segment = 0;  // the entity's index, set by the drawing code
};

// Triangles are counter-clockwise seen from outside. `coarse` is the same solid for distant views, with the same
// vertices; empty if there is none.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices, coarse;
  void clear() { vertices.clear(), indices.clear(), coarse.clear(); }
  void add_triangles(std::initializer_list<std::uint32_t> corners, bool from_afar) {
    indices.insert(indices.end(), corners);
    if (from_afar) coarse.insert(coarse.end(), corners);
  }
};

// A cross-section for sweeping a solid.
struct Ring {
  glm::dvec3 position{0};
  curve::Frame frame;
  float along = 0;  // arc length over the segment's length
  glm::dvec3 place(double left, double up) const { return position + left * frame.left() + up * frame.up; }
  glm::dvec3 place(glm::dvec2 offset) const { return place(offset.x, offset.y); }
};

// The ends of a tube that are closed by a fan. A tube that continues in another one needs no cap there.
struct Caps {
  bool first = true, last = true;
};

// A tube about the line at `offset` (left, up) from the rings' middle, closed at `caps`; smooth normals. For distant
// views it has `coarse_sides` sides, a divisor of `sides`, and every other ring.
struct Tube {
  glm::dvec2 offset{0};
  double radius = 0.1;
  int sides = 8, coarse_sides = 4;
  Material part{};
  Caps caps{};
};
void add_tube(std::span<const Ring> rings, const Tube& tube, Mesh& mesh);

// Adds a convex outline (left, up), counter-clockwise when looking against the direction of travel, swept along the
// rings: flat sides, and flat ends at `caps`.
void add_extrusion(std::span<const Ring> rings, std::span<const glm::dvec2> outline, Material part, bool from_afar,
                   Mesh& mesh, Caps caps = {});
// Adds the swept rectangle between two opposite corners.
void add_beam(std::span<const Ring> rings, glm::dvec2 a, glm::dvec2 b, Material part, bool from_afar, Mesh& mesh,
              Caps caps = {});

// Adds a flat convex face, counter-clockwise as seen from outside. The normal of a face of zero area is up.
void add_face(std::span<const glm::dvec3> corners, Material part, bool from_afar, Mesh& mesh, float along = 0);

// Adds six flat faces around eight corners: four of one end, counter-clockwise as seen from outside, and the matching
// ones of the other end.
void add_prism(const std::array<glm::dvec3, 4>& near, const std::array<glm::dvec3, 4>& far, Material part,
               bool from_afar, Mesh& mesh, float along = 0);
// Adds a box with half sides `half` along the frame's forward, up and left.
void add_box(glm::dvec3 middle, const curve::Frame& frame, glm::dvec3 half, Material part, bool from_afar, Mesh& mesh);

// Adds a round bar from one point to another, with a radius at each; smooth sides, flat ends. Adds nothing for equal
// points.
void add_bar(glm::dvec3 from, glm::dvec3 to, double from_radius, double to_radius, int sides, Material part,
             bool from_afar, Mesh& mesh);

}  // namespace coaster::sim
