// Force sections in a session: planning them again.
#include "edit/perform/replan.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "edit/force_fixture.h"

namespace coaster::edit {
namespace force_replan_test {

using test::Forces;
using world::ForceChannel;

TEST_F(Forces, keys_shape_the_track_and_the_simulated_ride_feels_them) {
  drop_and_force();
  EXPECT_GT(program().speed, 20);
  key("vertical key 1 at 0"), key("vertical key 3 at 20"), key("vertical key 0.2 at 45"), key("lateral key 0.4 at 30");
  key("lateral key 0 at 5"), key("roll key 2 at 30"), key("roll key 0 at 10"), key("roll key 0 at 50");
  EXPECT_EQ(program().keys(ForceChannel::vertical).size(), 3u);
  EXPECT_TRUE(plan().fit.within);
  EXPECT_LT(missed(), 0.06);
  expect_g2();
  good("force.handle @" + section + " vertical at 20 slope 0.05 before 6 after 3");
  EXPECT_LT(missed(), 0.06) << plan().fit.felt_error << " at " << plan().fit.felt_at << " of " << plan().length;
  good("force.move @" + section + " vertical at 20 to 23 key 2.5");
  EXPECT_EQ(program().keys(ForceChannel::vertical)[1], (world::ForceKey{23, 2.5, 0.05, 6, 3}));
  good("force.remove @" + section + " vertical at 45");
  good("force.length @" + section + " to 70");
  EXPECT_NEAR(plan().length, 70, 1e-6);
  good("force.tolerance @" + section + " to 0.3");
  good("force.tolerance @" + section + " to 0.03");
  EXPECT_LT(missed(), 0.04);
  expect_g2();
}

TEST_F(Forces, each_command_is_one_step_of_undo_and_no_change_is_none) {
  drop_and_force();
  const world::Document placed = session.document;
  key("vertical key 2 at 25");
  const world::Document with_key = session.document;
  const std::size_t steps = session.history.undo.size();
  key("vertical key 2 at 25");
  good("force.length @" + section + " to 60");
  good("section.title @" + section + " to \"\"");
  EXPECT_EQ(session.history.undo.size(), steps) << "nothing changed";
  good("undo");
  EXPECT_TRUE(session.document == placed);
  good("redo");
  EXPECT_TRUE(session.document == with_key);
  good("section.title @" + section + " to \"Hop\"");
  EXPECT_EQ(value().kind, world::SectionKind::force);
}

TEST_F(Forces, a_change_of_speed_plans_it_again) {
  drop_and_force();
  key("vertical key 1 at 0"), key("vertical key 3 at 20"), key("vertical key 1 at 45");
  const double slow = program().speed;
  for (const char* const change : {"section.equip @q1 as lift speed 8", "losses rolling 0.03 drag 0.0001",
                                   "section.change @q1 to climb height 36 equipment lift speed 6",
                                   "section.equip @q3 as launch speed 30 acceleration 12"}) {
    const world::Document before = session.document;
    const double speed = program().speed;
    const std::size_t steps = session.history.undo.size();
    good(change);
    EXPECT_NE(program().speed, speed) << change;
    EXPECT_EQ(value().kind, world::SectionKind::force) << change;
    EXPECT_LT(missed(), 0.06) << change;
    expect_g2();
    EXPECT_EQ(session.history.undo.size(), steps + 1) << change;
    good("undo");
    EXPECT_TRUE(session.document == before) << change;
    good("redo");
  }
  EXPECT_GT(program().speed, slow);
  // A loaded track is planned again to the bit: nothing changes.
  const auto loaded = exchange::parse_track(exchange::print_track(session.document), "text");
  ASSERT_TRUE(loaded) << loaded.status().message;
  const std::uint64_t hash_before = world::hash(session.document);
  start_on(loaded->document);
  force_plans_of(session) = {};
  good("section.title @" + section + " to \"Same\"");
  good("section.title @" + section + " to \"\"");
  EXPECT_EQ(world::hash(session.document), hash_before);
}

// A command that changes no force section plans none again, however many there are.
TEST_F(Forces, many_keep_their_plans) {
  good("start_speed 20");
  for (int i = 0; i < 40; ++i) good("force.add of curvature length 4");
  const auto first = [&] { return world::segment(session.document, session.document.track.segments.front()).section; };
  good("section.title @q40 to last");
  const std::uint64_t planned = edit::SessionFindings(session).force(first())->serial;
  good("section.title @q40 to end");
  EXPECT_EQ(edit::SessionFindings(session).force(first())->serial, planned);
}

// The speed at each follows from the one before it, so none is planned for a speed that the train no longer has.
class ForcesInARow : public Forces, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(between, ForcesInARow,
                         testing::Values("", "element straight length 15", "element curve left radius 60 angle 40"));

TEST_P(ForcesInARow, are_planned_once_each_when_the_train_comes_faster) {
  for (const char* const line : {"start_speed 38", "element straight length 10", "element climb height 30"}) good(line);
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) {
    good("force.add length 50");
    names.push_back(section = world::label_of(session.document, last()));
    key("vertical key 1 at 0"), key("vertical key 1.8 at 14"), key("vertical key 0.2 at 30");
    key("vertical key 1.3 at 48"), key("roll key 0.8 at 15"), key("roll key -0.8 at 35");
    if (i < 2 && *GetParam() != '\0') good(GetParam());
  }
  for (const char* const cars : {"1", "6"}) {
    good(std::string("train @c1 cars ") + cars);
    const std::uint64_t before = plan().serial;
    good(std::string("start_speed ") + (*cars == '1' ? "38.03" : "38.06"));
    EXPECT_EQ(plan().serial, before + 3) << cars << " cars";
    for (const std::string& name : names) {
      section = name;
      const std::size_t first = world::run_of(session.document, entity(name.c_str())).first;
      EXPECT_NEAR(program().speed, *edit::SessionFindings(session).speed_at(session.derived.starts[first]), 0.002)
          << name;
      EXPECT_LT(missed(), 0.06) << name;
    }
    expect_g2();
  }
}

TEST_F(Forces, its_own_equipment_counts_in_its_speed) {
  drop_and_force();
  key("vertical key 1 at 0"), key("vertical key 2.4 at 20"), key("vertical key 0.8 at 45");
  const double free = plan().end_speed;
  for (const char* const as : {"launch speed 34 acceleration 8", "brake speed 16 acceleration 5", "lift speed 30"}) {
    good("section.equip @" + section + " as " + as);
    EXPECT_EQ(value().kind, world::SectionKind::force);
    EXPECT_GT(std::abs(plan().end_speed - free), 1) << as;
    EXPECT_LT(missed(), 0.06) << as;
    expect_g2();
  }
  good("section.unequip @" + section);
  EXPECT_NEAR(plan().end_speed, free, 1e-9);
}

TEST_F(Forces, planned_sections_behind_follow_an_end_that_turns) {
  drop_and_force();
  key("vertical key 1.6 at 30");
  good("element curve left radius 40 angle 60");
  good("element straight length 20");
  const float height = knot(session.document.last_number[0]).position.y;
  key("vertical key 1.9 at 30");
  expect_g2();
  EXPECT_NE(knot(session.document.last_number[0]).position.y, height);
  for (const world::SectionRun& run : world::sections_of(session.document))
    EXPECT_NE(world::section(session.document, run.section).kind, world::SectionKind::free);
}

TEST_F(Forces, hand_shaped_track_behind_is_kept_or_the_change_is_refused) {
  drop_and_force();
  good("element straight length 20");
  const std::uint32_t end = session.document.last_number[0];
  good(fmt::format("move @k{} to {} {} {}", end, knot(end).position.x + 2, knot(end).position.y + 1,
                   knot(end).position.z));
  ASSERT_EQ(world::section(session.document, last()).kind, world::SectionKind::free);
  refused("force @" + section + " vertical key 2 at 30", "degrees further up than what follows begins");
}

TEST_F(Forces, track_is_planned_up_to_the_place_where_it_must_stop) {
  drop_and_force();
  key("vertical key -1 at 20");
  EXPECT_LT(plan().length, 59);
  EXPECT_NE(session.notices.list.back().text.find("m: the track would run into the ground there"), std::string::npos)
      << session.notices.list.back().text;
  EXPECT_EQ(program().length, 60) << "nothing is lost";
  key("vertical key 1.2 at 20");
  EXPECT_NEAR(plan().length, 60, 1e-6);
  start_on(world::Document{});
  refused("force.add", "the train is at 1.0 m/s there, and forces need 3 m/s: add a launch or a lift hill before them");
}

TEST_F(Forces, keys_keep_their_places_over_the_other_axis) {
  drop_and_force();
  key("vertical key 1 at 0"), key("vertical key 2 at 20"), key("vertical key 0.8 at 45"), key("roll key 1.5 at 25");
  key("roll key 0 at 8"), key("roll key 0 at 50");
  const glm::dvec3 end = plan().path.curve.points.back().position;
  good("force.over @" + section + " to time");
  EXPECT_EQ(program().over, world::ForceDomain::time);
  EXPECT_LT(glm::distance(plan().path.curve.points.back().position, end), 1.0);
  good("force.over @" + section + " to distance");
  EXPECT_NEAR(program().keys(ForceChannel::vertical)[1].at, 20, 0.2);
}

TEST_F(Forces, copies_mirrors_and_files_keep_their_keys) {
  drop_and_force();
  key("vertical key 1.2 at 20"), key("lateral key 0.5 at 30"), key("roll key 1 at 30"), key("roll key 0 at 50");
  key("vertical key 1 at 0"), key("vertical key 1 at 40");
  const world::ForceProgram before = program();
  good("section.mirror @" + section);
  EXPECT_EQ(program().keys(ForceChannel::lateral)[0].value, -0.5);
  EXPECT_LT(missed(), 0.06);
  good("section.mirror @" + section);
  EXPECT_EQ(program(), before);
  good("section.copy @" + section);
  good("section.paste");
  section = world::label_of(session.document, last());
  EXPECT_EQ(value().kind, world::SectionKind::force);
  EXPECT_EQ(program().channels, before.channels);
  EXPECT_NE(program().speed, before.speed) << "of the train there";
  EXPECT_LT(missed(), 0.06);
  const auto loaded = exchange::parse_track(exchange::print_track(session.document), "text");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(world::hash(loaded->document), hash());
  EXPECT_EQ(exchange::print_track(loaded->document), exchange::print_track(session.document));
}

TEST_F(Forces, a_circuit_with_one_stays_closed_when_its_speed_changes) {
  for (const char* const line :
       {"start_speed 5", "element straight length 30", "element climb height 30 equipment lift speed 5",
        "element dive height 20", "force.add length 40"})
    good(line);
  section = world::label_of(session.document, last());
  key("vertical key 1 at 0"), key("vertical key 1.8 at 15"), key("vertical key 0.9 at 32");
  good("complete 1");
  ASSERT_TRUE(session.document.track.closed);
  const double speed = program().speed;
  good("section.equip @q2 as lift speed 8");
  EXPECT_NE(program().speed, speed);
  EXPECT_TRUE(session.document.track.closed);
  expect_g2();
  EXPECT_LT(missed(), 0.06);
}

}  // namespace force_replan_test
}  // namespace coaster::edit
