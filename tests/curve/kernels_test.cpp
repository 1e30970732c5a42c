// Every processor path of this machine keeps the bounds, in every layout, for whole groups and the remaining vertices.
#include "curve/kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "curve/random_cubics.h"

namespace coaster::curve {
namespace kernels_test {

// The oracle, apart from the program's: Bernstein's form in long double.
glm::dvec3 exact(const Cubic& c, int i, int n) {
  const long double t = static_cast<long double>(i) / n, s = 1 - t;
  glm::dvec3 out;
  for (int a = 0; a < 3; ++a)
    out[a] = static_cast<double>(s * s * s * c.p0[a] + 3 * t * s * s * c.p1[a] + 3 * t * t * s * c.p2[a] +
                                 t * t * t * c.p3[a]);
  return out;
}
double extent_of(const Cubic& c) {
  double extent = 0;
  for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) extent = std::max(extent, static_cast<double>(glm::length(p)));
  return extent;
}
double size_of(const Cubic& c) {
  return glm::length(c.p1 - c.p0) + glm::length(c.p2 - c.p1) + glm::length(c.p3 - c.p2);
}

std::vector<PreparedCubic> prepared(const std::vector<Cubic>& cubics) {
  std::vector<PreparedCubic> all;
  for (const Cubic& c : cubics) all.push_back(prepare(c));
  return all;
}

constexpr int kSteps[] = {1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 23, 31, 33, 63, 64, 65, 71, 100, 127, 128, 129, 1000};

TEST(kernels, every_path_and_method_keeps_its_bound_for_every_number_of_steps) {
  const auto cubics = random_cubics(40, 41);
  for (const InstructionSet on : available_processors())
    for (const int n : kSteps)
      for (const Cubic& c : cubics) {
        std::vector<glm::vec3> by_horner(static_cast<std::size_t>(n) + 1), by_differences(by_horner.size());
        vector_polyline(VectorMethod::horner, prepare(c), by_horner, on);
        vector_polyline(VectorMethod::differences, prepare(c), by_differences, on);
        for (int i = 0; i <= n; ++i) {
          const auto k = static_cast<std::size_t>(i);
          ASSERT_LE(glm::length(glm::dvec3(by_horner[k]) - exact(c, i, n)),
                    vector_horner_error_bound(extent_of(c), size_of(c)))
              << n << " " << i;
          ASSERT_LE(glm::length(glm::dvec3(by_differences[k]) - exact(c, i, n)),
                    vector_differences_error_bound(extent_of(c), size_of(c)))
              << n << " " << i;
        }
        ASSERT_EQ(by_horner.front(), c.p0);
        ASSERT_EQ(by_horner.back(), c.p3);
        ASSERT_EQ(by_differences.front(), c.p0);
        ASSERT_EQ(by_differences.back(), c.p3);
      }
}

TEST(kernels, a_track_is_its_curves_one_after_the_other_in_both_layouts) {
  const auto cubics = random_cubics(7, 42);
  const auto all = prepared(cubics);
  for (const InstructionSet on : available_processors())
    for (const int n : kSteps)
      for (const VertexLayout layout : {VertexLayout::polylines, VertexLayout::chain}) {
        const std::size_t count = track_vertices(all.size(), n, layout),
                          own = layout == VertexLayout::chain ? n : n + 1;
        std::vector<glm::vec3> out(count + 1, glm::vec3(-7));
        track_points(all, n, layout, std::span(out).first(count), on);
        EXPECT_EQ(out.back(), glm::vec3(-7)) << "written past the end";
        EXPECT_EQ(out[count - 1], cubics.back().p3);
        for (std::size_t s = 0; s < all.size(); ++s)
          for (std::size_t i = 0; i < own; ++i)
            ASSERT_LE(glm::length(glm::dvec3(out[s * own + i]) - exact(cubics[s], static_cast<int>(i), n)),
                      track_error_bound(extent_of(cubics[s]), size_of(cubics[s])))
                << n << " " << s << " " << i;
      }
}

TEST(kernels, writing_past_the_caches_gives_the_same_vertices) {
  // 46,000 curves of 64 vertices: 34 MB, aligned.
  const auto cubics = random_cubics(50, 43);
  std::vector<PreparedCubic> all;
  for (std::size_t i = 0; i < 46'000; ++i) all.push_back(prepare(cubics[i % cubics.size()]));
  const std::size_t count = track_vertices(all.size(), 64, VertexLayout::chain);
  const std::size_t bytes = (count * sizeof(glm::vec3) + 31) / 32 * 32;
  const std::unique_ptr<void, decltype(&std::free)> memory(std::aligned_alloc(32, bytes), &std::free);
  const std::span<glm::vec3> out(static_cast<glm::vec3*>(memory.get()), count);
  for (const InstructionSet on : available_processors()) {
    std::fill(out.begin(), out.end(), glm::vec3(0));
    track_points(all, 64, VertexLayout::chain, out, on);
    std::vector<glm::vec3> some(track_vertices(50, 64, VertexLayout::chain));
    track_points(std::span(all).first(50), 64, VertexLayout::chain, some, on);
    for (std::size_t i = 0; i < all.size() * 64; ++i) ASSERT_EQ(out[i], some[i % (50 * 64)]);
    EXPECT_EQ(out.back(), all.back().cubic.p3);
  }
}

TEST(kernels, degenerate_curves_and_an_empty_track_are_finite) {
  const auto all = prepared(degenerate_cubics());
  for (const InstructionSet on : available_processors()) {
    for (const int n : {1, 7, 64}) {
      std::vector<glm::vec3> out(track_vertices(all.size(), n, VertexLayout::polylines));
      track_points(all, n, VertexLayout::polylines, out, on);
      for (const glm::vec3 p : out) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
    track_points({}, 64, VertexLayout::chain, {}, on);
  }
}

TEST(kernels, the_best_path_is_among_those_available_and_the_baseline_always_is) {
  const auto available = available_processors();
  ASSERT_FALSE(available.empty());
  EXPECT_EQ(available.front(), InstructionSet::baseline);
  EXPECT_EQ(available.back(), best_processor());
}

}  // namespace kernels_test
}  // namespace coaster::curve
