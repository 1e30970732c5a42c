// Rules for the widgets of all panels, pages and screens together.
#include <gtest/gtest.h>

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/scratch_folder.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/all_parts_stage.h"
#include "ui/widgets/theme.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/camera_feel.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace all_widgets_test {

using world::Workspace;

class AllWidgetsTest : public AllPartsStage {
 protected:
  // What lies over the view: notices, first steps, the legend, progress, the end of a ride.
  void over_the_view(const std::function<void(const std::string& where)>& show) override {
    edit::notify(session_, edit::NoticeKind::warning, "The train is too slow for the hill at 34.5 m.");
    edit::notify(session_, edit::NoticeKind::error, "There is no such file.");
    show("notice");
    edit::notify(session_, edit::NoticeKind::info, "Saved.");
    frames(400);
    set<&world::EditingAids::show_hints>(true);
    show("first steps");
    set<&world::EditingAids::show_hints>(false);
    stats_.colour_high = 25;
    set<&world::LabView::colouring>(world::Colouring::speed);
    show("legend");
    set<&world::LabView::colouring>(world::Colouring::plain);
    base::JobProgress progress;
    progress.report(0.375);
    job_ = {&progress, "Import", "Fitting a track to the imported points"};
    show("job");
    job_ = {};
    movie_ = MovieState{.frames = 321, .ticks = 1234, .done = 0.25};
    show("movie");
    movie_.reset();
    set<&world::EditingAids::show_card>(true);
    good(edit::RideStart{});
    edit::advance(session_, 120 * 120);
    EXPECT_TRUE(session_.game.result);
    show("score card");
    for (const int medal : {0, 2}) {
      session_.game.result->verdict =
          edit::ChallengeVerdict{.medal = medal, .reason = "Lateral: you have 1.40 g at 87.0 m."};
      show("score card with medal " + std::to_string(medal));
    }
    click("Score/Details");
    show("score card with details");
    click("Score/Details");
    key(platform::Key::escape);
    good(edit::RideStop{});
    set<&world::EditingAids::show_card>(false);
    frames(400);  // notices of the ride
  }
  // The lists of triangles of the last frame: of the windows that show, and of what is drawn behind and before them.
  struct Drawn {
    std::string name;
    const ImDrawList* list;
    bool scrolls;
  };
  static std::vector<Drawn> drawn() {
    std::vector<Drawn> found{{"behind", ImGui::GetBackgroundDrawList(), false},
                             {"before", ImGui::GetForegroundDrawList(), false}};
    for (const ImGuiWindow* const window : windows()) {
      bool scrolls = false;
      for (const ImGuiWindow* w = window; w != nullptr; w = w->ParentWindow)
        scrolls = scrolls || w->ScrollMax.x > 0 || w->ScrollMax.y > 0;
      found.push_back({window->Name, window->DrawList, scrolls});
    }
    return found;
  }
  // The windows of the last frame that show.
  static std::vector<const ImGuiWindow*> windows() {
    std::vector<const ImGuiWindow*> found;
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
      if (window->Active && !window->Hidden) found.push_back(window);
    return found;
  }
};

