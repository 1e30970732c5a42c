// Tests which commands leave a section as it was planned (edit/perform/change_propagation.h).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "world/sections.h"

namespace coaster::edit {
namespace hand_shaped_test {

// A straight q1 (k1, k2), a loop q2 (k2 to k12 or so) and a curve q3.
class HandShaped : public test::SessionTest {
 protected:
  HandShaped() : SessionTest(world::Document{}) {
    for (const char* line : {"element straight length 30", "element loop right", "element curve angle 120"}) good(line);
    loop_ = world::run_of(session.document, entity("q2"));
  }
  // Returns the kinds of the sections in the order of travel.
  std::string kinds() const {
    std::string text;
    for (const world::SectionRun& run : world::sections_of(session.document))
      text += (text.empty() ? "" : " ") + std::string(world::kind_name(world::section(session.document, run.section)));
    return text;
  }
  std::string name_of_knot(std::size_t index) const {
    return "@" + world::label_of(session.document, session.document.track.knots[index]);
  }
  // Applies a line to the track as placed; returns the kinds afterwards. Undo restores the document.
  std::string after(const std::string& line) {
    const world::Document before = session.document;
    const std::size_t steps = session.history.undo.size();
    good(line);
    const std::string result = kinds();
    if (session.history.undo.size() > steps) good("undo");
    EXPECT_TRUE(session.document == before) << line;
    return result;
  }

  world::SectionRun loop_;
};

TEST_F(HandShaped, placed_elements_are_sections) {
  EXPECT_EQ(kinds(), "straight loop curve");
  const world::Section& loop = world::section(session.document, entity("q2"));
  EXPECT_TRUE(loop.element.right);
  EXPECT_EQ(loop.element.values[0], 16);
  good("append at 100 5 100");
  EXPECT_EQ(kinds(), "straight loop curve free");
  good("element dive height 3");
  EXPECT_EQ(kinds(), "straight loop curve free dive");
}

TEST_F(HandShaped, editing_a_knot_frees_its_section_in_the_same_step_and_says_so) {
  const std::string inside = name_of_knot(loop_.first + 2);
  for (const std::string& edit :
       {"move " + inside + " to 40 3 1", "roll " + inside + " to 3", "spin " + inside + " to 1", "auto_spin " + inside,
        "lengths " + inside + " in 2 out 2", "remove " + inside, "direct " + inside + " to 1 1 0", "drop " + inside,
        "handle " + inside + ".in to 1 2 3"})
    EXPECT_EQ(after(edit), "straight free curve") << edit;
  const std::string segment = world::label_of(session.document, session.document.track.segments[loop_.first]);
  EXPECT_EQ(after("split @" + segment + " at 0.5"), "straight free curve");
  EXPECT_EQ(after("turns @" + segment + " to 1"), "straight free curve");
  good("move " + inside + " to 40 3 1");
  EXPECT_EQ(session.notices.list.back().text, "The loop is now hand-shaped.");
  EXPECT_EQ(world::section(session.document, entity("q2")), world::Section{});
}

TEST_F(HandShaped, a_joint_belongs_to_both_sides) {
  const std::string joint = name_of_knot(loop_.first);
  EXPECT_EQ(after("move " + joint + " to 31 3 1"), "free free curve");
  const auto& notices = session.notices.list;
  EXPECT_EQ(notices[notices.size() - 2].text, "2 sections are now hand-shaped.");
  EXPECT_EQ(notices.back().text, fmt::format("Undo: Moved {}.", joint.substr(1)));
  good("redo");
  EXPECT_EQ(session.notices.list.back().text, fmt::format("Redo: Moved {}.", joint.substr(1)));
  good("undo");
  EXPECT_EQ(after("spin " + joint + " to 1"), "straight loop curve") << "the spin belongs to neither";
  EXPECT_EQ(after("auto_spin " + joint), "straight loop curve");
  EXPECT_EQ(after("remove @k1"), "loop curve");
  EXPECT_EQ(after("closed on"), "straight loop curve free");
}

TEST_F(HandShaped, what_moves_as_a_whole_keeps_its_plan) {
  EXPECT_EQ(after("translate all by 100.3 -7.7 31.9"), "straight loop curve");
  EXPECT_EQ(after("rotate all by 33.3 about 900 -5 400"), "straight loop curve");
  EXPECT_EQ(after("rotate all by 3 about 0 0 0 axis 1 0 0"), "free free free") << "up is another direction";
  EXPECT_EQ(after("mirror all across 1 0 0 about 0 0 0"), "straight free free") << "a straight has no sides";
  EXPECT_EQ(after("scale_knots all by 1.001 1.001 1.001 about 0 0 0"), "free free free");
  EXPECT_EQ(after("reverse"), "free free straight") << "both ways of a straight are the same";
  std::string knots;
  for (std::size_t i = 0; i <= loop_.count; ++i) knots += (i > 0 ? "," : "") + name_of_knot(loop_.first + i);
  EXPECT_EQ(after("translate " + knots + " by 0 0 4"), "free loop free");
}

TEST_F(HandShaped, a_drag_frees_once_and_is_one_step) {
  const world::Document before = session.document;
  const std::size_t steps = session.history.undo.size();
  const std::string inside = name_of_knot(loop_.first + 1);
  good("gesture.begin");
  const std::uint64_t serial = session.notices.serial;
  for (int i = 1; i < 9; ++i) good("translate " + inside + " by 0 0." + std::to_string(i) + " 0 from_start on");
  EXPECT_EQ(session.notices.serial, serial + 1);
  good("gesture.end");
  EXPECT_EQ(kinds(), "straight free curve");
  EXPECT_EQ(session.history.undo.size(), steps + 1);
  good("undo");
  EXPECT_TRUE(session.document == before);
}

TEST_F(HandShaped, what_does_not_shape_the_track_frees_nothing) {
  for (const char* line : {"name \"x\"", "datum 3", "heartline 0.7", "curve heartline keep numbers", "start_speed 9",
                           "equip @s2 as brake speed 3", "add_cart @s1 at 0.5", "joint @k2 to aligned"})
    EXPECT_EQ(after(line), "straight loop curve") << line;
}

}  // namespace hand_shaped_test
}  // namespace coaster::edit
