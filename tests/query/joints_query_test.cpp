// Queries of joints and of curvature: closed forms of the control points.
#include <cmath>

#include "base/portable_math.h"
#include "curve/continuity.h"
#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"
#include "sim/study/jolt.h"
#include "sim/study/track_errata.h"
#include "world/topology.h"

namespace coaster::query {
namespace joints_query_test {

class JointsQueryTest : public test::SessionTest {
 protected:
  base::Result<Value> ask(std::string_view name, std::string_view argument = {}) {
    const Query* const query = find_query(name);
    EXPECT_TRUE(query) << name;
    return query->evaluate({session, stats, "", ""}, argument);
  }
  double number(std::string_view name, std::string_view argument = {}) {
    return std::get<double>(*ask(name, argument));
  }
  std::string words(std::string_view name, std::string_view argument = {}) { return to_text(*ask(name, argument)); }
  curve::Cubic cubic(std::size_t i) const {
    return world::cubic_of(session.document, session.document.track.segments[i]);
  }
  FrameStats stats;
};

TEST_F(JointsQueryTest, a_joints_curvatures_are_the_closed_form_of_its_control_points) {
  const curve::Cubic before = cubic(1), after = cubic(2);
  const auto size = [](glm::vec3 d0, glm::vec3 d1) {
    return 2.0 / 3.0 * glm::length(glm::cross(glm::dvec3(d0), glm::dvec3(d1))) /
           std::pow(glm::length(glm::dvec3(d0)), 3);
  };
  const auto at_end = std::get<glm::dvec3>(*ask("curvature_before", "@k3")),
             at_start = std::get<glm::dvec3>(*ask("curvature_after", "@k3"));
  EXPECT_NEAR(glm::length(at_end), size(before.p3 - before.p2, before.p2 - before.p1), 1e-7);
  EXPECT_NEAR(glm::length(at_start), size(after.p1 - after.p0, after.p2 - after.p1), 1e-7);
  EXPECT_NEAR(number("curvature_jump", "@k3"), glm::length(at_start - at_end), 1e-12);
  EXPECT_LT(number("joint_angle", "@k3"), 1e-4);
  const glm::dvec3 second = 6.0 * (glm::dvec3(after.p0) - 2.0 * glm::dvec3(after.p1) + glm::dvec3(after.p2)) -
                            6.0 * (glm::dvec3(before.p3) - 2.0 * glm::dvec3(before.p2) + glm::dvec3(before.p1));
  EXPECT_NEAR(number("second_jump", "@k3"), glm::length(second), 1e-3);
}

TEST_F(JointsQueryTest, the_g_step_is_at_the_present_speed_of_the_first_cart) {
  EXPECT_NEAR(number("g_step", "@k3"), 3.3 * 3.3 * number("curvature_jump", "@k3") / 9.81, 1e-12);
  good("start_speed 20");
  EXPECT_NEAR(number("g_step", "@k3"), 400 * number("curvature_jump", "@k3") / 9.81, 1e-9);
  double most = 0;
  for (const char* knot : {"@k2", "@k3", "@k4"}) most = std::max(most, number("g_step", knot));
  EXPECT_EQ(number("g_step_max"), most);
  EXPECT_EQ(number("g_step", "@" + words("roughest_joint")), most);
  EXPECT_EQ(words("g_step", "@k1"), "none") << "an end joins nothing";
}

TEST_F(JointsQueryTest, the_ride_g_step_is_at_the_fastest_passage_of_all_cars) {
  good("start_speed 20");
  std::vector<double> fastest(5, 0.0);
  for (const sim::JointPassage& passage : edit::SessionFindings(session).ride()->passages)
    fastest[passage.knot] = std::max(fastest[passage.knot], std::abs(passage.speed));
  double most = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    const std::string knot = "@k" + std::to_string(i + 1);
    if (fastest[i] == 0) {
      EXPECT_EQ(words("ride.g_step", knot), "none") << knot;
      continue;
    }
    const double step = fastest[i] * fastest[i] * number("curvature_jump", knot) / 9.81;
    EXPECT_NEAR(number("ride.g_step", knot), step, 1e-9) << knot;
    most = std::max(most, step);
  }
  EXPECT_GT(most, 0.1);
  EXPECT_NEAR(number("ride.g_step_max"), most, 1e-9);
  EXPECT_EQ(words("ride.g_step", "@k1"), "none") << "an end joins nothing";
  good("remove @c1");
  good("remove @c2");
  EXPECT_EQ(words("ride.g_step", "@k3"), "none") << "no ride";
  EXPECT_EQ(words("ride.g_step_max"), "none");
}

TEST_F(JointsQueryTest, jolts_are_those_of_the_whole_ride_at_the_knots) {
  good("start_speed 20");
  std::vector<sim::Jolt> expected =
      sim::jolts(*edit::SessionFindings(session).ride(), edit::force_limits(session).cutoff);
  expected.resize(5);
  double most = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    const std::string knot = "@k" + std::to_string(i + 1);
    EXPECT_EQ(number("jolt", knot), expected[i].total) << knot;
    EXPECT_EQ(number("jolt.vertical", knot), expected[i].up) << knot;
    EXPECT_EQ(number("jolt.lateral", knot), expected[i].left) << knot;
    EXPECT_EQ(number("jolt.longitudinal", knot), expected[i].forward) << knot;
    most = std::max(most, number("jolt", knot));
  }
  EXPECT_GT(most, 0.1);
  for (const char* const end : {"@k1", "@k5"}) EXPECT_EQ(words("jolt", end), "none") << "an end joins nothing";
  EXPECT_EQ(number("ride.jolt_max"), most);
  EXPECT_EQ(number("jolt", "@" + words("ride.jolt_knot")), most);
  good("remove @c1");
  good("remove @c2");
  EXPECT_EQ(words("jolt", "@k3"), "none") << "no ride";
  EXPECT_EQ(words("ride.jolt_knot"), "none");
}

