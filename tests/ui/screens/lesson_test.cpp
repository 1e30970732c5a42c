// Cards and rings of lessons (ui/screens/hud.h).
#include "ui/screens/hud.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "ui/widgets/theme.h"
#include "world/appearance_settings.h"

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

// Targets all round the card, some above or below it, and one wider than the card.
TEST(lesson, the_line_leads_from_the_card_to_the_target_and_never_across_the_card) {
  const LessonBox card{{539, 37}, {969, 152}};
  const glm::vec2 places[] = {{41, 48}, {41, 290}, {113, 248}, {700, 500}, {1170, 86}, {600, 10}, {1200, 690}};
  for (const glm::vec2 place : places)
    for (const glm::vec2 half : {glm::vec2(33, 18), glm::vec2(500, 20), glm::vec2(4, 4)}) {
      const LessonBox target{place - half, place + half};
      const LessonLine line = lesson_line(card, target);
      for (int i = 0; i <= 100; ++i) {
        const glm::vec2 at = glm::mix(line.from, line.to, static_cast<float>(i) / 100);
        const bool inside =
            glm::all(glm::lessThan(card.low + 0.01f, at)) && glm::all(glm::lessThan(at, card.high - 0.01f));
        ASSERT_FALSE(inside) << "at " << at.x << ", " << at.y << " to " << place.x << ", " << place.y;
      }
      const glm::vec2 near = glm::clamp(line.to, target.low, target.high);
      EXPECT_LT(glm::distance(near, line.to), 1e-3f);
    }
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

// The ring around the widget swells by 3 px and back 0.7 times a second; in scripts it stands still, at its largest.
TEST_F(LessonTest, the_ring_around_its_widget_breathes) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{2.0f}));
  resize(2560, 1440);
  const query::LessonCard card{"Click Play.", "Ride/Play", 1, 2};
  lesson_ = &card;
  frames(30);
  const auto grown = [&] {
    frame();
    const Widget& play = *find("Ride/Play");
    float left = play.x;
    for (const ImDrawVert& v : ImGui::GetForegroundDrawList()->VtxBuffer)
      if (v.col == packed(palette().warning)) left = std::min(left, v.pos.x);
    return play.x - left;
  };
  std::vector<float> sizes;
  for (int i = 0; i < 172; ++i) sizes.push_back(grown());  // two breaths
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  EXPECT_NEAR(*most - *least, 6, 1.1);  // whole pixels
  int swells = 0;
  for (std::size_t i = 1; i < sizes.size(); ++i) swells += sizes[i] == *most && sizes[i - 1] < *most;
  EXPECT_NEAR(swells, 2, 1);
  scripted_ = true;
  const float largest = grown();
  EXPECT_NEAR(largest, *least + 6, 0.1);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(grown(), largest);
}

// The buttons end where the text does, so that they stay in place from lesson to lesson.
TEST_F(LessonTest, its_buttons_are_at_the_right_of_the_card) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}}) {
    resize(width, height);
    const query::LessonCard card{"Click Close.", "Shape/Close", 1, 2};
    lesson_ = &card;
    frames(14);
    const view::Viewport scene = host_->view().viewport;
    const float right = std::floor(scene.x + 0.5f * scene.width) + std::min(430.0f, scene.width - 16) / 2 - 16;
    const Widget &show = *find("Lesson/Show me"), &leave = *find("Lesson/Leave");
    EXPECT_NEAR(leave.x + leave.width, right, 2) << width;
    EXPECT_GT(leave.x, show.x + show.width);
    EXPECT_EQ(leave.y, show.y);
    EXPECT_GT(find("Lesson/Text")->y, show.y + show.height);
  }
}

}  // namespace lesson_test
}  // namespace coaster::ui
