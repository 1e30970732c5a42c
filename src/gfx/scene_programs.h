// The shader programs of a scene's passes, from the sources in shaders/ that the build embeds.
#pragma once

#include "gfx/objects.h"

namespace coaster::gfx {

struct ScenePrograms {
  Program ground, ground_shadow, sky, solid, outline, shadow, polyline, coverage, line, mark;
};

// Code::graphics with the compiler's log if one does not compile.
base::Result<ScenePrograms> make_scene_programs(const Gl& gl);

}  // namespace coaster::gfx
