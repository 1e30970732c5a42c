// The force graph as an editor: mouse and keyboard edit a force section's keys.
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/set_setting.h"
#include "ui/sections_stage.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace force_key_editor_test {

using platform::Key;
using world::ForceChannel;
using world::ForceKey;

class ForceKeysTest : public SectionsStage {
 protected:
  void SetUp() override {
    Stage::SetUp();
    good(edit::NewTrack{});
    good(edit::SetStartSpeed{20});
    good(edit::PlaceElement{world::usual_element(world::ElementKind::straight)});
    good(edit::AddForceSection{world::ForceDomain::distance, 40, 0.1});
    good(edit::Set<&world::Panels::workspace>{world::Workspace::build});
    good(edit::Select{{{world::EntityKind::section, 2}}});
    frames(3);
    commands_.clear();
  }
  const std::vector<ForceKey>& keys(ForceChannel channel = ForceChannel::vertical) const {
    return value(2).force.keys(channel);
  }
  std::size_t steps() const { return session_.history.undo.size(); }
  glm::vec2 knob(int number) const {
    const Widget* const widget = find("Forces/Plot/Knob " + std::to_string(number));
    EXPECT_NE(widget, nullptr) << number;
    return widget ? middle(*widget) : glm::vec2(0);
  }
  // A place of the plot, by its share of the width and of the height.
  glm::vec2 in_plot(float across, float up) const {
    const Widget& plot = *find("Forces/Plot");
    return {plot.x + across * plot.width, plot.y + (1 - up) * plot.height};
  }
  void double_click_at(glm::vec2 pixel) {
    rest();
    hover(pixel);
    for (int i = 0; i < 2; ++i) press(), release();
    frames(2);
  }
  static bool is_multiple(double value, double step) { return std::abs(std::remainder(value, step)) < 1e-9; }
};

TEST_F(ForceKeysTest, a_double_click_inserts_a_key_that_snaps) {
  ASSERT_NE(find("Forces/Plot"), nullptr);
  EXPECT_EQ(find("Forces/Plot/Knob 1"), nullptr);
  const std::size_t before = steps();
  double_click_at(in_plot(0.5f, 0.5f));
  ASSERT_EQ(keys().size(), 1u);
  EXPECT_NEAR(keys()[0].at, 20, 1.5);
  EXPECT_TRUE(is_multiple(keys()[0].at, 1)) << keys()[0].at;
  EXPECT_TRUE(is_multiple(keys()[0].value, 0.1)) << keys()[0].value;
  EXPECT_EQ(steps(), before + 1);
  ASSERT_NE(find("Forces/Plot/Knob 1"), nullptr);
  double_click_at(knob(1));
  EXPECT_EQ(keys().size(), 1u) << "not on a key";
}

TEST_F(ForceKeysTest, the_table_opens_and_the_graph_folds_over_the_edited_section) {
  ASSERT_NE(find("Forces/Keys/Vertical"), nullptr);
  click("Sections");
  EXPECT_EQ(find("Sections")->value, "open");
  EXPECT_EQ(find("Forces/Plot"), nullptr);
  click("Forces");
  EXPECT_NE(find("Forces/Keys/Vertical"), nullptr);
  EXPECT_NE(find("Forces/Plot"), nullptr);
  click("Forces");
  EXPECT_EQ(find("Forces")->value, "closed");
  EXPECT_EQ(find("Forces/Keys/Vertical"), nullptr);
}

TEST_F(ForceKeysTest, a_drag_bends_the_track_in_each_of_its_frames_and_is_one_step) {
  good(edit::SetForceKey{{{world::EntityKind::section, 2}}, false, ForceChannel::vertical, 1, 20});
  frames(3);
  const std::size_t before = steps();
  const glm::vec2 from = knob(1), to = from + glm::vec2(-60, -30);
  const glm::dvec3 place = end();
  hover(from);
  press();
  frame();
  EXPECT_EQ(end(), place) << "a press moves nothing";
  for (int i = 1; i <= 4; ++i) {
    const std::uint64_t build = session_.derived.last_build;
    hover(from + (to - from) * (static_cast<float>(i) / 4));
    EXPECT_GT(session_.derived.last_build, build) << "in the same frame";
  }
  EXPECT_LT(keys()[0].at, 19);
  EXPECT_GT(keys()[0].value, 1.05);
  EXPECT_TRUE(is_multiple(keys()[0].at, 1) && is_multiple(keys()[0].value, 0.1));
  EXPECT_NE(end(), place);
  release();
  frames(2);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_NEAR(knob(1).x, to.x, 12);
  good(edit::Undo{});
  EXPECT_EQ(keys()[0].at, 20);
  EXPECT_EQ(end(), place);
}

