#include <cmath>

#include <gtest/gtest.h>

#include "curve/continuity.h"
#include "edit/session_fixture.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace perform_shape_test {

using glm::dvec3;
using world::JointKind;
using world::Knot;

// An open wavy track of seven knots, k1 to k7.
world::Document waves(bool closed = false) {
  world::Document document;
  for (int i = 0; i < 7; ++i) {
    Knot knot;
    const float f = static_cast<float>(i);
    knot.position = {12 * f + 3 * std::sqrt(f), 6 + 4 * static_cast<float>(i % 3), 5 * static_cast<float>((i * 2) % 5)};
    if (closed) knot.position = {30 * (i < 4 ? 1.0f : -1.0f) + f, 8 + f, 20 * (i % 4 - 1.5f)};
    knot.in_length = knot.out_length = 3;
    world::append_knot(document, knot);
  }
  world::set_closed(document, closed);
  return document;
}

class Shaping : public test::SessionTest {
 protected:
  Shaping() : SessionTest(waves()) {}
  const Knot& k(int number) const {
    return world::knot(session.document,
                       world::find(session.document, {world::EntityKind::knot, static_cast<std::uint32_t>(number)}));
  }
  curve::JointContinuity joint_at(int number) const {
    const auto at = world::neighbours(
        session.document, world::find(session.document, {world::EntityKind::knot, static_cast<std::uint32_t>(number)}));
    return curve::joint(world::cubic_of(session.document, at.before), world::cubic_of(session.document, at.after));
  }
};
class ShapingClosed : public Shaping {
 protected:
  ShapingClosed() { start_on(waves(true)); }
};

TEST_F(Shaping, smooth_makes_every_inner_joint_g2_and_frees_the_ends_of_curvature) {
  good("smooth all");
  for (int i = 2; i <= 6; ++i) EXPECT_GE(joint_at(i).geometric, curve::GeometricContinuity::g2) << i;
  const auto& track = session.document.track;
  EXPECT_LT(curve::curvature(world::cubic_of(session.document, track.segments.front()), 0), 1e-5);
  EXPECT_LT(curve::curvature(world::cubic_of(session.document, track.segments.back()), 1), 1e-5);
}

TEST_F(Shaping, smooth_by_equal_steps_is_c2) {
  good("smooth all by uniform");
  for (int i = 2; i <= 6; ++i) {
    EXPECT_GE(joint_at(i).parametric, curve::ParametricContinuity::c2) << i;
    EXPECT_EQ(k(i).joint, JointKind::smooth);
  }
}

TEST_F(ShapingClosed, smooth_goes_all_the_way_round) {
  good("smooth all");
  for (int i = 1; i <= 7; ++i) EXPECT_GE(joint_at(i).geometric, curve::GeometricContinuity::g2) << i;
}

TEST_F(Shaping, smooth_of_some_leaves_the_others_to_the_bit) {
  const Knot two = k(2), six = k(6), five = k(5);
  good("smooth @k4,@k3");
  EXPECT_EQ(k(2), two);
  EXPECT_EQ(k(5), five);
  EXPECT_EQ(k(6), six);
  EXPECT_GE(joint_at(3).geometric, curve::GeometricContinuity::g2);
  EXPECT_GE(joint_at(4).geometric, curve::GeometricContinuity::g2);
}

TEST_F(ShapingClosed, a_run_over_the_tracks_joint_is_one_run) {
  const Knot two = k(2), six = k(6);
  good("smooth @k7,@k1");
  EXPECT_GE(joint_at(7).geometric, curve::GeometricContinuity::g2);
  EXPECT_GE(joint_at(1).geometric, curve::GeometricContinuity::g2);
  EXPECT_EQ(k(2), two);
  EXPECT_EQ(k(6), six);
}

TEST_F(Shaping, equalise_takes_the_mean_of_both_handles) {
  good("lengths @k3 in 2 out 7");
  good("equalise @k3,@k4");
  EXPECT_EQ(k(3).in_length, 4.5f);
  EXPECT_EQ(k(3).out_length, 4.5f);
  EXPECT_EQ(k(3).joint, JointKind::smooth);
}

