#include "ui/screens/overlays.h"
#include "ui/stage.h"

namespace coaster::ui {
namespace lesson_test {

Widget widget(const std::string& path, bool visible) {
  Widget w;
  w.path = path, w.visible = visible;
  return w;
}

TEST(lesson, a_closed_list_is_marked_in_place_of_what_it_holds) {
  LessonGuide guide;
  const query::LessonCard card{"Choose it.", "Operation/Equipment/Launch", 3, 9};
  EXPECT_TRUE(guide.begins(&card));
  guide.follow(&card, {widget("Operation", true), widget("Operation/Equipment", true)});
  EXPECT_FALSE(guide.target);
  ASSERT_TRUE(guide.marked);
  EXPECT_EQ(guide.marked->path, "Operation/Equipment");
  guide.follow(&card, {widget("Operation/Equipment", true), widget("Operation/Equipment/Launch", true)});
  EXPECT_EQ(guide.marked->path, "Operation/Equipment/Launch");
  guide.follow(&card, {widget("Operation", true), widget("Operation/Equipment", false)});
  EXPECT_EQ(guide.marked->path, "Operation") << "what is scrolled out of sight is no mark";
  for (int i = 0; i < 20; ++i) guide.follow(&card, {});
  EXPECT_FALSE(guide.marked);
  EXPECT_FALSE(guide.begins(&card));
  EXPECT_TRUE(guide.begins(nullptr) == false);
}

struct LessonTest : Stage {};

TEST_F(LessonTest, a_lesson_opens_the_panel_of_its_widget_and_scrolls_to_it) {
  frames(3);
  ASSERT_EQ(find("Shape/Close"), nullptr) << "the panel is closed";
  const query::LessonCard card{"Click Close.", "Shape/Close", 1, 2};
  lesson_ = &card;
  frames(14);
  ASSERT_NE(find("Shape/Close"), nullptr);
  EXPECT_TRUE(find("Shape/Close")->visible);
  click("Shape");
  frames(2);
  EXPECT_EQ(find("Shape/Close"), nullptr) << "the user may close it again";
}

}  // namespace lesson_test
}  // namespace coaster::ui
