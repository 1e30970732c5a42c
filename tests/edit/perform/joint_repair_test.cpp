#include "edit/perform/joint_repair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/continuity.h"
#include "edit/session_fixture.h"
#include "sim/tracks.h"

namespace coaster::edit {
namespace joint_repair_test {

using curve::GeometricContinuity;
using curve::ParametricContinuity;
using world::Document;
using world::JointKind;
using world::Knot;

curve::JointContinuity class_at(const Document& d, std::size_t index) {
  const std::size_t count = d.track.segments.size();
  return curve::joint(world::cubic_of(d, d.track.segments[(index + count - 1) % count]),
                      world::cubic_of(d, d.track.segments[index % count]));
}
bool joins(const Document& d, std::size_t index) {
  return d.track.closed || (index > 0 && index + 1 < d.track.knots.size());
}

// Returns a track like a user's: knots about 17 m apart along a wavy way, crooked directions and lengths, given kinds.
Document wavy_track(std::uint32_t seed, bool closed, int knots = 9) {
  std::mt19937 bits(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  Document d;
  for (int i = 0; i < knots; ++i) {
    const double a = 2 * M_PI * i / knots, radius = 17.3 * knots / (2 * M_PI);
    // Braces: they fix the order of the draws, so every compiler gets the same track.
    const glm::dvec3 place{213.7 + radius * std::cos(a) + uniform(-2, 2), 31.1 + 4 * std::sin(3 * a) + uniform(-2, 2),
                           -91.9 - radius * std::sin(a) + uniform(-2, 2)};
    const glm::dvec3 way{-std::sin(a) + uniform(-0.2, 0.2), uniform(-0.3, 0.3), -std::cos(a) + uniform(-0.2, 0.2)};
    const auto kind = static_cast<JointKind>(bits() % 3);
    const auto in = static_cast<float>(uniform(4, 8)), out = static_cast<float>(uniform(4, 8));
    world::append_knot(
        d, test::skew_knot(glm::vec3(place), glm::vec3(way), kind == JointKind::smooth ? out : in, out, kind));
  }
  if (closed) world::set_closed(d, true);
  world::settle_joints(d);
  return d;
}

TEST(joint_repair, makes_a_joint_g2_and_the_other_joints_keep_their_class) {
  int repaired = 0, refused = 0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const Document before = wavy_track(seed, seed % 2 == 0);
    for (std::size_t k = 0; k < before.track.knots.size(); ++k) {
      if (!joins(before, k)) continue;
      Document d = before;
      double movement = -1;
      const base::Status status = make_g2(d, k, &movement);
      if (!status) {
        ++refused;
        EXPECT_FALSE(status.message.empty());
        EXPECT_TRUE(d == before);
        continue;
      }
      ++repaired;
      EXPECT_EQ(class_at(d, k).geometric, GeometricContinuity::g2);
      EXPECT_GE(movement, 0);
      EXPECT_EQ(world::broken_invariant(d), std::nullopt);
      Document settled = d;
      world::settle_joints(settled);
      EXPECT_TRUE(settled == d) << "the knots' own rules change nothing of it";
      for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
        if (!joins(d, i) || i == k) continue;
        EXPECT_GE(class_at(d, i).geometric, class_at(before, i).geometric);
        EXPECT_GE(class_at(d, i).parametric, class_at(before, i).parametric);
      }
      const Knot &was = world::knot(before, before.track.knots[k]), &is = world::knot(d, d.track.knots[k]);
      EXPECT_EQ(is.joint, was.joint == JointKind::automatic ? JointKind::aligned : was.joint);
    }
  }
  EXPECT_GT(repaired, 200);
  EXPECT_LT(refused, repaired / 10);
}

TEST(joint_repair, a_g2_neighbour_stays_g2) {
  int kept = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Document d = wavy_track(seed, true);
    if (!make_g2(d, 3)) continue;
    if (!make_g2(d, 4)) continue;
    EXPECT_EQ(class_at(d, 3).geometric, GeometricContinuity::g2);
    EXPECT_EQ(class_at(d, 4).geometric, GeometricContinuity::g2);
    ++kept;
  }
  EXPECT_GT(kept, 8);
}

