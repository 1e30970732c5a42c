// Programs and draw calls of the GPU evaluators. A segment of many steps is split into pieces that fit the stages'
// limits.
#include "gfx/gpu_curves.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

void PolylinePen::set(const ShaderProgram& program) const {
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
const ShaderProgram* GpuCurves::program(EvaluatedBy stage, bool measuring) {
  const auto row = static_cast<std::size_t>(stage);
  std::optional<ShaderProgram>& known = programs_->compiled[row][measuring ? 1 : 0];
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

void GpuCurves::run(EvaluatedBy stage, const CurveSlots& slots, const ShaderProgram& program, bool measuring) {
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
  const ShaderProgram* const drawing = program(stage, false);
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
  const ShaderProgram* const measuring = program(stage, true);
  if (measuring == nullptr) return false;
  measuring->use();
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  run(stage, slots, *measuring, true);
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  return true;
}

CurveDeviation::Result CurveDeviation::update(GpuCurves& curves, curve::EvaluatedBy stage, const TrackCache& track,
                                              const sim::DerivedTrack& derived) {
  if (stage != stage_ || derived.steps != steps_) known_.clear(), able_ = true;
  stage_ = stage, steps_ = derived.steps;
  const std::span<const TrackCache::Placed> placed = track.placed();
  known_.resize(placed.size());
  const auto changed = [&](std::size_t k) { return placed[k].segment.valid() && known_[k].placed != placed[k]; };
  int room = std::max(kBudget / (steps_ + 1), 1);  // segments
  for (std::size_t k = 0; able_ && room > 0 && k < placed.size(); ++k) {
    if (!changed(k)) continue;
    CurveSlots run{track.control_buffer(), int(k), 1, steps_};
    while (run.count < room && k + 1 < placed.size() && changed(k + 1)) ++run.count, ++k;
    room -= run.count;
    able_ = measure(curves, run, derived, placed);
  }
  Result result;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (!placed[k].segment.valid()) continue;
    if (changed(k)) ++result.pending;
    else result.metres = std::max(result.metres, known_[k].metres);
  }
  return result;
}

// Fills records_; those that the driver did not write keep a slot of -1.
bool CurveDeviation::read(GpuCurves& curves, const CurveSlots& slots) {
  records_.assign(GpuCurves::captured_count(stage_, slots), {glm::vec3(0), 0, -1});
  const auto bytes = GLsizeiptr(records_.size() * sizeof(GpuCurves::Captured));
  gl_->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_.id());
  gl_->BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, records_.data(), GL_DYNAMIC_READ);
  bool done = curves.capture(stage_, slots);
  if (done) {
    const void* const written = gl_->MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    done = written != nullptr;
    if (done) {
      std::memcpy(records_.data(), written, std::size_t(bytes));
      done = gl_->UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER) == GL_TRUE;
    }
  }
  gl_->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  return done;
}

bool CurveDeviation::measure(GpuCurves& curves, const CurveSlots& slots, const sim::DerivedTrack& derived,
                             std::span<const TrackCache::Placed> placed) {
  if (!read(curves, slots)) return false;
  std::vector<double> worst(std::size_t(slots.count), 0.0);  // squared
  std::vector<int> seen(std::size_t(slots.count), 0);
  for (const GpuCurves::Captured& record : records_) {
    const int slot = int(record.slot), number = int(record.number);
    if (slot < 0 || slot >= slots.count || number < 0 || number > slots.steps) return false;
    const curve::Cubic& cubic = derived.shape(placed[std::size_t(slots.first + slot)].segment).key.cubic;
    const glm::dvec3 error = glm::dvec3(record.place) - curve::point_long_double(cubic, double(number) / slots.steps);
    double& most = worst[std::size_t(slot)];
    most = std::max(most, glm::dot(error, error));
    ++seen[std::size_t(slot)];
  }
  if (std::count(seen.begin(), seen.end(), int(records_.size()) / slots.count) != slots.count) return false;
  for (int i = 0; i < slots.count; ++i) {
    const auto slot = std::size_t(slots.first + i);
    known_[slot] = {placed[slot], std::sqrt(worst[std::size_t(i)])};
  }
  return true;
}

}  // namespace coaster::gfx
