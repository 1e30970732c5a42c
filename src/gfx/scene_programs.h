// The shader programs of a scene's passes, from the sources in shaders/ that the build embeds.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/status.h"
#include "gfx/objects.h"

namespace coaster::gfx {

enum class SceneProgram { ground, ground_shadow, sky, solid, outline, shadow, polyline, coverage, line, mark };
inline constexpr std::size_t kScenePrograms = static_cast<std::size_t>(SceneProgram::mark) + 1;

// Compiles each program when it is first used: few pictures use all, and Mesa takes some 70 ms for them.
class ScenePrograms {
 public:
  explicit ScenePrograms(const Gl& gl) : gl_(&gl) {}
  // Returns the program, in use. One that does not compile is empty and draws nothing.
  const Program& use(SceneProgram name);
  // Code::graphics with the compiler's log of the first program that did not compile.
  const base::Status& failure() const { return failure_; }

 private:
  const Gl* gl_;
  std::array<std::optional<Program>, kScenePrograms> programs_;
  base::Status failure_;
};

}  // namespace coaster::gfx
