// Goals, and searches for them by the command seek.
#include "query/condition.h"

#include <cmath>

#include <fmt/format.h>

#include "base/folders.h"
#include "edit/session_fixture.h"
#include "exchange/formats.h"
#include "query/challenge_rules.h"
#include "query/context.h"
#include "world/sections.h"

namespace coaster::query {
namespace goal_test {

class Goals : public test::SessionTest {
 protected:
  Goals() { session.game.referee = referee(); }
  double value(std::string_view name, std::string_view argument = {}) {
    const auto found = find_query(name)->evaluate({session, stats, "", ""}, argument);
    return found ? std::get<double>(*found) : std::nan("");
  }
  void unreadable(const std::string& goal, std::string_view part) {
    const auto state = measure_goal(session, goal);
    ASSERT_FALSE(state) << goal;
    EXPECT_EQ(state.status().code, base::Code::usage);
    EXPECT_NE(state.status().message.find(part), std::string::npos) << state.status().message;
  }
  std::string note() const { return session.notices.list.back().text; }
  double height(const char* knot) { return world::knot(session.document, entity(knot)).position.y; }
  FrameStats stats;
};

TEST_F(Goals, are_measured_within_their_tolerance) {
  const double length = value("exact_length");
  const auto exact = measure_goal(session, "exact_length == " + base::to_text(length));
  ASSERT_TRUE(exact);
  EXPECT_TRUE(exact->met);
  EXPECT_EQ(exact->name, "Length of the track");
  EXPECT_EQ(exact->unit, "m");
  EXPECT_DOUBLE_EQ(exact->tolerance, 1e-3 * length);
  EXPECT_FALSE(measure_goal(session, "exact_length == " + base::to_text(length + 1))->met);
  EXPECT_TRUE(measure_goal(session, "exact_length == " + base::to_text(length + 1) + " +-1.5")->met);
  EXPECT_TRUE(measure_goal(session, "exact_length <= " + base::to_text(length + 1))->met);
  const auto more = measure_goal(session, "exact_length >= " + base::to_text(length + 1) + " +-0.1");
  EXPECT_FALSE(more->met);
  EXPECT_GE(more->wanted - more->tolerance, length + 1) << "what is found within the tolerance is allowed";
}

TEST_F(Goals, that_cannot_be_read_say_why) {
  unreadable("lap_tim == 3", "no query");
  unreadable("ride.lap_time", "a number");
  unreadable("ride.lap_time != 3", "a number");
  unreadable("ride.lap_time == fast", "expected a number (s), found \"fast\"");
  unreadable("ride.lap_time == 1 2", "one number");
  unreadable("fps == 60", "\"fps\" cannot be sought");
  unreadable("length == 60", "cannot be sought");
}

// A goal that has a solution: the value on a track that was changed by hand.
struct Task {
  std::string query, argument;
  std::string by, of;
  std::string plant = {};  // the change
};

double distance_of(const world::Document& a, const world::Document& b) {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.track.knots.size(), b.track.knots.size()); ++i)
    sum += std::pow(glm::distance(world::knot(a, a.track.knots[i]).position, world::knot(b, b.track.knots[i]).position),
                    2);
  return std::sqrt(sum);
}

class PlantedGoals : public Goals {
 protected:
  void solve(const Task& task) {
    SCOPED_TRACE(task.query + " " + task.argument + " by " + task.by + " of " + task.of);
    const world::Document start = session.document;
    const double before = value(task.query, task.argument);
    good(task.plant);
    const double wanted = value(task.query, task.argument), planted = distance_of(start, session.document);
    const double tolerance = 2e-3 * std::max(1.0, std::abs(wanted));
    ASSERT_GT(std::abs(wanted - before), tolerance) << "a task";
    start_on(start);
    good(fmt::format("seek {}{}{} == {} +-{} by {} of {}", task.query, task.argument.empty() ? "" : " ", task.argument,
                     base::to_text(wanted), base::to_text(tolerance), task.by, task.of));
    EXPECT_NEAR(value(task.query, task.argument), wanted, tolerance) << note();
    EXPECT_LE(distance_of(start, session.document), 1.3 * planted + 0.05) << note();
    EXPECT_EQ(session.history.undo.size(), 1u);
    good("undo");
    EXPECT_TRUE(session.document == start);
  }
};

