#include "gfx/shadow_map.h"

#include <string>

#include "base/check.h"

namespace coaster::gfx {

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

void ShadowMap::bind(const Program& program, const char* prefix, int unit) const {
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

}  // namespace coaster::gfx
