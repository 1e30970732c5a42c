#include <limits>

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/evaluation_settings.h"

namespace coaster::ui {
namespace fields_test {

struct FieldsTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    select(world::EntityKind::knot, 2);
    commands_.clear();
  }
};

TEST_F(FieldsTest, a_typed_number_is_one_command_and_one_step) {
  const std::size_t steps = session_.history.undo.size();
  type("Inspector/Position/x", "-12.625");
  ASSERT_EQ(all<edit::MoveKnot>().size(), 1u) << "nothing goes out while it is typed";
  EXPECT_EQ(knot(2).position.x, -12.625f);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
}

TEST_F(FieldsTest, numbers_beyond_float_are_clamped_by_the_command_with_a_notice) {
  for (const char* huge : {"1e39", "-1e39", "1e39+1e30"}) {
    commands_.clear();
    type("Inspector/Position/x", huge);
    frame();
    ASSERT_EQ(all<edit::MoveKnot>().size(), 1u) << huge;
    EXPECT_TRUE(std::isfinite(all<edit::MoveKnot>()[0].to.x)) << huge;
    EXPECT_EQ(std::abs(knot(2).position.x), world::kMaxCoordinate) << huge;
    EXPECT_NE(host_->toast().find("limit"), std::string::npos) << host_->toast();
    type("Inspector/Position/x", "3");
  }
}

TEST_F(FieldsTest, what_is_no_number_changes_nothing_and_says_so) {
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "1/0", "abc", "-", "", "7,25", "1.000,5", "12abc", "5 s"}) {
    const auto before = world::hash(session_.document);
    const std::size_t steps = session_.history.undo.size();
    commands_.clear();
    click("Inspector/Position/y", {.ctrl = true});
    key(platform::Key::a, {.ctrl = true});
    if (*bad == 0) key(platform::Key::del);
    else frame({platform::TextInput{bad}});
    key(platform::Key::enter);
    frame();
    EXPECT_TRUE(commands_.empty()) << bad;
    EXPECT_EQ(world::hash(session_.document), before) << bad;
    EXPECT_EQ(session_.history.undo.size(), steps) << bad;
    EXPECT_NE(host_->toast().find("not a number"), std::string::npos) << host_->toast();
  }
}

TEST_F(FieldsTest, arithmetic_and_units_of_length_count) {
  const std::pair<const char*, float> cases[]{
      {"5+5", 10}, {"2*(1.5 - 0.25)", 2.5f}, {"250 cm", 2.5f}, {"1 m + 50cm", 1.5f}};
  for (const auto& [typed, wanted] : cases) {
    type("Inspector/Position/y", typed);
    EXPECT_EQ(knot(2).position.y, wanted) << typed;
  }
}

TEST_F(FieldsTest, a_number_of_things_is_whole) {
  select(world::EntityKind::segment, 1);
  commands_.clear();
  type("Inspector/Turns", "1.5");
  frame();
  EXPECT_TRUE(commands_.empty());
  EXPECT_NE(host_->toast().find("not a whole number"), std::string::npos) << host_->toast();
  type("Inspector/Turns", "4/2");
  ASSERT_EQ(all<edit::SetTurns>().size(), 1u);
  EXPECT_EQ(all<edit::SetTurns>()[0].to, 2);
}

TEST_F(FieldsTest, a_plain_click_opens_a_number_for_typing_too) {
  click("Inspector/Position/z");
  EXPECT_TRUE(host_->wants_keyboard());
  frame({platform::TextInput{"7.75"}});
  key(platform::Key::enter);
  EXPECT_EQ(knot(2).position.z, 7.75f);
  EXPECT_FALSE(host_->wants_keyboard());
}

TEST_F(FieldsTest, escape_leaves_a_field_as_it_was) {
  const auto before = world::hash(session_.document);
  type("Inspector/Position/x", "55", false);
  key(platform::Key::escape);
  frame();
  EXPECT_EQ(world::hash(session_.document), before);
  EXPECT_TRUE(session_.settings.selected.valid()) << "Escape belongs to the field, not to the selection";
}

