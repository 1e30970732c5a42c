// The passes of a picture. Ground and sky are drawn by shaders that follow the ray of each pixel, track and trains from
// the same buffers as in shadow maps.
#include "gfx/passes.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "gfx/shader_sources.h"
#include "gfx/sun_shadows.h"
#include "sim/ground/ground.h"
#include "sim/solids/materials.h"
#include "sim/solids/track_mesh.h"
#include "view/colour_map.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace {

base::Result<ShaderProgram> make_scene_program(const Gl& gl, std::size_t index) {
  struct Row {
    const char* name;
    const char* defines;
    std::string_view shared;  // after common.glsl, in both stages
    std::string_view vertex, fragment;
  };
  const std::array<Row, kScenePrograms> rows{{
      // in the order of SceneProgram
      {"ground", "", shade_glsl(), backdrop_vert(), ground_frag()},
      {"ground_shadow", "", shade_glsl(), backdrop_vert(), ground_shadow_frag()},
      {"sky", "", "", backdrop_vert(), sky_frag()},
      {"solid", "", shade_glsl(), mesh_vert(), mesh_frag()},
      {"outline", "#define OUTLINE\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"shadow", "#define SHADOW\n", "", mesh_vert(), shadow_frag()},
      {"polyline", "", line_glsl(), polyline_vert(), line_frag()},
      {"coverage", "", "", coverage_vert(), coverage_frag()},
      {"line", "", line_glsl(), line_vert(), line_frag()},
      {"mark", "", "", mark_vert(), mark_frag()},
      {"lawn", "#define NO_GRID\n", shade_glsl(), backdrop_vert(), ground_frag()},
      {"haloed_sky", "#define HALO\n", "", backdrop_vert(), sky_frag()},
      {"park_sky", "#define BEHIND\n#define HALO\n", "", backdrop_vert(), sky_frag()},
      {"lawn_solid", "#define SHADED\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"plain_park_solid", "#define PARK\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"park_solid", "#define PARK\n#define SHADED\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"park_outline", "#define PARK\n#define OUTLINE\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"park_shadow", "#define PARK\n#define SHADOW\n", "", mesh_vert(), shadow_frag()},
      {"land", "", shade_glsl(), park_land_vert(), park_land_frag()},
      {"land_drawing", "#define BLUEPRINT\n", shade_glsl(), park_land_vert(), park_land_frag()},
      {"plant", "", shade_glsl(), park_plant_vert(), park_plant_frag()},
      {"plant_shadow", "#define PARK\n#define SHADOW\n", "", park_plant_vert(), shadow_frag()},
      {"contact", "", "", soft_quad_vert(), soft_quad_frag()},
      {"spray", "#define SPRAY\n", "", soft_quad_vert(), soft_quad_frag()},
      {"water", "", shade_glsl(), park_water_vert(), park_water_frag()},
      {"lamp", "", "", park_lamp_vert(), park_lamp_frag()},
      {"lamp_streak", "#define STREAK\n", "", park_lamp_vert(), park_lamp_frag()},
  }};
  const Row& row = rows[index];
  const std::string common = row.defines + std::string(common_glsl()) + std::string(row.shared);
  return make_program(gl, {.name = row.name, .common = common, .vertex = row.vertex, .fragment = row.fragment});
}

// A convex part of the viewport, -1 to 1, with the number of corners that the shader expects.
struct ViewportPolygon {
  std::array<glm::vec2, 6> corners{};
  int count = 0;
};

// Returns the part where a + b x + c y is not negative.
ViewportPolygon part_of_viewport(float a, float b, float c) {
  constexpr glm::vec2 kCorners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto height = [&](glm::vec2 at) { return a + b * at.x + c * at.y; };
  ViewportPolygon part;
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 from = kCorners[i], to = kCorners[(i + 1) % 4];
    const float before = height(from), after = height(to);
    if (before >= 0) part.corners[static_cast<std::size_t>(part.count++)] = from;
    if ((before >= 0) != (after >= 0))
      part.corners[static_cast<std::size_t>(part.count++)] = glm::mix(from, to, before / (before - after));
  }
  return part;
}

// True for the backdrop that is drawn to measure and to print: with a grid, and a sun without a halo.
bool plain_backdrop(const PassContext& pass) {
  return pass.scene.scenery == world::Scenery::plain || pass.scenery.drawing;
}

struct Rays {
  glm::vec3 forward, right, up;            // right and up: to the viewport's edges at distance 1
  glm::vec3 eye, eye_right{0}, eye_up{0};  // m; origin of the rays, and its change towards the edges
};

void draw_part(const PassContext& pass, const ShaderProgram& program, const Rays& rays, const ViewportPolygon& part) {
  program.set("forward", rays.forward);
  program.set("right", rays.right);
  program.set("up", rays.up);
  program.set("eye", rays.eye);
  program.set("eye_right", rays.eye_right);
  program.set("eye_up", rays.eye_up);
  for (std::size_t i = 0; i < part.corners.size(); ++i)
    program.set(fmt::format("corners[{}]", i).c_str(), part.corners[i]);
  if (!pass.scene.unseen) pass.gl.DrawArrays(GL_TRIANGLE_FAN, 0, part.count);
  pass.count(part.count - 2);
}

// Draws twice: the sunlit ground, which writes depth 0.5 where a shadow may be; then the shadows, only there. Pixels
// without shadow therefore cost little.
void draw_ground(const PassContext& pass, const SunShadows& shadows, const Rays& rays, const ViewportPolygon& part) {
  const Gl& gl = pass.gl;
  const ShaderProgram& ground = pass.use(plain_backdrop(pass) ? SceneProgram::ground : SceneProgram::lawn);
  shadows.bind(ground);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  draw_part(pass, ground, rays, part);
  if (!pass.scene.shadows) {
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    return;
  }
  const ShaderProgram& shadow = pass.use(SceneProgram::ground_shadow);
  shadows.bind(shadow);
  gl.DepthFunc(GL_EQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
  draw_part(pass, shadow, rays, part);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void draw_sky(const PassContext& pass, const Rays& rays, const ViewportPolygon& part) {
  if (part.count < 3) return;
  const view::View& view = pass.scene.view;
  const float by_distance = view.parallel > 0 ? view.parallel : 1;
  const ShaderProgram& program = pass.use(pass.park              ? SceneProgram::park_sky
                                          : plain_backdrop(pass) ? SceneProgram::sky
                                                                 : SceneProgram::haloed_sky);
  program.set("pixel", view::metres_per_pixel(view, 1) / by_distance);
  draw_part(pass, program, rays, part);
}

// Draws the sky of an orthographic view along the ground, and the earth below its horizon.
void draw_parallel_sky(const PassContext& pass, glm::vec3 forward, glm::vec3 right, glm::vec3 up) {
  const view::View& view = pass.scene.view;
  const float middle = view.eye.y / up.y;  // height of the picture's middle over the ground, in halves of the picture
  const glm::vec3 right_at_1 = right / view.parallel, up_at_1 = up / view.parallel;
  const Rays over{forward + middle * up_at_1, right_at_1, up_at_1, {0, 1, 0}},
      under{over.forward, over.right, over.up, {0, -1, 0}};
  draw_sky(pass, over, part_of_viewport(middle, 0, 1));
  draw_sky(pass, under, part_of_viewport(-middle, 0, -1));
}

// An orthographic view from above shows only ground. One along the ground shows it as a line: earth below it, and above
// it the sky of a perspective view with the same horizon.
void draw_parallel_backdrop(const PassContext& pass, const SunShadows& shadows) {
  const view::View& view = pass.scene.view;
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const glm::vec3 right = axes[0] / view.projection[0][0], up = axes[1] / view.projection[1][1];
  if (axes[2].y > 0.5f) {
    const Rays down{-axes[2], glm::vec3(0), glm::vec3(0), view.eye, right, up};
    return draw_ground(pass, shadows, down, part_of_viewport(1, 0, 0));
  }
  draw_parallel_sky(pass, -axes[2], right, up);
}

constexpr float kOutline = 0.9f;    // px, outline of solids in the blueprint style
constexpr float kLeastTube = 1.6f;  // px, smallest half width of distant coloured rails

// Returns the radius in metres per metre of distance that appears `pixels` wide: the projection scales a metre at
// distance one to half the viewport's height times its entry. Exact for the subject of an orthographic view.
float metres_of_pixels(const view::View& view, float pixels) {
  return pixels * view::metres_per_pixel(view, 1) / (view.parallel > 0 ? view.parallel : 1);
}

// Returns the eye used for lighting: above the ground, so that an orthographic view from below is lit as well.
glm::vec3 lit_from(const Scene& scene) {
  glm::vec3 eye = scene.view.eye;
  const double ground = scene.ground != nullptr ? scene.ground->surface(double{eye.x}, double{eye.z}) : 0;
  if (scene.view.parallel > 0) eye.y = std::max(eye.y, static_cast<float>(ground) + view::kLowestEye);
  return eye;
}

constexpr double kTieSpacing = 1.5;  // m, of steel; closer ties vanish no later

// Returns up to which distance a rail is more than two pixels wide, and up to which ties are a pixel apart.
SweptTrack::DetailDistances reach_of(const view::View& view, float detail) {
  const float pixel = metres_of_pixels(view, 1) / detail;
  return {static_cast<float>(sim::kRailRadius) / pixel, static_cast<float>(kTieSpacing) / pixel};
}

// Call with the program in use and its matrix set.
void draw_track(const PassContext& pass, const TrackCache& track) {
  if (!pass.scene.unseen) track.swept().draw();
  pass.stats.draw_calls += track.swept().draw_calls();
  pass.stats.triangles += track.swept().triangles();
  for (const MeshPool* pool : {&track.mesh(), &track.supports().mesh(), &track.buildings()}) {
    if (pool->index_count() == 0) continue;
    pass.stats.draw_calls += pass.scene.unseen ? pool->draw_calls() : pool->draw();
    pass.stats.triangles += pool->triangles();
  }
}

void draw_carts(const PassContext& pass, const CarInstances& instances) {
  if (instances.cars() == 0) return;
  pass.stats.draw_calls += pass.scene.unseen ? instances.car_draw_calls() : instances.draw_cars();
  pass.stats.triangles += instances.car_triangles();
}

// Sets the track's colours: the scene's values, or paint.
void set_colouring(const PassContext& pass, const ShaderProgram& program) {
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

glm::vec3 srgb(world::Colour colour) {
  return glm::vec3(colour.rgb >> 16 & 255, colour.rgb >> 8 & 255, colour.rgb & 255) / 255.0f;
}

// Sets the materials in the document's paint. Painted timber has no varnish.
void set_materials(const PassContext& pass, const ShaderProgram& program, const SectionPaint& paint) {
  constexpr float kTimberGloss = 0.06f;
  const world::CoasterKind kind = pass.scene.derived.made.kind;
  const world::Document* const document = pass.scene.document;
  const world::Paint shown = world::over(document ? document->paint : world::Paint{}, base::row_of(kind).paint);
  const bool timber = sim::form_of(kind).supports == sim::SupportForm::bent;
  std::array<glm::vec4, sim::kMaterialCount> materials;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const sim::MaterialRow& row = sim::kMaterials[i];
    const world::Colour own = row.painted ? shown.of(*row.painted) : world::Colour{};
    const bool wood = timber && (row.painted == world::PaintPart::spine || row.painted == world::PaintPart::supports);
    materials[i] = {own.own() ? srgb(own) : row.colour, wood ? kTimberGloss : row.gloss};
  }
  program.set("materials", materials);
  program.set("own_paints", paint.any() ? 1 : 0);
  program.set("section_paints", kPaintUnit);
}

// Sets what lights the track before the first cars at night.
void set_headlights(const PassContext& pass, const ShaderProgram& program) {
  constexpr std::size_t kMost = 4;
  std::vector<glm::vec4> lights;
  for (const sim::Pose& car : pass.scene.carts)
    if (car.leads && pass.lit && !plain_backdrop(pass) && lights.size() < 2 * kMost)
      lights.insert(lights.end(), {{headlight_of(car), 0}, {glm::vec3(car.frame.forward), 0}});
  program.set("headlight_count", static_cast<int>(lights.size() / 2));
  if (!lights.empty()) program.set("headlights", lights);
}

// Draws everything by a program, without the faces that are `hidden`.
void draw_all(const PassContext& pass, SceneProgram name, GLenum hidden, const TrackCache& track,
              const CarInstances& instances, const SectionPaint& paint, const SunShadows& shadows) {
  pass.gl.CullFace(hidden);
  const ShaderProgram& program = pass.use(name);
  program.set("view_projection", pass.view_projection);
  program.set("eye", lit_from(pass.scene));
  program.set("outline", metres_of_pixels(pass.scene.view, kOutline));
  set_colouring(pass, program);
  set_materials(pass, program, paint);
  shadows.bind(program);
  if (pass.park) {
    program.set("lamp_map", kLampUnit);
    program.set("lamps", pass.lit ? 1 : 0);
    program.set("lamp_square",
                static_cast<float>(pass.scene.ground->tiles_across() * world::kGroundTileCells * world::kGroundCell));
    program.set("cast_heights", pass.cast_heights);
    set_headlights(pass, program);
  }
  draw_track(pass, track);
  draw_carts(pass, instances);
}

constexpr float kPolylineWidth = 1.75f;  // points
constexpr glm::vec4 kPolylineColour{1, 1, 1, 0.9f};

// Draws the polyline's quads: from cached vertices, or from control points by the stage that evaluates them.
void draw_lines(const PassContext& pass, const TrackCache& track, GpuCurves& curves) {
  const view::View& view = pass.scene.view;
  const PolylinePen pen{pass.view_projection,
                        view.eye,
                        {view.viewport.width, view.viewport.height},
                        kPolylineWidth * view.density,
                        kPolylineColour};
  if (pass.stats.drawn_by != curve::EvaluatedBy::processor) {
    for (const CurveSlots& run : track.control_runs()) {
      pass.count(2LL * run.count * run.steps);
      if (!pass.scene.unseen) curves.draw(pass.stats.drawn_by, run, pen);
    }
    return;
  }
  pen.set(pass.use(SceneProgram::polyline));
  track.bind_lines();
  if (!pass.scene.unseen) pass.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, track.line_count());
  pass.count(2LL * track.line_count());
}

}  // namespace

const ShaderProgram& ScenePrograms::use(SceneProgram name) {
  const auto index = static_cast<std::size_t>(name);
  std::optional<ShaderProgram>& program = programs_[index];
  if (!program) {
    auto made = make_scene_program(*gl_, index);
    if (!made && failure_) failure_ = made.status();
    program = made ? std::move(*made) : ShaderProgram{};
  }
  gl_->UseProgram(program->object.id());
  return *program;
}

void draw_backdrop(const PassContext& pass, const SunShadows& shadows) {
  const view::View& view = pass.scene.view;
  blend(pass.gl, false);
  pass.gl.Disable(GL_DEPTH_TEST);
  pass.gl.BindVertexArray(pass.no_attributes);
  if (view.parallel > 0) return draw_parallel_backdrop(pass, shadows);
  // Rows of the view matrix are the camera's axes in the world; the projection is symmetric.
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const Rays rays{-axes[2], axes[0] / view.projection[0][0], axes[1] / view.projection[1][1], view.eye};
  const bool buried = view.eye.y <= 0;  // below the ground: earth all around
  const ViewportPolygon above =
      buried ? part_of_viewport(1, 0, 0) : part_of_viewport(rays.forward.y, rays.right.y, rays.up.y);
  const ViewportPolygon below =
      buried ? ViewportPolygon{} : part_of_viewport(-rays.forward.y, -rays.right.y, -rays.up.y);
  draw_sky(pass, rays, above);
  if (below.count > 2) draw_ground(pass, shadows, rays, below);
}

void draw_sky_behind(const PassContext& pass) {
  const view::View& view = pass.scene.view;
  const glm::mat3 axes = glm::transpose(glm::mat3(view.view));
  const glm::vec3 right = axes[0] / view.projection[0][0], up = axes[1] / view.projection[1][1];
  if (view.parallel > 0 && axes[2].y > 0.5f) return;  // from above there is land everywhere
  blend(pass.gl, false);
  pass.gl.Enable(GL_DEPTH_TEST);
  pass.gl.DepthFunc(GL_LEQUAL);
  pass.gl.DepthMask(GL_FALSE);
  pass.gl.BindVertexArray(pass.no_attributes);
  if (view.parallel > 0) draw_parallel_sky(pass, -axes[2], right, up);
  else draw_sky(pass, {-axes[2], right, up, {0, 1, 0}}, part_of_viewport(1, 0, 0));
  pass.gl.DepthMask(GL_TRUE);
}

sim::EyeSurroundings surroundings_of(const view::View& view) { return {view.eye, reach_of(view, 1).ties}; }

void choose_levels(const Scene& scene, TrackCache& track) {
  constexpr float kUnseen = 0.25f;  // px
  const SweptTrack::DetailDistances reach = reach_of(scene.view, scene.detail);
  track.look_from({scene.view.eye, metres_of_pixels(scene.view, kUnseen / scene.detail), reach.full}, reach.ties);
}

void choose_detail(const Scene& scene, TrackCache& track) {
  const SweptTrack::DetailDistances reach = reach_of(scene.view, scene.detail);
  track.swept().look_from(scene.view.eye, reach);
  track.mesh().look_from(scene.view.eye, reach.full);
  track.supports().mesh().look_from(scene.view.eye, reach.full);
  track.buildings().look_from(scene.view.eye, reach.full);
}

// Sets up the program that draws solids into a shadow map.
void use_casting(const PassContext& pass, const glm::mat4& light) {
  const ShaderProgram& program = pass.use(pass.park ? SceneProgram::park_shadow : SceneProgram::shadow);
  program.set("view_projection", light);
  if (pass.park) program.set("cast_heights", pass.cast_heights);
}

void cast_track(const PassContext& pass, TrackCache& track, const glm::mat4& light, float texel_metres) {
  use_casting(pass, light);
  // Independent of the eye, because a map is kept while it moves.
  const bool unseen = pass.scene.unseen;
  for (const ShadowDrawStats& cast :
       {track.swept().cast(light, texel_metres, unseen), track.mesh().cast(light, unseen),
        track.supports().mesh().cast(light, unseen), track.buildings().cast(light, unseen)}) {
    pass.stats.draw_calls += cast.draw_calls;
    pass.stats.triangles += cast.triangles;
  }
}

void cast_carts(const PassContext& pass, const CarInstances& instances, const glm::mat4& light) {
  use_casting(pass, light);
  draw_carts(pass, instances);
}

glm::vec3 headlight_of(const sim::Pose& car) {
  return glm::vec3(car.position + 1.2 * car.frame.forward + 0.45 * car.frame.up);
}

void draw_solids(const PassContext& pass, const TrackCache& track, const CarInstances& instances, ValueTexture& values,
                 SectionPaint& paint, const SunShadows& shadows) {
  blend(pass.gl, false);
  pass.gl.Enable(GL_DEPTH_TEST);
  pass.gl.DepthFunc(GL_LESS);
  pass.gl.Enable(GL_CULL_FACE);
  values.bind();  // a sampler always needs a texture
  paint.bind(kPaintUnit);
  const SceneProgram outline = pass.park ? SceneProgram::park_outline : SceneProgram::outline;
  if (pass.scenery.drawing) draw_all(pass, outline, GL_FRONT, track, instances, paint, shadows);
  constexpr SceneProgram kSolids[] = {SceneProgram::solid, SceneProgram::lawn_solid, SceneProgram::plain_park_solid,
                                      SceneProgram::park_solid};
  const SceneProgram solid = kSolids[2 * int{pass.park} + int{!plain_backdrop(pass)}];
  draw_all(pass, solid, GL_BACK, track, instances, paint, shadows);
  pass.gl.Disable(GL_CULL_FACE);
}

void draw_polyline(const PassContext& pass, const TrackCache& track, GpuCurves& curves, GpuTimer& timer) {
  if (!pass.scene.show_polyline || pass.scene.derived.order.empty()) return;
  const Gl& gl = pass.gl;
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_FALSE);
  timer.begin();
  draw_lines(pass, track, curves);
  timer.end();
  pass.stats.gpu_ms = timer.ms();
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_DEPTH_TEST);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ZERO);  // keeps the picture opaque
  pass.use(SceneProgram::coverage).set("paint", glm::vec4(glm::vec3(kPolylineColour), 1));
  gl.BindVertexArray(pass.no_attributes);
  if (!pass.scene.unseen) gl.DrawArrays(GL_TRIANGLES, 0, 3);
  pass.count(1);
}

constexpr float kMarkRim = 1.5f;  // points

void draw_overlay(const PassContext& pass, const CarInstances& instances) {
  blend(pass.gl, true);
  pass.gl.Disable(GL_DEPTH_TEST);
  const view::Viewport& viewport = pass.scene.view.viewport;
  const auto draw = [&](SceneProgram name, GLsizei count) {
    if (count == 0) return;
    const ShaderProgram& program = pass.use(name);
    program.set("rim", kMarkRim * pass.scene.view.density);
    program.set("view_projection", pass.view_projection);
    program.set("viewport", glm::vec2(viewport.width, viewport.height));
    if (!pass.scene.unseen) pass.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    pass.count(2LL * count);
  };
  draw(SceneProgram::line, instances.bind_lines());
  draw(SceneProgram::mark, instances.bind_marks());
}

}  // namespace coaster::gfx
