#include "gfx/park/visible_patches.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coaster::gfx {
namespace {

constexpr float kFine = 120, kMiddling = 260;  // m up to which steps are 1 and 2
constexpr int kSnap = 4;                       // cells between vertices of a snapped border

}  // namespace

bool may_show(const glm::mat4& m, const Box& box) {
  const auto row = [&](int i) { return glm::vec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  const glm::vec4 w = row(3);
  for (int i = 0; i < 3; ++i) {
    for (const float sign : {1.0f, -1.0f}) {
      const glm::vec4 plane = w + sign * row(i);
      // The corner farthest along the plane's normal.
      const glm::vec3 corner(plane.x > 0 ? box.high.x : box.low.x, plane.y > 0 ? box.high.y : box.low.y,
                             plane.z > 0 ? box.high.z : box.low.z);
      if (glm::dot(glm::vec3(plane), corner) + plane.w < 0) return false;
    }
  }
  return true;
}

float distance_to(const Box& box, glm::vec3 from) {
  return glm::length(glm::max(glm::max(box.low - from, from - box.high), glm::vec3(0)));
}

std::vector<VisiblePatch> visible_patches(std::span<const sim::LandPatch> patches, const glm::mat4& view_projection,
                                          glm::vec3 eye, float near) {
  const int across = static_cast<int>(std::lround(std::sqrt(static_cast<double>(patches.size()))));
  std::vector<Box> boxes(patches.size());
  std::vector<std::uint8_t> steps(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const sim::LandPatch& patch = patches[i];
    boxes[i] = {patch.vertices.front().position, patch.vertices.back().position};
    boxes[i].low.y = patch.low, boxes[i].high.y = patch.high + kPlantHeight;
    const float metres = distance_to(boxes[i], eye);
    steps[i] = metres < near * kFine ? 1 : metres < near * kMiddling ? 2 : 4;
  }
  // A patch with open cells has all its vertices, and so have its neighbours, whose borders it shares.
  const auto around = [&](std::size_t i, auto&& visit) {
    const int x = static_cast<int>(i) % across, z = static_cast<int>(i) / across;
    const std::array<std::array<int, 2>, 4> beside{{{x - 1, z}, {x + 1, z}, {x, z - 1}, {x, z + 1}}};
    for (int side = 0; side < 4; ++side) {
      const auto [column, row] = beside[static_cast<std::size_t>(side)];
      const bool inside = column >= 0 && row >= 0 && column < across && row < across;
      visit(side, inside ? &steps[static_cast<std::size_t>(row * across + column)] : nullptr);
    }
  };
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (!patches[i].open) continue;
    steps[i] = 1;
    around(i, [](int, std::uint8_t* step) {
      if (step) *step = 1;
    });
  }
  std::vector<VisiblePatch> visible;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (!may_show(view_projection, boxes[i])) continue;
    VisiblePatch patch{i, distance_to(boxes[i], eye), steps[i], 0};
    around(i, [&](int side, const std::uint8_t* step) {
      if (steps[i] > 1 || step == nullptr || *step > 1) patch.snapped |= static_cast<std::uint8_t>(1 << side);
    });
    visible.push_back(patch);
  }
  std::ranges::sort(visible, [](const VisiblePatch& a, const VisiblePatch& b) {
    return a.metres != b.metres ? a.metres < b.metres : a.index < b.index;
  });
  return visible;
}

std::vector<std::uint16_t> patch_indices(int step, std::uint8_t snapped) {
  constexpr int kCells = world::kGroundTileCells;
  const auto vertex = [&](int x, int z) {
    const auto snap = [](int v) { return (v + kSnap / 2) / kSnap * kSnap; };
    const bool across = (x == 0 && (snapped & 1)) || (x == kCells && (snapped & 2)),
               along = (z == 0 && (snapped & 4)) || (z == kCells && (snapped & 8));
    if (across) z = snap(z);
    if (along) x = snap(x);
    return static_cast<std::uint16_t>(z * sim::LandPatch::kSide + x);
  };
  std::vector<std::uint16_t> indices;
  const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
  };
  for (int z = 0; z < kCells; z += step) {
    for (int x = 0; x < kCells; x += step) {
      const std::uint16_t a = vertex(x, z), b = vertex(x + step, z), c = vertex(x, z + step),
                          d = vertex(x + step, z + step);
      // Diagonals by turns, so that slopes are not combed to one side.
      if ((x / step + z / step) % 2 == 0) add(a, c, d), add(a, d, b);
      else add(a, c, b), add(b, c, d);
    }
  }
  return indices;
}

}  // namespace coaster::gfx
