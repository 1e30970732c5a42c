// The passes of a park. Light that does not move is computed by vertex and kept; pixels add grain, moving shadows and
// the tone curve, which is what software renderers can afford.
#include "gfx/park_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gfx/land_cache.h"
#include "gfx/mesh_pool.h"
#include "gfx/plant_cache.h"
#include "sim/ground/fixtures.h"
#include "sim/ground/noise.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace {

constexpr int kGrainSide = 256;  // texels

// Noise of `cells` cells along the picture's side, 0..1.
double repeated(int x, int y, int cells, std::uint32_t seed) {
  const double at_x = (x + 0.5) * cells / kGrainSide, at_y = (y + 0.5) * cells / kGrainSide;
  const int i = static_cast<int>(at_x), j = static_cast<int>(at_y);
  const auto value = [&](int dx, int dy) { return sim::random_at((i + dx) % cells, (j + dy) % cells, seed); };
  const double u = sim::smooth_step(0, 1, at_x - i), v = sim::smooth_step(0, 1, at_y - j);
  return sim::mixed(sim::mixed(value(0, 0), value(1, 0), u), sim::mixed(value(0, 1), value(1, 1), u), v);
}

struct Octave {
  int cells;
  double part;
};
std::uint8_t summed(int x, int y, std::initializer_list<Octave> octaves, std::uint32_t seed) {
  double sum = 0;
  for (const Octave& octave : octaves)
    sum += octave.part * repeated(x, y, octave.cells, seed + static_cast<std::uint32_t>(octave.cells));
  return static_cast<std::uint8_t>(std::lround(255 * sum));
}

// Two bytes for each texel: coarse grain, and fine grain, without a seam.
std::vector<std::uint8_t> make_grain() {
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t{2} * kGrainSide * kGrainSide);
  for (int y = 0; y < kGrainSide; ++y) {
    for (int x = 0; x < kGrainSide; ++x) {
      texels.push_back(summed(x, y, {{8, 0.5}, {16, 0.25}, {32, 0.15}, {64, 0.1}}, 1));
      texels.push_back(summed(x, y, {{32, 0.25}, {64, 0.35}, {128, 0.4}}, 1001));
    }
  }
  return texels;
}

// A texture of the grain, with mipmaps.
GlObject make_grain_texture(const Gl& gl) {
  gl.ActiveTexture(GL_TEXTURE0);
  GlObject texture = make_texture(gl, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RG8, kGrainSide, kGrainSide, 0, GL_RG, GL_UNSIGNED_BYTE, make_grain().data());
  gl.GenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

void bind_texture(const Gl& gl, int unit, GLuint texture) {
  gl.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.ActiveTexture(GL_TEXTURE0);
}

constexpr float kHeightLayer = 16;  // m: maps are kept while a track grows by less

// Factor of the distances up to which rich scenery is drawn finely.
float nearness(const PassContext& pass) { return pass.scene.scenery == world::Scenery::rich ? 1.7f : 1; }

// True for orthographic views along the ground. There the land is a backdrop that hides no track.
bool along_ground(const view::View& view) { return view.parallel > 0 && line_of_sight(view).y > -0.5f; }

}  // namespace

struct ParkPasses::Parts {
  explicit Parts(const Gl& of)
      : gl(of),
        land(of),
        plants(of),
        fixture_vertices(of),
        fixture_light(of),
        fixture_indices(of),
        lamp_buffer(of),
        headlight_buffer(of) {}
  const Gl& gl;
  sim::LandMesh mesh;
  LandCache land;
  PlantCache plants;
  bool planted = false;
  sim::FixtureMesh fixtures;  // as uploaded
  GrowingBuffer<sim::LandVertex> fixture_vertices;
  GrowingBuffer<sim::LandLight> fixture_light;
  GrowingBuffer<std::uint32_t> fixture_indices;
  GlObject fixture_array;
  std::uint64_t ground_build = 0, fixture_version = 1;
  bool lit = false;
  std::vector<sim::Lamp> lamps, lights;  // all; those that shine
  GrowingBuffer<glm::vec4> lamp_buffer, headlight_buffer;
  GlObject lamp_array, headlight_array, lamp_map, grain;
  std::vector<VisiblePatch> visible;
  glm::vec2 heights{0};  // m, from the lowest land to the highest caster
  float lowest = 0;      // m, of the land

