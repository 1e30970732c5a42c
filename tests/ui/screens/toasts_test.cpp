// Notices (ui/screens/hud.h).
#include "ui/screens/hud.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "ui/widgets/theme.h"
#include "world/appearance_settings.h"

namespace coaster::ui {
namespace toasts_test {

TEST(toasts, information_lasts_four_seconds_and_warnings_six) {
  for (const auto& [kind, seconds] : {std::pair{edit::NoticeKind::info, 4.0}, {edit::NoticeKind::warning, 6.0}}) {
    edit::Session session = edit::make_session({});
    NoticeDisplay toasts;
    edit::notify(session, kind, "mind the gap");
    toasts.update(session, 100, false);
    toasts.update(session, 100 + seconds - 0.1, false);
    EXPECT_EQ(toasts.shown, "mind the gap");
    toasts.update(session, 100 + seconds + 0.1, false);
    EXPECT_EQ(toasts.shown, "");
  }
}

TEST(toasts, under_a_dialog_their_time_does_not_run) {
  edit::Session session = edit::make_session({});
  NoticeDisplay toasts;
  edit::notify(session, edit::NoticeKind::warning, "rows too far apart");
  toasts.update(session, 100, false);
  for (int second = 101; second <= 130; ++second) toasts.update(session, second, false, true);
  EXPECT_EQ(toasts.shown, "rows too far apart");
  toasts.update(session, 135.9, false);
  EXPECT_EQ(toasts.shown, "rows too far apart");
  toasts.update(session, 136.1, false);
  EXPECT_EQ(toasts.shown, "");
}

TEST(toasts, stay_until_the_next_one_in_scripts) {
  edit::Session session = edit::make_session({});
  NoticeDisplay toasts;
  edit::notify(session, edit::NoticeKind::info, "first");
  toasts.update(session, 0, true);
  toasts.update(session, 1e6, true);
  EXPECT_EQ(toasts.shown, "first");
  edit::notify(session, edit::NoticeKind::error, "second");
  toasts.update(session, 1e6, true);
  EXPECT_EQ(toasts.shown, "second");
}

TEST(toasts, warnings_stay_above_the_note_that_came_with_them) {
  edit::Session session = edit::make_session({});
  NoticeDisplay toasts;
  edit::notify(session, edit::NoticeKind::warning, "seen before");
  toasts.update(session, 100, false);
  edit::notify(session, edit::NoticeKind::info, "on the way");
  for (const char* line : {"one", "two", "three", "four", "five"})
    edit::notify(session, edit::NoticeKind::warning, line);
  edit::notify(session, edit::NoticeKind::info, "done");
  toasts.update(session, 200, false);
  EXPECT_EQ(toasts.shown, "one\ntwo\nthree\nand 2 more\ndone");
  EXPECT_EQ(toasts.kind, edit::NoticeKind::warning);
  toasts.update(session, 211.9, false);
  EXPECT_EQ(toasts.shown, "one\ntwo\nthree\nand 2 more\ndone");
  toasts.update(session, 212.1, false);
  EXPECT_EQ(toasts.shown, "");
  edit::notify(session, edit::NoticeKind::warning, "of another command");
  session.notices.before = session.notices.serial;
  edit::notify(session, edit::NoticeKind::info, "next");
  toasts.update(session, 300, false);
  EXPECT_EQ(toasts.shown, "next");
}

// A box in the middle of the view, 12 design px above its foot, with a bar in the colour of its kind along its left
// edge and the text inside.
struct ToastsDrawn : Stage {
  struct Box {
    ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    void add(ImVec2 p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  };
  static Box box_of(std::uint32_t rgb) {
    Box box;
    for (const ImDrawVert& v : ImGui::GetBackgroundDrawList()->VtxBuffer)
      if (((v.col ^ packed(rgb)) & 0xffffffu) == 0 && (v.col >> IM_COL32_A_SHIFT) > 200) box.add(v.pos);
    return box;
  }
};

TEST_F(ToastsDrawn, the_box_is_at_the_foot_of_the_view_with_its_bar_and_its_text_inside) {
  for (const float scale : {1.0f, 2.0f}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{scale}));
    resize(static_cast<int>(1280 * scale), static_cast<int>(720 * scale));
    for (const auto& [kind, colour] : {std::pair{edit::NoticeKind::info, palette().accent},
                                       {edit::NoticeKind::warning, palette().warning},
                                       {edit::NoticeKind::error, palette().error}}) {
      edit::notify(session_, kind, "The train stops on the hill,\n34.5 m from the start.");
      frames(3);
      const view::Viewport& scene = host_->view().viewport;
      const Box box = box_of(palette().raised), bar = box_of(colour);
      Box text;
      for (const DrawnGlyph& glyph : drawn_glyphs(*ImGui::GetBackgroundDrawList()))
        text.add(glyph.low), text.add(glyph.high);
      EXPECT_NEAR((box.low.x + box.high.x) / 2, scene.x + scene.width / 2, 1);
      EXPECT_NEAR(scene.y + scene.height - box.high.y, 12 * scale, 1.5);
      EXPECT_NEAR(bar.low.x, box.low.x, 1);
      EXPECT_NEAR(bar.high.x - bar.low.x, 4 * scale, 1.5);
      EXPECT_NEAR(bar.low.y, box.low.y, 1);
      EXPECT_NEAR(bar.high.y, box.high.y, 1);
      EXPECT_NEAR(text.low.x - bar.high.x, 10 * scale, 3 * scale);
      EXPECT_NEAR(box.high.x - text.high.x, 10 * scale, 3 * scale);
      const float line = ImGui::GetFontSize();
      EXPECT_NEAR(box.high.y - box.low.y, 2 * line + 16 * scale, 2 * scale);
      EXPECT_GT(text.low.y, box.low.y + 6 * scale);
      EXPECT_LT(text.high.y, box.high.y - 6 * scale);
    }
  }
}

}  // namespace toasts_test
}  // namespace coaster::ui
