#include "gfx/park/grain.h"

#include <cmath>
#include <initializer_list>

#include "sim/ground/noise.h"

namespace coaster::gfx {
namespace {

// Noise of `cells` cells along the picture's side, 0..1.
double repeated(int x, int y, int cells, std::uint32_t seed) {
  const double at_x = (x + 0.5) * cells / kGrainSide, at_y = (y + 0.5) * cells / kGrainSide;
  const int i = static_cast<int>(at_x), j = static_cast<int>(at_y);
  const auto value = [&](int dx, int dy) { return sim::random_at((i + dx) % cells, (j + dy) % cells, seed); };
  const double u = sim::smooth_step(0, 1, at_x - i), v = sim::smooth_step(0, 1, at_y - j);
  return sim::mixed(sim::mixed(value(0, 0), value(1, 0), u), sim::mixed(value(0, 1), value(1, 1), u), v);
}

struct Octave {
  int cells;
  double part;
};
std::uint8_t summed(int x, int y, std::initializer_list<Octave> octaves, std::uint32_t seed) {
  double sum = 0;
  for (const Octave& octave : octaves)
    sum += octave.part * repeated(x, y, octave.cells, seed + static_cast<std::uint32_t>(octave.cells));
  return static_cast<std::uint8_t>(std::lround(255 * sum));
}

}  // namespace

std::vector<std::uint8_t> make_grain() {
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t{2} * kGrainSide * kGrainSide);
  for (int y = 0; y < kGrainSide; ++y) {
    for (int x = 0; x < kGrainSide; ++x) {
      texels.push_back(summed(x, y, {{8, 0.5}, {16, 0.25}, {32, 0.15}, {64, 0.1}}, 1));
      texels.push_back(summed(x, y, {{32, 0.25}, {64, 0.35}, {128, 0.4}}, 1001));
    }
  }
  return texels;
}

}  // namespace coaster::gfx
