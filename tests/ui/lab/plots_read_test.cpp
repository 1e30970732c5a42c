// The plots of the laboratory, read like a person: by the numbers drawn beside the axes the drawn curves are converted
// back into values, which are compared with formulas and with the ride.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/lab/page_widgets.h"
#include "ui/stage.h"
#include "ui/widgets/theme.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace plots_read_test {

using glm::dvec3;

// A linear axis: the value at a pixel.
struct Axis {
  double value = 0, per_px = 0;
  float px = 0;
  double at(float pixel) const { return value + per_px * static_cast<double>(pixel - px); }
  float pixel(double of) const { return px + static_cast<float>((of - value) / per_px); }
};
struct Number {
  double value;
  float middle;  // px
};

// Returns the axis through the outermost two of the numbers. Each is rounded to its last digit and to a pixel.
Axis axis_of(std::vector<Number> numbers) {
  EXPECT_GE(numbers.size(), 2u);
  if (numbers.size() < 2) return {0, 1, 0};
  std::ranges::sort(numbers, {}, &Number::middle);
  const Number &a = numbers.front(), &b = numbers.back();
  const Axis axis{a.value, (b.value - a.value) / (b.middle - a.middle), a.middle};
  for (const Number& one : numbers) EXPECT_NEAR(axis.pixel(one.value), one.middle, 4) << one.value;
  return axis;
}

struct PlotsReadTest : Stage {
  void open(world::LabPage page) {
    using world::Panels;
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&Panels::workspace>{world::Workspace::laboratory}).ok());
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&Panels::show_laboratory>{true}).ok());
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::LabView::page>{page}).ok());
    resize(1920, 1080);
    frames(3);
  }
  // The numbers that one glyph after the other makes up, of those that are `wanted`.
  static std::vector<Number> numbers(const std::vector<DrawnGlyph>& all, bool rows,
                                     const std::function<bool(const DrawnGlyph&)>& wanted) {
    std::vector<Number> found;
    std::string word;
    ImVec2 low{}, high{};
    const auto end = [&] {
      char* rest = nullptr;
      const double value = std::strtod(word.c_str(), &rest);
      if (!word.empty() && *rest == '\0') found.push_back({value, rows ? (low.y + high.y) / 2 : (low.x + high.x) / 2});
      word.clear();
    };
    for (const DrawnGlyph& g : all) {
      if (!wanted(g)) continue;
      if (!word.empty() && (g.low.x > high.x + 6 || g.low.x < low.x || g.low.y > high.y || g.high.y < low.y)) end();
      if (word.empty()) low = g.low, high = g.high;
      low = {std::min(low.x, g.low.x), std::min(low.y, g.low.y)};
      high = {std::max(high.x, g.high.x), std::max(high.y, g.high.y)};
      word += g.codepoint < 128 ? static_cast<char>(g.codepoint) : g.codepoint == 0x2212 ? '-' : '?';
    }
    end();
    return found;
  }
  struct Read {
    Widget area;
    Axis x, y;
    const ImDrawList* list = nullptr;
  };
  Read read(const std::string& path) {
    Read plot{*find(path), {}, {}, nullptr};
    const Widget& a = plot.area;
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
      if (!window->Active || window->Hidden) continue;
      const std::vector<DrawnGlyph> all = drawn_glyphs(*window->DrawList);
      // Numbers at the ends of an axis are moved inside.
      const auto left = numbers(all, true, [&](const DrawnGlyph& g) {
        const float middle = (g.low.y + g.high.y) / 2;
        return g.high.x < a.x && g.low.x > a.x - 60 && middle > a.y + 12 && middle < a.y + a.height - 12;
      });
      const auto below = numbers(all, false, [&](const DrawnGlyph& g) {
        return g.low.y >= a.y + a.height && g.high.y < a.y + a.height + 20 && g.low.x > a.x - 8 &&
               g.high.x < a.x + a.width + 12;
      });
      if (left.size() < 2 || below.size() < 2) continue;
      plot.x = axis_of(below), plot.y = axis_of(left), plot.list = window->DrawList;
    }
    EXPECT_NE(plot.list, nullptr) << path << " has no numbers";
    return plot;
  }
  // The points of a line of this colour: its vertices are pairs about them.
  static std::vector<ImVec2> line(const Read& plot, std::uint32_t rgb) {
    std::vector<ImVec2> ends, points;
    for (const ImDrawVert& v : plot.list->VtxBuffer) {
      const Widget& a = plot.area;
      if (v.col == packed(ink(rgb)) && v.pos.x > a.x - 4 && v.pos.x < a.x + a.width + 4 && v.pos.y > a.y - 4 &&
          v.pos.y < a.y + a.height + 4)
        ends.push_back(v.pos);
    }
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      points.push_back({(ends[i].x + ends[i + 1].x) / 2, (ends[i].y + ends[i + 1].y) / 2});
    return points;
  }
  // Expects the line to be the graph of a function from `from` to `to`: most of its points within two pixels (marks and
  // cursors may have its colour), and a point wherever the graph is.
  static void expect_graph(const Read& plot, std::uint32_t rgb, double from, double to,
                           const std::function<double(double)>& function, const std::string& what) {
    if (plot.list == nullptr) return;
    std::vector<ImVec2> graph;
    for (int i = 0; i <= 2000; ++i) {
      const double x = from + (to - from) * i / 2000, y = function(x);
      if (std::isfinite(y)) graph.push_back({plot.x.pixel(x), plot.y.pixel(y)});
    }
    const std::vector<ImVec2> points = line(plot, rgb);
    ASSERT_GT(points.size(), 20u) << what;
    const auto distance = [](const std::vector<ImVec2>& all, ImVec2 p) {
      float least = std::numeric_limits<float>::infinity();
      for (const ImVec2& q : all) least = std::min(least, std::hypot(q.x - p.x, q.y - p.y));
      return least;
    };
    std::vector<float> off;
    for (const ImVec2& p : points) off.push_back(distance(graph, p));
    std::ranges::sort(off);
    EXPECT_LT(off[off.size() * 6 / 10], 2) << what;
    const Widget& a = plot.area;
    for (std::size_t i = 0; i < graph.size(); i += 50)
      if (graph[i].y > a.y && graph[i].y < a.y + a.height) {
        EXPECT_LT(distance(points, graph[i]), 25) << what << " at " << plot.x.at(graph[i].x);
      }
  }
  // Derivatives of the probed segment from its control points.
  struct Derivatives {
    dvec3 first, second, third;
  };
  Derivatives derivatives(double t) const {
    const curve::Cubic c = world::cubic_of(session_.document, entity(world::EntityKind::segment, 2));
    const dvec3 a = dvec3(c.p1) - dvec3(c.p0), b = dvec3(c.p2) - dvec3(c.p1), d = dvec3(c.p3) - dvec3(c.p2);
    const double u = 1 - t;
    return {3.0 * (u * u * a + 2 * u * t * b + t * t * d), 6.0 * (u * (b - a) + t * (d - b)), 6.0 * (d - 2.0 * b + a)};
  }
  // Returns the parameter at an arc length, by a table of many short chords.
  std::function<double(double)> parameter() const {
    constexpr int kChords = 4000;
    std::vector<double> s{0};
    for (int i = 0; i < kChords; ++i)
      s.push_back(s.back() + glm::length(derivatives((i + 0.5) / kChords).first) / kChords);
    return [s](double at) {
      const auto above = std::lower_bound(s.begin() + 1, s.end() - 1, at);
      return (static_cast<double>(above - s.begin()) - (*above - at) / (*above - *(above - 1))) / kChords;
    };
  }
};

