// Programs on a surface whose clock is set by the test, and which is a window if the test wants one.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "app/program.h"
#include "base/scratch_folder.h"
#include "edit/commands/commands_document.h"

namespace coaster::app {

class FakeSurface final : public platform::Surface {
 public:
  explicit FakeSurface(std::unique_ptr<platform::Surface> memory) : memory_(std::move(memory)) {}
  double now = 0;
  bool window = false;
  std::string copied;  // the clipboard
  std::optional<platform::WindowPlacement> at;

  platform::Events next;  // of the next poll
  double longest_wait = 0;
  int presented = 0;  // frames shown

  void poll(platform::Events& events, double wait) override {
    longest_wait = std::max(longest_wait, wait);
    for (platform::Event& event : std::exchange(next, {})) events.push_back(std::move(event));
  }
  platform::Size size() const override { return memory_->size(); }
  float content_scale() const override { return 1; }
  void* gl_proc(const char* name) override { return memory_->gl_proc(name); }
  void present(unsigned framebuffer) override {
    ++presented;
    memory_->present(framebuffer);
  }
  double clock() const override { return now; }
  void set_title(const std::string&) override {}
  void resize(platform::Size size) override { memory_->resize(size); }
  std::string clipboard() override { return copied; }
  void set_clipboard(const std::string& text) override { copied = text; }
  bool is_window() const override { return window; }
  std::string library() const override { return memory_->library(); }
  std::optional<platform::WindowPlacement> placement() const override { return at; }
  void place(const platform::WindowPlacement& placement) override { at = placement; }

 private:
  std::unique_ptr<platform::Surface> memory_;
};

class ProgramTest : public testing::Test {
 protected:
  void SetUp() override { program_ = make(); }

  // Returns a program without a renderer: it can do everything except drawing the scene.
  static std::unique_ptr<Program> make() {
    auto program = std::make_unique<Program>();
    auto memory = platform::make_offscreen({.size = {64, 48}});
    EXPECT_TRUE(memory.ok()) << memory.status().message;
    auto surface = std::make_unique<FakeSurface>(std::move(*memory));
    auto gl = gfx::load_gl([&](const char* name) { return surface->gl_proc(name); });
    EXPECT_TRUE(gl.ok()) << gl.status().message;
    program->gl = std::move(*gl);
    program->surface = std::move(surface);
    auto panels = ui::Host::make(program->gl);
    EXPECT_TRUE(panels.ok()) << panels.status().message;
    program->ui = std::move(*panels);
    program->session = edit::make_session({});
    return program;
  }
  // Returns a program with a renderer.
  static std::unique_ptr<Program> make_drawing() {
    std::unique_ptr<Program> program = make();
    program->renderer = std::make_unique<gfx::Renderer>(program->gl, 0);
    return program;
  }
  // Makes the test's program one that draws. The context of the former one is destroyed first, so that the new one is
  // current.
  void restart_drawing() {
    program_.reset();
    program_ = make_drawing();
  }
  static FakeSurface& surface(Program& program) { return static_cast<FakeSurface&>(*program.surface); }

  // Three knots, off-origin and skew, with a cart.
  static void build_track(Program& program) {
    for (const glm::vec3 place : {glm::vec3{-17.3f, 4.1f, 6.7f}, {3.9f, 9.6f, -2.3f}, {21.1f, 5.3f, 8.9f}})
      ASSERT_TRUE(apply(program, edit::AppendKnot{place}).ok());
    ASSERT_TRUE(apply(program, edit::AddTrain{{{world::EntityKind::segment, 1}}, 0.25}).ok());
  }
  static std::string last_notice(const Program& program) {
    const auto& notices = program.session.notices.list;
    return notices.empty() ? std::string() : notices.back().text;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  test::ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();
  std::unique_ptr<Program> program_;
};

}  // namespace coaster::app
