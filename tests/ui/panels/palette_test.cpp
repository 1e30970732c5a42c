#include "ui/panels/palette.h"

#include <tuple>

#include "ui/stage.h"
#include "world/look.h"
#include "world/panels.h"

namespace coaster::ui {
namespace palette_test {

struct PaletteTest : Stage {};

TEST_F(PaletteTest, buttons_have_labels_at_usual_sizes_and_the_view_its_share) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  for (const auto& [width, height, scale] : {std::tuple{1280, 720, 1.0f}, {1280, 720, 1.5f}, {1920, 1080, 2.0f}}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Look::ui_scale>{scale}));
    resize(width, height);
    frames(3);
    const Widget* loop = find("Elements/Loop");
    ASSERT_NE(loop, nullptr);
    EXPECT_EQ(loop->height, std::floor(36 * scale)) << "an icon above a label, " << width << " at " << scale;
    const view::Viewport& scene = host_->view().viewport;
    EXPECT_GE(scene.width * scene.height, 0.62f * static_cast<float>(width * height)) << width << " at " << scale;
  }
}

}  // namespace palette_test
}  // namespace coaster::ui