  std::int64_t write_fixtures(sim::FixtureMesh made);
  void write_glows(std::span<const glm::vec4> glows, GrowingBuffer<glm::vec4>& buffer, GlObject& array);
};

ParkPasses::ParkPasses(const Gl& gl) : parts_(std::make_unique<Parts>(gl)) {}
ParkPasses::~ParkPasses() = default;

bool ParkPasses::shows(const Scene& scene) { return scene.ground != nullptr && !scene.ground->plain(); }

std::int64_t ParkPasses::Parts::write_fixtures(sim::FixtureMesh made) {
  const auto bytes_of = [](const auto& items) { return static_cast<std::int64_t>(items.size() * sizeof(items[0])); };
  fixtures = std::move(made);
  ++fixture_version;
  fixture_vertices.fill(fixtures.vertices);
  fixture_light.fill(fixtures.light);
  fixture_indices.fill(fixtures.indices);
  if (fixture_array.id() == 0) fixture_array = make_vertex_array(gl);
  gl.BindVertexArray(fixture_array.id());
  land_attributes(gl, fixture_vertices.id());
  light_attribute(gl, fixture_light.id(), 0);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, fixture_indices.id());
  gl.BindVertexArray(0);
  return bytes_of(fixtures.vertices) + bytes_of(fixtures.light) + bytes_of(fixtures.indices);
}

void ParkPasses::Parts::write_glows(std::span<const glm::vec4> glows, GrowingBuffer<glm::vec4>& buffer,
                                    GlObject& array) {
  buffer.fill(glows);
  if (array.id() == 0) array = make_vertex_array(gl);
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  float_attribute(gl, 0, 4, sizeof(glm::vec4), 0, 1);
  gl.BindVertexArray(0);
}

// Writes the glow of lamps and their light on solids.
void ParkPasses::upload_lamps(const Scene& scene, const SceneStyle& style) {
  Parts& parts = *parts_;
  const Gl& gl = parts.gl;
  if (parts.lamp_map.id() == 0 || style.night) {
    const bool shine = style.night;
    const int side = shine ? static_cast<int>(scene.ground->tiles_across() * world::kGroundTileCells *
                                              world::kGroundCell / sim::kLampCell)
                           : 1;
    gl.ActiveTexture(GL_TEXTURE0);
    parts.lamp_map = make_texture(gl, GL_LINEAR, GL_LINEAR);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<std::uint8_t> texels =
        shine ? sim::lamp_map(*scene.ground, parts.lights, parts.heights) : std::vector<std::uint8_t>(2);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RG8, side, side, 0, GL_RG, GL_UNSIGNED_BYTE, texels.data());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  }
  std::vector<glm::vec4> glows;
  for (const sim::Lamp& lamp : parts.lights) glows.emplace_back(lamp.at, lamp.strength);
  parts.write_glows(glows, parts.lamp_buffer, parts.lamp_array);
}

