// Compiles the scene's programs.
#include "gfx/scene_programs.h"

#include "gfx/shader_sources.h"

namespace coaster::gfx {
namespace {

struct Row {
  const char* name;
  Program ScenePrograms::*program;
  const char* defines;
  std::string_view shared;  // after common.glsl, in both stages
  std::string_view vertex, fragment;
};

}  // namespace

base::Result<ScenePrograms> make_scene_programs(const Gl& gl) {
  const Row rows[] = {
      {"ground", &ScenePrograms::ground, "", shade_glsl(), backdrop_vert(), ground_frag()},
      {"ground_shadow", &ScenePrograms::ground_shadow, "", shade_glsl(), backdrop_vert(), ground_shadow_frag()},
      {"sky", &ScenePrograms::sky, "", "", backdrop_vert(), sky_frag()},
      {"solid", &ScenePrograms::solid, "", shade_glsl(), mesh_vert(), mesh_frag()},
      {"outline", &ScenePrograms::outline, "#define OUTLINE\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"shadow", &ScenePrograms::shadow, "#define SHADOW\n", "", mesh_vert(), shadow_frag()},
      {"polyline", &ScenePrograms::polyline, "", line_glsl(), polyline_vert(), line_frag()},
      {"coverage", &ScenePrograms::coverage, "", "", coverage_vert(), coverage_frag()},
      {"line", &ScenePrograms::line, "", line_glsl(), line_vert(), line_frag()},
      {"mark", &ScenePrograms::mark, "", "", mark_vert(), mark_frag()},
  };
  ScenePrograms programs;
  for (const Row& row : rows) {
    const std::string common = row.defines + std::string(common_glsl()) + std::string(row.shared);
    auto program =
        make_program(gl, {.name = row.name, .common = common, .vertex = row.vertex, .fragment = row.fragment});
    if (!program) return program.status();
    programs.*row.program = std::move(*program);
  }
  return programs;
}

}  // namespace coaster::gfx
