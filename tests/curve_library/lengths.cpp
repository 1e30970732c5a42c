// The length of a curve, and points at equal distances along it. The cubic is the parabola y = x^2 / 12 from x = 0 to
// 12, whose length has a closed form.
#include <cstdio>

#include <coaster/curve/arc_length.h>

namespace curve = coaster::curve;

int main() {
  const curve::Cubic parabola{{0, 0, 0}, {4, 0, 0}, {8, 4, 0}, {12, 12, 0}};
  const curve::ArcLengthMap map(parabola);
  std::printf("length %.12f\n", map.length());
  const curve::LengthEstimate coarse = curve::measure_arc_length(parabola, 0, 1, 1e-4);
  std::printf("coarse_length %.12f\ncoarse_evaluations %d\n", coarse.length, static_cast<int>(coarse.evaluations));

  constexpr int kParts = 6;
  for (int i = 0; i <= kParts; ++i) {
    const double s = map.length() * i / kParts, t = map.parameter(s);
    const glm::dvec3 p = curve::point(parabola, t);
    std::printf("point %.12f %.12f %.12f\n", s, p.x, p.y);
  }
}
