// The table of polyline evaluators: the methods of Barrett 2012, section 3, each in its textbook form, and later
// methods. Panels, scripts, tests and benchmarks iterate the table. To add a method, write its function and one row in
// evaluators.cpp.
#pragma once

#include <span>
#include <string_view>

#include "curve/cubic.h"

namespace coaster::curve {

inline constexpr int kMinSteps = 1;
inline constexpr int kMaxSteps = 4096;

// Row numbers of the table, stable for settings files.
enum class EvaluatorId : int {};

// Writes the polyline of one segment. `points` and `tangents` hold n+1 entries, n = steps >= 1: vertex i is B(i/n),
// tangent i is B'(i/n) (not normalised). points.front() is exactly p0 and points.back() exactly p3 with every method,
// so joints have no gaps. If `tangents` is empty, only points are written. Other sizes are a programmer error.
using PolylineFunction = void (*)(const PreparedCubic& curve, std::span<glm::vec3> points,
                                  std::span<glm::vec3> tangents);

// Where the displayed points of a method are computed: on the processor, or by a shader from the control points.
// `polyline` of a shader method repeats the shader's arithmetic on the processor, so tests, deviations and picking need
// no GL.
enum class EvaluatedBy { processor, vertex_shader, geometry_shader, tessellation_shader };
struct StageRow {
  std::string_view name, label;  // in scripts; in panels
};
inline constexpr StageRow kStages[] = {{"processor", "Processor"},
                                       {"vertex_shader", "Vertex shader"},
                                       {"geometry_shader", "Geometry shader"},
                                       {"tessellation_shader", "Tessellation shader"}};
constexpr std::span<const StageRow> rows_of(EvaluatedBy) { return kStages; }

struct Evaluator {
  std::string_view name;     // in scripts and files: "bernstein"
  std::string_view label;    // in the panel: "Cubic (Bernstein)"
  std::string_view formula;  // one line for the tooltip
  std::string_view cost;     // operations per point, as the literature counts them
  PolylineFunction polyline;
  // Returns the largest |vertex - exact| in m for `steps` steps of a cubic whose control points are at most `extent`
  // from the origin and whose control polygon is `size` long; derived in evaluators.cpp.
  double (*error_bound)(double extent, double size, int steps);
  EvaluatedBy evaluated_by = EvaluatedBy::processor;
};

std::span<const Evaluator> evaluators();
inline std::span<const Evaluator> rows_of(EvaluatorId) { return evaluators(); }
inline constexpr EvaluatorId kDefaultEvaluator{2};  // Horner

}  // namespace coaster::curve
