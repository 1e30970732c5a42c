// Iterates the table, so that a new row is covered at once.
#include "curve/evaluators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "base/tries.h"
#include "curve/evaluators_detail.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace evaluators_test {

double extent_of(const Cubic& c) {
  double extent = 0;
  for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) extent = std::max(extent, static_cast<double>(glm::length(p)));
  return extent;
}
double size_of(const Cubic& c) {
  return glm::length(c.p1 - c.p0) + glm::length(c.p2 - c.p1) + glm::length(c.p3 - c.p2);
}

// The oracle, apart from the program's: Bernstein's form in long double.
glm::dvec3 exact(const Cubic& c, int i, int n) {
  const long double t = static_cast<long double>(i) / n, s = 1 - t;
  glm::dvec3 out;
  for (int a = 0; a < 3; ++a)
    out[a] = static_cast<double>(s * s * s * c.p0[a] + 3 * t * s * s * c.p1[a] + 3 * t * t * s * c.p2[a] +
                                 t * t * t * c.p3[a]);
  return out;
}

double worst_error(const Evaluator& row, const Cubic& c, int steps, std::vector<glm::vec3>& points) {
  points.resize(static_cast<std::size_t>(steps) + 1);
  row.polyline(prepare(c), points, {});
  double worst = 0;
  for (int i = 0; i <= steps; ++i)
    worst = std::max(worst, glm::length(glm::dvec3(points[static_cast<std::size_t>(i)]) - exact(c, i, steps)));
  return worst;
}

TEST(evaluators, names_and_labels_are_unique_and_found) {
  std::set<std::string_view> names, labels;
  for (std::size_t i = 0; i < evaluators().size(); ++i) {
    const Evaluator& row = evaluators()[i];
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_TRUE(labels.insert(row.label).second);
    EXPECT_EQ(base::value_named<curve::EvaluatorId>(row.name), static_cast<EvaluatorId>(i));
    EXPECT_FALSE(row.formula.empty());
    EXPECT_FALSE(row.cost.empty());
  }
  EXPECT_EQ(base::value_named<curve::EvaluatorId>("no such row"), std::nullopt);
  for (const char* label : {"Cubic (Bernstein)", "de Casteljau", "Horner", "Forward differences"})
    EXPECT_TRUE(labels.count(label)) << label;
}

TEST(evaluators, every_row_keeps_its_error_bound_on_ten_thousand_cubics) {
  // Fewer steps on more cubics: 10,000 cubics in all, some at every number of steps.
  const struct {
    int steps, count;
  } plan[] = {{1, 2000}, {2, 2000}, {7, 2000}, {16, 1500}, {64, 1500}, {256, 700}, {1024, 240}, {4096, 60}};
  std::vector<glm::vec3> points;
  for (const Evaluator& row : evaluators()) {
    double closest = 0;  // the largest share of the bound that was used: a bound must hold, and not be idle
    unsigned seed = 11;
    for (const auto [steps, count] : plan)
      for (const Cubic& c : random_cubics(test::tries(count), seed++)) {
        const double error = worst_error(row, c, steps, points),
                     bound = row.error_bound(extent_of(c), size_of(c), steps);
        ASSERT_LE(error, bound) << row.name << " at " << steps << " steps";
        closest = std::max(closest, error / bound);
      }
    EXPECT_GT(closest, 0.01) << row.name << ": the bound says nothing";
  }
}

TEST(evaluators, the_ends_are_exactly_the_control_points_so_joints_never_gap) {
  auto cubics = random_cubics(300, 21);
  for (const Cubic& c : degenerate_cubics()) cubics.push_back(c);
  for (const Evaluator& row : evaluators())
    for (const Cubic& c : cubics)
      for (int steps : {1, 2, 3, 64, 1000}) {
        std::vector<glm::vec3> points(static_cast<std::size_t>(steps) + 1), tangents(points.size());
        row.polyline(prepare(c), points, tangents);
        ASSERT_EQ(points.front(), c.p0) << row.name;
        ASSERT_EQ(points.back(), c.p3) << row.name;
      }
}

TEST(evaluators, tangents_are_the_derivative) {
  for (const Evaluator& row : evaluators())
    for (const Cubic& c : random_cubics(100, 22)) {
      std::vector<glm::vec3> points(65), tangents(65);
      row.polyline(prepare(c), points, tangents);
      for (int i = 0; i <= 64; ++i)
        // |B'| is about 60; control points 350 m out round by 3e-5, which the factor 3 and 64 sums enlarge.
        ASSERT_LT(glm::length(glm::dvec3(tangents[static_cast<std::size_t>(i)]) - derivative(c, i / 64.0)), 5e-3)
            << row.name;
    }
}

