// Closed forms for the search by least change (base/least_change_solver.h).
#include "base/least_change_solver.h"

#include <cmath>

#include <gtest/gtest.h>

namespace coaster::base {
namespace least_change_solver_test {

using Values = std::vector<double>;

Equation equation(std::vector<Unknown> unknowns, double wanted, std::function<std::optional<double>(const Values&)> f) {
  Equation e;
  e.unknowns = std::move(unknowns), e.wanted = wanted, e.tolerance = 1e-7, e.value = std::move(f);
  return e;
}

TEST(LeastChange, of_a_linear_function_is_along_its_gradient) {
  // 3 x + 4 y = 25 from the origin: the nearest point is (3, 4).
  const auto f = [](const Values& x) { return std::optional(3 * x[0] + 4 * x[1]); };
  const Solution found = solve_by_least_change(equation({{0, 1, -100, 100}, {0, 1, -100, 100}}, 25, f));
  ASSERT_EQ(found.end, SolutionEnd::met);
  EXPECT_NEAR(found.unknowns[0], 3, 1e-7);
  EXPECT_NEAR(found.unknowns[1], 4, 1e-8);
  EXPECT_EQ(found.trials, 4) << "the start, two differences, and the solution";
}

TEST(LeastChange, counts_in_steps) {
  // With steps of 1 and 2, x / 1 and y / 2 count: x + y = 5 is nearest at (1, 4).
  const auto f = [](const Values& x) { return std::optional(x[0] + x[1]); };
  const Solution found = solve_by_least_change(equation({{0, 1, -100, 100}, {0, 2, -100, 100}}, 5, f));
  ASSERT_EQ(found.end, SolutionEnd::met);
  EXPECT_NEAR(found.unknowns[0], 1, 1e-8);
  EXPECT_NEAR(found.unknowns[1], 4, 1e-8);
}

TEST(LeastChange, finds_roots_of_curved_functions_on_either_side) {
  const auto cube = [](const Values& x) { return std::optional(x[0] * x[0] * x[0]); };
  for (const double wanted : {27.0, 1.0, -8.0, 1000.0}) {
    const Solution found = solve_by_least_change(equation({{2, 0.1, -100, 100}}, wanted, cube));
    ASSERT_EQ(found.end, SolutionEnd::met) << wanted;
    EXPECT_NEAR(found.unknowns[0], std::cbrt(wanted), 1e-6);
  }
  // A circle from a point inside: the nearest point on it lies in the same direction.
  const auto square = [](const Values& x) { return std::optional(x[0] * x[0] + x[1] * x[1]); };
  const Solution found = solve_by_least_change(equation({{3, 0.01, -100, 100}, {4, 0.01, -100, 100}}, 100, square));
  ASSERT_EQ(found.end, SolutionEnd::met);
  EXPECT_NEAR(found.unknowns[0], 6, 0.02);
  EXPECT_NEAR(found.unknowns[1], 8, 0.02);
}

TEST(LeastChange, keeps_within_limits_and_says_when_they_do_not_suffice) {
  const auto sum = [](const Values& x) { return std::optional(x[0] + x[1]); };
  const Solution other = solve_by_least_change(equation({{0, 1, 0, 1}, {0, 1, 0, 100}}, 10, sum));
  ASSERT_EQ(other.end, SolutionEnd::met);
  EXPECT_LE(other.unknowns[0], 1);
  EXPECT_NEAR(other.unknowns[0] + other.unknowns[1], 10, 1e-7);
  const Solution none = solve_by_least_change(equation({{0, 1, 0, 1}, {0, 1, 0, 2}}, 10, sum));
  EXPECT_NE(none.end, SolutionEnd::met);
  EXPECT_NEAR(none.value, 3, 1e-9) << "the best there is";
}

TEST(LeastChange, tries_the_side_that_has_room_and_leaves_out_what_can_go_no_further) {
  const auto sum = [](const Values& x) { return std::optional(x[0] + x[1]); };
  const Solution down = solve_by_least_change(equation({{5, 1, 0, 5}, {5, 1, 0, 5}}, 6, sum));
  ASSERT_EQ(down.end, SolutionEnd::met);
  EXPECT_NEAR(down.unknowns[0], 3, 1e-7);
  const Solution up = solve_by_least_change(equation({{1, 1, -100, 1}, {0, 1, -100, 100}}, 10, sum));
  ASSERT_EQ(up.end, SolutionEnd::met);
  EXPECT_NEAR(up.unknowns[1], 9, 1e-7);
  EXPECT_EQ(up.trials, 4) << "one way, since the first unknown takes no part in it";
}

TEST(LeastChange, needs_few_values_where_the_function_is_very_curved) {
  const auto steep = [](const Values& x) { return std::optional(std::pow(x[0], 9)); };
  const Solution found = solve_by_least_change(equation({{0.8, 0.1, -100, 100}}, 1000, steep));
  ASSERT_EQ(found.end, SolutionEnd::met);
  EXPECT_LE(found.trials, 24);
}

TEST(LeastChange, goes_round_places_without_a_value) {
  const auto f = [](const Values& x) { return x[0] > 3.5 ? std::nullopt : std::optional(x[0] * x[0]); };
  const Solution found = solve_by_least_change(equation({{0.5, 0.1, -100, 100}}, 9, f));
  ASSERT_EQ(found.end, SolutionEnd::met);
  EXPECT_NEAR(found.unknowns[0], 3, 1e-7);
}

TEST(LeastChange, ends_at_jumps_flat_places_and_values_that_do_not_exist) {
  const auto jump = [](const Values& x) { return std::optional(x[0] < 2 ? x[0] : x[0] + 10); };
  const Solution stuck = solve_by_least_change(equation({{0, 1, -100, 100}}, 6, jump));
  EXPECT_EQ(stuck.end, SolutionEnd::stuck);
  EXPECT_NEAR(stuck.value, 2, 0.01) << "the nearer side of the jump";
  const auto flat = [](const Values&) { return std::optional(1.0); };
  EXPECT_EQ(solve_by_least_change(equation({{0, 1, -100, 100}}, 6, flat)).end, SolutionEnd::no_effect);
  const auto nothing = [](const Values&) { return std::optional<double>(); };
  EXPECT_EQ(solve_by_least_change(equation({{0, 1, -100, 100}}, 6, nothing)).end, SolutionEnd::no_value);
}

TEST(LeastChange, takes_larger_differences_where_small_ones_show_nothing) {
  // A value in whole steps, as a count is.
  const auto stairs = [](const Values& x) { return std::optional(std::floor(x[0] / 5)); };
  const Solution found = solve_by_least_change(equation({{1, 1, -100, 100}}, 3, stairs));
  ASSERT_EQ(found.end, SolutionEnd::met);
  EXPECT_EQ(std::floor(found.unknowns[0] / 5), 3);
}

TEST(LeastChange, is_cancelled_and_tries_no_more_often_than_it_may) {
  Equation e = equation({{0, 1, -100, 100}}, 50, [](const Values& x) { return std::optional(std::atan(x[0])); });
  e.trials = 6;
  double last = -1;
  e.goes_on = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
    return true;
  };
  const Solution tired = solve_by_least_change(e);
  EXPECT_EQ(tired.end, SolutionEnd::trials_used);
  EXPECT_EQ(tired.trials, 6);
  e.goes_on = [](double done) { return done < 0.2; };
  EXPECT_EQ(solve_by_least_change(e).end, SolutionEnd::cancelled);
}

}  // namespace least_change_solver_test
}  // namespace coaster::base
