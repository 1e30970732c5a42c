// Programs, targets and owners of GL names.
#include "gfx/gl_objects.h"

#include "gfx/studio.h"

namespace coaster::gfx {
namespace gl_objects_test {

using Objects = test::Studio;

constexpr std::string_view kVertex = "void main() { gl_Position = vec4(0.0); }\n";
constexpr std::string_view kFragment = "out vec4 colour;\nvoid main() { colour = tone(); }\n";
constexpr std::string_view kCommon = "vec4 tone() { return vec4(0.5); }";

TEST_F(Objects, a_correct_program_links) {
  EXPECT_TRUE(make_program(gl_, {.name = "good", .common = kCommon, .vertex = kVertex, .fragment = kFragment}).ok());
}

TEST_F(Objects, a_broken_shader_shows_name_stage_and_log) {
  const auto program = make_program(gl_, {.name = "sunset",
                                          .common = kCommon,
                                          .vertex = kVertex,
                                          .fragment = "out vec4 colour;\nvoid main() { colour = no_such_name; }\n"});
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.status().code, base::Code::graphics);
  EXPECT_NE(program.status().message.find("sunset.frag"), std::string::npos) << program.status().message;
  EXPECT_NE(program.status().message.find("no_such_name"), std::string::npos) << program.status().message;
}

TEST_F(Objects, lines_in_a_log_are_counted_in_the_stage_alone) {
  const std::string common = "\n\n\n\n\n\n" + std::string(kCommon);
  const auto program = make_program(
      gl_, {.name = "x", .common = common, .vertex = "void main() {\n\n  wrong;\n}\n", .fragment = kFragment});
  ASSERT_FALSE(program.ok());
  // Mesa: "0:3(3): error", NVIDIA: "0(3) : error".
  EXPECT_TRUE(program.status().message.find(":3(") != std::string::npos ||
              program.status().message.find("0(3)") != std::string::npos)
      << program.status().message;
}

TEST_F(Objects, stages_that_do_not_fit_are_refused_by_the_linker) {
  const auto program = make_program(
      gl_, {.name = "misfit",
            .vertex = "out vec3 thing;\nvoid main() { thing = vec3(1.0); gl_Position = vec4(0.0); }\n",
            .fragment = "in vec2 thing;\nout vec4 colour;\nvoid main() { colour = vec4(thing, 0.0, 1.0); }\n"});
  ASSERT_FALSE(program.ok());
  EXPECT_NE(program.status().message.find("misfit does not link"), std::string::npos) << program.status().message;
}

TEST_F(Objects, a_target_beyond_the_driver_is_refused_not_fatal) {
  const auto target = make_target(gl_, 1 << 20, 16, 0);
  ASSERT_FALSE(target.ok());
  EXPECT_NE(target.status().message.find("1048576x16"), std::string::npos);
  while (gl_.GetError() != GL_NO_ERROR) {
  }
}

TEST_F(Objects, a_moved_object_is_deleted_once) {
  static int deleted;
  deleted = 0;
  {
    GlObject first(gl_, 7, [](const Gl&, GLuint id) { deleted += static_cast<int>(id); });
    GlObject second = std::move(first);
    GlObject third;
    third = std::move(second);
    EXPECT_EQ(third.id(), 7u);
  }
  EXPECT_EQ(deleted, 7);
}

}  // namespace gl_objects_test
}  // namespace coaster::gfx
