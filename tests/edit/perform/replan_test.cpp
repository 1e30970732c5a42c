#include "edit/perform/replan.h"

#include <gtest/gtest.h>

#include "curve/arc_length.h"
#include "curve/continuity.h"
#include "edit/commands/commands_sections.h"
#include "edit/session_fixture.h"
#include "world/equipment_rows.h"
#include "world/sections.h"

namespace coaster::edit {
namespace replan_test {

using glm::dvec3;

class Replan : public test::SessionTest {
 protected:
  Replan() : SessionTest(world::Document{}) {
    for (const char* line : {"element straight length 30", "element climb height 20 angle 30",
                             "element dive height 18 angle 50", "element loop right height 15",
                             "element curve left radius 22 angle 140", "element camelback height 9 speed 17"})
      good(line);
  }

  const world::Section& section(const char* name) const { return world::section(session.document, entity(name)); }
  const world::Knot& knot_at(std::size_t i) const {
    return world::knot(session.document, session.document.track.knots[i]);
  }
  world::SectionRun run(const char* name) const { return world::run_of(session.document, entity(name)); }
  std::vector<std::string> names(std::size_t from, std::size_t to) const {
    std::vector<std::string> all;
    for (std::size_t i = from; i < to; ++i)
      all.push_back(world::label_of(session.document, session.document.track.knots[i]));
    return all;
  }
  double length_of(std::size_t segment) const {
    return curve::arc_length(world::cubic_of(session.document, session.document.track.segments[segment]));
  }

  // The control points of all segments from a knot on and the ups at their ends, in the frame of that knot: tangent
  // level and ahead, +Y, and to the right. Brute force, for what follows must be the same in it.
  std::vector<dvec3> seen_from(std::size_t knot) const {
    const world::Knot& at = knot_at(knot);
    const dvec3 ahead = glm::normalize(dvec3(at.tangent.x, 0, at.tangent.z)), right(-ahead.z, 0, ahead.x);
    const auto in_frame = [&](dvec3 v) { return dvec3(glm::dot(v, ahead), v.y, glm::dot(v, right)); };
    std::vector<dvec3> seen;
    const auto& segments = session.document.track.segments;
    for (std::size_t i = knot; i < segments.size(); ++i) {
      const curve::Cubic c = world::cubic_of(session.document, segments[i]);
      for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) seen.push_back(in_frame(dvec3(p) - dvec3(at.position)));
      seen.push_back(in_frame(dvec3(knot_at(i + 1).up)));
    }
    return seen;
  }
  static void expect_near(const std::vector<dvec3>& a, const std::vector<dvec3>& b, double within) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(glm::distance(a[i], b[i]), within) << i;
  }
  void expect_g2() const {
    const auto& segments = session.document.track.segments;
    for (std::size_t i = 1; i < segments.size(); ++i) {
      const curve::JointContinuity joint = curve::joint(world::cubic_of(session.document, segments[i - 1]),
                                                        world::cubic_of(session.document, segments[i]));
      EXPECT_EQ(joint.geometric, curve::GeometricContinuity::g2) << i << " jumps by " << joint.curvature_jump;
    }
  }
};

TEST_F(Replan, the_same_parameters_give_the_same_track) {
  const world::Document before = session.document;
  const std::vector<dvec3> seen = seen_from(0);
  for (const char* line :
       {"section.change @q1 to straight length 30", "section.change @q2 to climb height 20 angle 30",
        "section.change @q4 to loop right height 15", "section.change @q5 to curve left radius 22 angle 140",
        "section.change @q6 to camelback height 9 speed 17"}) {
    good(line);
    EXPECT_EQ(session.document.track, before.track) << line;
    expect_near(seen_from(0), seen, 2e-5);
  }
  for (const auto& [name, value] : {std::pair{"q4", 15.0}, {"q6", 9.0}})
    EXPECT_EQ(section(name).element.values[0], value);
}

TEST_F(Replan, what_follows_moves_as_a_whole_and_stays_what_it_is) {
  const world::SectionRun lift = run("q2");
  const std::size_t end = lift.end();
  const std::vector<dvec3> behind = seen_from(end);
  const std::vector<std::string> front = names(0, lift.first + 1),
                                 rest = names(end, session.document.track.knots.size());
  const double height = knot_at(end).position.y;
  good("section.change @q2 to climb height 25 angle 30");
  EXPECT_EQ(section("q2").element.values[0], 25);
  const std::size_t now = run("q2").end();
  EXPECT_NEAR(knot_at(now).position.y, height + 5, 1e-4);
  expect_near(seen_from(now), behind, 1e-4);
  expect_g2();
  EXPECT_EQ(names(0, lift.first + 1), front);
  EXPECT_EQ(names(now, session.document.track.knots.size()), rest) << "the joint keeps its name, too";
  for (const char* name : {"q1", "q3", "q4", "q5", "q6"})
    EXPECT_EQ(section(name).kind, world::SectionKind::element) << name;
  EXPECT_EQ(session.history.undo.size(), 7u);
}

TEST_F(Replan, a_turn_turns_what_follows) {
  const std::size_t end = run("q5").end();
  const std::vector<dvec3> behind = seen_from(end);
  const dvec3 was(knot_at(end).tangent);
  good("section.change @q5 to curve right radius 30 angle 75");
  const dvec3 is(knot_at(run("q5").end()).tangent);
  // From 140 degrees to the left to 75 to the right.
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(was, is))), 360 - 140 - 75, 0.01);
  expect_near(seen_from(run("q5").end()), behind, 1e-4);
  expect_g2();
}

