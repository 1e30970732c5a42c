// Clicks on the ground.
#include "ui/tools/cursor_places.h"

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "ui/stage.h"
#include "world/aids.h"

namespace coaster::ui {
namespace cursor_places_test {

struct CursorPlacesTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    ASSERT_TRUE(edit::apply(session_, files_, edit::SetCamera{{.target = {0, 6, 3}, .distance = 60}}));
    frames(3);
  }
  void set_projection(world::Projection to) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Camera::projection>{to}));
    frames(2);
  }
};

TEST_F(CursorPlacesTest, knots_stand_above_the_ground_in_every_view) {
  const view::View& v = host_->view();
  const glm::vec2 low = empty_ground();
  const auto at = append_place(session_.document, v, low);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->y, 2);
  const auto seen = view::project(v, *at);
  ASSERT_TRUE(seen);
  EXPECT_LT(glm::distance(glm::vec2(*seen), low), 0.5f);
  EXPECT_FALSE(append_place(session_.document, v, {v.viewport.x + 5, v.viewport.y + 2})) << "the sky";
  set_projection(world::Projection::front);
  const glm::vec3 last = knot(3).position;
  const auto buried = append_place(session_.document, host_->view(), low),
             top = append_place(session_.document, host_->view(), pixel_of(2));
  ASSERT_TRUE(buried && top);
  EXPECT_EQ(buried->y, 2);
  EXPECT_EQ(buried->z, last.z);
  EXPECT_NEAR(top->y, knot(2).position.y, 1e-3f);
  set_projection(world::Projection::top);
  EXPECT_EQ(append_place(session_.document, host_->view(), low)->y, last.y);
  EXPECT_EQ(append_place({}, host_->view(), low)->y, 2) << "the first knot";
}

TEST_F(CursorPlacesTest, a_click_beside_the_preview_of_the_first_element_places_no_knot) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::ChooseElement{world::usual_element(world::ElementKind::straight)}));
  frames(3);
  click_at(empty_ground());
  EXPECT_TRUE(session_.document.track.knots.empty());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Aids::show_element>{false}));
  frames(30);  // no double click
  click_at(empty_ground());
  EXPECT_EQ(session_.document.track.knots.size(), 1u);
}

}  // namespace cursor_places_test
}  // namespace coaster::ui
