#include "gfx/sun_shadows.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "base/check.h"
#include "sim/solids/coaster_form.h"
#include "sim/solids/supports.h"

namespace coaster::gfx {
namespace {

constexpr float kTrackMargin = sim::kSupportReach + 1, kHangingMargin = 3.2f;  // m
constexpr float kParkDepth = 80;                                               // m, of trees and hills
constexpr float kLargest = 1 << 18;                                            // m, more than the world's width

// Returns the distance from a point to a box; 0 inside.
float distance_to(const LightBox& box, glm::vec3 at) {
  return glm::length(glm::max(glm::max(box.low - at, at - box.high), glm::vec3(0)));
}

float power_of_two(float least, float wanted) {
  float side = least;
  while (side < wanted && side < kLargest) side *= 2;
  return side;
}

constexpr std::size_t kRun = 64;  // segments

LightBox box_of(const SunAxes& axes, const sim::SegmentShape& shape, float ground) {
  LightBox box;
  const curve::Cubic& c = shape.key.cubic;
  const float margin = kTrackMargin + static_cast<float>(std::abs(shape.key.rails));
  for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) {
    box.add(axes.of(p), margin);
    box.add(axes.of({p.x, ground, p.z}), margin);
  }
  return box;
}

LightBox both(const LightBox& a, const LightBox& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

constexpr float kTrackSide = 256, kTrainSide = 16;  // m, the smallest squares

// Returns the texels per side: no more than the picture can show, which matters for small pictures, but so many that
// one is smaller than the track is wide: wider ones shade the track itself where the light grazes it.
int texels_for(const view::Viewport& viewport) {
  int size = 1024;
  while (size < 2048 && static_cast<float>(size) < 2 * std::max(viewport.width, viewport.height)) size *= 2;
  return size;
}

bool same(const sim::Pose& a, const sim::Pose& b) {
  return a.position == b.position && a.frame.forward == b.frame.forward && a.frame.up == b.frame.up &&
         a.length == b.length && a.leads == b.leads && a.group == b.group && a.arms_up == b.arms_up;
}

}  // namespace

SunAxes::SunAxes(glm::vec3 towards_sun) : sun(glm::normalize(towards_sun)) {
  const glm::vec3 level = glm::cross(glm::vec3(0, 1, 0), sun);
  across = glm::length(level) > 1e-4f ? glm::normalize(level) : glm::vec3(1, 0, 0);
  over = glm::cross(sun, across);
}

void LightBox::add(glm::vec3 light, float margin) {
  low = glm::min(low, light - margin);
  high = glm::max(high, light + margin);
}

const LightBox& TrackBox::update(const SunAxes& axes, const sim::DerivedTrack& derived, float ground) {
  looked_at_ = 0;
  std::vector<std::size_t> stale;
  const auto changes = sun_ == axes.sun && ground_ == ground ? derived.changes_since(last_build_) : std::nullopt;
  if (changes) {
    for (const sim::ShapeChange& change : *changes)
      if (const std::size_t run = change.index / kRun; stale.empty() || stale.back() != run) stale.push_back(run);
  } else {
    runs_.resize((derived.order.size() + kRun - 1) / kRun);
    for (std::size_t run = 0; run < runs_.size(); ++run) stale.push_back(run);
  }
  sun_ = axes.sun, ground_ = ground, last_build_ = derived.last_build;
  for (const std::size_t run : stale) {
    const std::size_t begin = run * kRun, end = std::min(begin + kRun, derived.order.size());
    runs_[run] = {};
    for (std::size_t i = begin; i < end; ++i) runs_[run] = both(runs_[run], box_of(axes, derived.shape_at(i), ground));
    looked_at_ += end - begin;
  }
  box_ = {};
  for (const LightBox& run : runs_) box_ = both(box_, run);
  return box_;
}

LightBox light_box(const SunAxes& axes, std::span<const sim::Pose> carts, float margin) {
  LightBox box;
  for (const sim::Pose& cart : carts)
    box.add(axes.of(glm::vec3(cart.position)),
            margin + static_cast<float>(std::max(cart.length - world::kCarLength, 0.0)));
  return box;
}

ShadowFit fit_shadow(const SunAxes& axes, const LightBox& box, float least, glm::vec3 eye, glm::vec3 forward,
                     float deeper) {
  if (box.empty()) return {};
  const glm::vec3 size = box.high - box.low;
  const float whole = power_of_two(least, std::max(size.x, size.y) / 0.87f);  // the middle is off by up to a sixteenth
  const glm::vec3 at = axes.of(eye);
  // Track farther away than a few sides of the square is small on the screen.
  const float seen = power_of_two(least, 2.5f * std::max(distance_to(box, at), std::abs(eye.y)));
  ShadowFit fit;
  fit.side = std::min(whole, seen);
  fit.middle = 0.5f * (box.low + box.high);
  if (fit.side < whole) {
    const glm::vec3 ahead = axes.of(eye + 0.3f * fit.side * forward);
    const glm::vec3 inside = glm::clamp(ahead, glm::min(box.low + 0.5f * fit.side, fit.middle),
                                        glm::max(box.high - 0.5f * fit.side, fit.middle));
    fit.middle = {inside.x, inside.y, fit.middle.z};
  }
  // The depth also moves in steps, so that a dragged knot does not change how everything else is drawn.
  const float step = fit.side / 8, layer = 8;
  fit.middle.x = step * std::round(fit.middle.x / step);
  fit.middle.y = step * std::round(fit.middle.y / step);
  const float far = layer * std::floor((box.low.z - deeper) / layer),
              near = layer * std::ceil((box.high.z + deeper) / layer);
  fit.middle.z = 0.5f * (far + near);
  fit.depth = near - far;
  return fit;
}

glm::mat4 clip_of(const SunAxes& axes, const ShadowFit& fit) {
  // Rows are the light's axes, scaled; depth increases away from the sun.
  const float flat = 2 / fit.side, deep = -2 / fit.depth;
  const glm::vec3 x = flat * axes.across, y = flat * axes.over, z = deep * axes.sun;
  return {glm::vec4(x.x, y.x, z.x, 0), glm::vec4(x.y, y.y, z.y, 0), glm::vec4(x.z, y.z, z.z, 0),
          glm::vec4(-flat * fit.middle.x, -flat * fit.middle.y, -deep * fit.middle.z, 1)};
}

glm::mat4 map_of(const SunAxes& axes, const ShadowFit& fit) {
  return glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f)) * clip_of(axes, fit);
}

