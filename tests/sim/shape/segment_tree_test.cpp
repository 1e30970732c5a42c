#include "sim/shape/segment_tree.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace segment_tree_test {

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }
  std::size_t below(std::size_t n) { return bits_() % n; }
  glm::vec3 point(double size) {
    const double x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
    return {31.7 + x, 8.3 + y, -12.9 + z};
  }

 private:
  std::mt19937 bits_;
};

std::vector<curve::Cubic> random_cubics(Random& random, std::size_t count) {
  std::vector<curve::Cubic> cubics;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 p = random.point(200);
    const glm::vec3 off = glm::vec3(-31.7f, -8.3f, 12.9f);
    switch (i % 4) {
      case 0: cubics.push_back({p, p, p, p}); break;  // a point
      case 1:
        cubics.push_back({p, p + glm::vec3(3.3f, 0, 0), p + glm::vec3(6.6f, 0, 0), p + glm::vec3(9.9f, 0, 0)});
        break;
      default: cubics.push_back({p, p + off + random.point(9), p + off + random.point(20), p + off + random.point(15)});
    }
  }
  return cubics;
}

bool holds(const TreeNode& node, int lane, glm::dvec3 p) {
  for (int a = 0; a < 3; ++a)
    if (p[a] < node.bounds[a][lane] - 1e-4 || p[a] > node.bounds[3 + a][lane] + 1e-4) return false;
  return true;
}

// Every box holds the curves below it, children point to their parents, each segment is met once; returns how many
// nodes are above each other.
int check_node(const SegmentTree& tree, std::int32_t at, std::vector<int>& met) {
  const TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
  int depth = 0;
  for (int lane = 0; lane < 4; ++lane) {
    if (!(node.lanes >> lane & 1)) continue;
    std::vector<int> below(tree.cubics.size());
    if (const std::int32_t child = node.child[lane]; child >= 0) {
      EXPECT_EQ(tree.nodes[static_cast<std::size_t>(child)].parent, at);
      EXPECT_EQ(tree.nodes[static_cast<std::size_t>(child)].lane, lane);
      depth = std::max(depth, check_node(tree, child, below));
    } else {
      const SegmentBlock& block = tree.blocks[static_cast<std::size_t>(~child)];
      EXPECT_EQ(block.parent, at);
      EXPECT_EQ(block.lane, lane);
      for (int i = 0; i < block.count; ++i) ++below[static_cast<std::size_t>(block.first + i)];
    }
    for (std::size_t i = 0; i < below.size(); ++i) {
      met[i] += below[i];
      for (int k = 0; below[i] > 0 && k <= 8; ++k)
        EXPECT_TRUE(holds(node, lane, curve::point(tree.cubics[i], k / 8.0)));
    }
  }
  return depth + 1;
}

void check_tree(const SegmentTree& tree) {
  std::vector<int> met(tree.cubics.size());
  if (!tree.nodes.empty()) {
    EXPECT_LE(check_node(tree, 0, met), kMaxTreeDepth);
  }
  for (const int times : met) EXPECT_EQ(times, 1);
}

TEST(segment_tree, every_segment_is_in_it_once_and_inside_its_boxes) {
  Random random(3);
  for (const std::size_t count : {0, 1, 2, 4, 5, 17, 100, 333}) {
    SegmentTree tree;
    build_tree(random_cubics(random, count), tree);
    EXPECT_EQ(tree.nodes.empty(), count == 0);
    check_tree(tree);
  }
}

TEST(segment_tree, segments_on_one_spot_or_ever_smaller_ones_nest_no_deeper_than_promised) {
  SegmentTree tree;
  build_tree(std::vector<curve::Cubic>(3000, curve::Cubic{{1, 2, 3}, {2, 2, 3}, {3, 3, 3}, {4, 3, 3}}), tree);
  check_tree(tree);
  std::vector<curve::Cubic> shrinking;
  for (int i = 0; i < 600; ++i) {
    const float at = 1e5f * std::pow(0.9f, static_cast<float>(i));
    shrinking.push_back({{at, 0, 0}, {at * 0.97f, 0, 0}, {at * 0.93f, 0, 0}, {at * 0.9f, 0, 0}});
  }
  build_tree(shrinking, tree);
  check_tree(tree);
}

TEST(segment_tree, chords_with_their_radii_hold_the_curves_and_little_more) {
  Random random(5);
  SegmentTree tree;
  build_tree(random_cubics(random, 400), tree);
  for (const SegmentBlock& block : tree.blocks)
    for (int lane = 0; lane < block.count; ++lane) {
      const curve::Cubic& cubic = tree.cubics[static_cast<std::size_t>(block.first + lane)];
      const glm::dvec3 from(cubic.p0), along = glm::dvec3(cubic.p3) - from;
      double farthest = 0;
      for (int k = 0; k <= 200; ++k) {
        const glm::dvec3 p = curve::point(cubic, k / 200.0);
        const double s =
            glm::dot(along, along) > 0 ? std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0) : 0;
        farthest = std::max(farthest, glm::distance(p, from + s * along));
      }
      EXPECT_LE(farthest, block.radius[lane] * (1 + 1e-6) + 1e-12);
      EXPECT_LE(block.radius[lane],
                1.25 * farthest + 0.05);  // control points after two halvings are a sixteenth as far off as before
    }
}

