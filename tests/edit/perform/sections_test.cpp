// Tests the commands of sections (edit/perform/sections.cpp).
#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "sim/ride/equipment.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::edit {
namespace perform_sections_test {

class PerformSections : public test::SessionTest {
 protected:
  // Writes the sections as "q1:2 free, q2:1 loop".
  std::string sections() const {
    std::string text;
    for (const world::SectionRun& run : world::sections_of(session.document))
      text += (text.empty() ? "" : ", ") + world::label_of(session.document, run.section) + ":" +
              std::to_string(run.count) + " " +
              std::string(world::kind_name(world::section(session.document, run.section)));
    return text;
  }
  std::string title(const char* name) const { return world::section(session.document, entity(name)).title; }
};

TEST_F(PerformSections, are_made_of_neighbouring_knots) {
  good("section.make @k2,@k3");
  EXPECT_EQ(sections(), "q1:1 free, q3:1 free, q2:2 free");
  EXPECT_EQ(session.settings.selected, entity("q3"));
  good("section.make @k2,@k3,@k4");
  EXPECT_EQ(sections(), "q1:1 free, q3:2 free, q2:1 free");
  good("section.make all");
  EXPECT_EQ(sections(), "q1:4 free");
  refused("section.make @k2", "two or more neighbouring knots");
  refused("section.make @k2,@k4", "two or more neighbouring knots");
  good("closed on");
  good("section.make all");
  EXPECT_EQ(sections(), "q1:5 free");
  refused("section.make @k5,@k1,@k2", "beyond the first knot of a closed track");
}

TEST_F(PerformSections, are_split_and_joined) {
  good("section.title @q1 to \"Way out\"");
  good("section.split @k3");
  EXPECT_EQ(sections(), "q1:2 free, q2:2 free");
  EXPECT_EQ(title("q1"), "Way out");
  EXPECT_EQ(title("q2"), "");
  refused("section.split @k3", "not inside a section");
  refused("section.split @k1", "not inside a section");
  refused("section.split @k5", "not inside a section");
  refused("section.join @q2", "there is no section after the hand-shaped section");
  good("section.title @q2 to \"Way home\"");
  good("section.join @q1");
  EXPECT_EQ(sections(), "q1:4 free");
  EXPECT_EQ(title("q1"), "Way out");
  good("undo"), good("undo"), good("undo");
  EXPECT_EQ(sections(), "q1:4 free");
}

TEST_F(PerformSections, a_planned_section_that_is_cut_becomes_free) {
  good("element loop"), good("element straight");
  EXPECT_EQ(sections().substr(0, 10), "q1:4 free,");
  const world::SectionRun loop = world::run_of(session.document, entity("q2"));
  good("section.split @" + world::label_of(session.document, session.document.track.knots[loop.first + 1]));
  EXPECT_TRUE(world::is_free(session.document, entity("q2")));
  EXPECT_EQ(session.notices.list.back().text, "The loop is now hand-shaped.");
  good("undo");
  good("section.join @q2");
  EXPECT_TRUE(world::is_free(session.document, entity("q2")));
  EXPECT_FALSE(entity("q3").valid());
}

TEST_F(PerformSections, titles_are_checked) {
  refused("section.title @q1 to \"" + std::string(201, 'x') + "\"", "limit of 200 bytes");
  refused("section.title @q1 to \"a\\nb\"", "without control characters");
  good("section.title @q1 to \"\u00c9pingle\"");
  EXPECT_EQ(title("q1"), "\u00c9pingle");
  const auto again = exchange::parse_track(exchange::print_track(session.document), "t");
  ASSERT_TRUE(again);
  EXPECT_EQ(world::hash(again->document), hash());
}

TEST_F(PerformSections, are_equipped_in_one_step) {
  good("section.split @k4");
  const auto spans = [&] { return sim::equipment_spans(session.document, session.derived); };
  good("section.equip @q1 as lift speed 3");
  EXPECT_EQ(spans().size(), 3u);
  good("section.equip @q1 as station speed 3 seconds 1");
  ASSERT_EQ(spans().size(), 1u);
  EXPECT_EQ(spans()[0].from, 0);
  EXPECT_EQ(spans()[0].to, session.derived.starts[3]) << "a train stops once, at the end";
  good("section.equip @q2 as station speed 3 seconds 1");
  EXPECT_EQ(spans().size(), 2u) << "never over the end of a section";
  good("reverse");
  EXPECT_EQ(spans().size(), 2u);
  good("undo");
  good("split @s2 at 0.4");
  EXPECT_EQ(spans().size(), 2u);
  good("equip @s2 as station speed 5 seconds 1");
  EXPECT_EQ(spans().size(), 4u) << "another station in the middle";
  good("undo");
  good("section.unequip @q1");
  EXPECT_EQ(spans().size(), 1u);
  refused("section.unequip @q1", "there is no equipment on the hand-shaped section");
  refused("section.equip @q9 as lift", "there is no section @q9");
  clamped("section.equip @q1 as lift speed 999", "speed");
}

TEST_F(PerformSections, are_selected_together_and_the_last_one_named_is_active) {
  good("section.split @k4");
  good("select_sections @q2,@q1");
  EXPECT_EQ(session.settings.selected, entity("q1"));
  EXPECT_EQ(session.settings.also, std::vector{entity("q2")});
  EXPECT_TRUE(world::selected_knots(session.document, session.settings).empty());
  good("select_sections selected");
  EXPECT_EQ(session.settings.selected, entity("q1"));
  good("section.join @q1");
  EXPECT_EQ(session.settings.selected, entity("q1"));
  EXPECT_TRUE(session.settings.also.empty()) << "what is gone is not selected";
  refused("select_sections @k2", "@k2");
  good("select none");
  refused("select_sections selected", "no section is selected");
}

// A number that is dragged gives the same equipment again and again.
TEST_F(PerformSections, a_notice_names_new_equipment_and_none_a_changed_number) {
  const auto notice_of = [&](const std::string& line) {
    const std::uint64_t before = session.notices.serial;
    good(line);
    return session.notices.serial == before ? std::string() : session.notices.list.back().text;
  };
  EXPECT_EQ(notice_of("section.title @q1 to \"Way out\""), "");
  EXPECT_EQ(notice_of("section.equip @q1 as lift speed 4"), "Made \"Way out\" a lift.");
  EXPECT_EQ(notice_of("section.equip @q1 as lift speed 5"), "");
  EXPECT_EQ(notice_of("equip @s2 as brake speed 5"), "Made s2 a brake.");
  EXPECT_EQ(notice_of("equip @s2 as brake speed 6"), "");
  EXPECT_EQ(notice_of("unequip @s2"), "Removed the equipment of s2.");
  EXPECT_EQ(notice_of("section.equip @q1 as lift speed 5"), "Made \"Way out\" a lift.") << "s2 was plain";
  EXPECT_EQ(notice_of("section.unequip @q1"), "Removed the equipment of \"Way out\".");
}

TEST_F(PerformSections, are_selected) {
  good("select @q1");
  EXPECT_EQ(session.settings.selected, entity("q1"));
  refused("select @q2", "there is no section @q2");
  good("section.split @k3");
  good("select @q2");
  good("undo");
  EXPECT_FALSE(session.settings.selected.valid());
}

}  // namespace perform_sections_test
}  // namespace coaster::edit
