// OpenGL state changes that the passes of a picture share, and the position of a viewport in the picture.
#pragma once

#include <algorithm>
#include <cmath>

#include "gfx/gl.h"
#include "view/camera.h"

namespace coaster::gfx {

// Pixels with their origin at the bottom left, inside the picture.
struct Rectangle {
  int x, y, width, height;
};
inline Rectangle pixels_of(const view::Viewport& v, int width, int height) {
  const auto pixel = [](float place, int limit) { return std::clamp(int(std::lround(place)), 0, limit); };
  const int left = pixel(v.x, width), right = pixel(v.x + v.width, width);
  const int top = pixel(v.y, height), bottom = pixel(v.y + v.height, height);
  return {left, height - bottom, right - left, bottom - top};
}

inline void enable(const Gl& gl, GLenum what, bool on) { (on ? gl.Enable : gl.Disable)(what); }

inline void blend(const Gl& gl, bool on) {
  enable(gl, GL_BLEND, on);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace coaster::gfx
