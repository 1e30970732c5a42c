// Iterates the table, so that a new row is covered at once.
#include "curve/evaluators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/enum_names.h"
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

struct Counts {
  int vector_additions = 0, vector_multiplications = 0, scalar_multiplications = 0;
};
Counts counted;

// A vector and a scalar that count the operations on them. 1 - t is counted nowhere.
struct Vector {
  double x = 0;
};
struct Scalar {
  double x = 0;
};
Vector operator+(Vector a, Vector b) { return ++counted.vector_additions, Vector{a.x + b.x}; }
Vector operator-(Vector a, Vector b) { return ++counted.vector_additions, Vector{a.x - b.x}; }
Vector operator*(Scalar a, Vector b) { return ++counted.vector_multiplications, Vector{a.x * b.x}; }
Vector operator*(float a, Vector b) { return ++counted.vector_multiplications, Vector{a * b.x}; }
Scalar operator*(Scalar a, Scalar b) { return ++counted.scalar_multiplications, Scalar{a.x * b.x}; }
Scalar operator*(float a, Scalar b) { return ++counted.scalar_multiplications, Scalar{a * b.x}; }
Scalar operator-(float a, Scalar b) { return {a - b.x}; }

std::string counts_of(const auto& work) {
  counted = {};
  work();
  std::string text = std::to_string(counted.vector_additions) + " vector additions";
  if (counted.vector_multiplications > 0) {
    text += ", " + std::to_string(counted.vector_multiplications) + " vector";
    if (counted.scalar_multiplications > 0)
      text += " and " + std::to_string(counted.scalar_multiplications) + " scalar";
    text += " multiplications";
  }
  return text;
}

// Every row's text against its inner loop.
TEST(evaluators, costs_are_those_of_the_inner_loops) {
  const Vector a{1}, b{2}, c{3}, d{4};
  const Scalar t{0.3};
  const std::string horner = counts_of([&] { (void)detail::horner(a, b, c, d, t); });
  auto differences = detail::start_differences(a, b, c, d, 0.125f);
  const std::string step = counts_of([&] { detail::step(differences); });
  // The shaders' curve.glsl, written out, as shader compilers share p2 - 2 p1 + p0: coefficients from control points.
  const std::string shader = counts_of([&] {
    const Vector d0 = b - a, d1 = c - b, d2 = d - c, dd = d1 - d0;
    (void)detail::horner(a, 3.0f * d0, 3.0f * dd, (d2 - d1) - dd, t);
  });
  // The kernels' loops (kernels_body.h) are compiled apart and read here. Horner's is the textbook's on vectors of
  // eight floats. Differences take three additions a step, and a fourth that adds the run's first point.
  const std::map<std::string_view, std::string> wanted{
      {"bernstein", counts_of([&] { (void)detail::bernstein(a, b, c, d, t); })},
      {"horner", horner},
      {"forward_differences", step},
      {"estrin", counts_of([&] { (void)detail::estrin(a, b, c, d, t); })},
      {"horner8", horner + ", by eights"},
      {"forward_differences8", "4 vector additions, by eights"},
      {"gpu_vertex", shader},
      {"gpu_geometry", shader},
      {"gpu_tessellation", shader}};
  for (const Evaluator& e : evaluators()) {
    if (e.name == "de_casteljau") continue;
    ASSERT_TRUE(wanted.count(e.name)) << e.name;
    EXPECT_EQ(e.cost, wanted.at(e.name)) << e.name;
  }
  EXPECT_EQ(horner, "3 vector additions, 3 vector multiplications");
  EXPECT_EQ(step, "3 vector additions");
}

TEST(evaluators, de_casteljau_takes_six_interpolations_of_an_addition_and_two_multiplications) {
  EXPECT_EQ(counts_of([] { (void)detail::de_casteljau(Vector{1}, Vector{2}, Vector{3}, Vector{4}, Scalar{0.3}); }),
            "6 vector additions, 12 vector multiplications");
  EXPECT_EQ(base::row_of(*base::value_named<EvaluatorId>("de_casteljau")).cost, "6 linear interpolations");
}

TEST(evaluators, tangents_by_differences_take_two_additions) {
  auto g = detail::start_tangent_differences<Vector>({2}, {3}, {4}, 0.125f);
  EXPECT_EQ(counts_of([&] { detail::step(g); }), "2 vector additions");
}

}  // namespace evaluators_test
}  // namespace coaster::curve