TEST_F(FieldsTest, a_click_elsewhere_completes_the_field_for_the_knot_it_was_typed_for) {
  const float third = knot(3).position.x;
  type("Inspector/Position/x", "-2.5", false);
  click_at(pixel_of(3));
  frame();
  EXPECT_EQ(knot(2).position.x, -2.5f);
  EXPECT_EQ(knot(3).position.x, third);
}

TEST_F(FieldsTest, a_drag_is_one_step_between_begin_and_end) {
  const std::size_t steps = session_.history.undo.size();
  const float before = knot(2).position.x;
  ASSERT_TRUE(reach("Inspector/Position/x"));
  const glm::vec2 at = middle(*find("Inspector/Position/x"));
  hover(at);
  press();
  for (int i = 1; i <= 6; ++i) hover(at + glm::vec2(8.0f * static_cast<float>(i), 0));
  release();
  frame();
  EXPECT_EQ(all<edit::BeginGesture>().size(), 1u);
  EXPECT_EQ(all<edit::EndGesture>().size(), 1u);
  EXPECT_GE(all<edit::MoveKnot>().size(), 3u);
  EXPECT_GT(knot(2).position.x, before);
  EXPECT_FALSE(session_.history.in_gesture);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
}

TEST_F(FieldsTest, escape_and_undo_during_a_drag_put_the_document_back) {
  for (const auto& [k, m] : {std::pair{platform::Key::escape, platform::Modifiers{}},
                             {platform::Key::z, platform::Modifiers{.ctrl = true}}}) {
    const world::Document before = session_.document;
    ASSERT_TRUE(reach("Inspector/Position/x"));
    const glm::vec2 at = middle(*find("Inspector/Position/x"));
    hover(at);
    press();
    for (int i = 1; i <= 4; ++i) hover(at + glm::vec2(9.0f * static_cast<float>(i), 0));
    EXPECT_FALSE(session_.document == before) << "the drag moves the knot as it goes";
    key(k, m);
    hover(at + glm::vec2(90, 0));
    release();
    frame();
    EXPECT_TRUE(session_.document == before);
    EXPECT_FALSE(session_.history.in_gesture);
    frames(30);  // no double click, which would open the field for typing
  }
}

TEST_F(FieldsTest, smooth_joints_keep_both_lengths_equal) {
  type("Inspector/Handles/in", "6.25");
  EXPECT_EQ(knot(2).in_length, 6.25f);
  EXPECT_EQ(knot(2).out_length, 6.25f);
  EXPECT_EQ(knot(2).joint, world::JointKind::smooth);
}

TEST_F(FieldsTest, steps_are_typed_and_dragged_within_their_limits) {
  type("Evaluation/Steps per segment", "300");
  EXPECT_EQ(session_.settings.evaluation->steps, 300);
  EXPECT_EQ(all<edit::Set<&world::Evaluation::steps>>().size(), 1u);
  type("Evaluation/Steps per segment", "99999");
  EXPECT_EQ(session_.settings.evaluation->steps, curve::kMaxSteps);
  ASSERT_TRUE(reach("Evaluation/Steps per segment"));
  const Widget& bar = *find("Evaluation/Steps per segment");
  hover({bar.x + bar.width - 3, bar.y + bar.height / 2});
  press();
  hover({bar.x - 50, bar.y + bar.height / 2});
  release();
  EXPECT_EQ(session_.settings.evaluation->steps, curve::kMinSteps);
}

TEST_F(FieldsTest, the_name_is_text_and_keys_belong_to_it_while_it_is_typed) {
  click("Track/Name");
  EXPECT_TRUE(host_->wants_keyboard());
  key(platform::Key::a, {.ctrl = true});
  frame({platform::KeyPress{platform::Key::x, true, false, {}}, platform::TextInput{"Xaver's Br\u00FCcke"}});
  frame({platform::KeyPress{platform::Key::x, false, false, {}}});
  key(platform::Key::enter);
  EXPECT_EQ(session_.document.name, "Xaver's Br\u00FCcke");
  EXPECT_EQ(session_.document.track.knots.size(), 3u) << "X deletes a knot only outside text";
}

}  // namespace fields_test
}  // namespace coaster::ui
