// Tests the commands that delete, mirror and reorder sections (edit/perform/sections.cpp).
#include <gtest/gtest.h>

#include "curve/arc_length.h"
#include "curve/continuity.h"
#include "edit/session_fixture.h"
#include "world/sections.h"

namespace coaster::edit {
namespace section_order_test {

using glm::dvec3;

class SectionOrder : public test::SessionTest {
 protected:
  SectionOrder() : SessionTest(world::Document{}) {
    for (const char* line : {"element straight length 30", "element loop right height 15",
                             "element curve left angle 70", "element camelback height 9 speed 17"})
      good(line);
  }
  std::string order() const {
    std::string text;
    for (const world::SectionRun& run : world::sections_of(session.document))
      text += (text.empty() ? "" : " ") + world::label_of(session.document, run.section) + " " +
              std::string(world::kind_name(world::section(session.document, run.section)));
    return text;
  }
  // The arc lengths of a section's segments, and at each of its knots the height above its first one and the angle of
  // `up` from the vertical: by what no carry can change.
  std::vector<double> shape_of(const char* name) const {
    std::vector<double> shape;
    const world::SectionRun run = world::run_of(session.document, entity(name));
    const auto& knots = session.document.track.knots;
    const world::Knot& first = world::knot(session.document, knots[run.first]);
    for (std::size_t i = run.first; i < run.end(); ++i) {
      const world::Knot& knot = world::knot(session.document, knots[(i + 1) % knots.size()]);
      shape.push_back(curve::arc_length(world::cubic_of(session.document, session.document.track.segments[i])));
      shape.push_back(double{knot.position.y} - double{first.position.y});
      shape.push_back(knot.up.y);
      shape.push_back(glm::distance(dvec3(knot.position), dvec3(first.position)));
    }
    return shape;
  }
  static void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-4) << i;
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

TEST_F(SectionOrder, steps_name_sections_by_their_titles) {
  good("section.title @q4 to \"Airtime\"");
  for (const auto& [line, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"section.mirror @q2", "Mirrored the loop"},
           {"section.equip @q1 as brake speed 8", "Made the straight a brake"},
           {"section.change @q4 to camelback height 10 speed 17", "Changed \"Airtime\""},
           {"section.delete @q4", "Deleted \"Airtime\""}}) {
    good(line);
    EXPECT_EQ(session.history.undo.back().text.sentence, sentence);
  }
}

TEST_F(SectionOrder, a_move_says_what_moved_where) {
  good("section.move @q2 after");
  EXPECT_EQ(session.notices.list.back().text, "Moved the loop after the banked curve.");
  good("section.move @q2 before");
  EXPECT_EQ(session.notices.list.back().text, "Moved the loop before the banked curve.");
}

TEST_F(SectionOrder, a_mirrored_section_says_so_or_why_nothing_changes) {
  good("section.mirror @q3");
  EXPECT_EQ(session.notices.list.back().text, "Mirrored the banked curve.");
  good("section.mirror @q4");
  EXPECT_EQ(session.notices.list.back().text, "The camelback is the same to both sides.");
}

TEST_F(SectionOrder, deleting_one_closes_the_gap) {
  const std::vector<double> loop = shape_of("q2"), hill = shape_of("q4");
  const world::Document before = session.document;
  const world::Knot start = knot(2);
  good("section.delete @q3");
  EXPECT_EQ(order(), "q1 straight q2 loop q4 camelback");
  expect_near(shape_of("q2"), loop), expect_near(shape_of("q4"), hill);
  expect_g2();
  good("section.delete @q4");
  EXPECT_EQ(order(), "q1 straight q2 loop");
  good("section.delete @q1");
  EXPECT_EQ(order(), "q2 loop");
  EXPECT_EQ(knot(2).position, start.position) << "nothing moves to the start of the track";
  EXPECT_EQ(session.document.entities.pool<world::Train>().size(), 0u) << "its train went with it";
  EXPECT_EQ(session.notices.list.back().text, "Deleted the straight and the train on it.");
  good("section.delete @q2");
  EXPECT_EQ(order(), "");
  for (int i = 0; i < 4; ++i) good("undo");
  EXPECT_TRUE(session.document == before);
}

TEST_F(SectionOrder, neighbours_swap) {
  const world::Document before = session.document;
  const std::vector<double> loop = shape_of("q2"), bend = shape_of("q3"), hill = shape_of("q4");
  good("section.move @q3 before");
  EXPECT_EQ(order(), "q1 straight q3 curve q2 loop q4 camelback");
  expect_near(shape_of("q2"), loop), expect_near(shape_of("q3"), bend), expect_near(shape_of("q4"), hill);
  expect_g2();
  // The end of both together is where it was: two rotations about the vertical and two translations of the plane differ
  // only by the order, so the heading stays.
  const auto heading = [](const world::Document& d) { return world::knot(d, d.track.knots.back()).tangent; };
  EXPECT_LT(glm::distance(heading(session.document), heading(before)), 1e-5f);
  good("section.move @q3 after");
  EXPECT_EQ(order(), "q1 straight q2 loop q3 curve q4 camelback");
  for (const world::Entity e : before.track.knots)
    EXPECT_LT(glm::distance(world::knot(session.document, e).position, world::knot(before, e).position), 1e-4f);
  EXPECT_EQ(session.document.track, before.track);
  refused("section.move @q4 after", "there is no section after the camelback");
  refused("section.move @q1 before", "there is no section before the straight");
}

TEST_F(SectionOrder, mirroring_swaps_left_and_right) {
  const world::Document before = session.document;
  const std::vector<double> hill = shape_of("q4"), bend = shape_of("q3");
  good("section.mirror @q3");
  EXPECT_TRUE(world::section(session.document, entity("q3")).element.right);
  expect_near(shape_of("q4"), hill), expect_near(shape_of("q3"), bend);
  expect_g2();
  good("section.mirror @q3");
  for (const world::Entity e : before.track.knots)
    EXPECT_LT(glm::distance(world::knot(session.document, e).position, world::knot(before, e).position), 1e-4f);
  good("element straight length 40 roll 30");
  good("section.mirror @q5");
  EXPECT_EQ(world::section(session.document, entity("q5")).element.values[1], -30);
}

TEST_F(SectionOrder, a_hand_shaped_section_is_mirrored_knot_by_knot) {
  const world::SectionRun run = world::run_of(session.document, entity("q3"));
  good("section.make @" + world::label_of(session.document, session.document.track.knots[run.first]) + ",@" +
       world::label_of(session.document, session.document.track.knots[run.end()]) + [&] {
         std::string more;
         for (std::size_t i = run.first + 1; i < run.end(); ++i)
           more += ",@" + world::label_of(session.document, session.document.track.knots[i]);
         return more;
       }());
  ASSERT_TRUE(world::is_free(session.document, entity("q3")));
  const std::vector<double> hill = shape_of("q4"), bend = shape_of("q3");
  const world::Document before = session.document;
  good("section.mirror @q3");
  expect_near(shape_of("q4"), hill), expect_near(shape_of("q3"), bend);
  expect_g2();
  // The same as the curve planned to the other side.
  const world::Document by_hand = session.document;
  good("undo");
  good("section.change @q3 to curve right angle 70");
  EXPECT_EQ(session.document.track, by_hand.track);
  for (const world::Entity e : before.track.knots) {
    EXPECT_LT(glm::distance(world::knot(session.document, e).position, world::knot(by_hand, e).position), 2e-4f);
    EXPECT_LT(glm::distance(world::knot(session.document, e).up, world::knot(by_hand, e).up), 1e-5f);
    EXPECT_NEAR(world::knot(session.document, e).spin, world::knot(by_hand, e).spin, 1e-5);
  }
}

TEST_F(SectionOrder, what_would_tilt_the_track_or_move_a_closed_one_is_refused) {
  good("element climb height 10");
  good("append at 100 30 0");
  refused("section.delete @q9", "there is no section @q9");
  good("closed on");
  for (const char* line : {"section.delete @q2", "section.move @q2 after"}) refused(line, "the track is closed");
  refused("section.mirror @q3", "the track is closed");
  good("new");
  good("append at 0 5 0"), good("append at 20 5 0"), good("append at 40 15 0"), good("append at 60 40 0");
  good("section.make @k2,@k3"), good("section.make @k3,@k4");
  refused("section.delete @q3", "degrees");
  refused("section.move @q1 after", "degrees");
}

}  // namespace section_order_test
}  // namespace coaster::edit
