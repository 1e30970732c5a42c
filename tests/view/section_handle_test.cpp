// Handles of sections: src/view/gizmo.
#include "view/gizmo.h"

#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "view/pick.h"
#include "world/panel_settings.h"

namespace coaster::view {
namespace section_handle_test {

class SectionHandles : public test::SessionTest {
 protected:
  SectionHandles() : SessionTest(world::Document{}) {
    for (const char* line : {"element straight length 30", "element climb height 20 angle 30", "element loop height 14",
                             "element curve left radius 25 angle 90 bank 0", "append at 200 30 100"})
      good(line);
  }
  SectionHandle handle(const char* name) {
    const auto found = section_handle(session.document, session.derived, entity(name));
    EXPECT_TRUE(found) << name;
    return found.value_or(SectionHandle{});
  }
  // The value for which the handle is at a place, seen across the line that it moves on.
  static double value_at(const SectionHandle& of, glm::dvec3 place) {
    const glm::dvec3 eye = place + glm::dvec3(-31, of.parameter == "height" ? 0 : 47, 59);
    return value_under(of, {glm::vec3(eye), glm::vec3(glm::normalize(place - eye))}).value();
  }
};

TEST_F(SectionHandles, each_kind_has_the_parameter_that_says_most) {
  EXPECT_EQ(handle("q1").parameter, "length");
  EXPECT_EQ(handle("q2").parameter, "height");
  EXPECT_EQ(handle("q3").parameter, "height");
  EXPECT_EQ(handle("q4").parameter, "radius");
  EXPECT_FALSE(section_handle(session.document, session.derived, entity("q5"))) << "shaped by hand";
  EXPECT_NEAR(handle("q2").at.y - handle("q2").from.y, 20, 1e-3);
  EXPECT_NEAR(handle("q3").at.y - handle("q3").from.y, 14, 0.05);
}

// Where the handle is put, there it is after the section was planned with that value.
TEST_F(SectionHandles, the_place_of_a_handle_follows_its_value) {
  const struct {
    const char *name, *change;
    double value;
  } kCases[] = {{"q1", "section.change @q1 to straight length 40", 40},
                {"q2", "section.change @q2 to climb height 26 angle 30", 26},
                {"q3", "section.change @q3 to loop height 17", 17},
                {"q4", "section.change @q4 to curve left radius 30 angle 90 bank 0", 30}};
  for (const auto& one : kCases) {
    const SectionHandle before = handle(one.name);
    good(one.change);
    const SectionHandle after = handle(one.name);
    EXPECT_EQ(after.value, one.value) << one.name;
    const glm::dvec3 moved = after.from - before.from;
    EXPECT_NEAR(value_at(before, after.at - moved), one.value, 0.02 * one.value) << one.name;
    EXPECT_NEAR(value_at(after, after.at), one.value, 1e-4) << one.name;
  }
}

TEST_F(SectionHandles, the_selected_one_s_is_picked_in_build_alone) {
  good("select @q2");
  const Viewport viewport{0, 0, 800, 600};
  const View view = orbit_view(frame_all({}, session.document, viewport), viewport);
  const auto pixel = project(view, glm::vec3(handle("q2").at));
  ASSERT_TRUE(pixel);
  const auto picked = [&] {
    return pick(session.document, session.derived, session.motion, session.settings, view, glm::vec2(*pixel)).kind;
  };
  EXPECT_NE(picked(), PickKind::section);
  session.settings.panels->workspace = world::Workspace::build;
  EXPECT_EQ(picked(), PickKind::section);
  const auto marks = [&] { return build_overlay(session.document, session.derived, session.settings, view, {}).marks; };
  ASSERT_FALSE(marks().empty());
  EXPECT_EQ(marks().back().position, glm::vec3(handle("q2").at));
  good("select_sections @q1,@q2");
  EXPECT_NE(picked(), PickKind::section) << "of several none";
}

}  // namespace section_handle_test
}  // namespace coaster::view
