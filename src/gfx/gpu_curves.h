// Draws the laboratory's polyline from control points, by the shader stage that evaluates it. Programs are compiled at
// first use.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "curve/evaluators.h"
#include "gfx/gl_objects.h"
#include "gfx/track_cache.h"

namespace coaster::gfx {

// Drawing parameters of the polyline's programs besides the curve.
struct PolylinePen {
  glm::mat4 view_projection{1};
  glm::vec3 eye{0};
  glm::vec2 viewport{1};  // px
  float width_px = 1;
  glm::vec4 paint{1};
  void set(const ShaderProgram& program) const;
};

// Slots [first, first + count) of a buffer of control points (48 bytes each), to be evaluated in `steps` steps.
struct CurveSlots {
  GLuint buffer = 0;
  int first = 0, count = 0, steps = 1;
};

class GpuCurves {
 public:
  explicit GpuCurves(const Gl& gl) : GpuCurves(gl, std::make_shared<Programs>()) {}
  // Returns another object in the same context that shares the programs.
  GpuCurves sibling() const { return GpuCurves(*gl_, programs_); }

  // Returns why a stage cannot be used here; empty if it can. The base path needs nothing beyond WebGL 2: the vertex
  // stage always works, the geometry stage in OpenGL, the tessellation stage from OpenGL 4.0 on. A compiler's messages
  // are available after the first use.
  std::string refusal(curve::EvaluatedBy stage) const;
  // Returns the stage itself, or the vertex stage as its substitute, which draws the same picture.
  curve::EvaluatedBy usable(curve::EvaluatedBy wanted);

  // Draws the lines of all slots with the pen; empty slots have no area. `stage` is a usable GPU stage.
  void draw(curve::EvaluatedBy stage, const CurveSlots& slots, const PolylinePen& pen);

  // One vertex of a polyline as computed by a stage and written by transform feedback.
  struct Captured {
    glm::vec3 place;
    float number;  // i of t = i / steps
    float slot;    // counted from CurveSlots::first
  };
  // Returns the number of records that capture() writes: steps + 1 per slot; stages that split a segment into pieces
  // write the joints between these twice.
  static std::size_t captured_count(curve::EvaluatedBy stage, const CurveSlots& slots);
  // Runs the stage without a picture and writes to the buffer bound at binding 0 for transform feedback. Returns false
  // if the driver cannot. No slot may be empty. The reader must check how many records were written: a query for that
  // number is answered only in a later frame in a browser.
  bool capture(curve::EvaluatedBy stage, const CurveSlots& slots);

 private:
  static constexpr std::size_t kStages = 4;
  struct Programs {
    std::array<std::array<std::optional<ShaderProgram>, 2>, kStages> compiled;  // by stage; [1]: the capturing program
    std::array<std::string, kStages> failures;
  };
  GpuCurves(const Gl& gl, std::shared_ptr<Programs> programs)
      : gl_(&gl), array_(make_vertex_array(gl)), programs_(std::move(programs)) {}
  const ShaderProgram* program(curve::EvaluatedBy stage, bool measuring);
  void run(curve::EvaluatedBy stage, const CurveSlots& slots, const ShaderProgram& program, bool measuring);

  const Gl* gl_;
  GlObject array_;
  std::shared_ptr<Programs> programs_;
};

// The deviation of vertices computed by a shader stage from the exact points: captured from the GPU, compared on the
// processor.
class CurveDeviation {
 public:
  explicit CurveDeviation(const Gl& gl) : gl_(&gl), buffer_(make_buffer(gl)) {}

  struct Result {
    double metres = 0;  // m, the largest |vertex - exact point at the same t| (long double) of the measured segments
    int pending = 0;    // segments not yet measured; all of them if the driver cannot capture
  };
  // Measures segments that have not been measured with this stage, shape and resolution, up to kBudget vertices per
  // call (at least one segment), and waits for the GPU. If nothing changed, a call costs one comparison per segment.
  Result update(GpuCurves& curves, curve::EvaluatedBy stage, const TrackCache& track, const sim::DerivedTrack& derived);
  static constexpr int kBudget = 32'768;

 private:
  struct Known {
    TrackCache::Placed placed;
    double metres = 0;
  };
  bool read(GpuCurves& curves, const CurveSlots& slots);
  bool measure(GpuCurves& curves, const CurveSlots& slots, const sim::DerivedTrack& derived,
               std::span<const TrackCache::Placed> placed);

  const Gl* gl_;
  GlObject buffer_;
  curve::EvaluatedBy stage_{};
  int steps_ = 0;
  bool able_ = true;
  std::vector<Known> known_;  // by slot
  std::vector<GpuCurves::Captured> records_;
};

}  // namespace coaster::gfx
