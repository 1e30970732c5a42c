// Plots in frames of their own: what is drawn lies where the data say, and what is under the mouse is returned.
#include "ui/plots/plot.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/stage.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace plot_test {

constexpr std::uint32_t kRed = 0xE04040, kBlue = 0x4060F0;

struct Box {
  float left = 1e9f, top = 1e9f, right = -1e9f, bottom = -1e9f;
  bool empty() const { return left > right; }
  void add(float x, float y) {
    left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
  }
};

struct PlotTest : Stage {
  static constexpr float kLeft = 40, kTop = 30, kWidth = 620, kHeight = 340;

  void SetUp() override {
    Stage::SetUp();
    frames(2);
  }
  // Draws the plot in a window of its own, twice, so that ImGui knows what is hovered.
  std::optional<PlotDrag> draw(const Plot& picture, std::optional<ImVec2> mouse = {}, bool down = false) {
    std::optional<PlotDrag> drag;
    for (int i = 0; i < 2; ++i) {
      ImGuiIO& io = ImGui::GetIO();
      io.DisplaySize = {1280, 720};
      io.DeltaTime = 1.0f / 60;
      io.MousePos = mouse.value_or(ImVec2(-1e4f, -1e4f));
      io.MouseDown[0] = down && i == 1;
      ImGui::NewFrame();
      list_.clear();
      Entry entry;
      NumberDrag gesture;
      HoverTime rest;
      const std::function<void()> begins = [] {};
      const std::function<void(const std::string&)> warns = [](const std::string&) {};
      WidgetFrame ui{list_, entry, gesture, rest, begins, warns, 1, "Test", units_};
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({700, 400});
      ImGui::SetNextWindowFocus();
      ImGui::Begin("plot test", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
      ImGui::SetCursorScreenPos({kLeft, kTop});
      Plot p = picture;
      p.width = kWidth, p.height = kHeight;
      drag = plot(ui, "plot", p, "What it shows.");
      drawn_.clear();
      for (const ImDrawVert& v : ImGui::GetWindowDrawList()->VtxBuffer) drawn_.push_back(v);
      ImGui::End();
      ImGui::EndFrame();
      ImGui::Render();
    }
    return drag;
  }
  const Widget& area() const { return list_.widgets().at(0); }
  const Widget& axes() const { return list_.widgets().at(1); }
  // The pixel of a point, where the axes have these ranges and are linear.
  ImVec2 pixel(double x_part, double y_part) const {
    const Widget& a = area();
    return {a.x + static_cast<float>(x_part) * a.width, a.y + a.height - static_cast<float>(y_part) * a.height};
  }
  static bool has_colour(const ImDrawVert& v, std::uint32_t rgb) { return ((v.col ^ packed(rgb)) & 0xffffffu) == 0; }
  Box box_of(std::uint32_t rgb) const {
    Box box;
    for (const ImDrawVert& v : drawn_)
      if (has_colour(v, rgb)) box.add(v.pos.x, v.pos.y);
    return box;
  }
  static Plot with(std::span<const Series> series) {
    return {.x = {"time", "", AxisScale::linear, 0, 10}, .y = {"g", "", AxisScale::linear, -5, 5}, .series = series};
  }

  WidgetList list_;
  std::vector<ImDrawVert> drawn_;
  base::UnitSystem units_ = base::UnitSystem::m_s;
};

TEST_F(PlotTest, lines_and_points_are_where_linear_and_logarithmic_axes_have_them) {
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic})
    for (const SeriesKind kind : {SeriesKind::line, SeriesKind::points, SeriesKind::line_and_points}) {
      std::vector<double> x, y;
      for (int i = 0; i <= 40; ++i) {
        const double part = i / 40.0;
        x.push_back(scale == AxisScale::linear ? 2 + 8 * part : std::pow(10.0, 3 * part));  // straight in both
        y.push_back(scale == AxisScale::linear ? -3 + 7 * part : std::pow(10.0, -4 + 2 * part));
      }
      const Series series{"", x, y, kRed, kind};
      Plot p{.x = {"x", "", scale, x.front(), x.back()}, .y = {"y", "", scale, y.front(), y.back()}};
      p.series = std::span(&series, 1);
      draw(p);
      const Box box = box_of(ink(kRed));
      const ImVec2 low = pixel(0, 0), high = pixel(1, 1);
      EXPECT_NEAR(box.left, low.x, 4);
      EXPECT_NEAR(box.right, high.x, 4);
      EXPECT_NEAR(box.top, high.y, 4);
      EXPECT_NEAR(box.bottom, low.y, 4);
      const double slope = (high.y - low.y) / (high.x - low.x);
      for (const ImDrawVert& v : drawn_) {
        if (!has_colour(v, ink(kRed))) continue;
        EXPECT_LT(std::abs((v.pos.y - low.y) - slope * (v.pos.x - low.x)) / std::hypot(1, slope), 4.1);
      }
    }
}

