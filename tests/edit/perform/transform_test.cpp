// Tests moving, turning, scaling and mirroring knots (edit/perform/knots.cpp).
#include <gtest/gtest.h>

#include "edit/commands/commands_shape.h"
#include "edit/session_fixture.h"
#include "sim/shape/derived_track.h"
#include "world/topology.h"

namespace coaster::edit {
namespace perform_transform_test {

using glm::dvec3;
using world::Knot;

class Transforming : public test::SessionTest {
 protected:
  Transforming() { good("joint @k4 to aligned"); }  // an automatic one would follow its neighbours
  std::vector<Knot> knots() const {
    std::vector<Knot> all;
    for (const world::Entity e : session.document.track.knots) all.push_back(world::knot(session.document, e));
    return all;
  }
  double length() const { return world::exact_length(session.document); }
};

TEST_F(Transforming, translate_moves_the_named_alone) {
  const std::vector<Knot> before = knots();
  good("translate @k1,@k3 by 1 -2 0.5");
  const std::vector<Knot> after = knots();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const bool moved = i == 0 || i == 2;
    EXPECT_EQ(after[i].position, moved ? glm::vec3(dvec3(before[i].position) + dvec3(1, -2, 0.5)) : before[i].position);
    EXPECT_EQ(after[i].tangent, before[i].tangent);
  }
}

TEST_F(Transforming, anew_replaces_what_the_gesture_did_before) {
  const std::vector<Knot> before = knots();
  good("gesture.begin");
  for (int i = 0; i < 50; ++i) good("translate all by " + std::to_string(i) + ".3 0 0 from_start on");
  good("rotate all by 200 about 1 2 3 from_start on");
  good("translate all by 2 0 0 from_start on");
  good("gesture.end");
  const std::vector<Knot> after = knots();
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_EQ(after[i].position, glm::vec3(dvec3(before[i].position) + dvec3(2, 0, 0)));
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].tangent, before[i].tangent);
}

TEST_F(Transforming, a_quarter_turn_about_the_vertical_takes_x_to_minus_z) {
  const std::vector<Knot> before = knots();
  const double length_before = length();
  good("rotate all by 90 about 0 0 0");
  const std::vector<Knot> after = knots();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto turned = [](glm::vec3 v) { return dvec3(v.z, v.y, -v.x); };
    EXPECT_LT(glm::length(dvec3(after[i].position) - turned(before[i].position)), 1e-4);
    EXPECT_LT(glm::length(dvec3(after[i].tangent) - turned(before[i].tangent)), 1e-6);
    EXPECT_LT(glm::length(dvec3(after[i].up) - turned(before[i].up)), 1e-6);
  }
  EXPECT_NEAR(length(), length_before, 1e-4 * length_before);
}

TEST_F(Transforming, scaling_all_by_two_doubles_the_length) {
  const double before = length();
  good("scale_knots all by 2 2 2 about 3 4 5");
  EXPECT_NEAR(length(), 2 * before, 1e-5 * before);
  refused("scale_knots all by 1 0 1 about 0 0 0", "factor");
}

TEST_F(Transforming, mirroring_twice_is_nothing_and_once_turns_rolls_round) {
  good("roll @k2 to 25");
  const std::vector<Knot> before = knots();
  const double length_before = length();
  good("mirror all across 0 0 2 about 0 0 1");
  EXPECT_NEAR(world::roll_deg(knots()[1]), -25, 1e-3);
  EXPECT_NEAR(length(), length_before, 1e-4 * length_before);
  good("mirror all across 0 0 2 about 0 0 1");
  const std::vector<Knot> after = knots();
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_LT(glm::length(dvec3(after[i].position) - dvec3(before[i].position)), 1e-4);
    EXPECT_LT(glm::length(dvec3(after[i].up) - dvec3(before[i].up)), 1e-6);
  }
}

TEST_F(Transforming, mirrored_twists_go_the_other_way) {
  const world::Entity segment = session.document.track.segments.front();
  const std::string name = "@" + world::label_of(session.document, segment);
  good("turns " + name + " to 2");
  const double twist = session.derived.shape(segment).roll.twist;
  good("mirror all across 1 0 0 about 0 0 0");
  EXPECT_EQ(world::segment(session.document, segment).turns, -2);
  EXPECT_NEAR(session.derived.shape(segment).roll.twist, -twist, 1e-3);
}

TEST_F(Transforming, a_twist_between_a_mirrored_knot_and_one_that_stays_keeps_its_turns) {
  good("turns @s2 to 2");
  for (const char* const knot : {"@k2", "@k3"}) {
    good(std::string("mirror ") + knot + " across 1 0 0 about 0 0 0");
    EXPECT_EQ(world::segment(session.document, entity("s2")).turns, 2) << knot;
  }
}

TEST_F(Transforming, align_gives_one_coordinate_to_all) {
  good("align all axis y to 7.25");
  for (const Knot& knot : knots()) EXPECT_EQ(knot.position.y, 7.25f);
  clamped("align @k1 axis x to 1e9", "limit");
}

TEST_F(Transforming, nonsense_is_refused_or_cut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Translate translate{Knots::Which::all, {nan, 0, 0}};
  refused(Command(translate), "finite");
  Rotate rotate{Knots::Which::all, 1, {0, 0, 0}, {0, 0, 0}};
  refused(Command(rotate), "axis");
  Mirror mirror{Knots::Which::all, {0, 0, 0}, {0, 0, 0}};
  refused(Command(mirror), "normal");
  clamped("translate @k1 by 3e38 0 0", "limit");
  clamped("scale_knots all by 9000 9000 9000 about 0 0 0", "limit");
}

}  // namespace perform_transform_test
}  // namespace coaster::edit
