#include "sim/shape/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace coaster::sim {

inline curve::Box joined(const curve::Box& a, const curve::Box& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// Writes the chords and radii of the block's segments from tree.cubics; returns the box of all their curves.
curve::Box fill_block(const SegmentTree& tree, SegmentBlock& block);

void put_box(TreeNode& node, int lane, const curve::Box& box);
curve::Box box_of(const TreeNode& node);  // of all its children, at least one

namespace {

constexpr int kBins = 16;
constexpr int kDeepBeforeHalving = 24;  // deeper ranges are split in equal halves, which bounds the depth

struct Item {
  curve::Box box;
  glm::vec3 middle{0};
  std::int32_t block = 0;
};

// Returns half the surface of the box, enlarged by the reach of a ray, so that boxes of straights along an axis differ.
float surface(const curve::Box& box) {
  const glm::vec3 d = box.high - box.low + 0.1f;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

curve::Box box_of(std::span<const Item> items) {
  curve::Box box = items[0].box;
  for (const Item& item : items) box = joined(box, item.box);
  return box;
}

struct Bin {
  curve::Box box;
  int count = 0;
  void add(const curve::Box& more, int items) {
    if (items == 0) return;
    box = count == 0 ? more : joined(box, more);
    count += items;
  }
  float cost() const { return surface(box) * static_cast<float>(count); }
};

// The bins of a range's middles along one axis.
struct Binning {
  int axis = 0;
  float low = 0, scale = 0;
  int bin_of(const Item& item) const {
    return std::min(static_cast<int>((item.middle[axis] - low) * scale), kBins - 1);
  }
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  Binning binning;
  int bin = 0;  // the first of the second part
};

void try_axis(std::span<const Item> items, const Binning& binning, Split& best) {
  std::array<Bin, kBins> bins{};
  for (const Item& item : items) bins[static_cast<std::size_t>(binning.bin_of(item))].add(item.box, 1);
  std::array<Bin, kBins> rest{};  // [i]: bins i and above
  rest.back() = bins.back();
  for (std::size_t i = kBins - 1; i-- > 1;) {
    rest[i] = rest[i + 1];
    rest[i].add(bins[i].box, bins[i].count);
  }
  Bin left;
  for (std::size_t i = 1; i < kBins; ++i) {
    left.add(bins[i - 1].box, bins[i - 1].count);
    if (left.count == 0 || rest[i].count == 0) continue;
    const float cost = left.cost() + rest[i].cost();
    if (cost < best.cost) best = {cost, binning, static_cast<int>(i)};
  }
}

// Partitions `items` and returns the start of the second part; both parts are not empty.
std::size_t split(std::span<Item> items, bool halve) {
  glm::vec3 low = items[0].middle, high = low;
  for (const Item& item : items) low = glm::min(low, item.middle), high = glm::max(high, item.middle);
  Split best;
  if (!halve)
    for (int axis = 0; axis < 3; ++axis)
      if (high[axis] - low[axis] > 1e-6f) try_axis(items, {axis, low[axis], kBins / (high[axis] - low[axis])}, best);
  if (best.cost < std::numeric_limits<float>::infinity()) {
    const auto second = std::partition(items.begin(), items.end(),
                                       [&](const Item& item) { return best.binning.bin_of(item) < best.bin; });
    return static_cast<std::size_t>(second - items.begin());
  }
  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), middle, items.end(), [&](const Item& a, const Item& b) {
    return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.block < b.block;
  });
  return items.size() / 2;
}

// Up to four parts of a range: the part with the largest surface is split until there are four.
struct Parts {
  std::array<std::span<Item>, 4> items;
  std::array<curve::Box, 4> boxes;
  int count = 1;
};

Parts parts_of(std::span<Item> items, int depth) {
  Parts parts;
  parts.items[0] = items;
  parts.boxes[0] = box_of(items);
  while (parts.count < 4) {
    int widest = -1;
    for (int i = 0; i < parts.count; ++i)
      if (parts.items[i].size() > 1 && (widest < 0 || surface(parts.boxes[i]) > surface(parts.boxes[widest])))
        widest = i;
    if (widest < 0) break;
    const std::span<Item> whole = parts.items[widest];
    const std::size_t at = split(whole, depth >= kDeepBeforeHalving);
    parts.items[widest] = whole.first(at), parts.items[parts.count] = whole.subspan(at);
    parts.boxes[widest] = box_of(parts.items[widest]), parts.boxes[parts.count] = box_of(parts.items[parts.count]);
    ++parts.count;
  }
  return parts;
}

std::int32_t add_node(std::span<Item> items, int depth, SegmentTree& tree) {
  const auto index = static_cast<std::int32_t>(tree.nodes.size());
  tree.nodes.emplace_back();
  const Parts parts = parts_of(items, depth);
  for (int lane = 0; lane < parts.count; ++lane) {
    std::int32_t child = 0;
    if (parts.items[lane].size() == 1) {
      SegmentBlock& block = tree.blocks[static_cast<std::size_t>(parts.items[lane][0].block)];
      block.parent = index, block.lane = lane;
      child = ~parts.items[lane][0].block;
    } else {
      child = add_node(parts.items[lane], depth + 1, tree);
      tree.nodes[static_cast<std::size_t>(child)].parent = index;
      tree.nodes[static_cast<std::size_t>(child)].lane = lane;
    }
    TreeNode& node = tree.nodes[static_cast<std::size_t>(index)];  // adding nodes may have moved it
    node.child[lane] = child;
    node.lanes |= 1u << lane;
    put_box(node, lane, parts.boxes[lane]);
  }
  return index;
}

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

void build_tree(std::vector<curve::Cubic> cubics, SegmentTree& tree) {
  tree.cubics = std::move(cubics);
  tree.blocks.clear();
  tree.nodes.clear();
  if (tree.cubics.empty()) return;
  const std::size_t count = (tree.cubics.size() + 3) / 4;
  tree.blocks.resize(count);
  tree.nodes.reserve(count / 2 + 1);
  std::vector<Item> items(count);
  for (std::size_t i = 0; i < count; ++i) {
    SegmentBlock& block = tree.blocks[i];
    block.first = static_cast<std::int32_t>(4 * i);
    block.count = static_cast<std::int32_t>(std::min<std::size_t>(4, tree.cubics.size() - 4 * i));
    items[i].box = fill_block(tree, block);
    items[i].middle = 0.5f * items[i].box.low + 0.5f * items[i].box.high;
    items[i].block = static_cast<std::int32_t>(i);
  }
  add_node(items, 0, tree);
}

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

void refit_tree(std::span<const std::size_t> changed, SegmentTree& tree) {
  if (changed.size() > tree.blocks.size() / 4) return refit_all(tree);
  std::size_t last = tree.blocks.size();
  for (const std::size_t i : changed) {
    if (i / 4 != last) refit_block(tree, tree.blocks[i / 4]);
    last = i / 4;
  }
}

}  // namespace coaster::sim
