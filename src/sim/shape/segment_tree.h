// A hierarchy of boxes over the segments of a track, to find those near a ray without testing all: four boxes per node,
// four consecutive segments per leaf, so that a processor tests four at a time. Refitted if segments moved, rebuilt if
// they are added or removed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include <glm/vector_relational.hpp>

#include "curve/cubic.h"

namespace coaster::sim {

using FourFloats = std::array<float, 4>;

// Up to four consecutive segments: lane i is segment `first` + i. A segment lies within `radius` of its chord.
struct alignas(64) SegmentBlock {
  std::array<FourFloats, 3> from{}, to{};  // by axis, m: the ends of the chords, exactly p0 and p3
  FourFloats radius{};                     // m, rounded up
  std::int32_t first = 0, count = 0;
  std::int32_t parent = -1, lane = 0;  // the node that contains this block's box, and its lane there
};

// Up to four children, each a node (its index) or a block (the complement ~index). Boxes contain all of the child's
// curves.
struct alignas(64) TreeNode {
  std::array<FourFloats, 6> bounds{};  // m: least x, y, z, greatest x, y, z
  std::array<std::int32_t, 4> child{};
  std::uint32_t lanes = 0;  // bit i: there is a child i; the first bits are set
  std::int32_t parent = -1, lane = 0;
};

// Largest depth for any arrangement of the segments, for far more of them than a document may have.
inline constexpr int kMaxTreeDepth = 48;

inline curve::Box box_of(const TreeNode& node, std::size_t lane) {
  const auto row = [&](std::size_t i) { return node.bounds[i][lane]; };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}

struct SegmentTree {
  std::vector<curve::Cubic> cubics;  // in track order
  std::vector<SegmentBlock> blocks;  // segment i is in blocks[i / 4]
  std::vector<TreeNode> nodes;       // the root first, children after their parents; none without segments
};

// Builds the tree of `cubics` by the surface-area heuristic over blocks. About 0.1 microseconds per segment.
void build_tree(std::vector<curve::Cubic> cubics, SegmentTree& tree);

// Updates the tree after changes of tree.cubics at these indices: their boxes and those up to the root, 0.5
// microseconds per segment, or all boxes in one pass if that is less work. The boxes are the same as in a rebuilt tree;
// the grouping into nodes may differ.
void refit_tree(std::span<const std::size_t> changed, SegmentTree& tree);

// Calls visit(index in the track) for the segments of each block for which meets(box) is true for the block's box and
// all boxes that contain it, until a visit returns false. Returns true if none did.
template <class Meets, class Visit>
bool all_within(const SegmentTree& tree, const Meets& meets, const Visit& visit) {
  if (tree.nodes.empty()) return true;
  std::array<std::int32_t, 4 * kMaxTreeDepth> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const TreeNode& node = tree.nodes[static_cast<std::size_t>(stack[--waiting])];
    for (std::size_t lane = 0; lane < 4 && (node.lanes >> lane & 1u) != 0; ++lane) {
      if (!meets(box_of(node, lane))) continue;
      if (node.child[lane] >= 0) {
        stack[waiting++] = node.child[lane];
        continue;
      }
      const SegmentBlock& block = tree.blocks[static_cast<std::size_t>(~node.child[lane])];
      for (std::int32_t i = 0; i < block.count; ++i)
        if (!visit(static_cast<std::size_t>(block.first + i))) return false;
    }
  }
  return true;
}

// The same for the blocks whose box meets `box`.
template <class Visit>
bool all_near(const SegmentTree& tree, const curve::Box& box, const Visit& visit) {
  return all_within(
      tree,
      [&](const curve::Box& other) {
        return glm::all(glm::lessThanEqual(other.low, box.high)) && glm::all(glm::lessThanEqual(box.low, other.high));
      },
      visit);
}

// Calls visit(index in the track) for the segments of each block, blocks in ascending order of key(box), while
// goes_on(key) is true for the next block. Boxes without a key are left out with all that they contain; a box has no
// smaller key than one that contains it.
template <class Key, class GoesOn, class Visit>
void all_by_key(const SegmentTree& tree, const Key& key, const GoesOn& goes_on, const Visit& visit) {
  using Waiting = std::pair<double, std::int32_t>;  // the key of a node, or of a block (the complement of its index)
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
  const auto add_children = [&](const TreeNode& node) {
    for (std::size_t lane = 0; lane < 4 && (node.lanes >> lane & 1u) != 0; ++lane) {
      const std::optional<double> of_child = key(box_of(node, lane));
      if (of_child) waiting.emplace(*of_child, node.child[lane]);
    }
  };
  if (!tree.nodes.empty()) add_children(tree.nodes.front());
  while (!waiting.empty() && goes_on(waiting.top().first)) {
    const std::int32_t next = waiting.top().second;
    waiting.pop();
    if (next >= 0) {
      add_children(tree.nodes[static_cast<std::size_t>(next)]);
      continue;
    }
    const SegmentBlock& block = tree.blocks[static_cast<std::size_t>(~next)];
    for (std::int32_t i = 0; i < block.count; ++i) visit(static_cast<std::size_t>(block.first + i));
  }
}

// Returns the bounding box of a curve's control points after two subdivisions: it contains the curve, and is too large
// by a few thousandths of it.
curve::Box tight_box(const curve::Cubic& cubic);

}  // namespace coaster::sim
