#include "gfx/gl.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "platform/surface.h"

namespace coaster::gfx {
namespace gl_test {

std::unique_ptr<platform::Surface> surface() {
  auto made = platform::make_offscreen({});
  EXPECT_TRUE(made.ok()) << made.status().message;
  return made.ok() ? std::move(*made) : nullptr;
}

TEST(gl, a_context_comes_up_with_the_needed_version) {
  const auto context = surface();
  ASSERT_TRUE(context);
  const auto gl = load_gl([&](const char* name) { return context->gl_proc(name); });
  ASSERT_TRUE(gl.ok()) << gl.status().message;
  EXPECT_GE(10 * gl->major + gl->minor, 33);
  EXPECT_FALSE(gl->renderer.empty());
  EXPECT_TRUE(gl->version.starts_with(std::to_string(gl->major) + "." + std::to_string(gl->minor))) << gl->version;
  EXPECT_EQ(gl->GetError(), GLenum(GL_NO_ERROR));
}

TEST(gl, a_missing_function_is_named) {
  const auto context = surface();
  ASSERT_TRUE(context);
  const auto gl = load_gl([&](const char* name) {
    return std::string_view(name) == "glVertexAttribDivisor" ? nullptr : context->gl_proc(name);
  });
  ASSERT_FALSE(gl.ok());
  EXPECT_EQ(gl.status().code, base::Code::graphics);
  EXPECT_NE(gl.status().message.find("glVertexAttribDivisor"), std::string::npos) << gl.status().message;
}

TEST(gl, without_any_function_there_is_a_reason_and_no_crash) {
  const auto gl = load_gl([](const char*) -> void* { return nullptr; });
  ASSERT_FALSE(gl.ok());
  EXPECT_EQ(gl.status().code, base::Code::graphics);
}

// Mesa reads the variable once in a process, so the old driver lives in one of its own.
TEST(gl, an_older_version_is_refused_with_both_versions) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto try_old = [] {
    setenv("MESA_GL_VERSION_OVERRIDE", "3.2", 1);
    auto made = platform::make_offscreen({});
    base::Status status = made.ok() ? base::Status{} : made.status();
    if (made.ok())
      if (const auto gl = load_gl([&](const char* name) { return (*made)->gl_proc(name); }); !gl.ok())
        status = gl.status();
    std::fprintf(stderr, "%s\n", status.message.c_str());
    const bool both =
        status.message.find("3.3") != std::string::npos && status.message.find("3.2") != std::string::npos;
    std::_Exit(status.code == base::Code::graphics && both ? 0 : 1);
  };
  EXPECT_EXIT(try_old(), testing::ExitedWithCode(0), "");
}

}  // namespace gl_test
}  // namespace coaster::gfx
