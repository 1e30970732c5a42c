#include "gfx/scene_programs.h"

#include <string>
#include <string_view>
#include <utility>

#include "gfx/shader_sources.h"

namespace coaster::gfx {
namespace {

base::Result<Program> make_scene_program(const Gl& gl, std::size_t index) {
  struct Row {
    const char* name;
    const char* defines;
    std::string_view shared;  // after common.glsl, in both stages
    std::string_view vertex, fragment;
  };
  const std::array<Row, kScenePrograms> rows{{
      // in the order of SceneProgram
      {"ground", "", shade_glsl(), backdrop_vert(), ground_frag()},
      {"ground_shadow", "", shade_glsl(), backdrop_vert(), ground_shadow_frag()},
      {"sky", "", "", backdrop_vert(), sky_frag()},
      {"solid", "", shade_glsl(), mesh_vert(), mesh_frag()},
      {"outline", "#define OUTLINE\n", shade_glsl(), mesh_vert(), mesh_frag()},
      {"shadow", "#define SHADOW\n", "", mesh_vert(), shadow_frag()},
      {"polyline", "", line_glsl(), polyline_vert(), line_frag()},
      {"coverage", "", "", coverage_vert(), coverage_frag()},
      {"line", "", line_glsl(), line_vert(), line_frag()},
      {"mark", "", "", mark_vert(), mark_frag()},
  }};
  const Row& row = rows[index];
  const std::string common = row.defines + std::string(common_glsl()) + std::string(row.shared);
  return make_program(gl, {.name = row.name, .common = common, .vertex = row.vertex, .fragment = row.fragment});
}

}  // namespace

const Program& ScenePrograms::use(SceneProgram name) {
  const auto index = static_cast<std::size_t>(name);
  std::optional<Program>& program = programs_[index];
  if (!program) {
    auto made = make_scene_program(*gl_, index);
    if (!made && failure_) failure_ = made.status();
    program = made ? std::move(*made) : Program{};
  }
  gl_->UseProgram(program->object.id());
  return *program;
}

}  // namespace coaster::gfx
