// The strip of the laboratory and its pages (ui/lab/strips.h).
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "curve/bernstein.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "ui/widgets/widgets.h"
#include "world/appearance_settings.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace laboratory_test {

struct LaboratoryTest : Stage {
  void open(const std::string& page) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_laboratory>{true}).ok());
    frames(2);
    if (find("Laboratory/" + page) != nullptr) click("Laboratory/" + page);
    else click("Laboratory/Page/" + page);
    frames(2);
  }
  static std::vector<std::string> pages() {
    std::vector<std::string> names;
    for (const base::NameRow& page : world::kLabPages) names.emplace_back(page.label);
    return names;
  }
  double number_shown(const std::string& path) const {
    const Widget* widget = find(path);
    return widget != nullptr ? std::strtod(widget->value.c_str(), nullptr) : -1e300;
  }
};

// Where the pages' names have no room, a list takes their place, and the mark alone is too small to find.
TEST_F(LaboratoryTest, its_bar_has_its_name_in_a_small_window_at_a_large_scale) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{1.5f}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::laboratory}).ok());
  resize(1280, 720);
  frames(3);
  ASSERT_NE(find("Laboratory/Page"), nullptr) << "a list";
  EXPECT_GT(find("Laboratory")->width, 3 * find("Laboratory")->height);
  click("Laboratory");
  EXPECT_TRUE(session_.settings.panels->show_laboratory);
}

TEST_F(LaboratoryTest, the_strip_starts_folded_and_its_bar_opens_and_folds_it) {
  frames(2);
  ASSERT_NE(find("Laboratory"), nullptr);
  EXPECT_EQ(find("Laboratory")->value, "closed");
  const float before = host_->view().viewport.height;
  click("Laboratory");
  EXPECT_TRUE(session_.settings.panels->show_laboratory);
  frames(2);
  EXPECT_LT(host_->view().viewport.height, before - 100);
  click("Laboratory");
  EXPECT_FALSE(session_.settings.panels->show_laboratory);
  click("Laboratory/Joints");  // a page's name opens the strip at that page
  EXPECT_TRUE(session_.settings.panels->show_laboratory);
  EXPECT_EQ(session_.settings.lab->page, world::LabPage::joints);
}

TEST_F(LaboratoryTest, every_page_draws_for_every_selection_with_paths_of_its_own) {
  for (const std::string& page : pages()) {
    open(page);
    for (const auto& [kind, number] :
         {std::pair{world::EntityKind::knot, 2u}, {world::EntityKind::segment, 1u}, {world::EntityKind::cart, 1u}}) {
      select(kind, number);
      std::set<std::string> paths;
      std::size_t inside = 0;
      for (const Widget& widget : host_->widgets()) {
        EXPECT_TRUE(paths.insert(widget.path).second) << widget.path << " twice on " << page;
        EXPECT_TRUE(widget.alias.empty() || paths.insert(widget.alias).second) << widget.alias << " twice on " << page;
        inside += widget.path.starts_with("Laboratory/") ? 1 : 0;
      }
      EXPECT_GT(inside, pages().size() + 2) << page;
    }
  }
}

TEST_F(LaboratoryTest, pages_lie_in_the_strip_in_every_window_and_nothing_is_cut) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {640, 360}}) {
    resize(width, height);
    for (std::size_t page = 0; page < pages().size(); ++page) {
      ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_laboratory>{true}).ok());
      ASSERT_TRUE(
          edit::apply(session_, files_, edit::Set<&world::LabView::page>{static_cast<world::LabPage>(page)}).ok());
      frames(2);
      std::vector<std::string> paths;
      for (const Widget& widget : host_->widgets())
        if (widget.path.starts_with("Laboratory")) paths.push_back(widget.path);
      const view::Viewport scene = host_->view().viewport;
      for (const std::string& path : paths) {
        const Widget& w = *find(path);
        if (!w.visible) continue;
        EXPECT_GE(w.y + w.height / 2, scene.y + scene.height) << path << " lies over the viewport at " << width;
        EXPECT_GE(w.x, scene.x - 0.5f) << path << " at " << width;
        EXPECT_LE(w.x + w.width, scene.x + scene.width + 0.5f) << path << " at " << width;
      }
    }
  }
}

TEST_F(LaboratoryTest, no_number_is_cut_in_a_small_window_at_a_large_scale) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::laboratory}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_laboratory>{true}).ok());
  select(world::EntityKind::segment, 1);
  for (const float scale : {1.0f, 1.5f}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{scale}).ok());
    for (std::size_t page = 0; page < pages().size(); ++page) {
      ASSERT_TRUE(
          edit::apply(session_, files_, edit::Set<&world::LabView::page>{static_cast<world::LabPage>(page)}).ok());
      frames(3);
      for (const Widget& widget : host_->widgets()) EXPECT_FALSE(widget.cut) << widget.path << " at " << scale;
    }
  }
}

