// Elements whose vertices have weights.
#include "exchange/nolimits/nl2_spline.h"

#include <random>

#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_rule.h"
#include "exchange/nolimits/nl2elem.h"
#include "sim/tracks.h"

namespace coaster::exchange {
namespace nl2_rational_test {

using glm::dvec3;
using Vertex = test::RuleVertex;
using test::encode;

// The largest distance of the rule's curve from the document's, m: sampled, then by bisection of the parameter.
double missed(const world::Document& d, const std::vector<Vertex>& vertices) {
  std::vector<curve::Cubic> cubics;
  for (const world::Entity e : d.track.segments) cubics.push_back(world::cubic_of(d, e));
  double most = 0;
  std::size_t i = 0;
  double t = 0;
  for (const test::RuleSpan& span : test::rule_spans(vertices))
    for (int k = 0; k <= 40; ++k) {
      const dvec3 here = span.at(k / 40.0);
      const auto off = [&](std::size_t j, double at) { return glm::distance(curve::point(cubics[j], at), here); };
      // The rule's curve leads on, so the nearest place is here or in one of the next segments.
      double best = off(i, t);
      for (std::size_t j = i; j < std::min(i + 6, cubics.size()); ++j)
        for (int step = 0; step <= 64; ++step)
          if (off(j, step / 64.0) < best) best = off(j, step / 64.0), i = j, t = step / 64.0;
      for (double step = 1 / 64.0; step > 1e-9; step /= 2)
        for (const double to : {std::max(t - step, 0.0), std::min(t + step, 1.0)})
          if (off(i, to) < best) best = off(i, to), t = to;
      most = std::max(most, best);
    }
  return most;
}

std::vector<Vertex> random_vertices(std::mt19937& bits, bool closed, bool strict) {
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  std::vector<Vertex> all;
  for (int i = 0; i < 14; ++i) {
    const double a = i * M_PI / 7;
    const dvec3 p = closed ? dvec3(40 * std::cos(a), uniform(4, 12), 40 * std::sin(a))
                           : dvec3(9.7 * i, uniform(3, 9), uniform(-5, 5));
    all.push_back({p, false, uniform(0.4, 2)});
  }
  if (closed) {
    all.push_back(all.front());
    all[13].p = all[0].p - 0.9 * (all[1].p - all[0].p);  // no corner at the seam
  }
  if (strict) {
    for (const std::size_t i : {4u, 9u}) {
      all[i].strict = true;
      all[i + 1].p = all[i].p + 1.2 * (all[i].p - all[i - 1].p);
    }
  }
  return all;
}

TEST(nl2_rational, runs_with_weights_are_within_a_millimetre_of_the_rational_b_spline) {
  std::mt19937 bits(17);
  for (int run = 0; run < 16; ++run) {
    const std::vector<Vertex> vertices = random_vertices(bits, run % 2 == 1, run % 4 > 1);
    const auto loaded = parse_nl2elem(encode(vertices), "x");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings[0];
    EXPECT_EQ(loaded->note, "The weights of vertices were read from <w>.");
    EXPECT_EQ(loaded->document.track.closed, run % 2 == 1);
    EXPECT_EQ(world::broken_invariant(loaded->document), std::nullopt);
    const double off = missed(loaded->document, vertices);
    EXPECT_LT(off, 0.001) << run;
    EXPECT_NEAR(loaded->import->max_error, off, 3e-4) << run;
    EXPECT_LT(loaded->document.track.knots.size(), 70u) << run;
    std::vector<Vertex> without = vertices;
    for (Vertex& v : without) v.weight = 1;
    EXPECT_GT(missed(loaded->document, without), 0.05) << "weights matter";
  }
  // Few vertices: a conic, a rational cubic, and a line, which weights do not bend.
  for (const std::size_t count : {2u, 3u, 4u}) {
    std::vector<Vertex> few = random_vertices(bits, false, false);
    few.resize(count);
    const auto loaded = parse_nl2elem(encode(few), "x");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_LT(missed(loaded->document, few), 0.001) << count;
    EXPECT_TRUE(count != 2 || loaded->document.track.segments.size() == 1);
  }
}

// A quarter of a circle is the conic of weights 1, sqrt(1/2), 1.
TEST(nl2_rational, a_quarter_circle_is_one) {
  const std::vector<Vertex> quarter{
      {{20, 5, 0}, false, 1}, {{20, 5, 20}, false, std::sqrt(0.5)}, {{0, 5, 20}, false, 1}};
  const auto loaded = parse_nl2elem(encode(quarter), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  for (const world::Entity e : loaded->document.track.segments) {
    const curve::Cubic cubic = world::cubic_of(loaded->document, e);
    for (int k = 0; k <= 16; ++k) EXPECT_NEAR(glm::length(curve::point(cubic, k / 16.0) - dvec3(0, 5, 0)), 20, 0.0006);
    for (const double end : {0.0, 1.0}) EXPECT_NEAR(curve::curvature(cubic, end), 0.05, 2e-6);
  }
}

// Joints of a plane curve are G2 where it does not change sides.
TEST(nl2_rational, plane_bends_are_joined_with_one_curvature) {
  std::vector<Vertex> bend;
  std::mt19937 bits(4);
  for (int i = 0; i < 9; ++i)
    bend.push_back({{50 * std::cos(0.3 * i), 7, 50 * std::sin(0.3 * i)}, false, 0.6 + bits() / 4294967296.0});
  const auto loaded = parse_nl2elem(encode(bend), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  const world::Document& d = loaded->document;
  ASSERT_GT(d.track.segments.size(), 8u);
  for (std::size_t i = 0; i + 1 < d.track.segments.size(); ++i)
    EXPECT_NEAR(curve::curvature(world::cubic_of(d, d.track.segments[i]), 1),
                curve::curvature(world::cubic_of(d, d.track.segments[i + 1]), 0), 5e-5)
        << i;
}

TEST(nl2_rational, equal_weights_change_no_bit_and_any_scale_of_weights_is_the_same_curve) {
  std::mt19937 bits(9);
  std::vector<Vertex> vertices = random_vertices(bits, false, true);
  std::vector<Vertex> twice = vertices, all_one = vertices, all_two = vertices;
  for (Vertex& v : twice) v.weight *= 2;
  for (Vertex& v : all_one) v.weight = 1;
  for (Vertex& v : all_two) v.weight = 2;
  const auto load = [](const std::vector<Vertex>& from) { return parse_nl2elem(encode(from), "x")->document; };
  EXPECT_EQ(load(twice), load(vertices));
  EXPECT_EQ(load(all_two), load(all_one));
}

TEST(nl2_rational, a_track_with_weights_is_saved_and_read_again) {
  std::mt19937 bits(21);
  const auto loaded = parse_nl2elem(encode(random_vertices(bits, true, true)), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  ASSERT_TRUE(check_nl2elem(loaded->document).ok());
  const auto again = parse_nl2elem(print_nl2elem(loaded->document), "x");
  ASSERT_TRUE(again) << again.status().message;
  EXPECT_EQ(again->document.track.knots.size(), loaded->document.track.knots.size());
  EXPECT_LT(again->import->max_error, 3e-5);
  EXPECT_EQ(again->note, "");
}

}  // namespace nl2_rational_test
}  // namespace coaster::exchange