TEST_F(ForceKeysTest, a_drag_that_is_undone_moves_nothing_more) {
  good(edit::SetForceKey{{{world::EntityKind::section, 2}}, false, ForceChannel::vertical, 1, 20});
  frames(3);
  const std::size_t before = steps();
  const glm::vec2 from = knob(1);
  hover(from);
  press();
  for (int i = 1; i <= 3; ++i) hover(from + glm::vec2(-20.0f * static_cast<float>(i), 0));
  EXPECT_LT(keys()[0].at, 19);
  key(Key::z, {.ctrl = true});
  EXPECT_EQ(keys()[0].at, 20);
  hover(from + glm::vec2(30, -20));
  hover(from + glm::vec2(60, -30));
  release();
  frames(2);
  EXPECT_EQ(keys()[0], (ForceKey{20, 1}));
  EXPECT_EQ(steps(), before);
  hover(from);
  press();
  for (int i = 1; i <= 3; ++i) hover(from + glm::vec2(20.0f * static_cast<float>(i), 0));
  release();
  frames(2);
  EXPECT_GT(keys()[0].at, 21) << "the next drag does";
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(ForceKeysTest, keys_of_curvature_snap_to_thousandths) {
  good(edit::SetForceQuantity{{{world::EntityKind::section, 2}}, world::ForceQuantity::curvature});
  const std::size_t there = keys().size();
  frames(3);
  double_click_at(in_plot(0.52f, 0.62f));
  ASSERT_EQ(keys().size(), there + 1);
  const ForceKey& key = keys()[1];
  EXPECT_NE(key.value, 0);
  EXPECT_TRUE(is_multiple(key.value, 0.001)) << key.value;
  EXPECT_LE(std::abs(key.value), 0.03);
}

TEST_F(ForceKeysTest, a_handle_of_the_chosen_key_shapes_the_curve) {
  for (const double at : {10.0, 20.0, 30.0})
    good(edit::SetForceKey{{{world::EntityKind::section, 2}}, false, ForceChannel::vertical, 1, at});
  frames(3);
  click_at(knob(2));
  frames(2);
  ASSERT_NE(find("Forces/Plot/Knob 5"), nullptr) << "three keys and two handles";
  const glm::vec2 handle = knob(5);
  EXPECT_GT(handle.x, knob(2).x);
  hover(handle);
  press();
  for (int i = 1; i <= 3; ++i) hover(handle + glm::vec2(0, -8.0f * static_cast<float>(i)));
  release();
  frames(2);
  EXPECT_GT(keys()[1].slope, 0);
  EXPECT_GT(keys()[1].after, 0);
  EXPECT_EQ(keys()[1].value, 1);
  EXPECT_EQ(all<edit::EndGesture>().size(), 1u);
}

TEST_F(ForceKeysTest, the_keyboard_chooses_moves_inserts_and_deletes) {
  for (const double at : {10.0, 30.0})
    good(edit::SetForceKey{{{world::EntityKind::section, 2}}, false, ForceChannel::vertical, 1, at});
  frames(2);
  key(Key::tab);
  EXPECT_TRUE(session_.settings.panels->show_panels);
  key(Key::up);
  key(Key::right);
  EXPECT_NEAR(keys()[0].value, 1.1, 1e-9);
  EXPECT_EQ(keys()[0].at, 11);
  key(Key::down, {.ctrl = true});
  EXPECT_NEAR(keys()[0].value, 1.09, 1e-9);
  key(Key::tab);
  key(Key::left);
  EXPECT_EQ(keys()[1].at, 29);
  key(Key::tab, {.shift = true});
  key(Key::insert);
  ASSERT_EQ(keys().size(), 3u);
  EXPECT_EQ(keys()[1].at, 20);
  key(Key::del);
  ASSERT_EQ(keys().size(), 2u);
  EXPECT_NE(session_.settings.selected, world::kNone) << "the section stays";
  key(Key::escape);
  EXPECT_NE(session_.settings.selected, world::kNone) << "the first Escape leaves the key";
  key(Key::left);
  EXPECT_EQ(keys()[0].at, 11) << "no key is chosen";
}

TEST_F(ForceKeysTest, each_channel_has_its_keys) {
  click("Forces/Keys/Lateral");
  frames(2);
  double_click_at(in_plot(0.5f, 0.5f));
  EXPECT_EQ(keys(ForceChannel::lateral).size(), 1u);
  EXPECT_TRUE(keys().empty());
  click("Forces/Keys/Roll");
  frames(2);
  EXPECT_EQ(find("Forces/Plot/Knob 1"), nullptr);
  good(edit::Select{{{world::EntityKind::section, 1}}});
  frames(2);
  EXPECT_EQ(find("Forces/Keys/Roll"), nullptr) << "other sections show the whole ride";
  EXPECT_NE(find("Forces/Vertical g"), nullptr);
}

}  // namespace force_key_editor_test
}  // namespace coaster::ui
