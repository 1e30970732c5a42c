#include "ui/host/layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace coaster::ui {
namespace layout_test {

bool apart(const view::Viewport& a, const view::Viewport& b) {
  constexpr float kRounding = 1e-3f;  // px
  return a.x + a.width <= b.x + kRounding || b.x + b.width <= a.x + kRounding || a.y + a.height <= b.y + kRounding ||
         b.y + b.height <= a.y + kRounding;
}

TEST(layout, regions_tile_the_window_and_the_viewport_keeps_two_fifths) {
  for (const auto& [width, height] :
       {std::pair{1280, 720}, {1920, 1080}, {640, 360}, {801, 601}, {3840, 2160}, {333, 222}}) {
    for (const float scale : {0.8f, 1.0f, 1.7f, 3.0f}) {
      for (const bool open : {false, true}) {
        const Layout l = make_layout(width, height, scale, 23 * scale, {.strip = {open}});
        const view::Viewport all[] = {l.menu, l.left, l.right, l.strip, l.status, l.scene};
        float area = 0;
        for (const view::Viewport& one : all) area += one.width * one.height;
        EXPECT_NEAR(area, static_cast<float>(width) * static_cast<float>(height), 1)
            << width << "x" << height << " at " << scale;
        for (std::size_t i = 0; i < 6; ++i)
          for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(apart(all[i], all[k])) << i << " and " << k << " at " << width;
        EXPECT_GE(l.scene.width, 0.4f * static_cast<float>(width));
        EXPECT_GE(l.scene.height, 0.5f * l.left.height - 1) << width << "x" << height << " at " << scale;
      }
    }
  }
}

TEST(layout, the_strip_folds_to_a_bar_and_opens_by_a_quarter_of_the_window) {
  const float bar = 23;
  EXPECT_EQ(make_layout(1280, 720, 1, bar, {.strip = {false}}).strip.height, bar);
  EXPECT_EQ(make_layout(1280, 720, 1, bar, {.strip = {true}}).strip.height, 190);
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, {.strip = {true}}).strip.height, 280);
  const Layout small = make_layout(640, 360, 0.8f, 19, {.strip = {true}});
  EXPECT_GT(small.strip.height, 100);
  EXPECT_LE(small.strip.height, small.scene.height + 1);
  EXPECT_EQ(make_layout(640, 180, 1, bar, {.strip = {true}}).strip.height, bar);  // nothing could be read in 67 px
}

TEST(layout, the_strip_has_its_share_of_the_height_between_the_bars) {
  const float bar = 23, middle = 1080 - 2 * bar;
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, {.strip = {true, 0.7f}}).strip.height, std::floor(0.7f * middle));
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, {.strip = {true, 0.01f}}).strip.height, 4 * bar);  // what can be read
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, {.strip = {false, 0.7f}}).strip.height, bar);
}

TEST(layout, hidden_panels_leave_the_whole_window) {
  const Layout l = make_layout(641, 359, 1.3f, 30, {.panels = false, .strip = {true}});
  EXPECT_EQ(l.scene.width, 641);
  EXPECT_EQ(l.scene.height, 359);
  EXPECT_EQ(l.left.width * l.left.height + l.right.width * l.right.height + l.menu.height + l.status.height, 0);
}

constexpr std::pair<int, int> kSizes[] = {{1280, 720}, {1920, 1080}, {640, 360}, {801, 601}, {3840, 2160}, {333, 222}};

std::vector<view::Viewport> areas_of(const Layout& l) {
  return {l.menu, l.status, l.left, l.right, l.strip, l.palette, l.drawer, l.parameters, l.graph, l.ride, l.scene};
}

LayoutOptions building() { return {.workspace = world::Workspace::build, .elements = 19, .label_width = 67.4f}; }
float scene_share(int width, int height, float scale, LayoutOptions wish) {
  const view::Viewport scene = make_layout(width, height, scale, std::floor(23 * scale), wish).scene;
  return scene.width * scene.height / static_cast<float>(width * height);
}

TEST(layout, the_areas_of_every_workspace_tile_the_window) {
  for (const auto& [width, height] : kSizes)
    for (const float scale : {0.8f, 1.0f, 1.5f, 2.0f})
      for (std::size_t w = 0; w < base::count_of<world::Workspace>(); ++w)
        for (const std::optional<bool> open : {std::optional<bool>(), std::optional(true), std::optional(false)})
          for (const float share : {0.0f, 0.05f, 0.6f}) {
            LayoutOptions wish = building();
            wish.workspace = static_cast<world::Workspace>(w);
            wish.strip = {open.value_or(true), share};
            wish.parameters = wish.graph = open;
            wish.graph_share = share;
            const std::vector<view::Viewport> areas = areas_of(make_layout(width, height, scale, 23 * scale, wish));
            float sum = 0;
            for (std::size_t i = 0; i < areas.size(); ++i) {
              const view::Viewport& a = areas[i];
              EXPECT_GE(std::min({a.x, a.y, a.width, a.height}), 0.0f) << i;
              EXPECT_LE(a.x + a.width, static_cast<float>(width) + 0.01f) << i;
              EXPECT_LE(a.y + a.height, static_cast<float>(height) + 0.01f) << i;
              sum += a.width * a.height;
              for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(a.width * a.height == 0 || areas[k].width * areas[k].height == 0 || apart(a, areas[k]))
                    << i << " and " << k << " of workspace " << w << ", " << width << "x" << height << " at " << scale;
            }
            EXPECT_NEAR(sum, static_cast<float>(width * height), 0.001f * static_cast<float>(width * height))
                << "workspace " << w << ", " << width << "x" << height << " at " << scale;
          }
}

