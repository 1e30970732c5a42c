// Track and trains: into the picture and into shadow maps, from the same buffers.
#include <algorithm>

#include <fmt/format.h>

#include "gfx/passes.h"
#include "gfx/sun_shadows.h"
#include "sim/solids/track_mesh.h"
#include "view/colour_map.h"

namespace coaster::gfx {
namespace {

constexpr float kOutline = 0.9f;    // px, outline of solids in the blueprint style
constexpr float kLeastTube = 1.6f;  // px, smallest half width of distant coloured rails

// Returns the radius in metres per metre of distance that appears `pixels` wide: the projection scales a metre at
// distance one to half the viewport's height times its entry. Exact for the subject of an orthographic view.
float metres_of_pixels(const view::View& view, float pixels) {
  return pixels * view::metres_per_pixel(view, 1) / (view.parallel > 0 ? view.parallel : 1);
}

// Returns the eye used for lighting: above the ground, so that an orthographic view from below is lit as well.
glm::vec3 lit_from(const view::View& view) {
  return view.parallel > 0 ? glm::vec3(view.eye.x, std::max(view.eye.y, view::kLowestEye), view.eye.z) : view.eye;
}

// Returns up to which distance a rail is more than two pixels wide, and up to which ties are a pixel apart.
SweptTrack::Reach reach_of(const view::View& view, float detail) {
  const float pixel = metres_of_pixels(view, 1) / detail;
  return {static_cast<float>(sim::kRailRadius) / pixel, static_cast<float>(sim::kTieSpacing) / pixel};
}

// Call with the program in use and its matrix set.
void draw_track(const Pass& pass, const TrackCache& track) {
  if (!pass.scene.unseen) track.swept().draw();
  pass.stats.draw_calls += track.swept().draw_calls();
  pass.stats.triangles += track.swept().triangles();
  for (const MeshPool* pool : {&track.mesh(), &track.supports().mesh()}) {
    if (pool->index_count() == 0) continue;
    pass.stats.draw_calls += pass.scene.unseen ? pool->draw_calls() : pool->draw();
    pass.stats.triangles += pool->triangles();
  }
}

void draw_carts(const Pass& pass, const Instances& instances) {
  if (instances.cars() == 0) return;
  pass.stats.draw_calls += pass.scene.unseen ? instances.car_draw_calls() : instances.draw_cars();
  pass.stats.triangles += instances.car_triangles();
}

// Sets the track's colours: the scene's values, or paint.
void set_colouring(const Pass& pass, const Program& program) {
  const sim::TrackValues* const values = pass.scene.values;
  const bool coloured = values != nullptr && !values->values.empty();
  program.set("colouring", coloured ? 1 : 0);
  program.set("values", kValueUnit);
  program.set("least_width", coloured ? metres_of_pixels(pass.scene.view, kLeastTube) : 0.0f);
  if (!coloured) return;
  program.set("value_range", glm::vec2(values->low, values->high));
  program.set("unknown", view::kUnknownColour);
  for (std::size_t i = 0; i < view::kColourStops.size(); ++i)
    program.set(fmt::format("stops[{}]", i).c_str(), view::kColourStops[i]);
}

// Draws everything by a program, without the faces that are `hidden`.
void draw_all(const Pass& pass, SceneProgram name, GLenum hidden, const TrackCache& track, const Instances& instances,
              const SunShadows& shadows) {
  pass.gl.CullFace(hidden);
  const Program& program = pass.use(name);
  program.set("view_projection", pass.view_projection);
  program.set("eye", lit_from(pass.scene.view));
  program.set("outline", metres_of_pixels(pass.scene.view, kOutline));
  set_colouring(pass, program);
  shadows.bind(program);
  draw_track(pass, track);
  draw_carts(pass, instances);
}

}  // namespace

sim::Surroundings surroundings_of(const view::View& view) { return {view.eye, reach_of(view, 1).ties}; }

void choose_levels(const Scene& scene, TrackCache& track) {
  constexpr float kUnseen = 0.25f;  // px
  const SweptTrack::Reach reach = reach_of(scene.view, scene.detail);
  track.look_from({scene.view.eye, metres_of_pixels(scene.view, kUnseen / scene.detail), reach.full}, reach.ties);
}

void choose_detail(const Scene& scene, TrackCache& track) {
  const SweptTrack::Reach reach = reach_of(scene.view, scene.detail);
  track.swept().look_from(scene.view.eye, reach);
  track.mesh().look_from(scene.view.eye, reach.full);
  track.supports().mesh().look_from(scene.view.eye, reach.full);
}

void cast_track(const Pass& pass, TrackCache& track, const glm::mat4& light, float texel_metres) {
  pass.use(SceneProgram::shadow).set("view_projection", light);
  // Independent of the eye, because a map is kept while it moves.
  const bool unseen = pass.scene.unseen;
  for (const Cast& cast : {track.swept().cast(light, texel_metres, unseen), track.mesh().cast(light, unseen),
                           track.supports().mesh().cast(light, unseen)}) {
    pass.stats.draw_calls += cast.draw_calls;
    pass.stats.triangles += cast.triangles;
  }
}

void cast_carts(const Pass& pass, const Instances& instances, const glm::mat4& light) {
  pass.use(SceneProgram::shadow).set("view_projection", light);
  draw_carts(pass, instances);
}

void draw_solids(const Pass& pass, const TrackCache& track, const Instances& instances, ValueTexture& values,
                 const SunShadows& shadows) {
  blend(pass.gl, false);
  pass.gl.Enable(GL_DEPTH_TEST);
  pass.gl.DepthFunc(GL_LESS);
  pass.gl.Enable(GL_CULL_FACE);
  values.bind();  // the sampler always needs a texture
  if (pass.scenery.drawing) draw_all(pass, SceneProgram::outline, GL_FRONT, track, instances, shadows);
  draw_all(pass, SceneProgram::solid, GL_BACK, track, instances, shadows);
  pass.gl.Disable(GL_CULL_FACE);
}

}  // namespace coaster::gfx