TEST_F(PlotsReadTest, weights_are_the_bernstein_polynomials) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{{{world::EntityKind::segment, 2}}, 0.3}).ok());
  open(world::LabPage::weights);
  constexpr double kChoose[] = {1, 3, 3, 1};
  const Read plot = read("Laboratory/Weights plot");
  for (int i = 0; i < 4; ++i)
    expect_graph(
        plot, row_colour(static_cast<std::size_t>(i)), 0, 1,
        [&](double t) { return kChoose[i] * std::pow(t, i) * std::pow(1 - t, 3 - i); }, "B" + std::to_string(i));
}

TEST_F(PlotsReadTest, curvature_and_torsion_are_those_of_the_control_points) {
  select(world::EntityKind::segment, 2);
  open(world::LabPage::frames);
  const auto t = parameter();
  const double length = session_.derived.shape(entity(world::EntityKind::segment, 2)).arc.length();
  expect_graph(
      read("Laboratory/Curvature plot"), row_colour(0), 0, length,
      [&](double s) {
        const Derivatives d = derivatives(t(s));
        return glm::length(glm::cross(d.first, d.second)) / std::pow(glm::length(d.first), 3);
      },
      "curvature");
  expect_graph(
      read("Laboratory/Torsion plot"), row_colour(4), 0, length,
      [&](double s) {
        const Derivatives d = derivatives(t(s));
        const dvec3 bend = glm::cross(d.first, d.second);
        return glm::dot(bend, d.third) / glm::dot(bend, bend);
      },
      "torsion");
}

TEST_F(PlotsReadTest, the_hodograph_page_shows_the_speed_over_t) {
  select(world::EntityKind::segment, 2);
  open(world::LabPage::hodograph);
  expect_graph(
      read("Laboratory/Speed plot"), kCurveColour, 0, 1, [&](double t) { return glm::length(derivatives(t).first); },
      "speed");
}

TEST_F(PlotsReadTest, forces_are_those_of_the_ride_by_distance_and_by_time) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetStartSpeed{18}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::LabView::seat>{world::Seat::car}).ok());
  open(world::LabPage::forces);
  const sim::SimulatedRide& ride = *edit::SessionFindings(session_).ride();
  const auto cars = static_cast<std::size_t>(ride.start.cars);
  for (const bool over_time : {false, true}) {
    if (over_time) click("Laboratory/By time");
    frames(3);
    std::vector<double> x;
    for (std::size_t i = 0; i * cars < ride.forces.size(); ++i)
      x.push_back(over_time ? static_cast<double>(ride.sample_of(i)) / 120 : ride.distance(ride.sample_of(i)));
    const auto over = [&x](const std::function<double(std::size_t)>& value) {
      return [&x, value](double at) {
        const auto above = std::lower_bound(x.begin() + 1, x.end() - 1, at);
        const auto i = static_cast<std::size_t>(above - x.begin());
        return std::lerp(value(i - 1), value(i), (at - x[i - 1]) / (x[i] - x[i - 1]));
      };
    };
    const std::string where = over_time ? " by time" : " by distance";
    expect_graph(read("Laboratory/Left plot"), row_colour(0), x.front(), x.back(),
                 over([&](std::size_t i) { return double{ride.forces[i * cars].up}; }), "vertical" + where);
    expect_graph(read("Laboratory/Right plot"), row_colour(6), x.front(), x.back(),
                 over([&](std::size_t i) { return ride.samples[ride.sample_of(i)].speed; }), "speed" + where);
  }
}

}  // namespace plots_read_test
}  // namespace coaster::ui