void ParkPasses::upload(const Scene& scene, const SceneStyle& style, DrawStats& stats) {
  Parts& parts = *parts_;
  const sim::Ground& ground = *scene.ground;
  if (parts.grain.id() == 0) parts.grain = make_grain_texture(parts.gl);
  const bool moved = std::exchange(parts.ground_build, ground.build()) != ground.build();
  const bool relit = std::exchange(parts.lit, style.night) != style.night || parts.lamp_map.id() == 0;
  if (moved) parts.lamps = sim::lamps_of(ground);
  parts.lights = style.night ? parts.lamps : std::vector<sim::Lamp>();
  Stopwatch watch{scene.clock};
  watch.time([&] { parts.mesh.update(ground, scene.plants, glm::normalize(style.sun), !style.drawing, parts.lights); });
  stats.prepare_ms += 1000 * watch.seconds;
  const LandCache::UploadStats written = parts.land.sync(ground, parts.mesh);
  stats.park_uploads = written.patches;
  stats.park_upload_bytes = written.bytes;
  float low = static_cast<float>(ground.water() > world::kNoWater ? ground.water() : 1e9), high = -1e9f;
  for (const sim::GroundPatch& patch : ground.patches())
    low = std::min(low, patch.low), high = std::max(high, patch.high + kPlantHeight);
  for (const sim::TrackSample& sample : ground.samples()) high = std::max(high, static_cast<float>(sample.at.y) + 4);
  parts.lowest = kHeightLayer * std::floor(low / kHeightLayer);
  parts.heights = {parts.lowest, kHeightLayer * std::ceil(high / kHeightLayer) - parts.lowest};
  if (scene.plants != nullptr) stats.park_upload_bytes += parts.plants.sync(*scene.plants, parts.mesh);
  else if (parts.planted) parts.plants.clear();
  parts.planted = scene.plants != nullptr;
  if (moved || relit) {
    sim::FixtureMesh made = sim::fixture_mesh(ground, parts.lamps, parts.lights);
    if (parts.fixture_array.id() == 0 || made.light != parts.fixtures.light || made.vertices != parts.fixtures.vertices)
      stats.park_upload_bytes += parts.write_fixtures(std::move(made));
    upload_lamps(scene, style);
  }
}

glm::vec2 ParkPasses::cast_heights() const { return parts_->heights; }

void ParkPasses::look(const PassContext& pass) {
  Parts& parts = *parts_;
  parts.visible = visible_patches(parts.mesh.patches(), pass.view_projection, pass.scene.view.eye, nearness(pass));
  pass.stats.park_upload_bytes += parts.land.prepare(parts.mesh, parts.visible);
}

SunShadows::ParkCasters ParkPasses::casters(const PassContext& pass) const {
  const Parts& parts = *parts_;
  const auto layers = static_cast<std::uint64_t>(parts.heights.x / kHeightLayer + 64) * 256 +
                      static_cast<std::uint64_t>(parts.heights.y / kHeightLayer);
  const std::uint64_t content = layers + (parts.plants.version() + parts.fixture_version) * 0x9e3779b1u;
  const auto cast = [&parts, &pass](const glm::mat4& light) {
    const bool unseen = pass.scene.unseen;
    const ShaderProgram& program = pass.use(SceneProgram::plant_shadow);
    program.set("view_projection", light);
    program.set("cast_heights", pass.cast_heights);
    if (!parts.fixtures.indices.empty()) {
      if (!unseen) {
        const Gl& gl = parts.gl;
        gl.BindVertexArray(parts.fixture_array.id());
        gl.VertexAttrib4f(4, 0, 0, 0, 1);
        gl.VertexAttrib4f(5, 1, 0, 0, 0);
        gl.VertexAttrib4f(6, 0.4f, 0, 0, 0);  // as wide as it is
        gl.DrawElements(GL_TRIANGLES, GLsizei(parts.fixtures.indices.size()), GL_UNSIGNED_INT, nullptr);
      }
      pass.count(static_cast<std::int64_t>(parts.fixtures.indices.size() / 3));
    }
    if (!parts.planted) return;
    const PlantCache::Drawn drawn = parts.plants.cast(light, unseen);
    pass.stats.draw_calls += drawn.draw_calls, pass.stats.triangles += drawn.triangles;
  };
  const float half =
      0.5f * static_cast<float>(pass.scene.ground->tiles_across() * world::kGroundTileCells * world::kGroundCell);
  return {content, parts.lowest, half, cast};
}

