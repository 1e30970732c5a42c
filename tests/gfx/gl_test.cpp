#include "gfx/gl.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.h"
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
  EXPECT_GE(10 * gl->major + gl->minor, gl->es ? 30 : 33);
  EXPECT_FALSE(gl->renderer.empty());
  EXPECT_TRUE(("OpenGL " + gl->version).find(version_text(*gl)) != std::string::npos) << gl->version;
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

// The names of a driver's functions and nothing behind them but the version that it claims.
base::Result<Gl> load_from(const char* version, const char* shaders, int major, int minor) {
  static const char *the_version, *the_shaders;
  static int the_major, the_minor;
  the_version = version, the_shaders = shaders, the_major = major, the_minor = minor;
  const PFNGLGETSTRINGPROC get_string = [](GLenum name) {
    return reinterpret_cast<const GLubyte*>(name == GL_SHADING_LANGUAGE_VERSION ? the_shaders : the_version);
  };
  const PFNGLGETINTEGERVPROC get_integer = [](GLenum name, GLint* value) {
    *value = name == GL_MAJOR_VERSION ? the_major : name == GL_MINOR_VERSION ? the_minor : 4;
  };
  return load_gl([&](const char* name) {
    return std::string_view(name) == "glGetString" ? reinterpret_cast<void*>(get_string)
                                                   : reinterpret_cast<void*>(get_integer);
  });
}

TEST(gl, opengl_es_3_0_is_enough_and_has_nothing_optional) {
  const auto web = load_from("OpenGL ES 3.0 (WebGL 2.0 (OpenGL ES 3.0 Chromium))",
                             "OpenGL ES GLSL ES 3.00 (WebGL GLSL ES 3.00 (OpenGL ES GLSL ES 3.0 Chromium))", 3, 0);
  ASSERT_TRUE(web.ok()) << web.status().message;
  EXPECT_TRUE(web->es);
  EXPECT_EQ(version_text(*web), "OpenGL ES 3.0");
  EXPECT_FALSE(web->has_geometry_shaders() || web->has_tessellation() || web->has_timers());
  const auto later = load_from("OpenGL ES 3.2 Mesa 22.3.6", "OpenGL ES GLSL ES 3.20", 3, 2);
  ASSERT_TRUE(later.ok()) << later.status().message;
#define X(name) EXPECT_EQ(later->name, nullptr) << #name;
  COASTER_GL_OPTIONAL_FUNCTIONS(X)
#undef X
  const auto old = load_from("OpenGL ES 2.0 Mesa 22.3.6", "OpenGL ES GLSL ES 1.00", 2, 0);
  ASSERT_FALSE(old.ok());
  EXPECT_NE(old.status().message.find("OpenGL ES 2.0"), std::string::npos) << old.status().message;
}

TEST(gl, opengl_has_each_optional_part_from_its_version_on) {
  const auto gl = load_from("3.3 (Core Profile)", "3.30", 3, 3);
  ASSERT_TRUE(gl.ok()) << gl.status().message;
  EXPECT_TRUE(gl->has_geometry_shaders() && gl->has_timers() && !gl->has_tessellation());
  EXPECT_TRUE(load_from("4.0 (Core Profile)", "4.00", 4, 0)->has_tessellation());
  EXPECT_FALSE(load_from("3.2 (Core Profile)", "1.50", 3, 2).ok());
  EXPECT_FALSE(load_from("3.3 (Core Profile)", "1.50", 3, 3).ok());
}

// A browser has the others alone. <GLES3/gl3.h> lists them.
TEST(gl, these_functions_are_outside_opengl_es_3_0) {
  std::vector<std::string> optional, needed;
#define X(name) optional.push_back("gl" #name);
  COASTER_GL_OPTIONAL_FUNCTIONS(X)
#undef X
#define X(name) needed.push_back("gl" #name);
  COASTER_GL_FUNCTIONS(X)
#undef X
  EXPECT_EQ(optional, (std::vector<std::string>{"glGetQueryObjectui64v", "glPatchParameteri"}));
  const std::filesystem::path header = "/usr/include/GLES3/gl3.h";
  if (!std::filesystem::exists(header)) GTEST_SKIP() << header << " is not installed";
  const auto text = base::Files().read(header);
  ASSERT_TRUE(text.ok()) << text.status().message;
  for (const std::string& name : needed)
    EXPECT_NE(text->find(" " + name + " ("), std::string::npos) << name << " belongs to the optional group";
  for (const std::string& name : optional) EXPECT_EQ(text->find(" " + name + " ("), std::string::npos) << name;
}

// Mesa reads the variable once in a process, so the old driver runs in a separate one.
TEST(gl, an_older_version_is_refused_with_both_versions) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto try_old = [] {
    setenv("MESA_GL_VERSION_OVERRIDE", "3.2", 1);
    const char* const named = std::getenv("COASTER_HEADLESS");  // OpenGL ES has another variable
    auto made = platform::make_offscreen({.headless = named && named == std::string("gles") ? "egl" : ""});
    base::Status status = made.ok() ? base::Status{} : made.status();
    if (made.ok()) {
      const auto gl = load_gl([&](const char* name) { return (*made)->gl_proc(name); });
      if (gl.ok() && gl->version.find("Mesa") == std::string::npos) std::_Exit(0);  // no other driver has the variable
      if (!gl.ok()) status = gl.status();
    }
    std::fprintf(stderr, "%s\n", status.message.c_str());
    const bool both =
        status.message.find("3.3") != std::string::npos && status.message.find("3.2") != std::string::npos;
    std::_Exit(status.code == base::Code::graphics && both ? 0 : 1);
  };
  EXPECT_EXIT(try_old(), testing::ExitedWithCode(0), "");
}

}  // namespace gl_test
}  // namespace coaster::gfx
