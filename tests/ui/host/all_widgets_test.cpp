// Rules for the widgets of all panels, pages and screens together.
#include <gtest/gtest.h>

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/scratch_folder.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_force.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aids.h"
#include "world/lab_view.h"
#include "world/look.h"
#include "world/panels.h"

namespace coaster::ui {
namespace all_widgets_test {

using world::Workspace;

class AllWidgetsTest : public Stage {
 protected:
  void SetUp() override {
    Stage::SetUp();
    good(edit::SetStartSpeed{18});
    good(edit::AddForce{});
    good(edit::PlaceElement{world::usual_element(world::ElementKind::straight)});
    good(edit::StartChallenge{(std::filesystem::path(COASTER_SOURCE_DIR) / "challenges/01_first_hill.json").string()});
  }
  void good(const edit::Command& command) {
    const base::Status status = edit::apply(session_, files_, command);
    EXPECT_TRUE(status.ok()) << status.message;
  }
  template <auto Member>
  void set(world::ValueOf<Member> to) {
    good(edit::Set<Member>{to});
  }

  // Shows every panel, page and screen, one after the other.
  void visit(const std::function<void(const std::string& where)>& look) {
    const auto show = [&](const std::string& where) {
      frames(3);
      look(where);
    };
    for (const Workspace one : {Workspace::build, Workspace::ride, Workspace::laboratory, Workspace::all}) {
      set<&world::Panels::workspace>(one);
      const std::string where(base::name_of(one));
      good(edit::Select{});
      show(where);
      for (const auto& [kind, number] :
           {std::pair{world::Kind::knot, 2u}, {world::Kind::segment, 1u}, {world::Kind::section, 1u}}) {
        if (!entity(kind, number).valid()) continue;
        select(kind, number);
        show(where + " with a selection");
      }
      set<&world::Aids::show_element>(true);
      show(where + " with an element");
      set<&world::Aids::show_element>(false);
    }
    set<&world::Panels::workspace>(Workspace::laboratory);
    set<&world::Panels::show_laboratory>(true);
    for (std::size_t page = 0; page < std::size(world::kLabPages); ++page) {
      set<&world::LabView::page>(static_cast<world::LabPage>(page));
      show("page " + std::string(world::kLabPages[page].label));
    }
    set<&world::Panels::show_laboratory>(false);
    set<&world::Panels::workspace>(Workspace::all);
    user_.emplace();
    host_->show_start();
    show("start screen");
    key(platform::Key::escape);
    frames(2);
  }
};

TEST_F(AllWidgetsTest, kinds_and_states_are_those_that_scripts_know) {
  const std::set<std::string> kinds{"button", "radio", "checkbox", "slider", "number", "text", "cell", "combo",
                                    "header", "menu",  "item",     "label",  "plot",   "knob", "edge"};
  std::set<std::string> seen;
  visit([&](const std::string& where) {
    for (const Widget& w : host_->widgets()) {
      EXPECT_TRUE(kinds.contains(w.kind)) << w.path << " is a \"" << w.kind << "\", " << where;
      seen.insert(w.kind);
      if (w.kind == "radio" || w.kind == "checkbox") {
        EXPECT_TRUE(w.value == "on" || w.value == "off") << w.path << ": " << w.value;
      }
      if (w.kind == "header") {
        EXPECT_TRUE(w.value == "open" || w.value == "closed") << w.path << ": " << w.value;
      }
      EXPECT_GT(w.width, 0) << w.path << ", " << where;
      EXPECT_GT(w.height, 0) << w.path << ", " << where;
    }
  });
  for (const char* const kind :
       {"button", "radio", "checkbox", "slider", "number", "text", "combo", "header", "menu", "label", "plot"})
    EXPECT_TRUE(seen.contains(kind)) << kind;
}

// On a screen with twice as many pixels, everything is twice as large and at twice the distance, within the rounding of
// text.
TEST_F(AllWidgetsTest, at_twice_the_scale_everything_is_twice_as_large) {
  using Places = std::map<std::string, std::map<std::string, Widget>>;
  const auto places = [&] {
    Places found;
    visit([&](const std::string& where) {
      for (const Widget& w : host_->widgets()) found[where].try_emplace(w.path, w);
    });
    return found;
  };
  resize(1280, 800);
  const Places small = places();
  restart();
  set<&world::Look::ui_scale>(2.0f);
  resize(2560, 1600);
  const Places large = places();
  int compared = 0;
  for (const auto& [where, widgets] : small)
    for (const auto& [path, a] : widgets) {
      const auto other = large.at(where).find(path);
      if (!a.visible || other == large.at(where).end()) continue;
      const Widget& b = other->second;
      ++compared;
      EXPECT_NEAR(b.x, 2 * a.x, 12 + 0.02f * a.x) << path << ", " << where;
      EXPECT_NEAR(b.y, 2 * a.y, 12 + 0.03f * a.y) << path << ", " << where;
      EXPECT_NEAR(b.width, 2 * a.width, 8 + 0.06f * a.width) << path << ", " << where;
      EXPECT_NEAR(b.height, 2 * a.height, 6 + 0.06f * a.height) << path << ", " << where;
    }
  EXPECT_GT(compared, 1000);
}

// Labels and fields of a panel begin at one left edge, or to the right of another widget in their row; those that take
// the rest of a row end at one right edge.
TEST_F(AllWidgetsTest, rows_of_a_panel_are_aligned) {
  visit([&](const std::string& where) {
    std::map<std::string, std::vector<Widget>> panels;
    for (const Widget& w : host_->widgets())
      if (w.visible && (w.kind == "number" || w.kind == "slider" || w.kind == "combo"))
        panels[w.path.substr(0, w.path.find('/'))].push_back(w);
    for (const auto& [panel, widgets] : panels) {
      if (panel == "Laboratory" || panel == "Ride" || panel == "Status" || panel == "Menu" || panel == "Sections")
        continue;
      float right = 0;
      for (const Widget& w : widgets) right = std::max(right, w.x + w.width);
      for (const Widget& w : widgets) {
        const bool row_goes_on = std::any_of(widgets.begin(), widgets.end(), [&](const Widget& other) {
          return std::abs(other.y - w.y) < 2 && other.x > w.x + w.width - 1;
        });
        EXPECT_TRUE(row_goes_on || std::abs(w.x + w.width - right) < 1.5f)
            << w.path << " ends at " << w.x + w.width << ", others at " << right << ", " << where;
      }
    }
  });
}

// Pages with settings beside their pictures begin where the strip's other pages do.
TEST_F(AllWidgetsTest, pages_of_the_laboratory_begin_at_one_edge) {
  set<&world::Panels::workspace>(Workspace::laboratory);
  set<&world::Panels::show_laboratory>(true);
  select(world::Kind::segment, 1);
  std::map<std::string, float> edges;
  for (std::size_t page = 0; page < std::size(world::kLabPages); ++page) {
    if (static_cast<world::LabPage>(page) == world::LabPage::errata) continue;  // a table
    set<&world::LabView::page>(static_cast<world::LabPage>(page));
    frames(3);
    float bar = 0, left = 1e9f;
    for (const Widget& w : host_->widgets())
      if (w.path == "Laboratory") bar = w.y + w.height;
    for (const Widget& w : host_->widgets())
      if (w.path.starts_with("Laboratory/") && w.y > bar && w.kind != "edge") left = std::min(left, w.x);
    edges[std::string(world::kLabPages[page].label)] = left;
  }
  for (const auto& [page, left] : edges) EXPECT_NEAR(left, edges.begin()->second, 1.01) << page;
}

}  // namespace all_widgets_test
}  // namespace coaster::ui
