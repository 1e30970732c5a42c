// Compares the evaluators: the largest distance of their vertices from the exact points, the bound that each promises,
// and one vertex. The last digits of the kernels with eight parameters at once depend on the processor.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <coaster/curve/evaluators.h>

namespace curve = coaster::curve;

int main() {
  constexpr int kSteps = 100;
  const curve::PreparedCubic prepared = curve::prepare({{101.5f, 3, -7}, {104, 9, 2}, {111, -5, 3}, {117, 2, -4}});
  const curve::Cubic& c = prepared.cubic;
  const double size = glm::distance(c.p0, c.p1) + glm::distance(c.p1, c.p2) + glm::distance(c.p2, c.p3);
  double extent = 0;
  for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) extent = std::max<double>(extent, glm::length(p));

  std::vector<glm::vec3> points(kSteps + 1);
  for (const curve::Evaluator& evaluator : curve::evaluators()) {
    if (evaluator.evaluated_by != curve::EvaluatedBy::processor) continue;  // twins of a program's shaders
    evaluator.polyline(prepared, points, {});
    double error = 0;
    for (int i = 0; i <= kSteps; ++i)
      error = std::max(error, glm::distance(glm::dvec3(points[i]), curve::point_long_double(c, 1.0 * i / kSteps)));
    const glm::vec3 middle = points[37];
    std::printf("%s %.9e %.9e %.9g %.9g %.9g\n", std::string(evaluator.name).c_str(), error,
                evaluator.error_bound(extent, size, kSteps), middle.x, middle.y, middle.z);
  }
}
