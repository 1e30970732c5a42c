// Programs and draw calls of the GPU evaluators. A segment of many steps is split into pieces that fit the stages'
// limits.
#include "gfx/gpu_curves.h"

#include <fmt/format.h>

#include "base/check.h"
#include "gfx/shader_sources.h"
#include "gfx/track_cache.h"

namespace coaster::gfx {
namespace {

using curve::EvaluatedBy;

// Lines per point of the geometry shader (kLines there) and per patch of the tessellator (kLevel there).
constexpr int kGeometryLines = 16, kTessellationLines = 64;

int pieces(int steps, int lines) { return (steps + lines - 1) / lines; }

ProgramSources sources_of(EvaluatedBy stage, bool measuring) {
  ProgramSources sources;
  switch (stage) {
    case EvaluatedBy::geometry_shader:
      sources.name = "gpu_geometry", sources.vertex = gpu_geometry_vert(), sources.geometry = gpu_geometry_geom();
      break;
    case EvaluatedBy::tessellation_shader:
      sources.name = "gpu_tessellation", sources.vertex = gpu_tessellation_vert();
      sources.tessellation_control = gpu_tessellation_tesc(), sources.tessellation_evaluation = gpu_tessellation_tese();
      if (!measuring) sources.geometry = gpu_tessellation_geom();
      break;
    default: sources.name = "gpu_vertex", sources.vertex = gpu_vertex_vert();
  }
  sources.fragment = measuring ? coverage_frag() : line_frag();
  return sources;
}

}  // namespace

void PolylinePen::set(const Program& program) const {
  program.set("view_projection", view_projection);
  program.set("eye", eye);
  program.set("viewport", viewport);
  program.set("width_px", width_px);
  program.set("paint", paint);
}

std::string GpuCurves::refusal(EvaluatedBy stage) const {
  if (stage == EvaluatedBy::geometry_shader && !gl_->has_geometry_shaders())
    return fmt::format("geometry shaders need OpenGL 3.3, the driver has {}", version_text(*gl_));
  if (stage == EvaluatedBy::tessellation_shader && !gl_->has_tessellation())
    return fmt::format("tessellation shaders need OpenGL 4.0, the driver has {}", version_text(*gl_));
  return programs_->failures[static_cast<std::size_t>(stage)];
}

EvaluatedBy GpuCurves::usable(EvaluatedBy wanted) {
  if (wanted == EvaluatedBy::processor || program(wanted, false) != nullptr) return wanted;
  return EvaluatedBy::vertex_shader;
}

// Returns null if the driver lacks the stage or its compiler rejects the program; refusal() says why.
const Program* GpuCurves::program(EvaluatedBy stage, bool measuring) {
  const auto row = static_cast<std::size_t>(stage);
  std::optional<Program>& known = programs_->compiled[row][measuring ? 1 : 0];
  if (known) return &*known;
  if (!refusal(stage).empty()) return nullptr;
  static constexpr const char* kCaptured[] = {"place", "number", "slot"};
  const std::string common = (measuring ? "#define MEASURE\n" : "") + std::string(common_glsl()) +
                             std::string(line_glsl()) + std::string(curve_glsl());
  ProgramSources sources = sources_of(stage, measuring);
  sources.common = common;
  if (measuring) sources.captured = kCaptured;
  auto made = make_program(*gl_, sources);
  if (!made) {
    programs_->failures[row] = made.status().message;
    return nullptr;
  }
  known = std::move(*made);
  return &*known;
}

void GpuCurves::run(EvaluatedBy stage, const CurveSlots& slots, const Program& program, bool measuring) {
  const int steps = slots.steps;
  const std::size_t offset = std::size_t(slots.first) * kControlBytes;
  program.set("steps", steps);
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, slots.buffer);
  if (stage == EvaluatedBy::tessellation_shader) {
    float_attribute(*gl_, 0, 3, sizeof(glm::vec3), offset);
    for (GLuint i = 1; i < 4; ++i) gl_->DisableVertexAttribArray(i);
    gl_->PatchParameteri(GL_PATCH_VERTICES, 4);
    gl_->DrawArraysInstanced(GL_PATCHES, 0, 4 * slots.count, pieces(steps, kTessellationLines));
    return;
  }
  for (GLuint i = 0; i < 4; ++i) float_attribute(*gl_, i, 3, kControlBytes, offset + i * sizeof(glm::vec3), 1);
  if (stage == EvaluatedBy::geometry_shader)
    gl_->DrawArraysInstanced(GL_POINTS, 0, pieces(steps, kGeometryLines), slots.count);
  else if (measuring) gl_->DrawArraysInstanced(GL_POINTS, 0, steps + 1, slots.count);
  else gl_->DrawArraysInstanced(GL_TRIANGLES, 0, 6 * steps, slots.count);
}

void GpuCurves::draw(EvaluatedBy stage, const CurveSlots& slots, const PolylinePen& pen) {
  const Program* const drawing = program(stage, false);
  if (drawing == nullptr) return;
  drawing->use();
  pen.set(*drawing);
  run(stage, slots, *drawing, false);
}

std::size_t GpuCurves::captured_count(EvaluatedBy stage, const CurveSlots& slots) {
  int doubled = 1;
  if (stage == EvaluatedBy::geometry_shader) doubled = pieces(slots.steps, kGeometryLines);
  if (stage == EvaluatedBy::tessellation_shader) doubled = pieces(slots.steps, kTessellationLines);
  return std::size_t(slots.count) * std::size_t(slots.steps + doubled);
}

bool GpuCurves::capture(EvaluatedBy stage, const CurveSlots& slots) {
  const Gl& gl = *gl_;
  const Program* const measuring = program(stage, true);
  if (measuring == nullptr) return false;
  measuring->use();
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  run(stage, slots, *measuring, true);
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  return true;
}

}  // namespace coaster::gfx
