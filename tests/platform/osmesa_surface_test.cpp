// What every surface promises, held by the one that needs no display.
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "platform/surface.h"

namespace coaster::platform {
namespace osmesa_surface_test {

std::unique_ptr<Surface> surface_of(Size size) {
  SurfaceOptions options;
  options.size = size;
  auto made = make_offscreen(options);
  EXPECT_TRUE(made.ok()) << made.status().message;
  return made.ok() ? std::move(*made) : nullptr;
}

TEST(osmesa_surface, each_poll_is_one_tick_of_a_sixtieth) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  Events events;
  for (std::size_t i = 1; i <= 3; ++i) {
    surface->poll(events);
    ASSERT_EQ(events.size(), i) << "polling appends";
    ASSERT_TRUE(std::holds_alternative<Tick>(events.back()));
    EXPECT_EQ(std::get<Tick>(events.back()).dt, 1.0 / 60.0);
  }
}

TEST(osmesa_surface, a_new_size_is_obeyed_and_told_once_before_the_tick) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->size(), (Size{320, 180}));
  surface->resize({77, 31});
  surface->resize({641, 359});
  EXPECT_EQ(surface->size(), (Size{641, 359}));
  Events events;
  surface->poll(events);
  ASSERT_EQ(events.size(), 2u);
  ASSERT_TRUE(std::holds_alternative<Resize>(events[0]));
  EXPECT_EQ(std::get<Resize>(events[0]).width, 641);
  EXPECT_EQ(std::get<Resize>(events[0]).height, 359);
  EXPECT_TRUE(std::holds_alternative<Tick>(events[1]));
  events.clear();
  surface->poll(events);
  EXPECT_EQ(events.size(), 1u);
}

TEST(osmesa_surface, sizes_below_zero_are_nothing) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  surface->resize({-5, 9});
  EXPECT_EQ(surface->size(), (Size{0, 9}));
}

TEST(osmesa_surface, the_clipboard_keeps_what_it_was_given) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->clipboard(), "");
  surface->set_clipboard("move @k1 by 0 1 0\nünï");
  EXPECT_EQ(surface->clipboard(), "move @k1 by 0 1 0\nünï");
  EXPECT_FALSE(surface->is_window());
}

TEST(osmesa_surface, the_clock_never_goes_back) {
  const auto surface = surface_of({320, 180});
  ASSERT_TRUE(surface);
  double before = surface->clock();
  for (int i = 0; i < 1000; ++i) {
    const double now = surface->clock();
    ASSERT_GE(now, before);
    before = now;
  }
}

TEST(osmesa_surface, a_second_context_outlives_the_first) {
  auto first = surface_of({16, 16});
  const auto second = surface_of({32, 32});
  ASSERT_TRUE(first && second);
  first.reset();
  EXPECT_NE(second->gl_proc("glClear"), nullptr);
  EXPECT_EQ(second->size(), (Size{32, 32}));
}

}  // namespace osmesa_surface_test
}  // namespace coaster::platform