// Draws the patches in the picture, with the shadow maps where they reach; the water of those that have some.
void ParkPasses::draw_patches(const PassContext& pass, const SunShadows& shadows, const ShaderProgram& program,
                              bool water) const {
  const Parts& parts = *parts_;
  const bool unseen = pass.scene.unseen, shaded = pass.scene.shadows && !pass.scenery.drawing;
  const auto level = static_cast<float>(pass.scene.ground->water());
  program.set("view_projection", pass.view_projection);
  program.set("eye", pass.scene.view.eye);
  program.set("water", level);
  program.set("cast_heights", parts.heights);
  program.set("grain", kGrainUnit);
  bind_texture(parts.gl, kGrainUnit, parts.grain.id());
  shadows.bind(program);
  int track = -1, trains = -1;
  const auto take_shadows = [&](bool by_track, bool by_trains) {
    if (track != int(by_track)) program.set("track_taps", track = int(by_track));
    if (trains != int(by_trains)) program.set("train_taps", trains = int(by_trains));
  };
  for (const VisiblePatch& patch : parts.visible) {
    const sim::LandPatch& land = parts.mesh.patches()[patch.index];
    if (water && land.low >= level) continue;
    Box box = box_of(land, 0);
    if (water) box.low.y = box.high.y = level;
    take_shadows(shaded && shadows.track().reaches(box), shaded && shadows.trains().reaches(box));
    pass.count(parts.land.draw(parts.mesh, patch, unseen));
  }
  take_shadows(false, false);
  if (water && parts.land.far().low >= level) return;
  if (along_ground(pass.scene.view)) return;  // it would hide the track
  if (const std::int64_t far = parts.land.draw_far(pass.view_projection, unseen); far > 0) pass.count(far);
}

void ParkPasses::draw_fixtures(const PassContext& pass, const ShaderProgram& program) const {
  const Parts& parts = *parts_;
  if (parts.fixtures.indices.empty()) return;
  program.set("water", static_cast<float>(world::kNoWater));  // tunnels are dry
  program.set("track_taps", 1);
  program.set("train_taps", 0);
  if (!pass.scene.unseen) {
    parts.gl.Disable(GL_CULL_FACE);  // tubes show through the open land behind a portal
    parts.gl.BindVertexArray(parts.fixture_array.id());
    no_corner(parts.gl);
    parts.gl.DrawElements(GL_TRIANGLES, GLsizei(parts.fixtures.indices.size()), GL_UNSIGNED_INT, nullptr);
    parts.gl.Enable(GL_CULL_FACE);
  }
  pass.count(static_cast<std::int64_t>(parts.fixtures.indices.size() / 3));
}

void ParkPasses::draw_plants(const PassContext& pass, const SunShadows& shadows) const {
  Parts& parts = *parts_;
  const ShaderProgram& program = pass.use(SceneProgram::plant);
  program.set("view_projection", pass.view_projection);
  program.set("eye", pass.scene.view.eye);
  program.set("snow", pass.scene.ground->land().park().land == world::Land::snow ? 0.85f : 0.0f);
  program.set("room", pass.scene.eye_room);
  shadows.bind(program);
  const auto add = [&](const PlantCache::Drawn& drawn) {
    pass.stats.draw_calls += drawn.draw_calls, pass.stats.triangles += drawn.triangles;
  };
  constexpr float kTapped = 150;  // m up to which plants stand in shadows
  int taps = -1, step = 0;
  for (const VisiblePatch& patch : parts.visible) {
    if (patch.metres > sim::kPlantReach.back()) break;
    const Box box = box_of(parts.mesh.patches()[patch.index], kPlantHeight);
    const bool shaded = pass.scene.shadows && patch.metres < kTapped && shadows.track().reaches(box);
    if (taps != int(shaded)) program.set("taps", taps = int(shaded));
    // Coarse land lies lower on ridges than trees stand.
    if (step != patch.step) step = patch.step, program.set("sunk", step == 4 ? 1.0f : step == 2 ? 0.25f : 0.0f);
    add(parts.plants.draw(patch.index, pass.scene.view.eye, nearness(pass), pass.scene.unseen));
  }
  if (pass.scene.scenery != world::Scenery::rich || pass.scene.view.parallel > 0) return;
  program.set("sunk", 0.0f);
  program.set("room", 0.0f);
  program.set("taps", pass.scene.shadows ? 1 : 0);
  parts.gl.Disable(GL_CULL_FACE);
  add(parts.plants.draw_grass(parts.mesh, *pass.scene.ground, pass.view_projection, pass.scene.view.eye,
                              pass.scene.unseen));
  parts.gl.Enable(GL_CULL_FACE);
}