TEST(joint_repair, moves_less_than_turning_the_tangent_alone) {
  // A smooth joint is G2 when its tangent runs along the line of the far handles: the repair by hand, by closed form.
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Document d = wavy_track(seed, true);
    for (std::size_t k = 0; k < d.track.knots.size(); ++k) {
      Knot& knot = d.entities.get<Knot>(d.track.knots[k]);
      knot.joint = JointKind::smooth;
      knot.in_length = knot.out_length;
    }
    const Document before = d;
    const curve::Cubic one = world::cubic_of(d, d.track.segments[4]), two = world::cubic_of(d, d.track.segments[5]);
    const Knot& knot = world::knot(d, d.track.knots[5]);
    const glm::dvec3 tangent = glm::normalize(glm::dvec3(two.p2) - glm::dvec3(one.p1));
    const double by_hand = std::sqrt(2.0) * knot.out_length * glm::length(tangent - glm::dvec3(knot.tangent));
    double movement = 0;
    const base::Status status = make_g2(d, 5, &movement);
    if (!status) continue;
    EXPECT_LE(movement, by_hand + 1e-4) << seed;
  }
}

TEST(joint_repair, a_c2_joint_stays_c2) {
  // Splitting in the middle twice gives joints that are C2; the one between the halves is left alone when its neighbour
  // is repaired.
  Document d = wavy_track(3, true);
  for (const world::Entity e : d.track.knots) d.entities.get<Knot>(e).joint = JointKind::aligned;
  const world::SplitResult split = world::split_segment(d, d.track.segments[2], 0.5, {0, 1, 0});
  const std::size_t at = *world::index_of(d.track.knots, split.knot);
  ASSERT_EQ(class_at(d, at).parametric, ParametricContinuity::c2);
  const base::Status status = make_g2(d, at - 1);
  ASSERT_TRUE(status) << status.message;
  EXPECT_EQ(class_at(d, at).parametric, ParametricContinuity::c2);
  EXPECT_EQ(class_at(d, at - 1).geometric, GeometricContinuity::g2);
}

TEST(joint_repair, a_straight_into_a_bend_is_repaired_or_refused_but_never_bent_where_it_is_straight_on) {
  Document d;
  for (const float x : {0.0f, 15.0f, 30.0f})
    world::append_knot(d, test::skew_knot({103.3f + x, 21.7f, 7.7f}, {1, 0, 0}, 5, 5));
  world::append_knot(d, test::skew_knot({143.3f, 21.7f, -7.7f}, {0.1f, 0, -1}, 6, 6));
  ASSERT_EQ(class_at(d, 1).geometric, GeometricContinuity::g2);
  ASSERT_EQ(class_at(d, 2).geometric, GeometricContinuity::g1);
  const Document before = d;
  if (const base::Status status = make_g2(d, 2); status) {
    EXPECT_EQ(class_at(d, 2).geometric, GeometricContinuity::g2);
    EXPECT_EQ(class_at(d, 1).geometric, GeometricContinuity::g2);
  } else {
    EXPECT_TRUE(d == before);
    EXPECT_FALSE(status.message.empty());
  }
}

TEST(joint_repair, refuses_at_an_end_and_where_rounding_hides_the_curvature) {
  Document d = wavy_track(5, false);
  EXPECT_EQ(make_g2(d, 0).code, base::Code::refused);
  EXPECT_EQ(make_g2(d, d.track.knots.size() - 1).code, base::Code::refused);
  // 90 km out coordinates are 8 mm apart: handles of half a metre cannot say their curvature to 1e-3.
  for (const world::Entity e : d.track.knots) {
    Knot& knot = d.entities.get<Knot>(e);
    knot.joint = JointKind::smooth;
    knot.position += glm::vec3(90'000, 0, 90'000);
    knot.in_length = knot.out_length = 0.31f;
  }
  const Document before = d;
  int refused = 0;
  for (std::size_t i = 1; i + 1 < d.track.knots.size(); ++i) {
    const base::Status status = make_g2(d, i);
    if (status) continue;
    ++refused;
    EXPECT_FALSE(status.message.empty());
  }
  EXPECT_GT(refused, 0);
}

