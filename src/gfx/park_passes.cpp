// The passes of a park. Light that does not move is computed by vertex and kept; pixels add grain, moving shadows and
// the tone curve, which is what software renderers can afford.
#include "gfx/park_passes.h"

#include <algorithm>
#include <cmath>

#include "gfx/land_cache.h"
#include "gfx/park/grain.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace {

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

constexpr float kHeightLayer = 16;  // m: maps are kept while a track grows by less

}  // namespace

struct ParkPasses::Parts {
  explicit Parts(const Gl& of) : gl(of), land(of) {}
  const Gl& gl;
  LandMesh mesh;
  LandCache land;
  GlObject grain;
  std::vector<VisiblePatch> visible;
  glm::vec2 heights{0};  // m, from the lowest land to the highest caster
  float lowest = 0;      // m, of the land
};

ParkPasses::ParkPasses(const Gl& gl) : parts_(std::make_unique<Parts>(gl)) {}
ParkPasses::~ParkPasses() = default;

bool ParkPasses::shows(const Scene& scene) { return scene.ground != nullptr && !scene.ground->plain(); }

void ParkPasses::upload(const Scene& scene, const SceneStyle& style, DrawStats& stats) {
  Parts& parts = *parts_;
  const sim::Ground& ground = *scene.ground;
  parts.mesh.update(ground, scene.plants, glm::normalize(style.sun), !style.drawing, {});
  const LandCache::UploadStats written = parts.land.sync(ground, parts.mesh);
  stats.park_uploads = written.patches;
  stats.park_upload_bytes = written.bytes;
  if (parts.grain.id() == 0) parts.grain = make_grain_texture(parts.gl);
  float low = static_cast<float>(ground.water() > world::kNoWater ? ground.water() : 1e9), high = -1e9f;
  for (const sim::GroundPatch& patch : ground.patches())
    low = std::min(low, patch.low), high = std::max(high, patch.high + kPlantHeight);
  for (const sim::TrackSample& sample : ground.samples()) high = std::max(high, static_cast<float>(sample.at.y) + 4);
  parts.lowest = kHeightLayer * std::floor(low / kHeightLayer);
  parts.heights = {parts.lowest, kHeightLayer * std::ceil(high / kHeightLayer) - parts.lowest};
}

glm::vec2 ParkPasses::cast_heights() const { return parts_->heights; }

void ParkPasses::look(const PassContext& pass) {
  parts_->visible = visible_patches(parts_->mesh.patches(), pass.view_projection, pass.scene.view.eye, 1);
}

SunShadows::ParkCasters ParkPasses::casters(const PassContext& pass) const {
  (void)pass;
  const auto layers = static_cast<std::uint64_t>(parts_->heights.x / kHeightLayer + 64) * 256 +
                      static_cast<std::uint64_t>(parts_->heights.y / kHeightLayer);
  return {1 + layers, parts_->lowest, [](const glm::mat4&) {}};
}

void ParkPasses::draw_land(const PassContext& pass, const SunShadows& shadows) const {
  const Parts& parts = *parts_;
  const Gl& gl = parts.gl;
  const bool unseen = pass.scene.unseen;
  blend(gl, false);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  const ShaderProgram& program = pass.use(pass.scenery.drawing ? SceneProgram::land_drawing : SceneProgram::land);
  program.set("view_projection", pass.view_projection);
  program.set("eye", pass.scene.view.eye);
  program.set("water", static_cast<float>(pass.scene.ground->water()));
  program.set("cast_heights", parts.heights);
  program.set("grain", kGrainUnit);
  gl.ActiveTexture(GL_TEXTURE0 + kGrainUnit);
  gl.BindTexture(GL_TEXTURE_2D, parts.grain.id());
  gl.ActiveTexture(GL_TEXTURE0);
  shadows.bind(program);
  int track = -1, trains = -1;
  const auto take_shadows = [&](bool by_track, bool by_trains) {
    if (track != int(by_track)) program.set("track_taps", track = int(by_track));
    if (trains != int(by_trains)) program.set("train_taps", trains = int(by_trains));
  };
  for (const VisiblePatch& patch : parts.visible) {
    const LandPatch& land = parts.mesh.patches()[patch.index];
    Box box{land.vertices.front().position, land.vertices.back().position};
    box.low.y = land.low, box.high.y = land.high;
    const bool shaded = pass.scene.shadows && !pass.scenery.drawing;
    take_shadows(shaded && shadows.track().reaches(box), shaded && shadows.trains().reaches(box));
    pass.count(parts.land.draw(parts.mesh, patch, unseen));
  }
  take_shadows(false, false);
  if (const std::int64_t far = parts.land.draw_far(pass.view_projection, unseen); far > 0) pass.count(far);
  gl.Disable(GL_CULL_FACE);
}

}  // namespace coaster::gfx
