#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_settings.h"
#include "ui/stage.h"
#include "ui/tools/places.h"
#include "ui/widgets/medals.h"
#include "ui/widgets/widgets.h"
#include "world/aids.h"

namespace coaster::ui {
namespace score_card_test {

class ScoreCardTest : public Stage {
 protected:
  void end_a_ride() {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Aids::show_card>{true}));
    ASSERT_TRUE(edit::apply(session_, files_, edit::RideStart{}));
    edit::advance(session_, 120 * 120);
    ASSERT_TRUE(session_.game.result);
    frames(3);
  }
};

TEST_F(ScoreCardTest, the_card_shows_the_ghosts_numbers_and_closes_by_key) {
  resize(1280, 720);
  EXPECT_EQ(find("Score/Top speed"), nullptr);
  end_a_ride();
  ASSERT_NE(find("Score/Top speed"), nullptr);
  EXPECT_EQ(find("Score/Top speed")->value,
            fixed(edit::find(session_, edit::Want::ratings).ratings->top_speed.value, 1) + " m/s");
  EXPECT_EQ(find("Score/Length"), nullptr) << "the card is slim until its details are wanted";
  const float slim = find("Score/Close")->y;
  click("Score/Details");
  frames(2);
  ASSERT_NE(find("Score/Length"), nullptr);
  EXPECT_GT(find("Score/Close")->y, slim + 100);
  EXPECT_EQ(find("Score/Length")->value, fixed(session_.derived.length, 1) + " m");
  key(platform::Key::escape);
  frame();
  EXPECT_EQ(find("Score/Top speed"), nullptr);
  EXPECT_FALSE(session_.game.show_result);
}

TEST_F(ScoreCardTest, the_card_stays_within_the_viewport_and_gives_way_where_there_is_none) {
  end_a_ride();
  for (const glm::ivec2 size : {glm::ivec2{1280, 720}, {1920, 1080}, {900, 500}}) {
    resize(size.x, size.y);
    frames(3);
    const view::Viewport scene = last_.view.viewport;
    for (const Widget& widget : host_->widgets()) {
      if (!widget.path.starts_with("Score/") || !widget.visible) continue;
      EXPECT_GE(widget.x, scene.x) << widget.path;
      EXPECT_LE(widget.x + widget.width, scene.x + scene.width) << widget.path;
    }
  }
  resize(320, 200);
  frames(3);
  EXPECT_EQ(find("Score/Top speed"), nullptr) << "there is no room";
}

TEST_F(ScoreCardTest, where_it_failed_is_selected_and_looked_at) {
  resize(1280, 720);
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetLosses{0.5f, 0}));
  end_a_ride();
  ASSERT_EQ(session_.game.result->end, edit::RideEnd::failed) << "that much friction holds it on the slope";
  const auto place = failed_place(session_);
  ASSERT_TRUE(place);
  key(platform::Key::j);
  frames(2);
  const sim::TrackPlace at = sim::place_at(session_.derived, *place);
  EXPECT_EQ(session_.settings.selected, session_.derived.order[at.index]);
  const glm::dvec3 target(session_.settings.camera.target),
      there =
          curve::point(world::cubic_of(session_.document, session_.settings.selected), session_.settings.selected_t);
  EXPECT_LT(glm::length(target - there), 1e-3);
  EXPECT_FALSE(card_shows(session_)) << "the card would lie over it";
}

TEST(medals, titles_go_from_none_to_gold) {
  EXPECT_EQ(medal_title(0), "No medal");
  EXPECT_EQ(medal_title(1), "Bronze");
  EXPECT_EQ(medal_title(3), "Gold");
}

}  // namespace score_card_test
}  // namespace coaster::ui
