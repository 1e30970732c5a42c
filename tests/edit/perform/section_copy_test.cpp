// Tests copying and pasting sections (edit/perform/sections.cpp).
#include <gtest/gtest.h>

#include "base/text.h"
#include "edit/session_fixture.h"
#include "world/sections.h"

namespace coaster::edit {
namespace section_copy_test {

class SectionCopy : public test::SessionTest {
 protected:
  SectionCopy() : SessionTest(world::Document{}) {
    for (const char* line :
         {"element straight length 30", "element curve right angle 60 radius 30", "append at 90 3 80"})
      good(line);
    good("section.title @q2 to \"Bend\"");
    good("section.equip @q2 as brake speed 7");
  }
  const world::Section& last() const {
    return world::section(session.document, world::sections_of(session.document).back().section);
  }
};

TEST_F(SectionCopy, a_planned_section_is_planned_again_at_the_open_end) {
  good("element straight length 10");
  const std::size_t steps = session.history.undo.size();
  good("section.copy @q2");
  EXPECT_EQ(session.history.undo.size(), steps) << "copying changes nothing";
  EXPECT_EQ(session.notices.list.back().text, "Copied \"Bend\".");
  const world::Section original = world::section(session.document, entity("q2"));
  good("section.paste");
  EXPECT_EQ(session.notices.list.back().text, "Pasted \"Bend\".");
  EXPECT_EQ(last(), original);
  EXPECT_EQ(session.history.undo.size(), steps + 1);
  const world::SectionRun run = world::sections_of(session.document).back();
  EXPECT_EQ(session.settings.selected, run.section);
  for (std::size_t i = run.first; i < run.end(); ++i) {
    const auto* const brake = session.document.entities.find<world::Equipment>(session.document.track.segments[i]);
    ASSERT_TRUE(brake);
    EXPECT_EQ(brake->speed, 7);
  }
  const world::Knot &from = world::knot(session.document, session.document.track.knots[run.first]),
                    &to = world::knot(session.document, session.document.track.knots[run.end()]);
  const auto level = [](glm::dvec3 v) { return glm::normalize(glm::dvec3(v.x, 0, v.z)); };
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(level(from.tangent), level(to.tangent)))), 60, 1e-3);
}

TEST_F(SectionCopy, a_hand_shaped_one_is_turned_to_go_on) {
  const world::SectionRun run = world::sections_of(session.document).back();
  const auto chord = [&](const world::SectionRun& r) {
    const auto& knots = session.document.track.knots;
    return glm::dvec3(world::knot(session.document, knots[r.end()]).position) -
           glm::dvec3(world::knot(session.document, knots[r.first]).position);
  };
  const glm::dvec3 original = chord(run);
  good("section.copy @q3");
  refused("section.paste", "degrees");
  const std::string end = "@" + world::label_of(session.document, session.document.track.knots.back());
  good("direct " + end + " to 0 0 1"), good("roll " + end + " to 0");
  good("section.copy @q3");
  good("section.paste");
  const glm::dvec3 copied = chord(world::sections_of(session.document).back());
  EXPECT_NEAR(glm::length(copied), glm::length(original), 1e-4);
  EXPECT_NEAR(copied.y, original.y, 1e-4);
}

TEST_F(SectionCopy, text_comes_from_anywhere) {
  good("section.copy @q2");
  const std::string text = session.copied;
  good("new");
  good("section.paste text " + base::quoted(text));
  EXPECT_EQ(last().title, "Bend");
  EXPECT_EQ(session.document.entities.pool<world::Train>().size(), 1u);
  good("section.paste");
  EXPECT_EQ(world::sections_of(session.document).size(), 2u) << "what was copied outlives the track";
  refused("section.paste text \"hello\"", "clipboard");
  refused("section.copy @q7", "there is no section @q7");
  good("closed on");
  refused("section.paste", "the track is closed");
}

TEST_F(SectionCopy, several_go_on_from_one_another_in_the_order_of_the_track) {
  good("element climb height 12 angle 30");
  good("section.copy @q4,@q2,@q1");
  EXPECT_EQ(session.notices.list.back().text, "Copied 3 sections.");
  good("new");
  good("section.paste");
  const std::vector<world::SectionRun> runs = world::sections_of(session.document);
  ASSERT_EQ(runs.size(), 3u);
  const char* const kinds[] = {"straight", "curve", "climb"};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(world::kind_name(world::section(session.document, runs[i].section)), kinds[i]);
  EXPECT_TRUE(session.document.entities.find<world::Equipment>(session.document.track.segments[runs[1].first]));
  EXPECT_FALSE(session.document.entities.find<world::Equipment>(session.document.track.segments[runs[2].first]));
  good("select_sections all");
  good("section.copy selected");
  refused("section.copy none", "expected a section");
}

TEST_F(SectionCopy, without_a_copy_there_is_nothing_to_paste) {
  refused("section.paste", "nothing was copied: copy sections first");
}

}  // namespace section_copy_test
}  // namespace coaster::edit