TEST_F(LaboratoryTest, measured_numbers_are_whole_and_every_column_is_in_sight) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::laboratory}).ok());
  open("Measurements");
  sim::Measurement& measured = session_.measuring.measurement;
  measured = sim::start_measurement(session_.derived);
  measured.running = false;
  for (const double error : {1.234e-7, 8.88e-10, 0.0456})
    for (const float scale : {1.0f, 1.5f})
      for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}}) {
        ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{scale}).ok());
        for (sim::MeasuredRow& row : measured.rows) row.cells.fill({4321.09, error, 1});
        resize(width, height);
        for (const bool time : {false, true}) {
          if (const char* side = time ? "Laboratory/Time" : "Laboratory/Worst error"; find(side) != nullptr)
            click(side);
          frames(2);
          const std::string where = std::to_string(width) + " at scale " + std::to_string(scale);
          const Widget* const row = find(time ? "Laboratory/Time of Horner" : "Laboratory/Error of Horner");
          ASSERT_NE(row, nullptr) << where;
          EXPECT_FALSE(row->cut) << row->value << ", " << where;
          if (width < 1500 && scale > 1) continue;  // the table scrolls sideways
          const Widget* const last = find(time ? "Laboratory/Times/4096" : "Laboratory/Errors/4096");
          ASSERT_NE(last, nullptr) << where;
          EXPECT_TRUE(last->visible) << where;
          EXPECT_LE(last->x + last->width, host_->view().viewport.x + host_->view().viewport.width) << where;
        }
      }
}

// Each number has a ground between dark green for the smallest and dark red for the largest, by the logarithm.
TEST_F(LaboratoryTest, measured_numbers_are_coloured_from_green_to_red) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::laboratory}).ok());
  resize(1920, 1080);
  open("Measurements");
  sim::Measurement& measured = session_.measuring.measurement;
  measured = sim::start_measurement(session_.derived);
  measured.running = false;
  for (sim::MeasuredRow& row : measured.rows) row.cells.fill({10, 1e-6, 1});
  measured.rows[1].cells[2] = {1000, 1e-6, 1};
  measured.rows[2].cells.fill({100, 1e-6, 1});
  frames(3);
  const auto ground = [](ImVec4 of) {
    int found = 0;
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
      if (window->Active && !window->Hidden)
        for (const ImDrawVert& v : window->DrawList->VtxBuffer) found += v.col == ImGui::ColorConvertFloat4ToU32(of);
    return found / 4;
  };
  const auto at = [](double share) {
    const auto mix = [&](double from, double to) {
      return static_cast<float>(std::lround(from + share * (to - from)) / 255.0);
    };
    return ImVec4(mix(0x1E, 0x52), mix(0x45, 0x2C), mix(0x38, 0x2E), 1);
  };
  EXPECT_EQ(ground(at(1)), 1) << "the one of 1000 ns";
  EXPECT_EQ(ground(at(0.5)), 5) << "the row of 100 ns";
  EXPECT_GT(ground(at(0)), 25);
}

TEST_F(LaboratoryTest, every_plot_can_be_reached_in_a_small_window_at_a_large_scale) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::laboratory}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_laboratory>{true}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{1.5f}).ok());
  const std::pair<world::LabPage, const char*> plots[] = {{world::LabPage::frames, "Laboratory/Curvature plot"},
                                                          {world::LabPage::frames, "Laboratory/Torsion plot"},
                                                          {world::LabPage::forces, "Laboratory/Left plot"},
                                                          {world::LabPage::forces, "Laboratory/Right plot"}};
  for (const auto& [page, plot] : plots) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::LabView::page>{page}).ok());
    frames(3);
    for (int i = 0; i < 20 && !find(plot)->visible; ++i) {
      frame({platform::MouseMove{middle(*find(plot)).x, static_cast<float>(height_) - 80}, platform::Wheel{0, -1}});
      frame();
    }
    EXPECT_TRUE(find(plot)->visible) << plot;
  }
}

TEST_F(LaboratoryTest, dragging_in_a_plot_moves_the_probe_and_weights_follow) {
  select(world::EntityKind::segment, 2);
  open("Weights");
  const Widget plot = *find("Laboratory/Weights plot");
  EXPECT_EQ(plot.kind, "plot");
  hover(middle(plot));
  press();
  hover({plot.x + 0.8f * plot.width, plot.y + plot.height / 2});
  release();
  frames(2);
  EXPECT_NEAR(session_.settings.selected_t, 0.8, 2.0 / plot.width);
  double weights[4];
  curve::bernstein_basis<double>(session_.settings.selected_t, weights);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(number_shown("Laboratory/B" + std::to_string(i)), weights[i], 6e-5) << i;
}

