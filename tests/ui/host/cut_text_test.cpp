// Texts that are too long for their place end in dots: no letter is drawn across an edge. Checked in the triangles of
// whole frames, so that it holds for every text that is drawn.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "base/scratch_folder.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace cut_text_test {

using world::Workspace;

// Returns the number of letters in a list of triangles that the left or right edge of their clip rectangle, or of the
// screen, cuts. A letter is two triangles over a part of the font's picture.
int cut_letters(const ImDrawList& list, float width) {
  int cut = 0;
  for (const ImDrawCmd& command : list.CmdBuffer)
    for (unsigned i = 0; i + 6 <= command.ElemCount; i += 3) {
      const ImDrawIdx* const index = list.IdxBuffer.Data + command.IdxOffset + i;
      const auto at = [&](int k) -> const ImDrawVert& {
        return list.VtxBuffer[static_cast<int>(command.VtxOffset + index[k])];
      };
      const bool quad = index[3] == index[0] && index[4] == index[2] && index[1] == index[0] + 1 &&
                        index[2] == index[0] + 2 && index[5] == index[0] + 3;
      if (!quad || at(0).uv.x == at(2).uv.x || at(0).uv.y == at(2).uv.y) continue;
      const ImVec2 low = at(0).pos, high = at(2).pos;
      if (high.x - low.x > 60 || high.y - low.y > 60) continue;  // a picture
      const float left = std::max(0.0f, command.ClipRect.x), right = std::min(width, command.ClipRect.z);
      const bool seen = high.y > command.ClipRect.y && low.y < command.ClipRect.w && high.x > left && low.x < right;
      constexpr float kEdge = 1.5f;  // px, of nothing about a letter
      if (seen && (low.x < left - kEdge || high.x > right + kEdge)) ++cut;
    }
  return cut;
}

struct CutText : Stage {
  test::ScratchFolder scratch;
  const std::string name = std::string(180, 'W');
  int cut() {
    frames(3);
    const ImDrawData& data = *ImGui::GetDrawData();
    int all = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) all += cut_letters(*data.CmdLists[i], static_cast<float>(width_));
    return all;
  }
  void good(const edit::Command& command) {
    const base::Status status = edit::apply(session_, files_, command);
    ASSERT_TRUE(status.ok()) << status.message;
  }
  // A track whose name, file, section and last notice are too long for any place.
  void SetUp() override {
    Stage::SetUp();
    good(edit::PlaceElement{world::usual_element(world::ElementKind::straight)});
    good(edit::SetSectionTitle{{{world::EntityKind::section, 2}}, name});
    good(edit::SetTrackName{name});
    good(edit::Save{(scratch.path() / (name + ".json")).string()});
    good(edit::SetStartSpeed{18});
    edit::notify(session_, edit::NoticeKind::warning, name);
  }
};

TEST_F(CutText, no_letter_is_cut_in_any_workspace) {
  good(edit::Set<&world::EditingAids::show_hints>{true});
  for (const int width : {1024, 1280})
    for (const Workspace workspace : {Workspace::build, Workspace::ride, Workspace::laboratory, Workspace::all}) {
      good(edit::Set<&world::Panels::workspace>{workspace});
      resize(width, 720);
      const std::string where = std::string(base::name_of(workspace)) + " at " + std::to_string(width);
      EXPECT_EQ(cut(), 0) << where;
      EXPECT_NE(find("Menu/Unsaved"), nullptr) << "shortened, not left out, " << where;
      select(world::EntityKind::section, 2);
      EXPECT_EQ(cut(), 0) << where << " with a section";
      good(edit::Select{});
    }
}

TEST_F(CutText, no_letter_is_cut_in_the_command_palette_and_the_file_browser) {
  for (const int width : {700, 1280}) {
    resize(width, 600);
    key(platform::Key::p, {.ctrl = true});
    EXPECT_EQ(cut(), 0) << "palette at " << width;
    key(platform::Key::escape);
    frames(3);
    key(platform::Key::s, {.shift = true, .ctrl = true});
    EXPECT_EQ(cut(), 0) << "files at " << width;
    key(platform::Key::escape);
    frames(3);
  }
}

TEST_F(CutText, no_letter_is_cut_on_the_start_screen) {
  user_.emplace();
  const std::string path = (scratch.path() / (name + ".json")).string();
  user_->settings.recent.push_back(path);
  pictures_[path] = {0, name, 100, ""};
  host_->show_start();
  EXPECT_EQ(cut(), 0);
}

TEST_F(CutText, a_letter_across_an_edge_is_found) {
  frames(2);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({10, 10}, {100, 40});
  list.AddText({12, 12}, IM_COL32_WHITE, "WWW");
  EXPECT_EQ(cut_letters(list, 1280), 0);
  list.AddText({12, 12}, IM_COL32_WHITE, name.c_str());
  EXPECT_EQ(cut_letters(list, 1280), 1);
  list.AddText({6, 12}, IM_COL32_WHITE, "WWW");
  EXPECT_EQ(cut_letters(list, 1280), 2);
  list.PopClipRect();
}

}  // namespace cut_text_test
}  // namespace coaster::ui