TEST(joint_repair, two_knots_that_are_each_others_neighbours_on_both_sides) {
  Document d;
  world::append_knot(d, test::skew_knot({13.3f, 7.1f, -5.9f}, {0.1f, 0.2f, 1}, 8, 11));
  world::append_knot(d, test::skew_knot({43.3f, 9.1f, -3.9f}, {0.1f, -0.3f, -1}, 12, 9));
  world::set_closed(d, true);
  const base::Status first = make_g2(d, 0);
  EXPECT_TRUE(!first || class_at(d, 0).geometric == GeometricContinuity::g2);
  const base::Status second = make_g2(d, 1);
  EXPECT_TRUE(!second || class_at(d, 1).geometric == GeometricContinuity::g2);
  EXPECT_TRUE(!first || class_at(d, 0).geometric == GeometricContinuity::g2) << "after the second";
  EXPECT_EQ(world::broken_invariant(d), std::nullopt);
}

TEST(joint_repair, the_whole_track_becomes_g2_without_losing_a_class) {
  int changed = 0, refused = 0;
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    const Document before = wavy_track(seed, seed % 2 == 0);
    Document d = before;
    const RepairReport report = make_all_g2(d);
    changed += report.changed;
    refused += static_cast<int>(report.refused.size());
    int g2 = 0, joints = 0;
    for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
      if (!joins(d, i)) continue;
      ++joints;
      g2 += class_at(d, i).geometric == GeometricContinuity::g2;
      EXPECT_GE(class_at(d, i).geometric, class_at(before, i).geometric);
      EXPECT_GE(class_at(d, i).parametric, class_at(before, i).parametric);
    }
    EXPECT_EQ(g2, report.changed + report.already);
    EXPECT_EQ(joints, g2 + static_cast<int>(report.refused.size()));
    EXPECT_EQ(world::broken_invariant(d), std::nullopt);
    Document again = d;
    EXPECT_EQ(make_all_g2(again).changed, 0) << seed << ": what was refused stays refused";
  }

  EXPECT_GT(changed, 100);
  EXPECT_LT(refused, changed / 4);
}

class RepairCommands : public test::SessionTest {
 protected:
  RepairCommands() : SessionTest(wavy_track(4, true)) {}
};

TEST_F(RepairCommands, one_joint_is_one_step_and_undo_restores_the_hash) {
  const std::uint64_t before = world::hash(session.document);
  good("make_g2 @k4");
  EXPECT_NE(world::hash(session.document), before);
  EXPECT_EQ(session.history.undo.size(), 1u);
  EXPECT_NE(session.notices.list.back().text.find("Made the joint G2 by moving"), std::string::npos);
  good("make_g2 @k4");
  EXPECT_EQ(session.history.undo.size(), 1u) << "it was G2";
  good("undo");
  EXPECT_EQ(world::hash(session.document), before);
}

TEST_F(RepairCommands, the_whole_track_is_one_step_and_says_what_it_did) {
  const std::uint64_t before = world::hash(session.document);
  good("make_all_g2");
  EXPECT_EQ(session.history.undo.size(), 1u);
  EXPECT_NE(session.notices.list.back().text.find(" G2 by moving "), std::string::npos)
      << session.notices.list.back().text;
  good("undo");
  EXPECT_EQ(world::hash(session.document), before);
}

TEST_F(RepairCommands, refuse_unknown_knots_and_ends) {
  refused("make_g2 @k99", "no knot");
  good("closed off");
  refused("make_g2 @k1", "end of an open track");
}

}  // namespace joint_repair_test
}  // namespace coaster::edit
