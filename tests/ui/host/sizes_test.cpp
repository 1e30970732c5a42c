// Every panel, dialog, table and page is laid out in windows of every size and scale. Dear ImGui ends the program over
// a size that it does not accept, and this test with it; the last "laid out" tells where.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/cancellable_job.h"
#include "base/scratch_folder.h"
#include "edit/commands/commands_ride.h"
#include "ui/all_parts_stage.h"

namespace coaster::ui {
namespace sizes_test {

namespace fs = std::filesystem;
using Size = std::pair<int, int>;

class Sizes : public AllPartsStage {
 protected:
  // Shows every part in a window of `base`, on a screen of that density, and then in windows of the other sizes.
  void visit_at(float density, Size base, const std::vector<Size>& sizes) {
    density_ = density;
    resize(base.first, base.second);
    const auto look = [&](const std::string& where) {
      last_ = where;
      const auto [before_width, before_height] = std::pair(width_, height_);
      for (const auto& [width, height] : sizes) {
        width_ = width, height_ = height;
        hover({static_cast<float>(width) * 0.3f, static_cast<float>(height) * 0.5f});
        frame();
        ++laid_out_;
        for (const Widget& w : host_->widgets())
          EXPECT_TRUE(w.width >= 0 && w.height >= 0 && std::isfinite(w.x + w.y + w.width + w.height))
              << w.path << " at " << width << "x" << height << ", " << where;
      }
      width_ = before_width, height_ = before_height;
      frames(2);
    };
    visit(look);
    visit_dialogs(look);
    visit_cards(look);
  }

  void visit_dialogs(const std::function<void(const std::string&)>& look) {
    using platform::Key;
    const auto asked = [&](const char* path) {
      frames(2);
      EXPECT_NE(find(path), nullptr) << path;
      look(path);
      key(Key::escape);
      frames(2);
    };
    user_.emplace();
    const fs::path own = scratch_.path() / (std::to_string(laid_out_) + ".json");
    good(edit::Save{own.string()});
    const std::string list = (scratch_.path() / "list.xyz").string();
    ASSERT_TRUE(base::Files().write_atomic(list, "0 0 0\n40 0 0\n40 30 1\n0 30 1\n"));
    frame({platform::FileDrop{list}});
    asked("Import points/Import");
    ASSERT_TRUE(base::Files().write_atomic(own, "theirs"));
    key(Key::s, {.ctrl = true});
    asked("Changed file/Question");
    good(edit::SetStartSpeed{1.0f + static_cast<float>(laid_out_ % 97)});
    frame({platform::CloseRequest{}});
    asked("Unsaved changes/Question");
    user_->recoveries.push_back({"/tmp/x.json", "Red", 1'000'000, 2'000'000});
    frames(2);
    EXPECT_NE(find("Recovery/Recover"), nullptr);
    look("Recovery");
    user_->recoveries.clear();
    frames(2);
  }

  void visit_cards(const std::function<void(const std::string&)>& look) {
    base::JobProgress progress;
    job_ = {&progress, "Import", "Fitting a track to the imported points"};
    movie_.emplace();
    edit::notify(session_, edit::NoticeKind::warning, "A notice with several words, which are wrapped.");
    frames(2);
    EXPECT_NE(find("Import/Cancel"), nullptr);
    look("job and movie");
    job_ = {}, movie_.reset();
    set<&world::EditingAids::show_card>(true);
    good(edit::RideStart{});
    edit::advance(session_, 120 * 120);
    ASSERT_TRUE(session_.game.result);
    frames(2);
    look("score card");
    key(platform::Key::escape);
    set<&world::Panels::workspace>(world::Workspace::build);
    frames(2);
    click("Sections");
    frames(2);
    EXPECT_NE(find("Sections/Table/Section"), nullptr);
    look("table of sections");
    click("Forces");
    frames(2);
    EXPECT_NE(find("Forces/Plot"), nullptr);
    look("force graph");
    set<&world::Panels::show_panels>(false);
    look("no panels");
    set<&world::Panels::show_panels>(true);
    frames(2);
  }

  void TearDown() override {
    if (HasFailure()) std::printf("%d times laid out, at last: %s\n", laid_out_, last_.c_str());
    AllPartsStage::TearDown();
  }

  test::ScratchFolder scratch_;
  std::string last_;
  int laid_out_ = 0;
};

// At four fifths of the smallest roomy window the scale is at its least, as in all smaller ones, so that fonts are
// loaded once.
TEST_F(Sizes, small_windows_at_every_scale) {
  for (const float density : {0.5f, 1.0f, 2.0f, 4.0f}) {
    std::vector<Size> sizes;
    for (const int width : {1, 2, 10, 60, 200, 720, 7680})
      for (const int height : {1, 2, 10, 60, 200, 440, 4320})
        if (std::min(width * 0.56f, height * 1.0f) <= 448 * density) sizes.emplace_back(width, height);
    visit_at(density, {static_cast<int>(800 * density), static_cast<int>(448 * density)}, sizes);
  }
  EXPECT_GT(laid_out_, 9'000);
}

TEST_F(Sizes, large_windows) {
  for (const float density : {1.0f, 4.0f})
    visit_at(density, {static_cast<int>(1000 * density), static_cast<int>(560 * density)},
             {{7680, 4320}, {4000, 4320}, {7680, 2240}});
  EXPECT_GT(laid_out_, 300);
}

// Each call that hands Dear ImGui a size has numbers that are written there, or passes them through sized().
TEST(Sizes_in_sources, all_are_clamped) {
  const std::regex call(
      R"((ImGui::(InvisibleButton|BeginChild|BeginTable|SetNextWindowSize|SetNextWindowSizeConstraints|Dummy|)"
      R"(SetNextItemWidth|ProgressBar|Button|ImageButton|PushItemWidth)|\bbegin_part)\()");
  int calls = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(COASTER_SOURCE_DIR) / "src/ui")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename() == "imgui_compat.cpp") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (auto at = std::sregex_iterator(text.begin(), text.end(), call); at != std::sregex_iterator(); ++at) {
      ++calls;
      std::size_t end = static_cast<std::size_t>(at->position() + at->length());
      const std::size_t begin = end;
      for (int depth = 1; depth > 0 && end < text.size(); ++end)
        depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
      const std::string inside = text.substr(begin, end - begin - 1);
      // Words and the sizes that are left: numbers, and names in braces or of a width.
      const std::regex unclamped(
          R"(\{(?![^{}]*sized\()[^{}]*[a-z_][^{}]*\}|, size\b|^[a-z_]*(size|width|room)\b|Avail\(\)(?!\.y - below))");
      const bool clamped = inside.find("sized(") != std::string::npos;
      EXPECT_TRUE(clamped || !std::regex_search(inside, unclamped))
          << entry.path().filename() << ": " << at->str() << inside;
    }
  }
  EXPECT_GT(calls, 40);
}

}  // namespace sizes_test
}  // namespace coaster::ui