TEST_F(AllWidgetsTest, kinds_and_states_are_those_that_scripts_know) {
  const std::set<std::string> kinds{"button", "radio", "checkbox", "slider", "number", "text", "cell", "combo",
                                    "header", "menu",  "item",     "label",  "plot",   "knob", "edge", "colour"};
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

// Every switch shows what a click made of it, and a second click takes it back.
TEST_F(AllWidgetsTest, every_checkbox_toggles_and_every_radio_is_chosen_alone) {
  std::set<std::string> tried;
  int boxes = 0, radios = 0;
  visit([&](const std::string& where) {
    if (where == "start screen" || where == "lesson") return;
    const std::vector<Widget> all = host_->widgets();
    for (const Widget& w : all) {
      const bool box = w.kind == "checkbox", radio = w.kind == "radio" && !w.path.starts_with("Menu/");
      if ((!box && !radio) || !w.visible || w.covered || !w.enabled || !tried.insert(w.path).second) continue;
      const auto value = [&] { return find(w.path) != nullptr ? find(w.path)->value : "gone"; };
      const std::string before = value();
      if (find(w.path) == nullptr || !find(w.path)->visible || find(w.path)->x != w.x || find(w.path)->y != w.y)
        continue;          // an earlier click has moved it
      std::string chosen;  // the radio that is on in the same rows
      for (const Widget& other : all)
        if (radio && other.kind == "radio" && other.value == "on" &&
            other.path.substr(0, other.path.find('/')) == w.path.substr(0, w.path.find('/')))
          chosen = other.path;
      click_at(middle(w));
      frames(2);
      if (box) {
        EXPECT_EQ(value(), before == "on" ? "off" : "on") << w.path << ", " << where;
        if (find(w.path) == nullptr) continue;
        click_at(middle(*find(w.path)));
        frames(2);
        EXPECT_EQ(value(), before) << w.path << ", " << where;
        ++boxes;
      } else {
        EXPECT_EQ(value(), "on") << w.path << ", " << where;
        if (const Widget* const former = find(chosen); former != nullptr && former->visible) click_at(middle(*former));
        frames(2);
        ++radios;
      }
    }
  });
  EXPECT_GT(boxes, 10);
  EXPECT_GT(radios, 5);
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
  set<&world::Appearance::ui_scale>(2.0f);
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

// The same for all that is drawn, by its colour: marks, icons, plots, frames and text.
TEST_F(AllWidgetsTest, at_twice_the_scale_all_ink_is_twice_as_far_away) {
  struct Box {
    ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
  };
  using Ink = std::map<std::pair<std::string, ImU32>, Box>;
  const auto inks = [&] {
    std::map<std::string, Ink> found;
    visit([&](const std::string& where) {
      Ink& ink = found[where];
      for (const Drawn& one : drawn())
        for (const ImDrawVert& v : one.list->VtxBuffer) {
          if ((v.col >> IM_COL32_A_SHIFT) == 0) continue;
          Box& box = ink[{one.name, v.col}];
          box.low = {std::min(box.low.x, v.pos.x), std::min(box.low.y, v.pos.y)};
          box.high = {std::max(box.high.x, v.pos.x), std::max(box.high.y, v.pos.y)};
        }
    });
    return found;
  };
  resize(1280, 800);
  const auto small = inks();
  restart();
  set<&world::Appearance::ui_scale>(2.0f);
  resize(2560, 1600);
  const auto large = inks();
  int compared = 0;
  for (const auto& [where, ink] : small)
    for (const auto& [key, a] : ink) {
      const auto other = large.at(where).find(key);
      if (other == large.at(where).end()) continue;
      const Box& b = other->second;
      ++compared;
      std::ostringstream place;
      place << std::hex << key.second << " in " << key.first << ", " << where;
      const auto expect_twice = [words = place.str()](float one, float two, const char* edge) {
        EXPECT_NEAR(two, 2 * one, 14 + 0.03f * std::abs(one)) << edge << " of " << words;
      };
      expect_twice(a.low.x, b.low.x, "left");
      expect_twice(a.high.x, b.high.x, "right");
      expect_twice(a.low.y, b.low.y, "top");
      expect_twice(a.high.y, b.high.y, "foot");
    }
  EXPECT_GT(compared, 300);
}

// A triangle's width and height. Of a thin one that lies aslant, a piece of a curve, how thick it is: curves are
// sampled anew at each size, and their pieces differ.
struct Shape {
  ImVec2 size;
  float thickness = 0;
  bool aslant = true;
  bool is_piece() const { return aslant && thickness < 4; }
};
Shape shape_of(const std::array<ImVec2, 3>& corners) {
  Shape shape;
  float longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ImVec2 a = corners[k], b = corners[(k + 1) % 3], edge(std::abs(b.x - a.x), std::abs(b.y - a.y));
    shape.size = {std::max(shape.size.x, edge.x), std::max(shape.size.y, edge.y)};
    shape.aslant = shape.aslant && edge.x > 0.01f && edge.y > 0.01f;
    longest = std::max(longest, std::hypot(edge.x, edge.y));
  }
  const ImVec2 a = corners[0], b = corners[1], c = corners[2];
  const float twice_area = std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
  if (longest > 0) shape.thickness = twice_area / longest;
  return shape;
}

// And for each shape by itself, in the order of drawing, where the same number of triangles is drawn (a larger circle
// has more): its width and height.
TEST_F(AllWidgetsTest, at_twice_the_scale_every_shape_is_twice_as_large) {
  using Shapes = std::map<std::pair<std::string, std::string>, std::vector<Shape>>;
  const auto shapes = [&] {
    Shapes found;
    visit([&](const std::string& where) {
      for (const Drawn& one : drawn()) {
        const ImDrawList& list = *one.list;
        std::vector<char> is_glyph(static_cast<std::size_t>(list.VtxBuffer.Size), 0);
        for (const DrawnGlyph& glyph : drawn_glyphs(list))
          for (int k = 0; k < 4; ++k) is_glyph[static_cast<std::size_t>(glyph.vertex + k)] = 1;
        std::vector<Shape>& sizes = found[{where, one.name}];
        for (int i = 0; i + 2 < list.IdxBuffer.Size; i += 3) {
          if (is_glyph[list.IdxBuffer[i]] != 0) continue;
          const auto corner = [&](int k) { return list.VtxBuffer[list.IdxBuffer[i + k]].pos; };
          sizes.push_back(shape_of({corner(0), corner(1), corner(2)}));
        }
      }
    });
    return found;
  };
  resize(1280, 800);
  const Shapes small = shapes();
  restart();
  set<&world::Appearance::ui_scale>(2.0f);
  resize(2560, 1600);
  const Shapes large = shapes();
  int compared = 0;
  for (const auto& [place, sizes] : small) {
    const auto other = large.find(place);
    if (other == large.end() || other->second.size() != sizes.size()) continue;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const Shape &one = sizes[i], &two = other->second[i];
      ++compared;
      const auto expect_twice = [&, &at = place](float small_one, float large_one) {
        EXPECT_NEAR(large_one, 2 * small_one, 5 + 0.05f * small_one) << i << " in " << at.second << ", " << at.first;
      };
      if (one.is_piece() || two.is_piece()) expect_twice(one.thickness, two.thickness);
      else expect_twice(one.size.x, two.size.x), expect_twice(one.size.y, two.size.y);
    }
  }
  EXPECT_GT(compared, 1000);
}

