// The versions of OpenGL that a driver is asked for, in this order: some drivers provide exactly that version.
// Tessellation needs the first, everything else the second.
#pragma once

namespace coaster::platform {

struct GlVersion {
  int major = 0, minor = 0;
};
inline constexpr GlVersion kGlVersions[] = {{4, 0}, {3, 3}};

}  // namespace coaster::platform