TEST(layout, the_view_keeps_62_percent_in_build_and_85_in_ride) {
  for (const int elements : {9, 19, 24}) {
    LayoutOptions build = building();
    build.elements = elements;
    EXPECT_GE(scene_share(1280, 720, 1, build), 0.62f);
    EXPECT_GE(scene_share(1280, 720, 1.5f, build), 0.62f);
    EXPECT_GE(scene_share(1920, 1080, 1, build), 0.62f);
    EXPECT_GE(scene_share(1920, 1080, 1.5f, build), 0.62f);
    EXPECT_GE(scene_share(1920, 1080, 2, build), 0.62f);
  }
  EXPECT_GE(scene_share(1280, 720, 1, {.workspace = world::Workspace::ride}), 0.85f);
  EXPECT_GE(scene_share(1920, 1080, 1.5f, {.workspace = world::Workspace::ride}), 0.85f);
}

TEST(layout, the_palette_has_room_for_every_button_with_or_without_parameters) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {3840, 2160}, {640, 480}})
    for (const float scale : {0.8f, 1.0f, 1.5f, 2.0f})
      for (const bool open : {true, false})
        for (const int elements : {9, 17, 20}) {
          LayoutOptions wish = building();
          wish.elements = elements;
          wish.parameters = open;
          const Layout l = make_layout(width, height, scale, 23 * scale, wish);
          const PaletteGrid& grid = l.grid;
          const float gap = std::floor(4 * scale), pad = std::floor(8 * scale);
          const auto columns = static_cast<float>(grid.columns), rows = static_cast<float>(grid.rows);
          const std::string where = std::to_string(width) + " at " + std::to_string(scale);
          EXPECT_GE(grid.columns * grid.rows, elements) << where;
          EXPECT_LE(columns * grid.cell_width + (columns - 1) * gap + 2 * pad, l.palette.width + 0.01f) << where;
          if (scale * 480 > static_cast<float>(height)) continue;  // too low for anything
          EXPECT_LE(rows * grid.cell_height + (rows - 1) * gap + 2 * pad, l.palette.height + 0.01f) << where;
        }
}

TEST(layout, the_palette_has_labels_at_usual_sizes_and_the_view_its_share) {
  constexpr std::tuple<int, int, float> kWindows[] = {
      {1280, 720, 1.0f}, {1280, 720, 1.5f}, {1920, 1080, 1.0f}, {1920, 1080, 1.5f}, {1920, 1080, 2.0f}};
  for (const auto& [width, height, scale] : kWindows)
    for (const std::optional<bool> parameters : {std::optional<bool>(), std::optional(true), std::optional(false)}) {
      LayoutOptions wish = building();
      wish.label_width = 67.4f * scale;
      wish.parameters = parameters;
      const Layout l = make_layout(width, height, scale, std::floor(23 * scale), wish);
      const std::string where = std::to_string(width) + " at " + std::to_string(scale);
      EXPECT_TRUE(l.grid.labels) << where;
      EXPECT_GE(l.grid.cell_width, wish.label_width - 1) << where;
      EXPECT_GE(scene_share(width, height, scale, wish), 0.62f) << where;
      if (parameters.value_or(true)) {
        EXPECT_GE(l.parameters.height, 110 * scale) << where;
      }
    }
}

TEST(layout, parameters_and_graph_fold_where_there_is_little_room_unless_the_user_opens_them) {
  const Layout roomy = make_layout(1280, 720, 1, 23, building());
  EXPECT_GT(roomy.parameters.height, 247);
  EXPECT_GT(roomy.graph.height, 110);
  EXPECT_EQ(roomy.drawer.height, 0);
  EXPECT_EQ(roomy.graph.width, 1280);
  LayoutOptions wish = building();
  const Layout little = make_layout(1250, 720, 1.5f, 34, wish);
  EXPECT_EQ(little.parameters.height, 0);
  EXPECT_EQ(little.graph.height, 34);
  EXPECT_EQ(little.drawer.height, 34);
  wish.parameters = wish.graph = true;
  const Layout opened = make_layout(1250, 720, 1.5f, 34, wish);
  EXPECT_GT(opened.parameters.height, 150);
  EXPECT_GT(opened.graph.height, 150);
  EXPECT_EQ(opened.drawer.height, 34);
}

TEST(layout, the_graph_has_its_share_and_the_palette_does_not_move_with_it) {
  LayoutOptions wish = building();
  const Layout before = make_layout(1280, 720, 1, 23, wish);
  wish.graph_share = 0.3f;
  const Layout after = make_layout(1280, 720, 1, 23, wish);
  EXPECT_EQ(after.graph.height, std::floor(0.3f * (720 - 2 * 23)));
  EXPECT_EQ(after.palette.y, before.palette.y);
  EXPECT_EQ(after.palette.width, before.palette.width);
}

TEST(layout, small_windows_shrink_text_by_a_fifth_at_most) {
  EXPECT_FLOAT_EQ(fitted_scale(1280, 720, 1, 1), 1);
  EXPECT_FLOAT_EQ(fitted_scale(640, 360, 1, 1), 0.8f);
  EXPECT_FLOAT_EQ(fitted_scale(64, 36, 1, 1), 0.8f);
  EXPECT_FLOAT_EQ(fitted_scale(2560, 1440, 1.5f, 2), 3);  // a dense screen is no small window
}

}  // namespace layout_test
}  // namespace coaster::ui
