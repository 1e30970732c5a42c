// The files of shaders/, embedded by the build: FILE.END is file_end().
#pragma once

#include <cstddef>
#include <string_view>

// clang-format off
#define COASTER_SHADERS(X) \
  X(common_glsl) X(line_glsl) X(shade_glsl) X(curve_glsl) X(backdrop_vert) X(ground_frag) X(ground_shadow_frag) \
  X(sky_frag) X(mesh_vert) X(mesh_frag) X(shadow_frag) X(polyline_vert) X(coverage_vert) X(coverage_frag) \
  X(line_vert) X(line_frag) X(mark_vert) X(mark_frag) X(gpu_vertex_vert) X(gpu_geometry_vert) X(gpu_geometry_geom) \
  X(gpu_tessellation_vert) X(gpu_tessellation_tesc) X(gpu_tessellation_tese) X(gpu_tessellation_geom) \
  X(park_land_vert) X(park_land_frag) X(park_plant_vert) X(park_plant_frag) \
  X(park_water_vert) X(park_water_frag) X(park_lamp_vert) X(park_lamp_frag) X(soft_quad_vert) \
  X(soft_quad_frag)
// clang-format on

namespace coaster::embedded {
#define X(symbol)                      \
  extern const unsigned char symbol[]; \
  extern const std::size_t symbol##_size;
COASTER_SHADERS(X)
#undef X
}  // namespace coaster::embedded

namespace coaster::gfx {
#define X(symbol)                                                                      \
  inline std::string_view symbol() {                                                   \
    return {reinterpret_cast<const char*>(embedded::symbol), embedded::symbol##_size}; \
  }
COASTER_SHADERS(X)
#undef X
}  // namespace coaster::gfx

#undef COASTER_SHADERS
