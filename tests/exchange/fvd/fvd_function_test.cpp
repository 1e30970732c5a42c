// Functions of openFVD projects, and force keys that follow them.
#include "exchange/fvd/fvd.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/plan/force_path.h"

namespace coaster::exchange {
namespace fvd_function_test {

FvdPiece piece(FvdShape shape, double form = 0) { return {shape, 2, 6, 1, 3, form}; }

// The integral over the piece by the midpoint rule.
double area(const FvdPiece& p, const FvdLevelling& levelling = {}) {
  constexpr int kSteps = 10000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += value_of(p, p.from + (i + 0.5) * (p.to - p.from) / kSteps, levelling);
  return sum * (p.to - p.from) / kSteps;
}

TEST(fvd_function, pieces_begin_and_end_as_named) {
  for (const auto shape : {FvdShape::linear, FvdShape::cubic, FvdShape::quintic, FvdShape::sinusoidal}) {
    EXPECT_NEAR(value_of(piece(shape), 2), 1, 1e-12);
    EXPECT_NEAR(value_of(piece(shape), 6), 4, 1e-12);
    EXPECT_NEAR(value_of(piece(shape), 4), 2.5, 1e-12) << "all are symmetric";
    EXPECT_NEAR(area(piece(shape)), 10, 1e-6);
    EXPECT_EQ(value_of(piece(shape), 9), value_of(piece(shape), 6)) << "limited to the piece";
  }
  EXPECT_NEAR(value_of(piece(FvdShape::quadratic, -1), 3), 1 + 3 * 7.0 / 16, 1e-12) << "fast at first";
  EXPECT_NEAR(value_of(piece(FvdShape::quadratic, 1), 3), 1 + 3 / 16.0, 1e-12) << "slow at first";
  EXPECT_NEAR(value_of(piece(FvdShape::quartic, 10), 6), 4, 1e-9);
}

TEST(fvd_function, humps_return_and_peak_at_the_change) {
  for (const FvdPiece& p : {piece(FvdShape::quadratic, 0), piece(FvdShape::quartic, -10), piece(FvdShape::quintic, 4),
                            piece(FvdShape::quintic, -4), piece(FvdShape::plateau, 1)}) {
    double most = -1e9;
    for (int i = 0; i <= 4000; ++i) most = std::max(most, value_of(p, 2 + i / 1000.0));
    EXPECT_NEAR(most, 4, 1e-5);
    EXPECT_NEAR(value_of(p, 2), 1, 1e-12);
    EXPECT_NEAR(value_of(p, 6), 1, 1e-12);
  }
}

TEST(fvd_function, levelling_turns_by_the_roll_and_ends_at_rest) {
  const FvdPiece p{FvdShape::to_zero, 2, 6, 12};
  const FvdLevelling from{35, 7};
  EXPECT_NEAR(value_of(p, 2, from), 12, 1e-12);
  EXPECT_NEAR((value_of(p, 2 + 4e-6, from) - 12) / 1e-6, 7, 1e-3) << "by the share of the piece";
  EXPECT_NEAR(area(p, from), -35, 1e-5);
  EXPECT_NEAR(value_of(p, 6, from), 0, 1e-12);
  EXPECT_NEAR(value_of(p, 6 - 1e-6, from), 0, 1e-9);
}

TEST(fvd_function, centre_and_tension_move_the_middle_alone) {
  FvdPiece p = piece(FvdShape::linear);
  p.centre = 2;
  EXPECT_NEAR(value_of(p, 4), 1 + 3 * 0.25, 1e-12) << "x to the power of 2";
  p.centre = -2;
  EXPECT_NEAR(value_of(p, 4), 1 + 3 * 0.75, 1e-12);
  p.centre = 0;
  for (const double tension : {-3.0, 3.0}) {
    p.tension = tension;
    EXPECT_NEAR(value_of(p, 4), 2.5, 1e-12);
    EXPECT_NEAR(value_of(p, 6), 4, 1e-12);
    EXPECT_NEAR(value_of(p, 3),
                1 + 3 * (tension > 0 ? 0.5 * (1 - std::sinh(1.5) / std::sinh(3.0))
                                     : 0.5 * (1 - std::asinh(std::sinh(3.0) / 2) / 3)),
                1e-12);
  }
}

TEST(fvd_function, joined_pieces_continue_and_locked_ones_reach_the_end) {
  FvdFunction f{{FvdShape::cubic, 0, 1, 9, 2}, {FvdShape::quartic, 1, 2, 9, 5, -10}, {FvdShape::linear, 2, 3, 9, -1}};
  f.back().follows = true;
  const FvdFunction other{{FvdShape::linear, 0, 7, 0, 0}};
  const FvdFunction* const both[] = {&f, &other};
  EXPECT_EQ(shared_length(both), 7);
  join_pieces(f, 1, 7);
  EXPECT_EQ(f[1].start, 3);
  EXPECT_EQ(f[2].start, 3) << "a hump ends where it begins";
  EXPECT_EQ(f[2].to, 7);
  EXPECT_EQ(&piece_at(f, 1.5), &f[1]);
  EXPECT_EQ(&piece_at(f, 99), &f[2]);
}

// The keys' curve as force sections evaluate it.
TEST(fvd_function, keys_follow_within_the_tolerance_but_at_corners) {
  const FvdFunction f{{FvdShape::sinusoidal, 0, 1.5, 1, 3},
                      {FvdShape::linear, 1.5, 2, 4, -2},
                      {FvdShape::plateau, 2, 4, 2, 1.5, 1},
                      {FvdShape::quintic, 4, 6, 2, -2, 3}};
  const auto at = [&](double x) { return value_of(piece_at(f, x), x); };
  world::ForceProgram program;
  program.over = world::ForceDomain::time, program.length = 6;
  program.channels[0] = keys_along(at, {0, 1.5, 2, 4}, 6, 0.01, world::kKeyGap_s, 10);
  ASSERT_FALSE(world::broken(program)) << *world::broken(program);
  const sim::ForceCurve curve(program, world::ForceChannel::vertical);
  for (double x = 0; x <= 6; x += 0.003) {
    const bool near = std::abs(x - 1.5) < 0.06 || std::abs(x - 2) < 0.06;
    EXPECT_NEAR(curve.at(x).value, at(x), near ? 0.11 : 0.012) << x;
  }
  const auto flat = keys_along([](double) { return 2.0; }, {}, 6, 0.01, 0.05, 10);
  EXPECT_EQ(flat.size(), 1u) << "what stays is one key";
}

// Polylines with corners anywhere, also next to the ends and closer together than keys may be.
TEST(fvd_function, keys_follow_random_polylines_but_within_a_gap_of_their_corners) {
  std::mt19937 random(7);
  const auto number = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  for (int round = 0; round < 40; ++round) {
    const double gap = round % 2 == 0 ? world::kKeyGap_s : 0.2, length = number(4, 12);
    std::vector<double> x{0}, y{number(-3, 3)};
    while (x.back() < length) {
      x.push_back(x.back() + (round % 4 == 3 ? number(0.2, 1) : number(2.2, 9)) * gap * number(1, 4));
      y.push_back(y.back() + number(-0.6, 0.6) * (x.back() - x[x.size() - 2]));
    }
    const auto at = [&](double place) {
      const std::size_t i = static_cast<std::size_t>(std::lower_bound(x.begin() + 1, x.end() - 1, place) - x.begin());
      return std::lerp(y[i - 1], y[i], (place - x[i - 1]) / (x[i] - x[i - 1]));
    };
    world::ForceProgram program;
    program.over = world::ForceDomain::time, program.length = length;
    program.channels[0] = keys_along(at, x, length, 0.01, gap, 1000);
    ASSERT_FALSE(world::broken(program)) << *world::broken(program);
    // Corners that are far enough apart cost two or three keys each, the straights between them none.
    const auto corners = std::ranges::count_if(x, [&](double one) { return one > 0 && one < length; });
    if (round % 4 != 3) {
      EXPECT_LE(program.channels[0].size(), static_cast<std::size_t>(3 * corners + 2)) << round;
    }
    const sim::ForceCurve curve(program, world::ForceChannel::vertical);
    for (double place = 0; place <= length; place += 0.003) {
      double beside = 1e9;  // m or s to the nearest corner
      for (std::size_t i = 1; i + 1 < x.size(); ++i) beside = std::min(beside, std::abs(place - x[i]));
      // A corner is cut over at most a gap; slopes are at most 0.6.
      EXPECT_NEAR(curve.at(place).value, at(place), beside < 1.6 * gap ? 0.7 * gap : 0.012)
          << place << " of " << length << ", round " << round;
    }
  }
}

TEST(fvd_function, one_corner_costs_two_keys_wherever_it_is) {
  for (const double corner : {0.1, 0.2, 0.5, 1.0, 1.4, 4.0, 6.6, 7.1, 7.6, 7.9}) {
    const auto f = [corner](double x) { return x < corner ? 1 + 0.5 * x : 1 + 0.5 * corner - 0.7 * (x - corner); };
    const auto keys = keys_along(f, {corner}, 8, 0.001, world::kKeyGap_s, 10);
    EXPECT_LE(keys.size(), 4u) << corner;
  }
}

TEST(fvd_function, wild_functions_get_as_many_keys_as_there_may_be) {
  const auto keys = keys_along([](double x) { return 20 * std::sin(40 * x); }, {}, 60, 0.01, 0.05, 10);
  EXPECT_LE(keys.size(), world::kMostForceKeys);
  world::ForceProgram program;
  program.over = world::ForceDomain::time, program.length = 60, program.channels[0] = keys;
  EXPECT_FALSE(world::broken(program)) << *world::broken(program);
}

}  // namespace fvd_function_test
}  // namespace coaster::exchange