TEST_F(Replan, undo_restores_and_files_keep_it) {
  const world::Document before = session.document;
  for (const char* line : {"section.change @q3 to dive height 30 angle 70", "section.change @q1 to straight length 2",
                           "section.change @q4 to corkscrew left", "section.change @q4 to helix turns 4"}) {
    good(line);
    const world::Document after = session.document;
    good("undo");
    EXPECT_TRUE(session.document == before) << line;
    good("redo");
    EXPECT_TRUE(session.document == after) << line;
    const auto again = exchange::parse_track(exchange::print_track(after), "t");
    ASSERT_TRUE(again) << again.status().message;
    EXPECT_EQ(world::hash(again->document), hash());
    good("undo");
  }
}

TEST_F(Replan, what_follows_is_never_tilted) {
  refused("section.change @q1 to straight length 30 roll 20",
          "the track would end there rolled by 20.0 degrees against what follows");
  good("section.change @q6 to straight length 30 roll 20");
  good("new");
  good("append at 0 5 0"), good("append at 20 8 0"), good("element straight"), good("element curve");
  refused("section.change @q2 to climb", "degrees further down than what follows begins");
  good("section.change @q1 to curve radius 30");
  EXPECT_EQ(world::kind_name(section("q1")), "curve");
}

TEST_F(Replan, on_a_closed_track_only_what_moves_no_end_is_changed) {
  good("closed on");
  refused("section.change @q2 to climb height 25 angle 30", "the track is closed");
  const world::Document before = session.document;
  good("section.change @q5 to curve left radius 22 angle 140 bank 10");
  EXPECT_EQ(session.document.track, before.track);
  const std::size_t end = run("q5").end();
  EXPECT_EQ(knot_at(end).position, world::knot(before, before.track.knots[end]).position);
  refused("section.change @q7 to straight", "the track is closed");
}

TEST_F(Replan, trains_stay_on_their_segments_or_else_at_their_share_of_the_section) {
  const world::SectionRun loop = run("q4");
  good("add_cart @" + world::label_of(session.document, session.document.track.segments[loop.first + 1]) + " at 0.25");
  const auto cart = [&] { return session.document.entities.get<world::Train>(entity("c2")); };
  const world::Train before = cart();
  good("section.change @q4 to loop right height 15.5");
  if (run("q4").count == loop.count) {
    EXPECT_EQ(cart(), before);
  }
  const auto share = [&] {
    const world::SectionRun now = run("q4");
    double whole = 0, part = 0;
    for (std::size_t i = now.first; i < now.end(); ++i) {
      if (session.document.track.segments[i] == cart().segment) part = whole + cart().fraction * length_of(i);
      whole += length_of(i);
    }
    return part / whole;
  };
  const double at = share();
  good("section.change @q4 to helix right turns 5");
  EXPECT_NE(run("q4").count, loop.count);
  EXPECT_NEAR(share(), at, 1e-6);
}

TEST_F(Replan, a_drag_of_a_parameter_is_one_step_without_drift) {
  const world::Document before = session.document;
  const std::size_t steps = session.history.undo.size();
  good("gesture.begin");
  for (int i = 0; i < 40; ++i) good("section.change @q5 from_start on to curve radius " + std::to_string(20 + i % 7));
  good("section.change @q5 from_start on to curve radius 26 angle 140");
  good("gesture.end");
  EXPECT_EQ(session.history.undo.size(), steps + 1);
  const world::Document dragged = session.document;
  good("undo");
  EXPECT_TRUE(session.document == before);
  good("section.change @q5 to curve radius 26 angle 140");
  EXPECT_EQ(hash(), world::hash(dragged)) << "as if it had been set at once";
}

TEST_F(Replan, what_cannot_be_planned_is_refused) {
  refused("section.change @q9 to loop", "there is no section @q9");
  refused("section.change @s1 to loop", "expected a section, found @s1");
  good("direct @k1 to 0 1 0");
  refused("section.change @q1 to loop", "steeper than");
  good("section.change @q2 to climb height 1000");
  EXPECT_NE(session.notices.list.back().text.find("limit"), std::string::npos);
  EXPECT_EQ(section("q2").element.values[0], 300);
}

TEST_F(Replan, equipment_stays_that_was_put_on_or_taken_off_since) {
  const auto kind = [&](const char* name) {
    std::string all;
    for (std::size_t i = run(name).first; i < run(name).end(); ++i) {
      const auto* const e = session.document.entities.find<world::Equipment>(session.document.track.segments[i]);
      all += e ? std::string(base::name_of(e->kind)) + " " + base::to_text(e->acceleration) + " " : "- ";
    }
    return all;
  };
  good("section.equip @q2 as lift speed 5 acceleration 2");
  world::Element element = section("q2").element;
  EXPECT_EQ(world::value_of(element, "speed"), 5);
  world::set_value(element, "height", 31);
  ASSERT_TRUE(apply(ChangeSection{{{world::EntityKind::section, 2}}, false, element}));
  for (std::size_t i = run("q2").first; i < run("q2").end(); ++i)
    ASSERT_TRUE(session.document.entities.find<world::Equipment>(session.document.track.segments[i])) << i;
  EXPECT_EQ(kind("q2").substr(0, 7), "lift 2 ") << "also what the parameters do not name";
  good("section.unequip @q2");
  world::set_value(element = section("q2").element, "height", 24);
  ASSERT_TRUE(apply(ChangeSection{{{world::EntityKind::section, 2}}, false, element}));
  EXPECT_EQ(kind("q2").find("lift"), std::string::npos);
  good("section.change @q2 to climb height 24 equipment lift speed 6");
  EXPECT_NE(kind("q2").find("lift"), std::string::npos);
  good("section.change @q2 to climb height 25");
  EXPECT_EQ(kind("q2").find("lift"), std::string::npos);
}

}  // namespace replan_test
}  // namespace coaster::edit
