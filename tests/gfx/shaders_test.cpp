// Every vertex and fragment shader is in the common subset of GLSL 3.30 and GLSL ES 3.00, which WebGL 2 has.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "base/files.h"
#include "gfx/gl_objects.h"
#include "platform/surface.h"

namespace coaster::gfx {
namespace shaders_test {

// The compiler's log, empty when the source compiles.
std::string complaint(const Gl& gl, GLenum stage, const std::string& source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  std::array<char, 2000> log{};
  gl.GetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  return ok == GL_TRUE ? "" : std::string("does not compile: ") + log.data();
}

TEST(shaders, all_compile_for_the_desktop_and_for_webgl_2) {
  auto surface = platform::make_offscreen({});
  ASSERT_TRUE(surface.ok()) << surface.status().message;
  const auto gl = load_gl([&](const char* name) { return (*surface)->gl_proc(name); });
  ASSERT_TRUE(gl.ok()) << gl.status().message;
  const std::string es(shader_header(true, false)), desktop(shader_header(false, false));
  // ES has no implicit conversions: a driver that takes this one would check nothing here.
  const std::string implicit = "void main() { float one = 1; gl_Position = vec4(one); }\n";
  if (!gl->es) {
    ASSERT_EQ(complaint(*gl, GL_VERTEX_SHADER, desktop + implicit), "");
  }
  ASSERT_NE(complaint(*gl, GL_VERTEX_SHADER, es + implicit), "");

  base::Files files;
  const auto source = [&](const std::filesystem::path& path) {
    const auto text = files.read(path);
    EXPECT_TRUE(text.ok()) << text.status().message;
    return text.ok() ? *text : std::string();
  };
  const std::filesystem::path folder = std::filesystem::path(COASTER_SOURCE_DIR) / "shaders";
  const std::string common = source(folder / "common.glsl") + source(folder / "shade.glsl") +
                             source(folder / "line.glsl") + source(folder / "curve.glsl");
  int compiled = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".vert" && extension != ".frag") continue;
    for (const std::string& header : {es, gl->es ? es : desktop})
      for (const char* defines :
           {"", "#define CARTS\n", "#define SHADOW\n", "#define CARTS\n#define SHADOW\n", "#define OUTLINE\n",
            "#define OUTLINE\n#define CARTS\n", "#define MEASURE\n", "#define PARK\n", "#define PARK\n#define SHADOW\n",
            "#define BEHIND\n#define HALO\n", "#define NO_GRID\n", "#define BLUEPRINT\n", "#define STREAK\n"}) {
        const std::string text = header + defines + common + source(entry.path());
        EXPECT_EQ(complaint(*gl, extension == ".vert" ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER, text), "")
            << entry.path().filename() << " with " << defines << header;
        ++compiled;
      }
  }
  EXPECT_GE(compiled, 14 * 14);
}

}  // namespace shaders_test
}  // namespace coaster::gfx