TEST_F(PlantedGoals, of_the_track_are_reached_by_as_little_change) {
  for (const Task& task : std::vector<Task>{{"exact_length", "", "height", "@k2..@k4", "translate @k2..@k4 by 0 2 0"},
                                            {"exact_length", "", "place", "@k3", "translate @k3 by 4 1 -3"},
                                            {"open_end.distance", "", "x", "@k5", "translate @k5 by 6 0 0"},
                                            {"open_end.distance", "", "place", "@k4,@k5", "translate @k5 by -3 2 4"},
                                            {"ride.height_max", "", "height", "all", "translate @k2 by 0 5 0"},
                                            {"ride.height_max", "", "height", "@k2", "translate @k2 by 0 -1 0"}})
    solve(task);
}

TEST_F(PlantedGoals, of_a_circuit_are_reached_by_as_little_change) {
  auto loaded = exchange::load_track(files, (base::data_folder() / "tracks/loop.json").string());
  ASSERT_TRUE(loaded) << loaded.status().message;
  start_on(loaded->document);
  for (const Task& task :
       std::vector<Task>{{"ride.lap_time", "", "height", "@k14..@k24", "translate @k14..@k24 by 0 2 0"},
                         {"ride.lap_time", "", "height", "all", "translate @k16..@k20 by 0 -1.5 0"},
                         {"ride.speed_max", "", "height", "@k1..@k12", "translate @k1..@k4 by 0 3 0"},
                         {"ride.g_up_max", "", "place", "all", "translate @k4 by 0 0.5 0"},
                         {"ride.g_up_min", "", "place", "@k10..@k15", "translate @k13 by 0 0.5 0"},
                         {"seat.speed", "250", "height", "@k10..@k16", "translate @k12..@k16 by 0 1 0"},
                         {"seat.g_side", "250", "roll", "@k10..@k20", "roll @k14 to 12"}})
    solve(task);
}

TEST_F(PlantedGoals, of_sections_are_reached_by_their_parameters) {
  good("new");
  good("start_speed 30");
  good("element camelback height 14");
  good("element loop height 18");
  good("element curve angle 120 radius 30");
  good("element straight length 40");
  good("add_cart @s1 at 0");
  const world::Document start = session.document;
  start_on(start);
  for (const Task& task :
       std::vector<Task>{{"open_end.distance", "", "length", "@q4", "section.change @q4 to straight length 64"},
                         {"exact_length", "", "radius", "@q3", "section.change @q3 to curve angle 120 radius 36"},
                         {"ride.height_max", "", "height", "@q2", "section.change @q2 to loop height 21"},
                         {"ride.drop_max", "", "height", "@q2", "section.change @q2 to loop height 22"},
                         {"ride.g_up_min", "", "height", "@q1", "section.change @q1 to camelback height 17"},
                         {"section.g_most", "@q2", "height", "@q2", "section.change @q2 to loop height 22"},
                         {"ride.height_max", "", "height", "@q1..@q2", "section.change @q2 to loop height 20"}})
    solve(task);
}

// A drop, a force section of some keys behind it, and track behind that.
class ForceGoals : public PlantedGoals {
 protected:
  ForceGoals() {
    for (const char* const line :
         {"new", "start_speed 5", "element climb height 32 equipment lift speed 5", "element straight length 8",
          "element dive height 28", "force.add length 60", "force @q4 vertical key 1 at 0",
          "force @q4 vertical key 2 at 20", "force @q4 vertical key 1.2 at 45", "element straight length 20"})
      good(line);
    start_on(world::Document(session.document));
  }
  const world::ForceProgram& program() { return world::section(session.document, entity("q4")).force; }
  double key(std::size_t i) { return program().keys(world::ForceChannel::vertical)[i].value; }
};

TEST_F(ForceGoals, are_reached_by_keys_and_by_what_is_before_them) {
  for (const Task& task :
       std::vector<Task>{{"section.g_most", "@q4", "vertical at 20", "@q4", "force @q4 vertical key 2.3 at 20"},
                         {"ride.speed_max", "", "height", "@q3", "section.change @q3 to dive height 29"},
                         {"open_end.distance", "", "height", "@q3", "section.change @q3 to dive height 29"}})
    solve(task);
}

TEST_F(ForceGoals, are_reached_by_length) {
  const double length = value("exact_length"), before = program().length;
  good("seek exact_length == " + base::to_text(length + 2) + " by length of @q4");
  EXPECT_NEAR(value("exact_length"), length + 2, 1e-3 * (length + 2)) << note();
  EXPECT_NEAR(program().length, before + 2, 0.5);
  good("seek exact_length == " + base::to_text(length - 3) + " by length of @q4 above 50 below 70");
  EXPECT_NEAR(value("exact_length"), length - 3, 1e-3 * length) << note();
}

