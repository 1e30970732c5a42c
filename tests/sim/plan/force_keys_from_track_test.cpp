#include "sim/plan/force_keys_from_track.h"

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/force_oracle.h"
#include "world/topology.h"

namespace coaster::sim {
namespace force_keys_from_track_test {

world::Document document_of(const std::vector<world::Knot>& knots) {
  world::Document document;
  for (const world::Knot& knot : knots) world::append_knot(document, knot);
  return document;
}

RunForcePlan read(const ForceTask& task, const std::vector<world::Knot>& knots) {
  const DerivedTrack derived = shapes_of(document_of(knots));
  return read_forces({derived, 0, derived.order.size()}, task);
}

// Largest distance of a fine polyline of the one from one of the other: brute force.
double apart(const std::vector<world::Knot>& from, const std::vector<world::Knot>& to) {
  const auto points = [](const std::vector<world::Knot>& knots, int steps) {
    std::vector<glm::dvec3> all;
    const DerivedTrack derived = shapes_of(document_of(knots));
    for (std::size_t k = 0; k < derived.order.size(); ++k)
      for (int i = 0; i <= steps; ++i)
        all.push_back(curve::point(derived.shape_at(k).key.cubic, static_cast<double>(i) / steps));
    return all;
  };
  const auto fine = points(to, 200);
  double most = 0;
  for (const glm::dvec3 here : points(from, 11)) {
    double least = 1e9;
    for (std::size_t i = 1; i < fine.size(); ++i) {
      const glm::dvec3 chord = fine[i] - fine[i - 1], way = here - fine[i - 1];
      const double t = std::clamp(glm::dot(way, chord) / std::max(glm::dot(chord, chord), 1e-12), 0.0, 1.0);
      least = std::min(least, glm::distance(way, t * chord));
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(RunForcePlan, keeps_the_shape_of_random_force_sections) {
  test::RandomForces random(19);
  for (int i = 0; i < test::tries(3); ++i) {
    ForceTask task = random.next(90);
    const ForcePlan was = plan_force(task);
    ASSERT_TRUE(was.refusal.empty()) << was.refusal;
    const RunForcePlan reading = read(task, was.fit.spans.knots);
    ASSERT_EQ(reading.refusal, "") << i;
    const std::vector<world::Knot>& now = reading.plan.fit.spans.knots;
    EXPECT_LE(reading.error, kKeptShape);
    EXPECT_NEAR(apart(now, was.fit.spans.knots), reading.error, 1e-3);
    const world::Knot &end = was.fit.spans.knots.back(), &last = now.back();
    EXPECT_LT(glm::distance(last.position, end.position), 1e-4f);
    EXPECT_LT(glm::distance(last.tangent, end.tangent), 2e-5f);
    EXPECT_LT(glm::distance(last.up, end.up), 2e-5f);
    for (const auto& keys : reading.plan.task.program.channels) EXPECT_LE(keys.size(), 45u);
  }
}

TEST(RunForcePlan, reads_constant_g_off_a_circle) {
  // A flat turn of 40 m radius, a quarter, by four spans; its riders feel v^2/(r g) sideways and 1 g.
  std::vector<world::Knot> knots;
  const double radius = 40, turn = std::acos(-1.0) / 8;
  for (int i = 0; i <= 4; ++i) {
    world::Knot knot;
    const double a = i * turn;
    knot.position = glm::vec3(radius * std::sin(a), 10, -radius * (1 - std::cos(a)));
    knot.tangent = glm::vec3(std::cos(a), 0, -std::sin(a)), knot.up = {0, 1, 0};
    knot.in_length = knot.out_length = static_cast<float>(4.0 / 3 * std::tan(turn / 4) * radius);
    knots.push_back(knot);
  }
  ForceTask task;
  task.end.position = {0, 10, 0}, task.end.curvature = {0, 0, -1 / radius};
  task.program.speed = 20;
  const RunForcePlan reading = read(task, knots);
  ASSERT_EQ(reading.refusal, "");
  const world::ForceProgram& program = reading.plan.task.program;
  EXPECT_NEAR(program.length, 2 * std::acos(0.0) / 2 * radius, 0.01);
  for (const world::ForceKey& key : program.channels[0]) EXPECT_NEAR(key.value, 1, 0.02);
  for (const world::ForceKey& key : program.channels[1]) EXPECT_NEAR(key.value, 400 / radius / world::kGravity, 0.03);
  for (const world::ForceKey& key : program.channels[2]) EXPECT_NEAR(key.value, 0, 0.05);
  for (const auto& keys : program.channels) EXPECT_LE(keys.size(), 5u);
}

TEST(RunForcePlan, says_why_it_cannot) {
  std::vector<world::Knot> knots(2);
  knots[0].position = {0, 10, 0}, knots[1].position = {2, 10, 0};
  for (world::Knot& knot : knots) knot.tangent = {1, 0, 0}, knot.in_length = knot.out_length = 0.6f;
  ForceTask task;
  task.end.position = {0, 10, 0};
  EXPECT_NE(read(task, knots).refusal.find("expected 3 to 1000"), std::string::npos);
  knots[1].position = {40, 50, 0};
  for (world::Knot& knot : knots)
    knot.tangent = glm::normalize(glm::vec3(1, 1, 0)), knot.up = glm::normalize(glm::vec3(-1, 1, 0)),
    knot.in_length = knot.out_length = 15;
  task.end.forward = glm::normalize(glm::dvec3(1, 1, 0)), task.end.up = glm::normalize(glm::dvec3(-1, 1, 0));
  task.program.speed = 20;
  EXPECT_NE(read(task, knots).refusal.find("falls below 3 m/s"), std::string::npos);
  // Begins bent, where the track before it ends straight: the ramp cannot follow a turn of 6 m radius.
  task = {}, task.end.position = {0, 10, 0}, task.program.speed = 25;
  knots = std::vector<world::Knot>(2);
  knots[0].position = {0, 10, 0}, knots[0].tangent = {1, 0, 0};
  knots[1].position = {6, 16, 0}, knots[1].tangent = {0, 1, 0}, knots[1].up = {-1, 0, 0};
  for (world::Knot& knot : knots) knot.in_length = knot.out_length = 3.3f;
  EXPECT_NE(read(task, knots).refusal, "");
}

}  // namespace force_keys_from_track_test
}  // namespace coaster::sim