void ParkPasses::draw_land(const PassContext& pass, const SunShadows& shadows) const {
  const Gl& gl = parts_->gl;
  if (along_ground(pass.scene.view)) draw_sky_behind(pass);
  blend(gl, false);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  const ShaderProgram& land = pass.use(pass.scenery.drawing ? SceneProgram::land_drawing : SceneProgram::land);
  draw_patches(pass, shadows, land, false);
  draw_fixtures(pass, land);
  if (parts_->planted && !pass.scenery.drawing && !along_ground(pass.scene.view)) draw_plants(pass, shadows);
  bind_texture(gl, kLampUnit, parts_->lamp_map.id());  // for the track and the trains
  gl.Disable(GL_CULL_FACE);
  if (along_ground(pass.scene.view)) gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void ParkPasses::draw_sky_and_water(const PassContext& pass, const SunShadows& shadows) const {
  const Gl& gl = parts_->gl;
  if (!along_ground(pass.scene.view)) draw_sky_behind(pass);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_FALSE);
  blend(gl, true);
  if (pass.scene.ground->water() > world::kNoWater && !pass.scenery.drawing && !along_ground(pass.scene.view)) {
    const ShaderProgram& water = pass.use(SceneProgram::water);
    water.set("clock", static_cast<float>(std::fmod(pass.scene.seconds, 1000.0)));
    water.set("waves", pass.scene.scenery == world::Scenery::plain ? 0.0f : 1.0f);
    draw_patches(pass, shadows, water, true);
  }
  if (pass.lit) draw_lamps(pass);
  gl.DepthMask(GL_TRUE);
}

void ParkPasses::draw_lamps(const PassContext& pass) const {
  Parts& parts = *parts_;
  const view::View& view = pass.scene.view;
  std::vector<glm::vec4> headlights;
  for (const sim::Pose& car : pass.scene.carts)
    if (car.leads && pass.scene.scenery != world::Scenery::plain) headlights.emplace_back(headlight_of(car), 0.7f);
  parts.write_glows(headlights, parts.headlight_buffer, parts.headlight_array);
  for (const SceneProgram name : {SceneProgram::lamp_streak, SceneProgram::lamp}) {
    if (name == SceneProgram::lamp_streak && pass.scene.ground->water() <= world::kNoWater) continue;
    const ShaderProgram& program = pass.use(name);
    program.set("view_projection", pass.view_projection);
    program.set("eye", view.eye);
    program.set("right", view::right_of(view));
    program.set("up", view::top_of(view));
    program.set("pixel", view::metres_per_pixel(view, 1) / (view.parallel > 0 ? view.parallel : 1));
    program.set("water", static_cast<float>(pass.scene.ground->water()));
    const auto draw = [&](const GlObject& array, std::size_t count) {
      if (count == 0) return;
      parts.gl.BindVertexArray(array.id());
      if (!pass.scene.unseen) parts.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(count));
      pass.count(2 * static_cast<std::int64_t>(count));
    };
    draw(parts.lamp_array, parts.lights.size());
    draw(parts.headlight_array, headlights.size());
  }
}

}  // namespace coaster::gfx