TEST(evaluators, points_do_not_depend_on_whether_tangents_are_asked_for) {
  for (const Evaluator& row : evaluators())
    for (const Cubic& c : random_cubics(50, 23)) {
      std::vector<glm::vec3> alone(33), together(33), tangents(33);
      row.polyline(prepare(c), alone, {});
      row.polyline(prepare(c), together, tangents);
      ASSERT_EQ(alone, together) << row.name;
    }
}

TEST(evaluators, degenerate_curves_give_finite_vertices) {
  for (const Evaluator& row : evaluators())
    for (const Cubic& c : degenerate_cubics())
      for (int steps : {1, 4, 64}) {
        std::vector<glm::vec3> points(static_cast<std::size_t>(steps) + 1), tangents(points.size());
        row.polyline(prepare(c), points, tangents);
        for (const glm::vec3 p : points) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << row.name;
        for (const glm::vec3 d : tangents) ASSERT_TRUE(std::isfinite(d.x + d.y + d.z)) << row.name;
      }
}

TEST(evaluators, horner_uses_the_stored_coefficients_alone) {
  PreparedCubic curve = prepare(random_cubics(1, 24)[0]);
  std::vector<glm::vec3> before(17), after(17);
  const Evaluator& row = base::row_of(*base::value_named<curve::EvaluatorId>("horner"));
  row.polyline(curve, before, {});
  curve.cubic.p1 += glm::vec3(5, 5, 5);  // without preparing it again
  row.polyline(curve, after, {});
  EXPECT_EQ(before, after);
}

double worst_of(const char* name, int steps, const std::vector<Cubic>& cubics) {
  std::vector<glm::vec3> points;
  double worst = 0;
  for (const Cubic& c : cubics)
    worst = std::max(worst, worst_error(base::row_of(*base::value_named<curve::EvaluatorId>(name)), c, steps, points));
  return worst;
}

TEST(evaluators, eight_lanes_started_anew_stay_within_four_times_horners_error_at_4096_steps) {
  const auto cubics = random_cubics(100, 25);
  const double horner = worst_of("horner", 4096, cubics);
  EXPECT_LE(worst_of("horner8", 4096, cubics), 1.5 * horner);
  EXPECT_LE(worst_of("forward_differences8", 4096, cubics), 4 * horner);
  EXPECT_GT(worst_of("forward_differences", 4096, cubics), 10 * horner);  // what the starts are for
}

// Counts vector operations.
struct Counting {
  double x = 0;
  static inline int additions = 0, multiplications = 0;
};
Counting operator+(Counting a, Counting b) { return ++Counting::additions, Counting{a.x + b.x}; }
Counting operator*(float a, Counting b) { return ++Counting::multiplications, Counting{a * b.x}; }

TEST(evaluators, forward_differences_take_three_additions_a_point_and_two_a_tangent) {
  auto d = detail::start_differences<Counting>({1}, {2}, {3}, {4}, 0.125f);
  Counting::additions = Counting::multiplications = 0;
  detail::step(d);
  EXPECT_EQ(Counting::additions, 3);
  EXPECT_EQ(Counting::multiplications, 0);
  auto g = detail::start_tangent_differences<Counting>({2}, {3}, {4}, 0.125f);
  Counting::additions = Counting::multiplications = 0;
  detail::step(g);
  EXPECT_EQ(Counting::additions, 2);
  EXPECT_EQ(Counting::multiplications, 0);
}

TEST(evaluators, estrin_takes_a_multiplication_more_than_horner) {
  Counting::additions = Counting::multiplications = 0;
  detail::estrin<Counting>({1}, {2}, {3}, {4}, 0.3f);
  EXPECT_EQ(Counting::additions, 3);
  EXPECT_EQ(Counting::multiplications, 3);  // of vectors; t * t is the fourth
}

TEST(evaluators, horner_takes_three_additions_and_three_multiplications_a_point) {
  Counting::additions = Counting::multiplications = 0;
  detail::horner<Counting>({1}, {2}, {3}, {4}, 0.3f);
  EXPECT_EQ(Counting::additions, 3);
  EXPECT_EQ(Counting::multiplications, 3);
}

}  // namespace evaluators_test
}  // namespace coaster::curve
