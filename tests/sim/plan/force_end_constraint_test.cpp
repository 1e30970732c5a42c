#include "sim/plan/force_end_constraint.h"

#include <gtest/gtest.h>

#include <random>

#include "base/tries.h"
#include "sim/force_oracle.h"

namespace coaster::sim {
namespace force_end_constraint_test {

using glm::dvec3;

TrackEnd end_of(const ForceTask& task) {
  const ElementPoint last = force_path(task).curve.points.back();
  return {last.position, last.tangent, last.up, last.curvature, last.spin};
}

// Returns how much roll counts as much as 1 g, in the keys' units.
double roll_per_g(const world::ForceProgram& program) {
  return kRollPerG * (program.over == world::ForceDomain::time ? program.speed : 1.0);
}

// Returns the sum that hold_end() makes least, g^2: over half a gap for the last key.
double added_square(const ForceTask& task) {
  const double bend = task.program.of == world::ForceQuantity::curvature ? kCurvaturePerG : 1.0;
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<world::ForceKey>& keys = task.added->channels[c];
    for (const world::ForceKey& key : keys) {
      const double value = key.value / (c == 2 ? roll_per_g(task.program) : bend);
      sum += (key == keys.back() ? 0.5 : 1.0) * value * value;
    }
  }
  return sum;
}

// Turns an end about an axis of its own.
void turn(TrackEnd& end, dvec3 axis, double angle) {
  for (dvec3* const v : {&end.forward, &end.up, &end.curvature})
    *v = std::cos(angle) * *v + std::sin(angle) * glm::cross(axis, *v) +
         (1 - std::cos(angle)) * glm::dot(axis, *v) * axis;
}

// A random program, and an end beside its own: some metres and degrees away, with another bend and spin.
template <class Programs>
ForceTask planted(Programs& programs, std::mt19937& random, double metres) {
  const auto uniform = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
  ForceTask task = programs.next(metres);
  TrackEnd end = end_of(task);
  // Drawn one by one: compilers evaluate arguments in different orders.
  const double z = uniform(2), y = uniform(1.5), x = uniform(2);
  end.position += dvec3(x, y, z);
  turn(end, end.up, uniform(0.06)), turn(end, glm::cross(end.up, end.forward), uniform(0.06));
  turn(end, end.forward, uniform(0.15));
  const double to_left = uniform(0.004), to_up = uniform(0.004);
  end.curvature += to_up * end.up + to_left * glm::cross(end.up, end.forward);
  end.spin += uniform(0.01);
  task.held = end;
  return task;
}

// The end's nine conditions, in metres and radians.
std::vector<double> off(const ForceTask& task) {
  const ElementPoint last = force_path(task).curve.points.back();
  const TrackEnd& to = *task.held;
  const dvec3 left = glm::cross(to.up, to.forward), by = last.position - to.position,
              bend = last.curvature - to.curvature;
  return {by.x,
          by.y,
          by.z,
          glm::dot(last.tangent, to.up),
          glm::dot(last.tangent, left),
          glm::dot(last.up, left),
          glm::dot(bend, to.up),
          glm::dot(bend, left),
          last.spin - to.spin};
}

TEST(force_hold, an_independent_integration_ends_where_it_must) {
  test::RandomForces programs(23);
  std::mt19937 random(5);
  int whole = 0;
  for (int i = 0; i < test::tries(10); ++i) {
    const ForceTask task = planted(programs, random, i < 2 ? 200 : 70);
    const auto held = hold_end(task);
    ASSERT_TRUE(held) << i;
    if (!force_path(*held).stopped.empty()) continue;  // a random one may run through itself
    ++whole;
    test::ForceOracle oracle(*held);
    oracle.go_to(held->length());
    const auto of = [](const test::Vector& v) { return dvec3(v[0], v[1], v[2]); };
    EXPECT_LT(glm::distance(of(oracle.position), task.held->position), 1e-3) << i;
    EXPECT_LT(glm::distance(of(oracle.forward), task.held->forward), 1e-4) << i;
    EXPECT_LT(glm::distance(of(oracle.up), task.held->up), 1e-4) << i;
    const std::vector<double> missed = off(*held);
    for (std::size_t k = 0; k < missed.size(); ++k)
      EXPECT_LT(std::abs(missed[k]), k < 3 ? 1e-5 : 1e-6) << i << ' ' << k;
  }
  EXPECT_GE(whole, test::tries(10) - 2);
}

TEST(force_hold, curvature_ends_where_it_must_by_an_independent_integration) {
  test::RandomCurvature programs(8);
  std::mt19937 random(9);
  for (int i = 0; i < test::tries(6); ++i) {
    const ForceTask task = planted(programs, random, i < 2 ? 150 : 60);
    const auto held = hold_end(task);
    ASSERT_TRUE(held) << i;
    test::ForceOracle oracle(*held);
    oracle.go_to(held->length());
    const auto of = [](const test::Vector& v) { return dvec3(v[0], v[1], v[2]); };
    EXPECT_LT(glm::distance(of(oracle.position), task.held->position), 1e-3) << i;
    EXPECT_LT(glm::distance(of(oracle.up), task.held->up), 1e-4) << i;
    const std::vector<double> missed = off(*held);
    for (std::size_t k = 0; k < missed.size(); ++k)
      EXPECT_LT(std::abs(missed[k]), k < 3 ? 1e-5 : 1e-6) << i << ' ' << k;
    EXPECT_LT(added_square(*held), 8) << "units of a g at 20 m/s";
    ForceTask slow = task;
    slow.program.speed = 2;
    const auto again = hold_end(slow);
    ASSERT_TRUE(again) << i << ": speed does not matter";
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(again->added->channels[c], held->added->channels[c]);
  }
}

// Solves A x = b by elimination with pivots.
std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]), std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double by = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= by * a[k][j];
      b[i] -= by * b[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) b[k] /= a[k][k];
  return b;
}

