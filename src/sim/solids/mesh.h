// Triangle meshes as they are drawn, and the few solids that they are put together from. Pure functions, nothing here
// knows what it builds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "curve/frames.h"

namespace coaster::sim {

// What a triangle is made of: rows of the table of paints in shaders/mesh.frag, in its order.
enum class Part : std::uint8_t {
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
  hair
};

struct MeshVertex {
  glm::vec3 position;
  glm::vec3 normal;   // unit
  float part;         // static_cast<float>(Part): the shader picks the colour
  float along = 0;    // place on the segment, arc length over length, 0..1
  float segment = 0;  // the entity's index, filled in by who draws the track
};

// Triangles are counter-clockwise seen from outside. `coarse` is the same solid from afar, of the same vertices; empty
// where there is no such thing.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices, coarse;
  void clear() { vertices.clear(), indices.clear(), coarse.clear(); }
};

// A cross-section that a solid is swept through.
struct Ring {
  glm::dvec3 position{0};
  curve::Frame frame;
  float along = 0;  // arc length over the segment's
};

// A tube about the line at `offset` (left, up) from the rings' middle, closed by a fan at both ends; smooth normals.
// From afar it has `coarse_sides` sides, which divide `sides`, and every other ring.
struct Tube {
  glm::dvec2 offset{0};
  double radius = 0.1;
  int sides = 8, coarse_sides = 4;
  Part part{};
};
void add_tube(std::span<const Ring> rings, const Tube& tube, Mesh& mesh);

// A convex outline (left, up), counter-clockwise as seen by one who looks against the direction of travel, swept along
// the rings: flat sides and ends.
void add_extrusion(std::span<const Ring> rings, std::span<const glm::dvec2> outline, Part part, bool from_afar,
                   Mesh& mesh);
// The rectangle between two corners.
void add_beam(std::span<const Ring> rings, glm::dvec2 low, glm::dvec2 high, Part part, bool from_afar, Mesh& mesh);

// A flat convex face, counter-clockwise as seen from outside.
void add_face(std::span<const glm::dvec3> corners, Part part, float along, bool from_afar, Mesh& mesh);

// Six flat faces about eight corners: four of one end, counter-clockwise as seen from outside, and those of the other
// end that they are joined to.
void add_prism(const std::array<glm::dvec3, 4>& near, const std::array<glm::dvec3, 4>& far, Part part, float along,
               bool from_afar, Mesh& mesh);
// A box of half sides `half` along the frame's forward, up and left.
void add_box(glm::dvec3 middle, const curve::Frame& frame, glm::dvec3 half, Part part, float along, bool from_afar,
             Mesh& mesh);

// A round bar from one point to another, with a radius at each; smooth sides, flat ends. Equal points add nothing.
void add_bar(glm::dvec3 from, glm::dvec3 to, double from_radius, double to_radius, int sides, Part part, float along,
             bool from_afar, Mesh& mesh);

}  // namespace coaster::sim
