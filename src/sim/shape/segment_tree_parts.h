// Shared by building and refitting a segment tree: bounds of blocks and nodes.
#pragma once

#include <glm/common.hpp>

#include "sim/shape/segment_tree.h"

namespace coaster::sim {

inline curve::Box joined(const curve::Box& a, const curve::Box& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// Writes the chords and radii of the block's segments from tree.cubics; returns the box of all their curves.
curve::Box fill_block(const SegmentTree& tree, SegmentBlock& block);

void put_box(TreeNode& node, int lane, const curve::Box& box);
curve::Box box_of(const TreeNode& node);  // of all its children, at least one

}  // namespace coaster::sim