// No character is drawn over another one of its window, and none is cut at the left or right.
TEST_F(AllWidgetsTest, text_keeps_apart_and_within_its_window) {
  int characters = 0;
  visit([&](const std::string& where) {
    for (const Drawn& one : drawn()) {
      std::vector<std::pair<DrawnGlyph, ImVec4>> shown;
      const std::vector<DrawnGlyph> all = drawn_glyphs(*one.list);
      for (const ImDrawCmd& command : one.list->CmdBuffer) {
        std::vector<char> used(static_cast<std::size_t>(one.list->VtxBuffer.Size), 0);
        for (unsigned i = 0; i < command.ElemCount; ++i)
          used[one.list->IdxBuffer[static_cast<int>(command.IdxOffset + i)]] = 1;
        for (const DrawnGlyph& glyph : all) {
          if (used[static_cast<std::size_t>(glyph.vertex)] == 0) continue;
          const ImVec4& clip = command.ClipRect;
          if (glyph.high.y < clip.y || glyph.low.y > clip.w) continue;  // scrolled out of sight
          shown.emplace_back(glyph, clip);
        }
      }
      std::stable_sort(shown.begin(), shown.end(),
                       [](const auto& x, const auto& y) { return x.first.low.y < y.first.low.y; });
      for (std::size_t i = 0; i < shown.size(); ++i) {
        const auto& [g, clip] = shown[i];
        ++characters;
        EXPECT_TRUE(g.low.x > clip.x - 1.5f && g.high.x < clip.z + 1.5f)
            << static_cast<char>(g.codepoint) << " is cut at " << g.low.x << ", " << g.low.y << " in " << one.name
            << ", " << where;
        for (std::size_t k = i + 1; k < shown.size() && shown[k].first.low.y < g.high.y - 1.5f; ++k) {
          const DrawnGlyph& h = shown[k].first;
          const float wide = std::min(g.high.x, h.high.x) - std::max(g.low.x, h.low.x),
                      high = std::min(g.high.y, h.high.y) - h.low.y;
          EXPECT_FALSE(wide > 1.5f && high > 1.5f)
              << static_cast<char>(g.codepoint) << " over " << static_cast<char>(h.codepoint) << " at " << g.low.x
              << ", " << g.low.y << " in " << one.name << ", " << where;
        }
      }
    }
  });
  EXPECT_GT(characters, 10'000);
}

// Text over the view has a ground that was drawn before it, so that it can be read over any scene.
TEST_F(AllWidgetsTest, text_over_the_view_has_a_ground) {
  int characters = 0;
  visit([&](const std::string& where) {
    for (const ImDrawList* const list : {ImGui::GetBackgroundDrawList(), ImGui::GetForegroundDrawList()}) {
      std::vector<char> is_glyph(static_cast<std::size_t>(list->VtxBuffer.Size), 0);
      const std::vector<DrawnGlyph> glyphs = drawn_glyphs(*list);
      for (const DrawnGlyph& glyph : glyphs)
        for (int k = 0; k < 4; ++k) is_glyph[static_cast<std::size_t>(glyph.vertex + k)] = 1;
      const auto covered = [&](const DrawnGlyph& glyph, ImVec2 p) {
        for (int i = 0; i + 2 < list->IdxBuffer.Size; i += 3) {
          const int first = list->IdxBuffer[i];
          if (first >= glyph.vertex) return false;
          if (is_glyph[static_cast<std::size_t>(first)] != 0) continue;
          const ImDrawVert &a = list->VtxBuffer[first], &b = list->VtxBuffer[list->IdxBuffer[i + 1]],
                           &c = list->VtxBuffer[list->IdxBuffer[i + 2]];
          if ((a.col >> IM_COL32_A_SHIFT) < 100) continue;
          const auto side = [&](ImVec2 from, ImVec2 to) {
            return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
          };
          const float x = side(a.pos, b.pos), y = side(b.pos, c.pos), z = side(c.pos, a.pos);
          if ((x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0)) return true;
        }
        return false;
      };
      for (const DrawnGlyph& glyph : glyphs) {
        ++characters;
        EXPECT_TRUE(covered(glyph, glyph.low) && covered(glyph, glyph.high))
            << static_cast<char>(glyph.codepoint) << " at " << glyph.low.x << ", " << glyph.low.y << ", " << where;
      }
    }
  });
  EXPECT_GT(characters, 100);
}

// Nothing is drawn where it cannot be seen, but for what scrolls, plots, and lists that are cut.
TEST_F(AllWidgetsTest, what_is_drawn_can_be_seen) {
  visit([&](const std::string& where) {
    for (const Drawn& one : drawn()) {
      if (one.scrolls) continue;
      const ImDrawList& list = *one.list;
      for (const ImDrawCmd& command : list.CmdBuffer)
        for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
          ImVec2 low(1e9f, 1e9f), high(-1e9f, -1e9f);
          unsigned alpha = 0;
          for (unsigned k = 0; k < 3; ++k) {
            const ImDrawVert& v = list.VtxBuffer[list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)]];
            low = {std::min(low.x, v.pos.x), std::min(low.y, v.pos.y)};
            high = {std::max(high.x, v.pos.x), std::max(high.y, v.pos.y)};
            alpha = std::max(alpha, v.col >> IM_COL32_A_SHIFT);
          }
          if (alpha == 0) continue;
          const ImVec4& clip = command.ClipRect;
          EXPECT_TRUE(high.x > clip.x - 1 && low.x < clip.z + 1 && high.y > clip.y - 1 && low.y < clip.w)
              << low.x << ", " << low.y << " to " << high.x << ", " << high.y << " in " << one.name << ", " << where;
        }
    }
  });
}