void ShadowMap::make(int size) {
  const Gl& gl = *gl_;
  gl.ActiveTexture(GL_TEXTURE0);
  depth_ = make_texture(gl, GL_LINEAR, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  cover_ = make_texture(gl, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RG8, size, size, 0, GL_RG, GL_UNSIGNED_BYTE, nullptr);
  framebuffer_ = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, cover_.id(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
  COASTER_CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                "OpenGL 3.3 requires RG8 and 24-bit depth framebuffers");
}

bool ShadowMap::update(int size, const SunAxes& axes, const ShadowFit& fit, std::uint64_t content, bool unseen,
                       const std::function<void(const glm::mat4&)>& draw) {
  const Key wanted{size, axes.sun, fit, fit.side > 0 ? content : 0};
  const bool news = wanted != wanted_;
  wanted_ = wanted;
  if (unseen && news && fit.side > 0) draw(clip_of(axes, fit));
  if (unseen || wanted == drawn_) return news;
  const Gl& gl = *gl_;
  if (size != drawn_.size) make(size);
  drawn_ = wanted;
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.Viewport(0, 0, size, size);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (fit.side > 0) {
    to_map_ = map_of(axes, fit);
    blend(gl, false);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    // Draws the back faces: a sunlit surface is then a thickness away from the map's depth and cannot shade itself.
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT);
    draw(clip_of(axes, fit));
    gl.CullFace(GL_BACK);
    gl.Disable(GL_CULL_FACE);
  }
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, cover_.id());
  gl.GenerateMipmap(GL_TEXTURE_2D);
  return news;
}

