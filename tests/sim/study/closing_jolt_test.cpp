// The jolt of a closing section, compared with closed forms: a jump of curvature, planted at the open end of a level
// straight, steps the vertical g of its riders by v^2 times the jump over g.
#include "sim/study/complete_circuit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "curve/continuity.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace closing_jolt_test {

constexpr float kSpeed = 14;  // m/s

world::Document straight(bool train) {
  world::Document d;
  for (const float x : {0.0f, 60.0f}) world::append_knot(d, test::skew_knot({x, 5, 0}, {1, 0, 0}, 20, 20));
  d.start_speed = kSpeed;
  d.heartline = 0;  // riders higher up would also be thrown forwards
  if (train) world::add_cart(d, d.track.segments.front(), 0);
  return d;
}

struct Home {
  world::Document document;
  world::Entity cart;
  CircuitProposals found;
  double worst(ClosingJolts& cache, std::size_t index = 0) const {
    return cache.worst(found, index, document, 1, cart, 5);
  }
};

Home home_of(bool train) {
  Home home{straight(train), world::kNone, {}};
  const DerivedTrack derived = test::derived_of(home.document);
  if (train) home.cart = home.document.entities.pool<world::Train>().entities().front();
  RideCache rides;
  Conflicts conflicts;
  conflicts.update(derived);
  home.found = ProposalCache().update(home.document, derived, conflicts,
                                      train ? rides.ride(home.document, derived, home.cart) : nullptr);
  return home;
}

TEST(closing_jolt, is_small_at_the_joints_of_a_planned_way) {
  const Home home = home_of(true);
  ASSERT_FALSE(home.found.list.empty()) << home.found.refusal;
  ClosingJolts cache;
  for (std::size_t i = 0; i < home.found.list.size(); ++i) {
    EXPECT_LT(home.worst(cache, i), 0.3);
    EXPECT_GT(home.worst(cache, i), 0);
  }
}

TEST(closing_jolt, tells_a_jump_of_curvature_at_the_open_end) {
  Home home = home_of(true);
  ASSERT_FALSE(home.found.list.empty()) << home.found.refusal;
  CircuitProposal& closing = home.found.list.front();
  closing.plan.serial = 1;
  // Lowers the second knot: the first span then leaves the straight with curvature, 2/3 of the height over the square
  // of its handle. At the next two knots the curvatures differ, too.
  constexpr float kDown = 0.05f;
  world::Knot& second = closing.plan.fit.knots.at(1);
  second.position.y -= kDown;
  world::Document closed = home.document;
  close_by(closed, closing);
  const auto cubic = [&](std::size_t i) { return world::cubic_of(closed, closed.track.segments[i]); };
  double jump = 0;
  for (const std::size_t i : {1u, 2u, 3u})
    jump = std::max(jump,
                    glm::distance(curve::curvature_vector(cubic(i), 0.0), curve::curvature_vector(cubic(i - 1), 1.0)));
  const double step = kSpeed * kSpeed * jump / world::kGravity;
  ASSERT_GT(step, 0.5);
  // A Butterworth low-pass of four poles overshoots a step by 11 %.
  ClosingJolts cache;
  EXPECT_NEAR(home.worst(cache), 1.11 * step, 0.03 * step);
}

TEST(closing_jolt, is_0_without_a_train_and_follows_the_track) {
  const Home none = home_of(false);
  ASSERT_FALSE(none.found.list.empty());
  ClosingJolts cache;
  EXPECT_EQ(none.worst(cache), 0);
  const Home home = home_of(true);
  EXPECT_GT(home.worst(cache), 0) << "another train: not the cached value";
}

}  // namespace closing_jolt_test
}  // namespace coaster::sim
