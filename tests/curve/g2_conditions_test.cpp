// The derivatives of a repair's conditions and of its objective, by central differences: with wrong ones it still
// converges, only later or elsewhere.
#include <gtest/gtest.h>

#include <random>

#include "curve/g2_repair.h"

namespace coaster::curve {
namespace g2_conditions_test {

using detail::Conditions;
using detail::G2Unknowns;
using detail::Matrix;
using detail::Vector;
using glm::dvec3;

struct Chance {
  std::mt19937_64 bits{7};
  double number(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  dvec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  dvec3 unit() { return glm::normalize(vector(1) + dvec3(0.2, 0.1, 1.3)); }
};

G2Side side_of(Chance& chance, G2Side::FarEndConstraint keep) {
  G2Side side{chance.vector(14), chance.unit(), chance.number(2, 6), false, keep};
  side.curvature = glm::cross(side.direction, chance.vector(0.2));
  return side;
}

G2Problem problem_of(Chance& chance, G2Side::FarEndConstraint before, G2Side::FarEndConstraint after) {
  G2Problem p;
  p.position = chance.vector(50);
  p.in_handle = p.position + chance.vector(6), p.out_handle = p.position + chance.vector(6);
  p.position_fixed = true;
  p.before = side_of(chance, before), p.after = side_of(chance, after);
  return p;
}

double& unknown(G2Unknowns& x, int i) {
  if (i < 6) return i < 3 ? x.q[i] : x.r[i - 3];
  return i == 6 ? x.l : i == 7 ? x.a : x.b;
}
G2Unknowns at(G2Unknowns x, int i, double by) {
  unknown(x, i) += by;
  return x;
}

struct Place {
  detail::G2Solver repair;
  G2Unknowns x;
  detail::Axes axes;
};
Place place_of(Chance& chance, const G2Problem& problem) {
  return {detail::G2Solver(problem),
          {chance.vector(6), chance.vector(6), chance.number(0.2, 0.8), chance.number(2, 6), chance.number(2, 6)},
          detail::axes_across(chance.unit())};
}

constexpr double kStep = 1e-4;  // m; the conditions are polynomials, differences lose some 1e-8
constexpr std::array kKept{G2Side::FarEndConstraint::nothing, G2Side::FarEndConstraint::curvature,
                           G2Side::FarEndConstraint::handle};

TEST(g2_conditions, rows_are_the_derivatives_of_the_conditions) {
  Chance chance;
  for (const auto before : kKept)
    for (const auto after : kKept) {
      const Place p = place_of(chance, problem_of(chance, before, after));
      const Conditions now = p.repair.conditions(p.x, p.axes);
      const auto count = [](G2Side::FarEndConstraint keep) {
        return keep == G2Side::FarEndConstraint::nothing ? 0 : keep == kKept[1] ? 2 : 3;
      };
      ASSERT_EQ(now.count, 2 + count(before) + count(after) + 3);
      for (int i = 0; i < detail::kUnknowns; ++i) {
        const Conditions more = p.repair.conditions(at(p.x, i, kStep), p.axes),
                         less = p.repair.conditions(at(p.x, i, -kStep), p.axes);
        for (std::size_t k = 0; k < static_cast<std::size_t>(now.count); ++k)
          EXPECT_NEAR(now.rows[k][static_cast<std::size_t>(i)], (more.c[k] - less.c[k]) / (2 * kStep), 1e-6)
              << "condition " << k << ", unknown " << i;
      }
    }
}

// The condition itself is out^2 (a - p) - in^2 (b - p) parallel to the line of the handles (g2.h).
TEST(g2_conditions, equal_curvature_is_met_where_both_sides_have_it) {
  Chance chance;
  for (int i = 0; i < 40; ++i) {
    G2Problem problem = problem_of(chance, kKept[0], kKept[0]);
    problem.position_fixed = false;
    Place p = place_of(chance, problem);
    const dvec3 line = p.x.r - p.x.q, tangent = glm::normalize(line), place = p.x.p();
    const double in = p.x.l * glm::length(line), out = (1 - p.x.l) * glm::length(line);
    const dvec3 bent = glm::cross(tangent, chance.vector(0.1));  // the curvature vector of both sides
    const auto far = [&](double handle) {
      return problem.position + place + 1.5 * handle * handle * bent + chance.number(-9, 9) * tangent;
    };
    problem.before.anchor = far(in) - p.x.a * problem.before.direction;
    problem.after.anchor = far(out) - p.x.b * problem.after.direction;
    const detail::Axes across = detail::axes_across(tangent);
    const Conditions met = detail::G2Solver(problem).conditions(p.x, across);
    EXPECT_NEAR(met.c[0], 0, 1e-11);
    EXPECT_NEAR(met.c[1], 0, 1e-11);
    problem.after.anchor += 0.01 * across.first;
    const Conditions missed = detail::G2Solver(problem).conditions(p.x, across);
    EXPECT_GT(std::abs(missed.c[0]) + std::abs(missed.c[1]), 1e-5);
  }
}

// The objective is half the sum of the squared movements of q, r, p and both lengths.
std::array<double, 11> movements(const G2Problem& problem, const G2Unknowns& x) {
  const dvec3 q = x.q - (problem.in_handle - problem.position), r = x.r - (problem.out_handle - problem.position),
              p = x.p();
  return {q.x, q.y, q.z, r.x, r.y, r.z, p.x, p.y, p.z, x.a - problem.before.length, x.b - problem.after.length};
}

TEST(g2_conditions, slopes_are_those_of_the_sum_of_squares) {
  Chance chance;
  for (int i = 0; i < 10; ++i) {
    const G2Problem problem = problem_of(chance, kKept[0], kKept[0]);
    const Place p = place_of(chance, problem);
    Vector gradient{};
    Matrix hessian{};
    p.repair.slopes(p.x, gradient, hessian);
    const std::array<double, 11> now = movements(problem, p.x);
    double sum = 0;
    for (const double m : now) sum += 0.5 * m * m;
    EXPECT_NEAR(p.repair.cost(p.x), sum, 1e-9);
    std::array<std::array<double, 11>, detail::kUnknowns> slopes{};  // of each movement
    for (int u = 0; u < detail::kUnknowns; ++u) {
      const auto more = movements(problem, at(p.x, u, kStep)), less = movements(problem, at(p.x, u, -kStep));
      for (std::size_t m = 0; m < now.size(); ++m)
        slopes[static_cast<std::size_t>(u)][m] = (more[m] - less[m]) / (2 * kStep);
    }
    for (std::size_t u = 0; u < detail::kUnknowns; ++u) {
      double of_sum = 0;
      for (std::size_t m = 0; m < now.size(); ++m) of_sum += slopes[u][m] * now[m];
      EXPECT_NEAR(gradient[u], of_sum, 1e-7) << u;
      for (std::size_t v = 0; v < detail::kUnknowns; ++v) {
        double product = 0;
        for (std::size_t m = 0; m < now.size(); ++m) product += slopes[u][m] * slopes[v][m];
        EXPECT_NEAR(hessian[u][v], product, 1e-7) << u << ' ' << v;
      }
    }
  }
}

TEST(g2_conditions, with_the_bend_the_second_derivatives_are_those_of_the_lagrangian) {
  Chance chance;
  for (const auto keep : kKept) {
    const Place p = place_of(chance, problem_of(chance, keep, kKept[1]));
    std::array<double, detail::kMostConditions> multipliers{};
    for (double& m : multipliers) m = chance.number(-2, 2);
    Vector gradient{};
    Matrix hessian{};
    p.repair.slopes(p.x, gradient, hessian);
    p.repair.bend(p.x, p.axes, multipliers, hessian);
    const auto lagrangian = [&](const G2Unknowns& x) {
      const Conditions c = p.repair.conditions(x, p.axes);
      double sum = p.repair.cost(x);
      for (std::size_t k = 0; k < static_cast<std::size_t>(c.count); ++k) sum += multipliers[k] * c.c[k];
      return sum;
    };
    constexpr double kWide = 1e-3;
    for (int u = 0; u < detail::kUnknowns; ++u)
      for (int v = 0; v < detail::kUnknowns; ++v) {
        const double second =
            (lagrangian(at(at(p.x, u, kWide), v, kWide)) - lagrangian(at(at(p.x, u, kWide), v, -kWide)) -
             lagrangian(at(at(p.x, u, -kWide), v, kWide)) + lagrangian(at(at(p.x, u, -kWide), v, -kWide))) /
            (4 * kWide * kWide);
        EXPECT_NEAR(hessian[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)], second, 2e-4) << u << ' ' << v;
      }
  }
}

TEST(g2_conditions, axes_are_perpendicular_whatever_the_direction) {
  for (const dvec3 v : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, -1), dvec3(1, 1, 1), dvec3(1, 1, 0),
                        dvec3(0.1, 1, 5), dvec3(-3, 0.2, 1), dvec3(5, 2, 0.1)}) {
    const dvec3 direction = glm::normalize(v);
    const detail::Axes axes = detail::axes_across(direction);
    EXPECT_NEAR(glm::length(axes.first), 1, 1e-14);
    EXPECT_NEAR(glm::length(axes.second), 1, 1e-14);
    for (const double dot :
         {glm::dot(axes.first, direction), glm::dot(axes.second, direction), glm::dot(axes.first, axes.second)})
      EXPECT_NEAR(dot, 0, 1e-14);
  }
}

}  // namespace g2_conditions_test
}  // namespace coaster::curve
