// A picture of the track or the trains seen from the sun: depth, for shadows on solids, and coverage with mipmaps, for
// the ground, which is below everything and needs no depth.
#pragma once

#include <functional>

#include "gfx/objects.h"
#include "gfx/shadow_fit.h"

namespace coaster::gfx {

class ShadowMap {
 public:
  explicit ShadowMap(const Gl& gl) : gl_(&gl) {}

  // Redraws the map if its size (texels per side), fit, light or `content` (a number that changes with the casters)
  // differ from the last time. `draw` gets the matrix to clip space, with state and target set. Leaves another
  // framebuffer bound. `unseen`: `draw` only counts, and the map is drawn with the next visible picture. Returns true
  // if the requested map differs from the last call's.
  bool update(int size, const SunAxes& axes, const ShadowFit& fit, std::uint64_t content, bool unseen,
              const std::function<void(const glm::mat4&)>& draw);

  // Binds the textures to units `unit` (depth) and `unit` + 1 (coverage), and sets PREFIX_depth, PREFIX_cover,
  // PREFIX_light and PREFIX_texel of the program in use. Call after update().
  void bind(const Program& program, const char* prefix, int unit) const;

 private:
  void make(int size);

  struct Key {
    int size = 0;
    glm::vec3 sun{0};
    ShadowFit fit;
    std::uint64_t content = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  const Gl* gl_;
  Object framebuffer_, depth_, cover_;
  Key drawn_, wanted_;
  glm::mat4 to_map_{1};
};

}  // namespace coaster::gfx
