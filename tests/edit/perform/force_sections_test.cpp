// Commands of force sections: their keys, both ends kept, and the memory of their steps. No header of its own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "edit/force_fixture.h"
#include "edit/session/ride_report.h"

namespace coaster::edit {
namespace force_sections_test {

using test::Forces;
using world::ForceChannel;

// A step's keys are counted: with as much memory as a few steps of 600 keys take, the oldest are dropped.
TEST_F(Forces, keys_count_in_the_memory_of_the_history) {
  drop_and_force();
  constexpr std::size_t kKeys = 150, kBytes = 3 * kKeys * sizeof(world::ForceKey);
  world::ForceProgram many = program();
  many.length = 200;
  for (auto& channel : many.channels)
    for (std::size_t i = 0; i < kKeys; ++i) channel.push_back({1.2 * static_cast<double>(i), 1});
  for (world::ForceKey& key : many.keys(ForceChannel::lateral)) key.value = 0;
  for (world::ForceKey& key : many.keys(ForceChannel::roll)) key.value = 0;
  session.document.entities.get<world::Section>(entity(section.c_str())).force = many;
  const std::size_t before = session.history.bytes;
  key("vertical key 1.01 at 0");
  EXPECT_GE(session.history.bytes - before, kBytes);
  EXPECT_LT(session.history.bytes - before, kBytes + 65'536);
  session.history.limit = session.history.bytes + 3 * kBytes;
  for (const char* const to : {"1.02", "1.03", "1.04", "1.05", "1.06"})
    key(std::string("vertical key ") + to + " at 0");
  EXPECT_GT(session.history.dropped, 0u);
  EXPECT_LE(session.history.bytes, session.history.limit);
}

// What follows is what it was to the bit, and the joint at the held end is G2 with continuous spin.
TEST_F(Forces, both_ends_stay_while_the_keys_are_met_as_far_as_possible) {
  drop_and_force();
  key("vertical key 1 at 0"), key("vertical key 1.5 at 20"), key("vertical key 1 at 40");
  good("element straight length 20");
  const std::string straight = world::label_of(session.document, last());
  good("element curve left radius 40 angle 30");
  good("section.join @" + straight);
  refused("force @" + section + " vertical key 1.9 at 20", "than what follows begins");
  good("force.hold @" + section + " on");
  EXPECT_LT(plan().unmet, 0.02);
  const std::vector<world::Knot> followers = knots_behind();
  const world::Document before = session.document;
  const std::size_t steps = session.history.undo.size();
  key("vertical key 1.9 at 20"), key("lateral key 0.3 at 25"), key("lateral key 0 at 5"), key("lateral key 0 at 45");
  EXPECT_EQ(knots_behind(), followers);
  EXPECT_EQ(session.history.undo.size(), steps + 4);
  EXPECT_EQ(value().kind, world::SectionKind::force);
  EXPECT_GT(plan().unmet, 0.1);
  EXPECT_LT(missed(), 0.06) << "riders feel the keys and what is added";
  expect_g2();
  const std::string& notice = session.notices.list.back().text;
  EXPECT_EQ(notice, sim::unmet_text(plan()));
  EXPECT_NE(notice.find(" riders feel 0."), std::string::npos) << notice;
  // A change of speed, a file and the way back.
  good("section.equip @q1 as lift speed 8");
  EXPECT_EQ(knots_behind(), followers);
  EXPECT_LT(missed(), 0.06);
  const auto loaded = exchange::parse_track(exchange::print_track(session.document), "text");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(world::hash(loaded->document), hash());
  EXPECT_TRUE(world::section(loaded->document, world::find(loaded->document, *world::parse_name(section))).force.hold);
  const std::uint64_t same = hash();
  force_plans_of(session) = {};
  good("section.title @" + section + " to \"Same\""), good("section.title @" + section + " to \"\"");
  EXPECT_EQ(hash(), same) << "planned again to the bit";
  for (int i = 0; i < 7; ++i) good("undo");
  EXPECT_TRUE(session.document == before);
  EXPECT_EQ(exchange::print_track(session.document).find("\"hold\": false"), std::string::npos);
}

// The closing section that follows keeps its knots to the bit, too.
TEST_F(Forces, a_circuit_is_closed_by_the_same_closing_section_while_both_ends_stay) {
  drop_and_force();
  key("vertical key 1 at 0"), key("vertical key 1.8 at 15"), key("vertical key 0.9 at 32");
  good("complete 1");
  good("force.hold @" + section + " on");
  const std::vector<world::Knot> before = knots_behind();
  key("vertical key 2.1 at 15");
  EXPECT_TRUE(session.document.track.closed);
  EXPECT_EQ(knots_behind(), before);
  EXPECT_EQ(world::section(session.document, last()).kind, world::SectionKind::complete);
  EXPECT_GT(plan().unmet, 0.05);
  EXPECT_LT(missed(), 0.06);
  expect_g2();
}

TEST_F(Forces, an_open_end_is_free_until_track_follows) {
  drop_and_force();
  good("force.hold @" + section + " on");
  key("vertical key 1.5 at 20");
  EXPECT_EQ(plan().unmet, 0) << "nothing follows";
  good("element straight length 20");
  refused("force @" + section + " vertical key -10 at 20", "its ends stay, and no forces near those of its keys");
  key("vertical key 1 at 2"), key("vertical key 1 at 40"), key("vertical key 0 at 20");
  EXPECT_GT(plan().unmet, 0.3) << "met as far as possible";
  EXPECT_NEAR(glm::distance(plan().path.curve.points.back().position, plan().task.held->position), 0, 1e-5);
  good("section.mirror @" + section);
  EXPECT_FALSE(program().hold);
}

// A faster or slower train needs no other track, and one that does not arrive, none less.
TEST_F(Forces, curvature_is_the_same_track_at_any_speed) {
  drop_and_force();
  good("force.of @" + section + " to curvature");
  good("force.length @" + section + " to 50");
  key("vertical key 0.02 at 20"), key("lateral key 0.01 at 30"), key("roll key 30 at 40");
  const auto knots = [&] {
    std::vector<world::Knot> list;
    const world::SectionRun run = world::run_of(session.document, entity(section.c_str()));
    for (std::size_t i = run.first + 1; i <= run.end(); ++i)
      list.push_back(world::knot(session.document, session.document.track.knots[i]));
    return list;
  };
  const std::vector<world::Knot> before = knots();
  const double speed = program().speed;
  good("section.equip @q1 as lift speed 9");
  EXPECT_GT(program().speed, speed + 0.5);
  EXPECT_EQ(knots(), before);
  good("undo");
  const auto loaded = exchange::parse_track(exchange::print_track(session.document), "text");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(world::hash(loaded->document), hash());
  const std::uint64_t bends = hash();
  session.document.entities.get<world::Section>(entity(section.c_str())).force.of = world::ForceQuantity::forces;
  EXPECT_NE(hash(), bends);
  EXPECT_EQ(exchange::print_track(session.document).find("\"of\""), std::string::npos) << "files as ever";
}

TEST_F(Forces, equipment_that_does_not_count_is_told_with_the_reason) {
  drop_and_force();
  const auto told = [&] {
    const world::SectionRun run = world::run_of(session.document, entity(section.c_str()));
    return sim::uncounted_text(session.document, run, program());
  };
  EXPECT_EQ(told(), "");
  good("section.equip @" + section + " as brake speed 12 acceleration 3");
  EXPECT_EQ(told(), "") << "it counts";
  good("section.equip @" + section + " as station speed 4");
  EXPECT_NE(told().find("The station is not in the planned speed"), std::string::npos) << told();
  good("force.of @" + section + " to curvature");
  EXPECT_EQ(told(), "") << "speed does not shape it";
  good("undo"), good("section.unequip @" + section);
  key("vertical key 2.5 at 20"), key("vertical key 1 at 45");
  ASSERT_GT(plan().spans(), 1u);
  const world::SectionRun run = world::run_of(session.document, entity(section.c_str()));
  for (const std::size_t at : {run.end() - 1, run.first}) {
    const std::string segment = world::label_of(session.document, session.document.track.segments[at]);
    good("equip @" + segment + " as brake speed 12 acceleration 3");
    EXPECT_NE(told().find("Equipment on part of a force section"), std::string::npos) << told();
    good("undo");
  }
}

TEST_F(Forces, the_quantity_changes_and_the_shape_stays) {
  drop_and_force();
  key("vertical key 1 at 0"), key("vertical key 2.4 at 20"), key("vertical key 0.6 at 45"), key("roll key 1 at 30");
  key("roll key 0 at 10"), key("roll key 0 at 50");
  const world::Document before = session.document;
  const glm::dvec3 end = plan().path.curve.points.back().position;
  good("force.of @" + section + " to curvature");
  EXPECT_EQ(program().of, world::ForceQuantity::curvature);
  EXPECT_LT(glm::distance(plan().path.curve.points.back().position, end), 0.2);
  refused("force @" + section + " vertical key 2 at 20", "has the value 2 1/m, expected -0.5 to 0.5");
  good("force.copy @" + section + " vertical");
  good("force.of @" + section + " to forces");
  EXPECT_LT(glm::distance(plan().path.curve.points.back().position, end), 0.3);
  refused("force.paste @" + section + " vertical at 0", "of curvature, those of the section of forces");
  good("undo"), good("undo");
  EXPECT_TRUE(session.document == before);
  good("force.of @" + section + " to forces");
  EXPECT_TRUE(session.document == before) << "no step without a change";
}

TEST_F(Forces, bad_values_are_refused_with_a_clear_word) {
  drop_and_force();
  const auto on = [&](const std::string& name, const std::string& rest) { return name + " @" + section + " " + rest; };
  refused(on("force", "vertical key 20 at 10"), "has the value 20 g, expected -10 to 10");
  refused(on("force", "vertical key 2 at 2000"), "expected 0 to 1000");
  SetForceKey nan{Target{*world::parse_name(section)}, false, ForceChannel::lateral, std::nan(""), 10};
  refused(Command{nan}, "finite");
  std::swap(nan.value, nan.at);
  refused(Command{nan}, "finite");
  key("vertical key 2 at 10");
  refused(on("force", "vertical key 3 at 10.5"), "two keys within 1 m at 10.5 m");
  refused(on("force.move", "vertical at 11 to 12 key 1"), "has no key at 11 m");
  refused(on("force.remove", "lateral at 10"), "has no key at 10 m");
  refused(on("force.length", "to 0"), "the length is 0 m, expected 3 to 1000");
  refused(on("force.length", "to 10000"), "the length is 10000 m");
  refused(on("force.tolerance", "to 0.001"), "the tolerance is 0.001 g");
  refused("force @q1 vertical key 1 at 1", " is not a force section");
  refused("force @q99 vertical key 1 at 1", "there is no section @q99");
  refused("force.add over time length 500", "the length is 500 s");
}

// 5 g within a metre at some 24 m/s: no span of half a metre follows that within 0.02 g.
TEST_F(Forces, each_change_that_misses_the_tolerance_says_by_how_much_and_where_and_the_report_too) {
  drop_and_force();
  good("force.tolerance @" + section + " to 0.02");
  key("vertical key 1 at 20");
  key("vertical key 6 at 21");
  const sim::ForcePlan& missed = plan();
  EXPECT_FALSE(missed.fit.within);
  EXPECT_GT(missed.fit.felt_error, program().tolerance);
  EXPECT_NEAR(missed.fit.felt_at, 20.5, 1.5);
  EXPECT_EQ(session.notices.list.back().text,
            fmt::format("Riders feel up to {:.2f} g more or less than the keys say, at {:.1f} m.",
                        missed.fit.felt_error, missed.fit.felt_at));
  const std::string line = fmt::format(
      "    section {}: riders feel up to {:.2f} g more or less than the keys say, at {:.1f} m; tolerance "
      "0.02 g\n",
      section, missed.fit.felt_error, missed.fit.felt_at);
  EXPECT_NE(
      ride_report(session)->find("  missed forces                 1 (force sections over their tolerance)\n" + line),
      std::string::npos)
      << *ride_report(session);
  good("force.tolerance @" + section + " to 0.5");
  EXPECT_TRUE(plan().fit.within);
  EXPECT_NE(ride_report(session)->find("  missed forces                 0 "), std::string::npos);
  good("force.free @" + section);
  EXPECT_EQ(ride_report(session)->find("missed forces"), std::string::npos);
}

TEST_F(Forces, a_drag_changes_the_keys_that_it_began_with) {
  drop_and_force();
  key("vertical key 2 at 25");
  const world::Document before = session.document;
  good("gesture.begin");
  for (const char* const to : {"26 key 2.2", "28 key 2.6", "30 key 3"})
    good("force.move @" + section + " from_start on vertical at 25 to " + to);
  good("gesture.end");
  EXPECT_EQ(program().keys(ForceChannel::vertical).size(), 1u);
  EXPECT_EQ(program().keys(ForceChannel::vertical)[0].at, 30);
  good("undo");
  EXPECT_TRUE(session.document == before);
}

}  // namespace force_sections_test
}  // namespace coaster::edit
