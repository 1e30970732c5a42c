// The guarantees of every surface, tested on those that need no display.
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "platform/surface.h"

namespace coaster::platform {
namespace offscreen_surface_test {

// With each library that is installed.
struct OffscreenSurfaceTest : testing::TestWithParam<const char*> {
  void SetUp() override {
    const auto made = make_offscreen({.headless = GetParam()});
    if (!made.ok() && made.status().message.find("was not found") != std::string::npos)
      GTEST_SKIP() << made.status().message;
    ASSERT_TRUE(made.ok()) << made.status().message;
  }
  static std::unique_ptr<Surface> surface_of(Size size) {
    auto made = make_offscreen({.size = size, .headless = GetParam()});
    EXPECT_TRUE(made.ok()) << made.status().message;
    return made.ok() ? std::move(*made) : nullptr;
  }
};
INSTANTIATE_TEST_SUITE_P(, OffscreenSurfaceTest, testing::Values("osmesa", "egl", "gles"),
                         [](const auto& library) { return std::string(library.param); });

TEST_P(OffscreenSurfaceTest, each_poll_is_one_tick_of_a_sixtieth) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  Events events;
  for (std::size_t i = 1; i <= 3; ++i) {
    surface->poll(events, 0);
    ASSERT_EQ(events.size(), i) << "polling appends";
    ASSERT_TRUE(std::holds_alternative<Tick>(events.back()));
    EXPECT_EQ(std::get<Tick>(events.back()).dt, 1.0 / 60.0);
  }
}

TEST_P(OffscreenSurfaceTest, a_new_size_is_obeyed_and_told_once_before_the_tick) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->size(), (Size{320, 180}));
  surface->resize({77, 31});
  surface->resize({641, 359});
  EXPECT_EQ(surface->size(), (Size{641, 359}));
  Events events;
  surface->poll(events, 0);
  ASSERT_EQ(events.size(), 2u);
  ASSERT_TRUE(std::holds_alternative<Resize>(events[0]));
  EXPECT_EQ(std::get<Resize>(events[0]).width, 641);
  EXPECT_EQ(std::get<Resize>(events[0]).height, 359);
  EXPECT_TRUE(std::holds_alternative<Tick>(events[1]));
  events.clear();
  surface->poll(events, 0);
  EXPECT_EQ(events.size(), 1u);
}

TEST_P(OffscreenSurfaceTest, sizes_below_zero_are_nothing) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  surface->resize({-5, 9});
  EXPECT_EQ(surface->size(), (Size{0, 9}));
}

TEST_P(OffscreenSurfaceTest, the_clipboard_keeps_what_it_was_given) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->clipboard(), "");
  surface->set_clipboard("move @k1 by 0 1 0\nünï");
  EXPECT_EQ(surface->clipboard(), "move @k1 by 0 1 0\nünï");
  EXPECT_FALSE(surface->is_window());
}

TEST_P(OffscreenSurfaceTest, the_clock_never_goes_back) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  double before = surface->clock();
  for (int i = 0; i < 1000; ++i) {
    const double now = surface->clock();
    ASSERT_GE(now, before);
    before = now;
  }
}

TEST_P(OffscreenSurfaceTest, a_second_context_outlives_the_first) {
  auto first = surface_of({16, 16});
  const auto second = surface_of({32, 32});
  ASSERT_TRUE(first && second);
  first.reset();
  EXPECT_NE(second->gl_proc("glClear"), nullptr);
  EXPECT_EQ(second->size(), (Size{32, 32}));
}

TEST_P(OffscreenSurfaceTest, its_context_is_current_and_has_the_needed_version) {
  const auto surface = surface_of({16, 16});
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->library(), GetParam() == std::string("osmesa") ? "OSMesa" : "EGL");
  const auto get = reinterpret_cast<void (*)(unsigned, int*)>(surface->gl_proc("glGetIntegerv"));
  ASSERT_NE(get, nullptr);
  constexpr unsigned kMajor = 0x821b, kMinor = 0x821c, kProfile = 0x9126;  // GL_MAJOR_VERSION, ...
  int major = 0, minor = 0, profile = 0;
  get(kMajor, &major);
  get(kMinor, &minor);
  get(kProfile, &profile);
  if (GetParam() == std::string("gles")) {
    const auto text = reinterpret_cast<const char* (*)(unsigned)>(surface->gl_proc("glGetString"));
    ASSERT_NE(text, nullptr);
    EXPECT_TRUE(std::string(text(0x1f02)).starts_with("OpenGL ES 3.")) << text(0x1f02);  // GL_VERSION
    EXPECT_GE(10 * major + minor, 30);
    return;
  }
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(profile, 1) << "GL_CONTEXT_CORE_PROFILE_BIT";
}

TEST(offscreen_surface, shaders_are_compiled_fast_unless_the_user_says_otherwise) {
  const char* const now = std::getenv("GALLIVM_PERF");
  const std::string before = now ? now : "";
  for (const char* said : {"", "no_quad_lod"}) {
    setenv("GALLIVM_PERF", said, 1);
    static_cast<void>(make_offscreen({}));
    EXPECT_STREQ(std::getenv("GALLIVM_PERF"), said);
  }
  unsetenv("GALLIVM_PERF");
  static_cast<void>(make_offscreen({}));
  EXPECT_STREQ(std::getenv("GALLIVM_PERF"), "nopt");
  if (now) setenv("GALLIVM_PERF", before.c_str(), 1);
  else unsetenv("GALLIVM_PERF");
}

TEST(offscreen_surface, one_library_is_enough) {
  const auto made = make_offscreen({});
  EXPECT_TRUE(made.ok()) << made.status().message;
}

TEST(offscreen_surface, an_unknown_library_is_an_error_of_usage) {
  const auto made = make_offscreen({.headless = "vulkan"});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().code, base::Code::usage);
  EXPECT_NE(made.status().message.find("expected osmesa, egl or gles, found vulkan"), std::string::npos);
}

}  // namespace offscreen_surface_test
}  // namespace coaster::platform
