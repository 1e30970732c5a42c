// Soft quads between ground and solids: contact shadows of footings and platforms, which maps of the sun cannot show,
// and the spray of cars over water.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/passes.h"

namespace coaster::gfx {

class SoftQuads {
 public:
  explicit SoftQuads(const Gl& gl) : gl_(&gl), shadows_(gl), spray_(gl) {}

  // Finds the quads of a scene whose scenery is not plain; those on the ground again only after `solids`, the version
  // of the track's meshes, or the ground changed.
  void upload(const Scene& scene, std::uint64_t solids);
  // Draws on the ground, before solids.
  void draw_contact(const PassContext& pass) const;
  // Draws over everything that hides it.
  void draw_spray(const PassContext& pass) const;

 private:
  struct Quad {
    std::array<glm::vec3, 4> corners;  // m, as of a strip
    glm::vec4 look;                    // see shaders/soft_quad.frag
  };
  struct Batch {
    explicit Batch(const Gl& gl) : buffer(gl) {}
    void fill(const Gl& gl, const std::vector<Quad>& quads);
    GrowingBuffer<Quad> buffer;
    GlObject array;
    GLsizei count = 0;
  };
  void draw(const PassContext& pass, const ShaderProgram& program, const Batch& batch) const;

  const Gl* gl_;
  Batch shadows_, spray_;
  std::array<std::uint64_t, 2> key_{};
};

}  // namespace coaster::gfx
