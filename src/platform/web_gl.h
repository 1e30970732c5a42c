// The functions of WebGL 2 by their names in OpenGL ES.
#pragma once

namespace coaster::platform {

// Returns null for functions that a page lacks.
void* web_gl_function(const char* name);

}  // namespace coaster::platform