// What a button, a switch or a line of a list is called, or its value, is written on it.
TEST_F(AllWidgetsTest, names_are_written_where_the_widgets_are) {
  int named = 0;
  visit([&](const std::string& where) {
    std::vector<DrawnGlyph> all;
    for (const ImGuiWindow* const window : windows())
      for (const DrawnGlyph& glyph : drawn_glyphs(*window->DrawList)) all.push_back(glyph);
    for (const Widget& w : host_->widgets()) {
      if (!w.visible || w.covered || (w.kind != "button" && w.kind != "radio" && w.kind != "checkbox")) continue;
      // Samples are named once their pictures are there, and keys are not always set.
      if (w.path.starts_with("Start/Samples/") || w.path.starts_with("Settings/Keys/")) continue;
      std::string words;
      for (const DrawnGlyph& g : all) {
        const float x = (g.low.x + g.high.x) / 2, y = (g.low.y + g.high.y) / 2;
        if (x > w.x && x < w.x + w.width && y > w.y && y < w.y + w.height)
          words += g.codepoint < 128 ? static_cast<char>(g.codepoint) : '?';
      }
      std::string name = w.path.substr(w.path.rfind('/') + 1);
      std::erase(name, ' ');
      std::string value = w.value;
      std::erase(value, ' ');
      if (words.empty() && w.kind == "button" && w.width < 60) continue;  // an icon
      ++named;
      EXPECT_TRUE(words.find(name.substr(0, 5)) != std::string::npos ||
                  (!value.empty() && words.find(value.substr(0, 5)) != std::string::npos))
          << w.path << " has the words " << words << ", " << where;
    }
  });
  EXPECT_GT(named, 500);
}