void ShadowMap::bind(const ShaderProgram& program, const char* prefix, int unit) const {
  const Gl& gl = *gl_;
  gl.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
  gl.BindTexture(GL_TEXTURE_2D, depth_.id());
  gl.ActiveTexture(GLenum(GL_TEXTURE0 + unit + 1));
  gl.BindTexture(GL_TEXTURE_2D, cover_.id());
  gl.ActiveTexture(GL_TEXTURE0);
  const std::string name = prefix;
  const float part = 1.0f / static_cast<float>(drawn_.size);
  program.set((name + "_depth").c_str(), unit);
  program.set((name + "_cover").c_str(), unit + 1);
  // An empty map shadows nothing: its matrix puts every point outside.
  program.set((name + "_light").c_str(), drawn_.fit.side > 0 ? to_map_ : glm::mat4(0));
  program.set((name + "_texel").c_str(),
              drawn_.fit.side > 0 ? glm::vec2(drawn_.fit.side * part, part) : glm::vec2(1, part));
}

bool ShadowMap::reaches(const Box& box) const {
  if (drawn_.fit.side <= 0) return false;
  glm::vec2 low(3e38f), high(-3e38f);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 at(corner & 1 ? box.low.x : box.high.x, corner & 2 ? box.low.y : box.high.y,
                       corner & 4 ? box.low.z : box.high.z);
    const glm::vec2 there(to_map_ * glm::vec4(at, 1));
    low = glm::min(low, there), high = glm::max(high, there);
  }
  return low.x < 1 && low.y < 1 && high.x > 0 && high.y > 0;
}

void SunShadows::update(const PassContext& pass, TrackCache& track, const CarInstances& instances,
                        const ParkCasters* park) {
  const Scene& scene = pass.scene;
  const SunAxes axes(pass.scenery.sun);
  const glm::vec3 eye = scene.view.eye, forward = view::line_of_sight(scene.view);
  const world::CoasterKind kind = std::exchange(kind_, scene.derived.made.kind);
  if (kind != kind_ || !std::equal(cars_.begin(), cars_.end(), scene.carts.begin(), scene.carts.end(), same)) {
    cars_.assign(scene.carts.begin(), scene.carts.end());
    ++cars_version_;
  }
  const int texels = scene.shadows ? texels_for(scene.view.viewport) : 4;
  const auto fit = [&](const LightBox& box, float least) {
    return fit_shadow(axes, scene.shadows ? box : LightBox{}, least, eye, forward, park ? kParkDepth : kDepthMargin);
  };
  LightBox casters = track_box_.update(axes, scene.derived, park ? park->lowest : 0);
  if (park && casters.empty())
    for (const float x : {-park->half, park->half})
      for (const float z : {-park->half, park->half}) casters.add(axes.of({x, park->lowest, z}), 0);
  const ShadowFit square = fit(casters, kTrackSide);
  const float texel_metres = square.side / static_cast<float>(texels);
  const auto cast = [&](const glm::mat4& light) {
    cast_track(pass, track, light, texel_metres);
    if (park) park->draw(light);
  };
  const std::uint64_t content = track.mesh_version() + (park ? park->content << 32 : 0);
  if (track_.update(texels, axes, square, content, scene.unseen, cast)) ++pass.stats.shadow_maps;
  const float margin = sim::form_of(kind_).side < 0 ? kHangingMargin : kCarMargin;
  if (trains_.update(texels / 4, axes, fit(light_box(axes, scene.carts, margin), kTrainSide), cars_version_,
                     scene.unseen, [&](const glm::mat4& light) { cast_carts(pass, instances, light); }))
    ++pass.stats.shadow_maps;
}

void SunShadows::bind(const ShaderProgram& program) const {
  program.set("taps", 4);
  track_.bind(program, "track", kTrackShadowUnit);
  trains_.bind(program, "train", kTrainShadowUnit);
}

}  // namespace coaster::gfx