TEST_F(PlotTest, many_points_in_a_column_keep_its_lowest_and_highest) {
  std::vector<double> x, y;
  for (int i = 0; i < 20'000; ++i) {
    x.push_back(10.0 * i / 19'999);
    y.push_back(i == 7'777 ? 4.0 : i == 12'345 ? -4.0 : std::sin(0.1 * i));
  }
  const Series series{"", x, y, kRed};
  draw(with(std::span(&series, 1)));
  const Box box = box_of(ink(kRed));
  EXPECT_NEAR(box.top, pixel(0, 0.9).y, 3);
  EXPECT_NEAR(box.bottom, pixel(0, 0.1).y, 3);
  EXPECT_NEAR(box.left, pixel(0, 0).x, 3);
  EXPECT_NEAR(box.right, pixel(1, 0).x, 3);
  EXPECT_LT(std::count_if(drawn_.begin(), drawn_.end(), [](const ImDrawVert& v) { return has_colour(v, ink(kRed)); }),
            40'000);
}

// A gap is free of ink, and a point alone between two gaps is a dot.
TEST_F(PlotTest, what_is_no_number_is_a_gap) {
  const double none = std::nan("");
  const std::vector<double> x{0, 2, 4, 6, 8, 10}, y{1, 1, none, 1, none, 1};
  const Series series{"", x, y, kRed};
  draw(with(std::span(&series, 1)));
  int first = 0, dot = 0;
  for (const ImDrawVert& v : drawn_) {
    if (!has_colour(v, ink(kRed))) continue;
    const float part = (v.pos.x - area().x) / area().width;
    EXPECT_TRUE(part < 0.21f || std::abs(part - 0.6f) < 0.01f || part > 0.99f) << part;
    first += part < 0.21f, dot += std::abs(part - 0.6f) < 0.01f;
  }
  EXPECT_GT(first, 0);
  EXPECT_GT(dot, 4);
}

TEST_F(PlotTest, bars_stand_on_zero_and_bands_lie_between_their_edges) {
  const std::vector<double> x{2, 5, 8}, y{3, -4, 1}, high{4, -2, 3};
  Series series{"", x, y, kRed, SeriesKind::bars};
  draw(with(std::span(&series, 1)));
  const Box bars = box_of(ink(kRed));
  EXPECT_NEAR(bars.top, pixel(0, 0.8).y, 1);
  EXPECT_NEAR(bars.bottom, pixel(0, 0.1).y, 1);
  for (const ImDrawVert& v : drawn_) {
    if (!has_colour(v, ink(kRed))) continue;
    const double at = 10.0 * (v.pos.x - area().x) / area().width;
    const auto bar =
        std::min_element(x.begin(), x.end(), [&](double a, double b) { return std::abs(a - at) < std::abs(b - at); });
    EXPECT_LT(std::abs(*bar - at), 1.2) << "a gap between bars";
    const double value = y[static_cast<std::size_t>(bar - x.begin())];
    EXPECT_TRUE(std::abs(v.pos.y - pixel(0, 0.5).y) < 1 || std::abs(v.pos.y - pixel(0, 0.5 + value / 10).y) < 1);
  }
  std::vector<double> fine, low, top;
  for (int i = 0; i <= 1000; ++i) fine.push_back(0.01 * i), low.push_back(-3 + 0.001 * i), top.push_back(1 + 0.002 * i);
  series = {"", fine, low, kBlue, SeriesKind::line, 1.8f, top};
  draw(with(std::span(&series, 1)));
  const Box band = box_of(ink(kBlue));
  EXPECT_NEAR(band.top, pixel(0, 0.8).y, 2);
  EXPECT_NEAR(band.bottom, pixel(0, 0.2).y, 2);
  for (const ImDrawVert& v : drawn_) {
    if (!has_colour(v, ink(kBlue))) continue;
    const double at = 10.0 * (v.pos.x - area().x) / area().width;
    EXPECT_TRUE(std::abs(v.pos.y - pixel(0, (5 - 3 + 0.1 * at) / 10).y) < 2.5 ||
                std::abs(v.pos.y - pixel(0, (5 + 1 + 0.2 * at) / 10).y) < 2.5);
  }
}

TEST_F(PlotTest, levels_are_dashed_to_the_right_edge_and_spots_are_dots_with_their_labels_inside) {
  const std::vector<double> x{0, 10}, y{0, 0};
  const Series series{"", x, y, kRed};
  Plot p = with(std::span(&series, 1));
  for (const double at : {-4.9, 1.0, 4.95}) {
    const LevelLine level{"limit", at, kBlue};
    p.levels = std::span(&level, 1);
    draw(p);
    const Box box = box_of(ink(kBlue));
    const float line = pixel(0, 0.5 + at / 10).y;
    EXPECT_NEAR(box.left, pixel(0, 0).x, 1);
    EXPECT_LT(box.right, pixel(1, 0).x + 1);
    EXPECT_GT(box.right, pixel(1, 0).x - 12) << "less than a dash and its gap";
    EXPECT_GT(box.bottom, line - 2);
    EXPECT_GT(box.top, area().y - 2) << "the label is inside";
    EXPECT_LT(box.bottom, area().y + area().height + 2);
    EXPECT_LT(box.bottom - box.top, 25);
  }
  p.levels = {};
  for (const auto& [sx, sy] : {std::pair{5.0, 0.0}, {9.9, 4.9}, {0.1, -4.9}}) {
    const Spot spot{sx, sy, kBlue, "the place"};
    p.spots = std::span(&spot, 1);
    draw(p);
    const Box box = box_of(ink(kBlue));
    const ImVec2 at = pixel(sx / 10, 0.5 + sy / 10);
    EXPECT_TRUE(box.left < at.x && at.x < box.right);
    EXPECT_GT(box.right - box.left, small_size("the place").x);
    EXPECT_GT(box.left, area().x - 6);
    EXPECT_LT(box.right, area().x + area().width + 6);
    EXPECT_GT(box.top, area().y - 6);
    EXPECT_LT(box.bottom, area().y + area().height + 6);
  }
}

TEST_F(PlotTest, of_labels_at_one_place_only_one_is_drawn) {
  const std::vector<double> x{0, 10}, y{0, 0};
  const Series series{"", x, y, kRed};
  Plot p = with(std::span(&series, 1));
  // Vertices of the label and of the dots: two at nearly one place have one label, in either order.
  const auto drawn_with = [&](std::vector<Spot> spots) {
    p.spots = spots;
    draw(p);
    return std::ranges::count_if(drawn_, [&](const ImDrawVert& v) { return has_colour(v, ink(kBlue)); });
  };
  const auto dot = drawn_with({{5, 0, kBlue, ""}}), label = drawn_with({{5, 0, kBlue, "flip"}}) - dot;
  ASSERT_EQ(label, 16);  // four letters
  EXPECT_EQ(drawn_with({{5, 0, kBlue, "flip"}, {5.1, 0, kBlue, "flip"}}), 2 * dot + label);
  EXPECT_EQ(drawn_with({{5.1, 0, kBlue, "flip"}, {5, 0, kBlue, "flip"}}), 2 * dot + label);
  EXPECT_EQ(drawn_with({{5, 0, kBlue, "flip"}, {5.1, 2, kBlue, "flip"}}), 2 * (dot + label)) << "above each other";
  EXPECT_EQ(drawn_with({{5, 0, kBlue, "flip"}, {7, 0, kBlue, "flip"}, {7.1, 0, kBlue, "flip"}}), 3 * dot + 2 * label);
}

// All ink is within the plot's own box, and the data have most of it: a line of text below and to the left what the
// numbers need. A title takes a line above, none half a line.
TEST_F(PlotTest, the_data_have_the_room_that_titles_and_numbers_leave) {
  const std::vector<double> x{0, 10}, y{-3, 4};
  const Series series{"", x, y, kRed};
  const float line = small_pixels();
  for (const bool titled : {true, false})
    for (const bool long_title : {true, false}) {
      Plot p = with(std::span(&series, 1));
      p.y.title = titled ? "vertical g" : "";
      p.x.title = long_title ? "a title that is far too long to be beside the numbers" : "t";
      draw(p);
      EXPECT_NEAR(area().y - kTop, titled ? line + 4 : line / 2, 1.01);
      const float below = kTop + kHeight - area().y - area().height, beside = kLeft + kWidth - area().x - area().width;
      EXPECT_NEAR(below, line + 4 + (long_title ? line : 0), 1.01);
      EXPECT_NEAR(beside, long_title ? line : line + 4 + small_size("t").x, 1.01);
      EXPECT_NEAR(area().x - kLeft, small_size("-4").x + 8, 1.01);
      for (const ImDrawVert& v : drawn_) {
        if (v.pos.x == 0 || v.pos.y == 0 || v.pos.x >= 699 || v.pos.y >= 399) continue;  // the window's own
        EXPECT_TRUE(v.pos.x > kLeft - 2 && v.pos.x < kLeft + kWidth + 2) << v.pos.x;
        EXPECT_TRUE(v.pos.y > kTop - 2 && v.pos.y < kTop + kHeight + 2) << v.pos.y;
      }
    }
  Plot p = with(std::span(&series, 1));
  p.labels = 90;
  draw(p);
  EXPECT_NEAR(area().x - kLeft, 98, 1.01) << "so that plots in a column line up";
  EXPECT_EQ(axes().value, "g -5 -4 -3 -2 -1 0 1 2 3 4 5");
  EXPECT_EQ(axes().kind, "label");
  EXPECT_EQ(area().kind, "plot");
}

TEST_F(PlotTest, shapes_have_the_same_scale_on_both_axes) {
  for (const auto& [wide, high] : {std::pair{40.0, 3.0}, {3.0, 40.0}, {20.0, 20.0}}) {
    const std::vector<double> x{0, wide, wide, 0, 0}, y{0, 0, high, high, 0};
    const Series series{"", x, y, kRed};
    draw({.x = {"x", "m"}, .y = {"y", "m"}, .series = std::span(&series, 1), .square = true});
    const Box box = box_of(ink(kRed));
    EXPECT_NEAR((box.right - box.left - 3) / wide, (box.bottom - box.top - 3) / high, 0.2);
    const float share = std::max((box.right - box.left) / area().width, (box.bottom - box.top) / area().height);
    EXPECT_GT(share, 0.8f);
    EXPECT_LT(share, 1);
  }
}

TEST_F(PlotTest, a_right_axis_has_its_own_range_and_takes_its_room_from_the_data) {
  const std::vector<double> x{0, 10}, y{0, 0}, other{100, 900};
  const Series series{"", x, y, kRed}, right{"", x, other, kBlue};
  Plot p = with(std::span(&series, 1));
  draw(p);
  const float before = area().width;
  p.right = {"m/s", "", AxisScale::linear, 0, 1000};
  p.right_series = std::span(&right, 1);
  draw(p);
  EXPECT_LT(area().width, before - small_size("1000").x);
  const Box box = box_of(ink(kBlue));
  EXPECT_NEAR(box.bottom, pixel(0, 0.1).y, 3);
  EXPECT_NEAR(box.top, pixel(0, 0.9).y, 3);
  EXPECT_NEAR(box_of(ink(kRed)).top, pixel(0, 0.5).y, 3);
}

// The legend is in the title's row, at the right, with a mark of each series' colour.
TEST_F(PlotTest, the_legend_is_above_the_data) {
  const std::vector<double> x{0, 10}, y{0, 0};
  for (const SeriesKind kind : {SeriesKind::line, SeriesKind::points, SeriesKind::bars}) {
    const Series series[] = {{"first", x, y, kRed, kind}, {"second", x, y, kBlue, kind}, {"", x, y, 0x20C020, kind}};
    draw(with(series));
    float at[2] = {0, 0};
    for (const ImDrawVert& v : drawn_)
      for (int k = 0; k < 2; ++k)
        if (has_colour(v, ink(k == 0 ? kRed : kBlue)) && v.pos.y < area().y - 2) {
          EXPECT_GT(v.pos.y, kTop - 1);
          EXPECT_GT(v.pos.x, area().x + area().width - small_size("first second").x - 90);
          EXPECT_LT(v.pos.x, area().x + area().width);
          at[k] = std::max(at[k], v.pos.x);
        }
    EXPECT_GT(at[0], 0);
    EXPECT_GT(at[1], at[0] + small_size("first").x);
  }
}

TEST_F(PlotTest, without_data_it_says_so_in_its_middle) {
  Plot p = with({});
  p.empty = "nothing yet";
  draw(p);
  EXPECT_EQ(area().value, "nothing yet");
  Box words;
  for (const ImDrawVert& v : drawn_)
    if (has_colour(v, ink(palette().dim)) && v.pos.x > area().x + 60 && v.pos.x < area().x + area().width - 60 &&
        v.pos.y < area().y + area().height - 20)
      words.add(v.pos.x, v.pos.y);
  ASSERT_FALSE(words.empty());
  EXPECT_NEAR(words.left + words.right, 2 * area().x + area().width, 6);
  EXPECT_NEAR(words.top + words.bottom, 2 * area().y + area().height, 10);
}

// Wherever the mouse is, all of the read-out is within the data and not under the mouse.
TEST_F(PlotTest, the_read_out_is_beside_the_mouse_and_within_the_plot) {
  std::vector<double> x, y, z;
  for (int i = 0; i <= 100; ++i) x.push_back(0.1 * i), y.push_back(2), z.push_back(-2);
  const Series series[] = {{"upper", x, y, kRed}, {"lower", x, z, kBlue}};
  draw(with(series));
  const Widget a = area();
  for (const float across : {0.01f, 0.3f, 0.5f, 0.7f, 0.99f})
    for (const float down : {0.01f, 0.5f, 0.99f}) {
      const ImVec2 mouse(a.x + across * a.width, a.y + down * a.height);
      draw(with(series), mouse);
      const Box box = box_of(palette().raised);
      ASSERT_FALSE(box.empty()) << across << ' ' << down;
      EXPECT_GT(box.left, a.x - 1) << across;
      EXPECT_LT(box.right, a.x + a.width + 1) << across;
      EXPECT_GT(box.top, a.y - 1) << down;
      EXPECT_LT(box.bottom, a.y + a.height + 1) << down;
      EXPECT_TRUE(mouse.x < box.left || mouse.x > box.right) << across;
      EXPECT_LT(std::min(std::abs(mouse.x - box.left), std::abs(mouse.x - box.right)), 14) << across;
      EXPECT_NEAR(box.bottom - box.top, 3 * small_pixels() + 10, 2) << "the x and both values";
      EXPECT_GT(box.right - box.left, small_size("upper 2").x + 9);
    }
  draw(with(series), ImVec2(a.x + 0.5f * a.width, kTop + 2));
  EXPECT_TRUE(box_of(palette().raised).empty()) << "beside the data there is none";
}

TEST_F(PlotTest, a_drag_moves_the_cursor_to_a_round_place_within_a_pixel) {
  const std::vector<double> x{0, 10}, y{0, 0};
  const Series series{"", x, y, kRed};
  for (const base::UnitSystem units : {base::UnitSystem::m_s, base::UnitSystem::feet}) {
    units_ = units;
    Plot p = with(std::span(&series, 1));
    p.x.unit = "m", p.cursor = 5;
    draw(p);
    const Widget a = area();
    EXPECT_EQ(a.value, units == base::UnitSystem::m_s ? "5.00000" : "16.4042");
    const double per_pixel = 10 / static_cast<double>(a.width),
                 factor = units == base::UnitSystem::m_s ? 1 : 1 / 0.3048;
    for (const double part : {0.0, 0.123, 0.731, 1.0}) {
      const double wanted = 10 * part;
      const ImVec2 mouse(a.x + static_cast<float>(part) * (a.width - 1), a.y + 0.5f * a.height);
      draw(p, mouse);
      const auto drag = draw(p, mouse, true);
      ASSERT_TRUE(drag) << part;
      EXPECT_NEAR(drag->x, wanted, 2.5 * per_pixel) << part;
      EXPECT_GE(drag->x, 0);
      EXPECT_LE(drag->x, 10);
      if (part > 0 && part < 1) {
        EXPECT_NEAR(drag->x * factor * 100, std::round(drag->x * factor * 100), 1e-6) << "two decimals";
      }
      const Box box = box_of(palette().accent);
      EXPECT_NEAR((box.left + box.right) / 2, pixel(0.5, 0).x, 2) << "it is drawn where it is";
      EXPECT_NEAR(box.top, a.y, 2);
      EXPECT_NEAR(box.bottom, a.y + a.height, 2);
      draw(p);
    }
  }
  Plot p = with(std::span(&series, 1));
  p.drags_point = true;
  draw(p);
  const Widget a = area();
  const ImVec2 mouse(a.x + 0.25f * a.width, a.y + 0.8f * a.height);
  draw(p, mouse);
  const auto drag = draw(p, mouse, true);
  ASSERT_TRUE(drag);
  EXPECT_NEAR(drag->x, 2.5, 0.05);
  EXPECT_NEAR(drag->y, -3, 0.05);
  draw(p);
  std::optional<double> pointed;
  p.pointed = &pointed;
  draw(p, mouse);
  ASSERT_TRUE(pointed);
  EXPECT_NEAR(*pointed, 2.5, 0.05);
  EXPECT_TRUE(box_of(palette().raised).empty()) << "the caller shows the values";
}

TEST_F(PlotTest, axes_from_the_data_have_a_margin_and_the_least_span) {
  const std::vector<double> x{1, 9}, y{-2, 6};
  const Series series{"", x, y, kRed};
  draw({.x = {"x"}, .y = {"y"}, .series = std::span(&series, 1)});
  Box box = box_of(ink(kRed));
  EXPECT_NEAR(box.left, area().x, 3) << "the x axis ends with the data";
  EXPECT_NEAR(box.right, area().x + area().width, 3);
  const float air = 0.06f / 1.12f * area().height;
  EXPECT_NEAR(box.top - area().y, air, 3);
  EXPECT_NEAR(area().y + area().height - box.bottom, air, 3);
  const std::vector<double> noise{1, 1.001};
  const Series still{"", x, noise, kRed};
  draw({.x = {"x"}, .y = {.title = "y", .least_span = 2}, .series = std::span(&still, 1)});
  box = box_of(ink(kRed));
  EXPECT_LT(box.bottom - box.top, 6) << "no noise fills the plot";
  EXPECT_NEAR((box.top + box.bottom) / 2, area().y + area().height / 2, 3);
}

}  // namespace plot_test
}  // namespace coaster::ui