TEST_F(LaboratoryTest, weights_of_every_degree_are_written_and_of_a_cubic_with_their_points) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{{{world::EntityKind::segment, 1}}, 0.31}).ok());
  resize(1280, 1080);
  open("Weights");
  for (int degree = 1; degree <= 8; ++degree) {
    type("Laboratory/Degree n", std::to_string(degree));
    frames(3);
    std::string written;
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
      if (window->Active && !window->Hidden)
        for (const DrawnGlyph& g : drawn_glyphs(*window->DrawList))
          written += g.codepoint >= 0x2080 && g.codepoint <= 0x2089 ? static_cast<char>('0' + g.codepoint - 0x2080)
                     : g.codepoint < 128                            ? static_cast<char>(g.codepoint)
                                                                    : '?';
    double choose = 1;  // binomial coefficient
    for (int i = 0; i <= degree; ++i) {
      const std::string digit = std::to_string(i),
                        value = fixed(choose * std::pow(0.31, i) * std::pow(0.69, degree - i), 4);
      const std::string row = "B" + digit + (degree == 3 ? "weighsp" + digit : "") + value;
      EXPECT_NE(written.find(row), std::string::npos) << row << " of degree " << degree;
      EXPECT_EQ(find("Laboratory/B" + digit)->value, value);
      choose *= static_cast<double>(degree - i) / (i + 1);
    }
    EXPECT_EQ(find("Laboratory/B" + std::to_string(degree + 1)), nullptr);
  }
}

TEST_F(LaboratoryTest, the_construction_shows_the_point_of_the_curve) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{{{world::EntityKind::segment, 1}}, 0.3}).ok());
  open("Construction");
  const glm::dvec3 exact =
      curve::point_long_double(world::cubic_of(session_.document, entity(world::EntityKind::segment, 1)), 0.3);
  const Widget* shown = find("Laboratory/B(t)");
  ASSERT_NE(shown, nullptr);
  EXPECT_EQ(shown->value, fixed(exact.x, 3) + " " + fixed(exact.y, 3) + " " + fixed(exact.z, 3) + " m");
}

TEST_F(LaboratoryTest, a_still_frame_measures_nothing_again) {
  int asked = 0;
  session_.measuring.clock = [&] { return ++asked * 1e-3; };
  select(world::EntityKind::segment, 1);
  open("Lengths");
  frames(3);
  EXPECT_GT(asked, 0);
  const int before = asked;
  commands_.clear();
  frames(5);
  EXPECT_EQ(asked, before);
  EXPECT_TRUE(commands_.empty());
}

TEST_F(LaboratoryTest, a_row_of_the_joints_selects_its_knot_and_the_button_mends_it) {
  const edit::Target second{{world::EntityKind::knot, 2}};
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetJoint{second, world::JointKind::aligned}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetHandleLengths{second, 2.1f, 9.7f}).ok());  // unequal curvature
  open("Joints");
  click("Laboratory/Joint k2");
  ASSERT_EQ(all<edit::Select>().size(), 1u);
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2));
  frames(2);
  ASSERT_TRUE(find("Laboratory/Make G2")->enabled);
  click("Laboratory/Make G2");
  EXPECT_EQ(all<edit::MakeG2>().size(), 1u);
}

TEST_F(LaboratoryTest, joints_are_listed_by_their_jolts_though_the_train_stands) {
  // A slow joint whose curvature jumps more, at the top, and a fast one that jumps less, at the bottom.
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());
  for (const glm::vec3 place : {glm::vec3(-11, 31, 3), {1, 30, 3}, {40, 3, 3}, {90, 4, 3}, {140, 5, 3}})
    ASSERT_TRUE(edit::apply(session_, files_, edit::AppendKnot{place}).ok());
  const auto lengths = [&](std::uint32_t knot, float in, float out) {
    const edit::Target target{{world::EntityKind::knot, knot}};
    ASSERT_TRUE(edit::apply(session_, files_, edit::SetJoint{target, world::JointKind::aligned}).ok());
    ASSERT_TRUE(edit::apply(session_, files_, edit::SetHandleLengths{target, in, out}).ok());
  };
  lengths(2, 2, 6);
  lengths(3, 9, 18);
  open("Joints");
  EXPECT_EQ(session_.motion.state, world::RideState::stopped);
  const Widget *const slow = find("Laboratory/Joint k2"), *const fast = find("Laboratory/Joint k3");
  ASSERT_TRUE(slow != nullptr && fast != nullptr);
  EXPECT_LT(fast->y, slow->y);
  click("Laboratory/Track order");
  frames(2);
  EXPECT_GT(find("Laboratory/Joint k3")->y, find("Laboratory/Joint k2")->y);
}

TEST_F(LaboratoryTest, without_a_segment_pages_say_what_to_do) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());
  for (const std::string& page : pages()) {
    open(page);
    if (page == "Joints" || page == "Measurements") continue;  // they speak of the whole track
    EXPECT_NE(find("Laboratory/No segment"), nullptr) << page;
  }
}

}  // namespace laboratory_test
}  // namespace coaster::ui
