// Bounds of segments and nodes; refitting. segment_tree_build.cpp decides which blocks share a node.
#include "sim/shape/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/shape/segment_tree_parts.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr int kPieces = 4;
using PieceControls = std::array<dvec3, 3 * kPieces + 1>;

// Returns the control points of the curve's four quarters, by de Casteljau: their hull is a sixteenth as far from the
// curve as the whole curve's hull.
PieceControls quarters(const curve::Cubic& cubic) {
  PieceControls out;
  const auto halve = [](const std::array<dvec3, 4>& p, std::array<dvec3, 4>& left, std::array<dvec3, 4>& right) {
    const dvec3 a = 0.5 * (p[0] + p[1]), b = 0.5 * (p[1] + p[2]), c = 0.5 * (p[2] + p[3]), d = 0.5 * (a + b),
                e = 0.5 * (b + c), f = 0.5 * (d + e);
    left = {p[0], a, d, f}, right = {f, e, c, p[3]};
  };
  std::array<dvec3, 4> half[2], quarter[kPieces];
  halve({dvec3(cubic.p0), dvec3(cubic.p1), dvec3(cubic.p2), dvec3(cubic.p3)}, half[0], half[1]);
  halve(half[0], quarter[0], quarter[1]);
  halve(half[1], quarter[2], quarter[3]);
  for (int q = 0; q < kPieces; ++q)
    for (int i = 0; i < 4; ++i) out[3 * q + i] = quarter[q][i];
  return out;
}

float rounded_down(double x) {
  const auto near = static_cast<float>(x);
  return static_cast<double>(near) <= x ? near : std::nextafter(near, -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) {
  const auto near = static_cast<float>(x);
  return static_cast<double>(near) >= x ? near : std::nextafter(near, std::numeric_limits<float>::infinity());
}

curve::Box box_of(const PieceControls& controls) {
  dvec3 low = controls[0], high = controls[0];
  for (const dvec3& p : controls) low = glm::min(low, p), high = glm::max(high, p);
  curve::Box box;
  for (int a = 0; a < 3; ++a) box.low[a] = rounded_down(low[a]), box.high[a] = rounded_up(high[a]);
  return box;
}

double distance_to_chord(dvec3 p, dvec3 from, dvec3 along) {
  const double square = glm::dot(along, along);
  const double s = square > 0 ? std::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - from - s * along);
}

// The distance to the chord is convex, so the curve's distance is at most that of the farthest control point.
float radius_about_chord(const PieceControls& controls) {
  const dvec3 from = controls.front(), along = controls.back() - from;
  double radius = 0;
  for (const dvec3& p : controls) radius = std::max(radius, distance_to_chord(p, from, along));
  return rounded_up(radius * (1 + 1e-9));
}

}  // namespace

curve::Box tight_box(const curve::Cubic& cubic) { return box_of(quarters(cubic)); }

curve::Box fill_block(const SegmentTree& tree, SegmentBlock& block) {
  curve::Box box;
  for (int lane = 0; lane < block.count; ++lane) {
    const curve::Cubic& cubic = tree.cubics[static_cast<std::size_t>(block.first + lane)];
    const PieceControls controls = quarters(cubic);
    for (int a = 0; a < 3; ++a) {
      block.from[a][lane] = cubic.p0[a];
      block.to[a][lane] = cubic.p3[a];
    }
    block.radius[lane] = radius_about_chord(controls);
    const curve::Box one = box_of(controls);
    box = lane == 0 ? one : joined(box, one);
  }
  return box;
}

void put_box(TreeNode& node, int lane, const curve::Box& box) {
  for (int a = 0; a < 3; ++a) node.bounds[a][lane] = box.low[a], node.bounds[3 + a][lane] = box.high[a];
}

curve::Box box_of(const TreeNode& node) {
  curve::Box box = box_of(node, 0);
  for (std::size_t lane = 1; node.lanes >> lane != 0; ++lane) box = joined(box, box_of(node, lane));
  return box;
}

namespace {

void refit_block(SegmentTree& tree, SegmentBlock& block) {
  curve::Box box = fill_block(tree, block);
  for (std::int32_t at = block.parent, lane = block.lane; at >= 0;) {
    TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
    put_box(node, lane, box);
    box = box_of(node);
    lane = node.lane;
    at = node.parent;
  }
}

void refit_all(SegmentTree& tree) {
  for (SegmentBlock& block : tree.blocks)
    put_box(tree.nodes[static_cast<std::size_t>(block.parent)], block.lane, fill_block(tree, block));
  for (std::size_t i = tree.nodes.size(); i-- > 1;)  // children come after their parents
    put_box(tree.nodes[static_cast<std::size_t>(tree.nodes[i].parent)], tree.nodes[i].lane, box_of(tree.nodes[i]));
}

}  // namespace

void refit_tree(std::span<const std::size_t> changed, SegmentTree& tree) {
  if (changed.size() > tree.blocks.size() / 4) return refit_all(tree);
  std::size_t last = tree.blocks.size();
  for (const std::size_t i : changed) {
    if (i / 4 != last) refit_block(tree, tree.blocks[i / 4]);
    last = i / 4;
  }
}

}  // namespace coaster::sim