// The chosen tab alone has a line in the colour of the accent, along its foot.
TEST_F(AllWidgetsTest, the_tab_of_the_workspace_is_underlined) {
  for (const Workspace one : {Workspace::build, Workspace::ride, Workspace::laboratory}) {
    set<&world::Panels::workspace>(one);
    frames(3);
    for (const Widget& w : host_->widgets()) {
      if (!w.path.starts_with("Menu/Workspace/")) continue;
      int at_foot = 0, elsewhere = 0;
      for (const ImGuiWindow* const window : windows())
        for (const ImDrawVert& v : window->DrawList->VtxBuffer) {
          if (v.col != packed(palette().accent) || v.pos.x < w.x || v.pos.x > w.x + w.width ||
              v.pos.y > w.y + w.height + 9)
            continue;
          const float over = w.y + w.height - v.pos.y;
          (over >= 0 && over < 4 ? at_foot : elsewhere) += 1;
        }
      EXPECT_EQ(at_foot >= 4, w.value == "on") << w.path;
      EXPECT_TRUE(w.value != "on" || elsewhere == 0) << w.path;
    }
  }
}

// With reduced motion nothing moves by the clock alone.
TEST_F(AllWidgetsTest, with_reduced_motion_a_still_picture_stays_still) {
  set<&world::CameraFeel::reduced_motion>(true);
  const auto ink = [] {
    std::vector<float> all;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i)
      for (const ImDrawVert& v : data.CmdLists[i]->VtxBuffer)
        all.insert(all.end(), {v.pos.x, v.pos.y, static_cast<float>(v.col)});
    return all;
  };
  visit([&](const std::string& where) {
    frames(14);  // a dialog darkens what is behind it
    const std::vector<float> before = ink();
    frames(11);
    EXPECT_TRUE(ink() == before) << where;
  });
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
  select(world::EntityKind::segment, 1);
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