TEST_F(JointsQueryTest, a_repair_takes_the_step_away) {
  ASSERT_GT(number("curvature_jump", "@k3"), 1e-3);
  const double joints = number("joints_g2");
  good("make_g2 @k3");
  EXPECT_LT(number("curvature_jump", "@k3"), 1e-3);
  EXPECT_EQ(number("joints_g2"), joints + 1);
}

TEST_F(JointsQueryTest, curvature_and_torsion_are_of_the_selected_place) {
  EXPECT_EQ(words("curvature"), "none") << "nothing is selected";
  EXPECT_EQ(words("torsion"), "none");
  EXPECT_EQ(words("frenet"), "off");
  good("select @s2 at 0.37");
  const curve::Cubic c = cubic(1);
  const glm::dvec3 d = curve::derivative(c, 0.37), dd = curve::second_derivative(c, 0.37), across = glm::cross(d, dd);
  EXPECT_NEAR(number("curvature"), glm::length(across) / std::pow(glm::length(d), 3), 1e-12);
  EXPECT_NEAR(number("torsion"), glm::dot(across, curve::third_derivative(c)) / glm::dot(across, across), 1e-12);
  EXPECT_EQ(words("frenet"), "on");
  good("select @k3");
  EXPECT_NEAR(number("curvature"), glm::length(std::get<glm::dvec3>(*ask("curvature_after", "@k3"))), 1e-9);
  good("select @k5");
  EXPECT_NEAR(number("curvature"), curve::curvature(cubic(3), 1.0), 1e-12);
  good("select @c1");
  EXPECT_GT(number("curvature"), 0);
}

TEST_F(JointsQueryTest, at_a_cusp_there_is_no_curvature_and_over_it_no_twist) {
  good("new");
  good("append at 0 10 0");
  good("append at 20 10 0");
  good("direct @k1 to 1 0 1");
  good("direct @k2 to 1 0 -1");
  for (const char* knot : {"@k1", "@k2"})
    good(std::string("lengths ") + knot + " in 28.284271247461902 out 28.284271247461902");
  good("select @s1 at 0.5");
  for (const char* name : {"curvature", "torsion", "loop_twist"}) EXPECT_EQ(words(name), "none") << name;
  EXPECT_EQ(words("twist", "@s1"), "none");
  good("select @s1 at 0.4999");
  EXPECT_GT(number("curvature"), 100);
  good("lengths @k1 in 20 out 20");
  good("select @s1 at 0.5");
  EXPECT_GT(number("curvature"), 0);
  EXPECT_NEAR(number("twist", "@s1"), 0, 1e-9) << "level";
}

TEST_F(JointsQueryTest, frames_are_chosen_by_the_name_of_their_row) {
  for (const char* name : {"rmf", "frenet", "world_up", "knots"}) {
    good(std::string("frames_by ") + name);
    EXPECT_EQ(words("frames_by"), name);
    EXPECT_NEAR(glm::length(std::get<glm::dvec3>(*ask("cart_up"))), 1, 1e-9);
  }
  EXPECT_EQ(words("loop_twist"), "none");
  good("closed on");
  EXPECT_NE(number("loop_twist"), 0);
  EXPECT_LE(std::abs(number("loop_twist")), 180);
}

TEST_F(JointsQueryTest, errata_are_of_the_selected_segment) {
  good("select @s3");
  for (const std::string_view name : sim::kErrata) {
    const auto e = sim::erratum(session.derived, session.document.track.segments[2], 3.3, 64, name);
    EXPECT_EQ(number("erratum", name), e->right) << name;
    EXPECT_EQ(number("erratum_wrong", name), e->wrong) << name;
    EXPECT_NE(usage_of(find_query("erratum")->argument).find(name), std::string_view::npos) << name;
  }
  EXPECT_NEAR(number("erratum", "gravesen"), number("segment_length", "@s3"), 0.2 * number("segment_length", "@s3"));
  const auto unknown = ask("erratum", "gravisen");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.status().message.find("gravesen"), std::string::npos);
}

}  // namespace joints_query_test
}  // namespace coaster::query
