// The shader programs of a scene.
#include "gfx/passes.h"

#include "gfx/studio.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace scene_programs_test {

int links;
PFNGLLINKPROGRAMPROC link_program;

class ScenePrograms : public test::Studio {
 protected:
  void SetUp() override {
    Studio::SetUp();
    links = 0, link_program = gl_.LinkProgram;
    gl_.LinkProgram = [](GLuint program) { ++links, link_program(program); };
  }
  DrawStats draw_unseen() {
    const view::View view = look(track_);
    Scene scene{track_.derived, view, overlay_, carts_};
    scene.unseen = true;
    return renderer_->draw(scene, width_, height_);
  }
  test::Track track_{test::ring_document(9, 17.3f)};
  view::Overlay overlay_;
};

TEST_F(ScenePrograms, are_compiled_when_they_first_draw_and_only_then) {
  const DrawStats unseen = draw_unseen();
  EXPECT_EQ(links, 0);
  const DrawStats seen = draw(track_);
  EXPECT_EQ(unseen.draw_calls, seen.draw_calls);
  EXPECT_EQ(unseen.triangles, seen.triangles);
  const int usual = links;
  EXPECT_GT(usual, 3);
  EXPECT_LT(usual, static_cast<int>(kScenePrograms));
  draw(track_);
  EXPECT_EQ(links, usual);
  style_ = world::Style::blueprint;
  draw(track_);
  EXPECT_EQ(links, usual + 1) << "outlines";
  const auto sibling = renderer_->sibling(0);
  draw(*sibling, track_);
  EXPECT_EQ(links, usual + 1) << "siblings share them";
}

TEST_F(ScenePrograms, one_that_does_not_compile_is_told_with_its_name) {
  gl_.CompileShader = [](GLuint) {};
  draw_unseen();
  EXPECT_TRUE(renderer_->failure().ok());
  const view::View view = look(track_);
  renderer_->draw({track_.derived, view, overlay_, carts_}, width_, height_);
  EXPECT_EQ(renderer_->failure().code, base::Code::graphics);
  EXPECT_NE(renderer_->failure().message.find("shadow"), std::string::npos) << renderer_->failure().message;
}

}  // namespace scene_programs_test
}  // namespace coaster::gfx