// Changes what is added at a node, with the slopes of the parabolas beside it.
void add_at(ForceTask& task, std::size_t channel, std::size_t node, double by) {
  std::vector<world::ForceKey>& keys = task.added->channels[channel];
  keys[node].value += by;
  for (std::size_t i = 1; i + 1 < keys.size(); ++i)
    keys[i].slope = (keys[i + 1].value - keys[i - 1].value) / (keys[i + 1].at - keys[i - 1].at);
}

// Newton's method for nine of the nodes, so that the path ends where it must again.
bool restore(ForceTask& task, const std::vector<std::pair<std::size_t, std::size_t>>& nodes) {
  for (int round = 0; round < 12; ++round) {
    const std::vector<double> now = off(task);
    double most = 0;
    for (const double value : now) most = std::max(most, std::abs(value));
    if (most < 1e-9) return true;
    std::vector<std::vector<double>> slopes(9, std::vector<double>(9));
    for (std::size_t k = 0; k < 9; ++k) {
      ForceTask beside = task;
      add_at(beside, nodes[k].first, nodes[k].second, 1e-5);
      const std::vector<double> there = off(beside);
      for (std::size_t e = 0; e < 9; ++e) slopes[e][k] = (there[e] - now[e]) / 1e-5;
    }
    const std::vector<double> by = solved(slopes, now);
    for (std::size_t k = 0; k < 9; ++k) add_at(task, nodes[k].first, nodes[k].second, -by[k]);
  }
  return false;
}

// Brute force: to both sides of the answer, no other additions that lead to the same end have a smaller sum of squares.
TEST(force_hold, no_additions_beside_it_are_less) {
  test::RandomForces programs(31);
  std::mt19937 random(6);
  for (int i = 0; i < test::tries(3); ++i) {
    const ForceTask task = planted(programs, random, 60);
    const auto held = hold_end(task);
    ASSERT_TRUE(held);
    const double least = added_square(*held);
    EXPECT_GT(least, 0.001);
    const std::size_t count = held->added->channels[0].size();
    const double per_g = roll_per_g(task.program);
    int tried = 0;
    for (int k = 0; k < 12; ++k) {
      std::vector<std::pair<std::size_t, std::size_t>> nodes;
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t n = 1; n < count; ++n) nodes.emplace_back(c, n);
      std::shuffle(nodes.begin(), nodes.end(), random);
      // Nine that can do it: three of each channel, the last one among them for its bend or spin.
      std::vector<std::pair<std::size_t, std::size_t>> nine;
      for (std::size_t c = 0; c < 3; ++c)
        for (const std::size_t n : {count - 1, count - 1 - count / 3, 1 + count / 4}) nine.emplace_back(c, n);
      for (const double sign : {-1.0, 1.0}) {
        ForceTask beside = *held;
        for (std::size_t n = 0; n < 4; ++n)
          add_at(beside, nodes[n].first, nodes[n].second, sign * 0.005 * (nodes[n].first == 2 ? per_g : 1.0));
        if (!restore(beside, nine)) continue;
        ++tried;
        EXPECT_GT(added_square(beside), least - 3e-6) << i << ' ' << k;
      }
    }
    EXPECT_GE(tried, 12) << i;
  }
}