TEST_F(ForceGoals, change_the_named_keys_alone) {
  good("seek section.g_most @q4 == 2.4 by vertical at 20 of @q4");
  EXPECT_NEAR(value("section.g_most", "@q4"), 2.4, 0.003);
  EXPECT_GT(key(1), 2);
  EXPECT_EQ(key(0), 1);
  EXPECT_EQ(key(2), 1.2);
  EXPECT_EQ(world::kind_name(world::section(session.document, entity("q4"))), "force");
  EXPECT_EQ(world::kind_name(world::section(session.document, entity("q5"))), "straight") << "planned again behind it";
  good("undo");
  good("seek section.g_most @q4 == 2.4 by vertical of @q4 together on");
  EXPECT_NEAR(key(1) - key(0), 1, 1e-9);
  EXPECT_GT(key(0), 1);
  EXPECT_NE(note().find("Vertical keys: 3 of 3 changed, by up to"), std::string::npos) << note();
}

// What is found holds when the force section has been planned for its train's new speed.
TEST_F(ForceGoals, hold_where_forces_follow_another_speed) {
  const double speed = program().speed, far = value("open_end.distance") + 2;
  good("seek ride.speed_max == 25 by height of @q3");
  EXPECT_NEAR(value("ride.speed_max"), 25, 0.026) << note();
  EXPECT_GT(program().speed, speed);
  good("undo");
  good("seek open_end.distance == " + base::to_text(far) + " by height of @q3");
  EXPECT_NEAR(value("open_end.distance"), far, 1e-3 * far) << note();
  EXPECT_NE(program().speed, speed);
}

TEST_F(ForceGoals, name_what_a_section_has) {
  refused(command("seek exact_length == 200 by lateral of @q4"), "has no number \"lateral\"");
  refused(command("seek exact_length == 200 by vertical at 21 of @q4"), "has no number \"vertical at 21\"");
  refused(command("seek exact_length == 200 by vertical at noon of @q4"), "has no number");
  refused(command("seek datum == 200 by vertical of @q4"), "datum does not depend on the vertical keys");
}

TEST_F(Goals, leave_locked_knots_and_limits_alone) {
  const double length = value("exact_length");
  good("seek exact_length == " + base::to_text(length + 3) + " by height of all except @k2 below 30");
  EXPECT_NEAR(value("exact_length"), length + 3, 0.004 * length);
  start_on(test::sample_document());
  const double before = height("k2");
  good("seek exact_length == " + base::to_text(length + 1) + " by height of all except @k2");
  EXPECT_EQ(height("k2"), before);
  refused(command("seek exact_length == 1e4 by height of @k3 below 40"), "comes no closer to 1e+04 m");
  refused(command("seek exact_length == 100 by height of @k3 above 90"), "beyond the limits");
}

TEST_F(Goals, change_all_numbers_alike_where_that_is_wanted) {
  const float k2 = static_cast<float>(height("k2")), k3 = static_cast<float>(height("k3"));
  good("seek ride.height_max == 40 by height of @k2..@k4 together on");
  EXPECT_NEAR(height("k2") - k2, height("k3") - k3, 1e-5);
  EXPECT_NE(height("k2"), k2);
}

TEST_F(Goals, plan_sections_again) {
  good("new");
  good("start_speed 35");
  good("element climb height 20");
  good("element loop height 12");
  good("element straight length 30");
  good("seek open_end.distance == 120 by length of @q3");
  EXPECT_NEAR(value("open_end.distance"), 120, 0.13);
  EXPECT_EQ(world::kind_name(world::section(session.document, entity("q3"))), "straight") << "still planned";
  good("seek ride.height_max == 30 by height of @q1..@q2");
  EXPECT_NEAR(value("ride.height_max"), 30, 0.04) << note();
  EXPECT_EQ(world::kind_name(world::section(session.document, entity("q2"))), "loop");
}

TEST_F(Goals, already_reached_are_no_step) {
  good("seek exact_length <= 1e5 by height of @k3");
  EXPECT_TRUE(session.history.undo.empty());
  EXPECT_NE(note().find("already"), std::string::npos) << note();
}

TEST_F(Goals, that_nothing_can_reach_are_refused) {
  refused(command("seek exact_length == 50 by height of @k9"), "no knot @k9");
  refused(command("seek exact_length == 50 by colour of @k3"), "expected height, x, z, place or roll");
  refused(command("seek datum == 50 by x of @k3"), "datum does not depend on the x");
  refused(command("seek exact_length == 50 by height of @q1"), "name its knots");
  refused(command("seek exact_length == 50 by height of @k3 except @k3"), "nothing to change");
}

}  // namespace goal_test
}  // namespace coaster::query
