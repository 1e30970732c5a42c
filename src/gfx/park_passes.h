// What a park adds to a picture: land, water, plants, tunnels and lamps.
#pragma once

#include <memory>

#include "gfx/passes.h"
#include "gfx/sun_shadows.h"

namespace coaster::gfx {

class ParkPasses {
 public:
  explicit ParkPasses(const Gl& gl);
  ~ParkPasses();

  // True if the scene has a land. The other functions are for such scenes.
  static bool shows(const Scene& scene);
  // Brings the buffers up to date; writes only what changed.
  void upload(const Scene& scene, const SceneStyle& style, DrawStats& stats);
  // Returns the lowest height (m) that shadow maps have to tell apart, and their range.
  glm::vec2 cast_heights() const;
  // Chooses what the view shows; call before the others.
  void look(const PassContext& pass);
  // What casts shadows besides track and trains. Valid as long as `pass`.
  SunShadows::ParkCasters casters(const PassContext& pass) const;

  // Draws land, tunnels and plants, before track and trains; then sky, water and lamps.
  void draw_land(const PassContext& pass, const SunShadows& shadows) const;
  void draw_sky_and_water(const PassContext& pass, const SunShadows& shadows) const;

 private:
  void upload_lamps(const Scene& scene, const SceneStyle& style);
  void draw_patches(const PassContext& pass, const SunShadows& shadows, const ShaderProgram& program, bool water) const;
  void draw_fixtures(const PassContext& pass, const ShaderProgram& program) const;
  void draw_plants(const PassContext& pass, const SunShadows& shadows) const;
  void draw_lamps(const PassContext& pass) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::gfx