TEST(segment_tree, refitted_boxes_are_those_of_a_tree_built_anew) {
  Random random(8);
  for (int trial = 0; trial < 60; ++trial) {
    SegmentTree tree, again;
    build_tree(random_cubics(random, 1 + random.below(300)), tree);
    for (int round = 0; round < 4; ++round) {
      // Few, many, or all of them.
      std::vector<std::size_t> changed;
      const double share = round == 3 ? 1.0 : std::pow(10.0, -round);
      for (std::size_t i = 0; i < tree.cubics.size(); ++i)
        if (random(0, 1) < share) changed.push_back(i), tree.cubics[i] = random_cubics(random, 3).back();
      refit_tree(changed, tree);
      check_tree(tree);
      build_tree(tree.cubics, again);
      ASSERT_EQ(tree.blocks.size(), again.blocks.size());
      for (std::size_t b = 0; b < tree.blocks.size(); ++b) {
        EXPECT_EQ(tree.blocks[b].from, again.blocks[b].from);
        EXPECT_EQ(tree.blocks[b].to, again.blocks[b].to);
        EXPECT_EQ(tree.blocks[b].radius, again.blocks[b].radius);
        const auto box = [b](const SegmentTree& t, int row) {
          return t.nodes[static_cast<std::size_t>(t.blocks[b].parent)].bounds[row][t.blocks[b].lane];
        };
        for (int row = 0; row < 6; ++row) EXPECT_EQ(box(tree, row), box(again, row));
      }
      // The roots' boxes together are the box of all.
      for (int row = 0; row < 6; ++row) {
        const auto bound = [row](const TreeNode& root) {
          float out = root.bounds[row][0];
          for (int lane = 1; root.lanes >> lane & 1; ++lane)
            out = row < 3 ? std::min(out, root.bounds[row][lane]) : std::max(out, root.bounds[row][lane]);
          return out;
        };
        EXPECT_EQ(bound(tree.nodes[0]), bound(again.nodes[0]));
      }
    }
  }
}

TEST(segment_tree, follows_what_is_derived_and_keeps_its_nodes_while_knots_move) {
  world::Document d = test::ring_document(101, 160);
  DerivedTrack derived = test::derived_of(d);
  const auto in_step = [&] {
    ASSERT_EQ(derived.tree.cubics.size(), derived.order.size());
    for (std::size_t i = 0; i < derived.order.size(); ++i)
      EXPECT_EQ(derived.tree.cubics[i], derived.shape(derived.order[i]).key.cubic);
    check_tree(derived.tree);
  };
  in_step();
  const auto children = [&] {
    std::vector<std::array<std::int32_t, 4>> all;
    for (const TreeNode& node : derived.tree.nodes) all.push_back(node.child);
    return all;
  };
  const auto before = children();
  world::Knot moved = world::knot(d, d.track.knots[40]);
  moved.position += glm::vec3(13, 70, -4);
  d.entities.put(d.track.knots[40], moved);
  derive(d, {}, {}, derived);
  in_step();
  EXPECT_EQ(children(), before);

  world::remove_knot(d, d.track.knots[7]);
  derive(d, {}, {}, derived);
  in_step();
  world::set_closed(d, false);
  derive(d, {}, {}, derived);
  in_step();
  // Every segment elsewhere, in the same order.
  for (const world::Entity e : d.track.knots) {
    world::Knot knot = world::knot(d, e);
    knot.position = {knot.position.z * 3, knot.position.x, knot.position.y};
    d.entities.put(e, knot);
  }
  derive(d, {}, {}, derived);
  in_step();
  while (!d.track.knots.empty()) world::remove_knot(d, d.track.knots.back());
  derive(d, {}, {}, derived);
  EXPECT_TRUE(derived.tree.nodes.empty());
}

TEST(segment_tree, blocks_are_visited_by_their_key_until_told_to_stop) {
  Random random(5);
  for (const std::size_t count : {0u, 1u, 3u, 4u, 5u, 2'001u}) {
    SegmentTree tree;
    build_tree(random_cubics(random, count), tree);
    const auto least_x = [](const curve::Box& box) { return std::optional<double>(box.low.x); };
    std::vector<double> keys;
    std::vector<int> met(count);
    all_by_key(
        tree, least_x, [&](double key) { return keys.push_back(key), true; }, [&](std::size_t i) { ++met[i]; });
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(count)) << "each once";
    // Up to a plane, and only on one side of another.
    std::vector<bool> found(count);
    all_by_key(
        tree, [&](const curve::Box& box) { return box.high.y < 8 ? std::nullopt : std::optional<double>(box.low.x); },
        [](double key) { return key <= 31; }, [&](std::size_t i) { found[i] = true; });
    for (std::size_t i = 0; i < count; ++i) {
      const curve::Box box = tight_box(tree.cubics[i]);
      EXPECT_TRUE(found[i] || box.low.x > 31 || box.high.y < 8);
    }
    if (count > 1'000) {
      EXPECT_LT(std::count(found.begin(), found.end(), true), 1'900) << "some are left out";
    }
  }
}

}  // namespace segment_tree_test
}  // namespace coaster::sim