TEST(force_hold, adds_nothing_where_the_keys_lead_there) {
  test::RandomForces programs(3);
  ForceTask task = programs.next(90);
  task.held = end_of(task);
  const auto held = hold_end(task);
  ASSERT_TRUE(held);
  EXPECT_LT(added_square(*held), 1e-10);
  EXPECT_NEAR(held->length(), task.program.length, 1e-6);
}

// Lateral g from a level start leads aside and down. The end is straight ahead: it is not reached with the frame turned
// over, though the products of its axes with the wanted ones are 0 then, too.
TEST(force_hold, the_end_is_upright) {
  ForceTask task;
  task.end.position = {0, 30, 0}, task.riders = 1.1, task.losses = {0.02f, 2e-5f};
  task.program.speed = 22, task.program.length = 70;
  auto& keys = task.program.channels;
  keys[0] = {{0, 1}, {20, 1.5}, {45, 1}};
  task.held = end_of(task);
  keys[0][1].value = 2.2, keys[1] = {{30, 0.3}};
  const auto held = hold_end(task);
  ASSERT_TRUE(held);
  const ElementPoint last = force_path(*held).curve.points.back();
  EXPECT_GT(glm::dot(last.up, task.held->up), 0.999999);
  EXPECT_GT(glm::dot(last.tangent, task.held->forward), 0.999999);
}

// Ends of all kinds are reached, also those at which the steps of least squares overshoot.
TEST(force_hold, reaches_each_of_many_random_ends) {
  for (const unsigned seed : {100u, 200u}) {
    test::RandomForces programs(seed);
    std::mt19937 random(seed + 1);
    for (int i = 0; i < 60; ++i) EXPECT_TRUE(hold_end(planted(programs, random, 60))) << seed << ' ' << i;
  }
}

// Of a float of 26 m at 0 g the end is moved to other g; with 1 g the keys alone lead 30 m away and fold the track.
// Nothing that is asked for leads aside, and nothing that is added does.
TEST(force_hold, a_hill_stays_in_its_plane) {
  ForceTask task;
  task.end.position = {0, 60, 0}, task.riders = 1.1, task.losses = {0.02f, 2e-5f};
  task.program.speed = 24.5, task.program.length = 110;
  auto& keys = task.program.keys(world::ForceChannel::vertical);
  keys = {{0, 1}, {14, 2.5}, {20, 2.5}, {34, 0}, {60, 0}, {74, 2.5}, {80, 2.5}, {94, 1}};
  ASSERT_EQ(force_path(task).stopped, "");
  task.held = end_of(task);
  double before = 0;
  for (int tenths = 1; tenths <= 25; ++tenths) {
    keys[4].value = 0.1 * tenths;
    const auto held = hold_end(task);
    ASSERT_TRUE(held) << tenths;
    for (const ElementPoint& point : force_path(*held).curve.points) EXPECT_EQ(point.position.z, 0) << tenths;
    EXPECT_GT(added_square(*held), before) << tenths;
    EXPECT_LT(added_square(*held), 0.011 * tenths * tenths + 0.01) << tenths;
    before = added_square(*held);
  }
}

TEST(force_hold, gives_nothing_where_no_path_leads_there) {
  test::RandomForces programs(3);
  ForceTask task = programs.next(60);
  task.held = end_of(task);
  task.held->position.y += 200;
  EXPECT_FALSE(hold_end(task)) << "higher than the train's energy";
  task.held = end_of(task);
  task.program.speed = 4;
  task.program.channels[0] = {{0, 1}, {10, 3}};
  EXPECT_FALSE(hold_end(task)) << "the train stops on the way";
}

}  // namespace force_end_constraint_test
}  // namespace coaster::sim