TEST_F(Shaping, straighten_puts_a_run_on_its_chord) {
  good("straighten @k2,@k3,@k4,@k5");
  const dvec3 start(k(2).position), way = glm::normalize(dvec3(k(5).position) - start);
  for (int i = 2; i <= 5; ++i) {
    const dvec3 off = dvec3(k(i).position) - start;
    EXPECT_LT(glm::length(off - glm::dot(off, way) * way), 1e-5) << i;
    EXPECT_LT(glm::length(dvec3(k(i).tangent) - way), 1e-6) << i;
  }
  for (int i = 1; i < 4; ++i)
    EXPECT_LT(curve::curvature(
                  world::cubic_of(session.document, session.document.track.segments[static_cast<std::size_t>(i)]), 0.3),
              1e-5);
  refused("straighten @k2,@k5", "two neighbouring knots");
}

TEST_F(Shaping, radius_is_what_was_asked_for_on_both_sides) {
  good("smooth all");
  good("radius @k3,@k4,@k6 to 17.5");
  for (const int i : {3, 4, 6}) {
    const auto at = world::neighbours(
        session.document, world::find(session.document, {world::EntityKind::knot, static_cast<std::uint32_t>(i)}));
    EXPECT_NEAR(1 / curve::curvature(world::cubic_of(session.document, at.before), 1), 17.5, 1e-3) << i;
    EXPECT_NEAR(1 / curve::curvature(world::cubic_of(session.document, at.after), 0), 17.5, 1e-3) << i;
  }
  good("straighten @k1,@k2");
  refused("radius @k1 to 5", "straight");
}

TEST_F(Shaping, drop_puts_knots_on_the_ground_and_level) {
  good("direct @k3 to 1 1 1");
  good("drop @k3,@k5");
  EXPECT_EQ(k(3).position.y, 0.0f);
  EXPECT_EQ(k(5).position.y, 0.0f);
  EXPECT_EQ(k(3).tangent.y, 0.0f);
  EXPECT_NE(k(4).position.y, 0.0f);
  good("drop @k3 to 2.5");
  EXPECT_EQ(k(3).position.y, 2.5f);
}

TEST_F(Shaping, one_command_speaks_of_named_all_or_selected_knots) {
  refused("roll selected to 10", "no knot is selected");
  good("select_knots @k2,@k5");
  good("roll selected to 10");
  EXPECT_NEAR(world::roll_deg(k(2)), 10, 1e-4);
  EXPECT_NEAR(world::roll_deg(k(5)), 10, 1e-4);
  EXPECT_NEAR(world::roll_deg(k(3)), 0, 1e-4);
  good("joint all to aligned");
  for (int i = 1; i <= 7; ++i) EXPECT_EQ(k(i).joint, JointKind::aligned);
  refused("roll @k2,@k99 to 1", "no knot @k99");
  refused("roll none to 1", "found none");
}

TEST_F(Shaping, selecting_many_keeps_the_last_named_active_and_forgets_the_dead) {
  good("select_knots @k5,@k2,@k3");
  EXPECT_EQ(world::selected_knots(session.document, session.settings).size(), 3u);
  EXPECT_EQ(world::label_of(session.document, session.settings.selected), "k3");
  good("remove @k3");
  EXPECT_EQ(world::selected_knots(session.document, session.settings).size(), 2u);
  EXPECT_TRUE(session.settings.selected.valid());
  good("select @k1");
  EXPECT_EQ(world::selected_knots(session.document, session.settings).size(), 1u);
  good("select_knots all");
  EXPECT_EQ(world::selected_knots(session.document, session.settings).size(), 6u);
  good("select none");
  EXPECT_TRUE(world::selected_knots(session.document, session.settings).empty());
}

TEST_F(Shaping, every_one_of_them_is_one_step_of_undo) {
  for (const char* line :
       {"smooth all", "equalise all", "straighten @k2,@k3,@k4", "drop all", "radius @k4 to 30", "align all axis x to 3",
        "mirror all across 1 0 0 about 0 0 0", "translate @k2,@k3 by 1 2 3", "rotate all by 30 about 0 0 0",
        "scale_knots all by 1 2 1 about 0 0 0", "reverse", "duplicate @k2,@k3", "close within 0"}) {
    start_on(waves());
    good("lengths @k3 in 2 out 7");
    const world::Document before = session.document;
    const std::size_t steps = session.history.undo.size();
    good(line);
    EXPECT_EQ(session.history.undo.size(), steps + 1) << line;
    const world::Document after = session.document;
    good("undo");
    EXPECT_TRUE(session.document == before) << line;
    good("redo");
    EXPECT_TRUE(session.document == after) << line;
  }
}

}  // namespace perform_shape_test
}  // namespace coaster::edit
