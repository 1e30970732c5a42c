#include "ui/actions/actions.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace actions_test {

struct ActionsTest : Stage {};

TEST(action_table, no_key_is_given_twice_and_every_row_is_explained) {
  for (const Action& a : actions()) {
    EXPECT_FALSE(a.help.empty()) << a.name;
    EXPECT_EQ(a.enabled.otherwise.empty(), a.enabled.holds == kAlways.holds) << a.name;
    for (const Action& b : actions())
      for (const platform::KeyChord& chord : {a.chord, a.other}) {
        if (&a == &b || chord.key == platform::Key::unknown) continue;
        EXPECT_TRUE(chord != b.chord && chord != b.other) << a.name << ", " << b.name;
      }
  }
}

TEST(action_table, the_menu_file_ends_with_quit) {
  std::string_view last;
  for (const Action& a : actions())
    if (a.menu == "File") last = a.name;
  EXPECT_EQ(last, "Quit");
}

// A menu that is higher than the window covers its own title, and needs the wheel.
TEST_F(ActionsTest, every_menu_fits_a_small_window_at_both_scales_and_leaves_its_bar_free) {
  for (const float scale : {1.0f, 1.5f}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Appearance::ui_scale>{scale}).ok());
    frames(3);
    std::size_t items = 0;
    std::vector<std::string_view> menus;
    for (const Action& action : actions())
      if (!action.menu.empty() && std::ranges::find(menus, action.menu) == menus.end()) menus.push_back(action.menu);
    for (const std::string_view menu : menus) {
      SCOPED_TRACE(fmt::format("{} at scale {}", menu, scale));
      for (std::size_t end = menu.find('/');; end = menu.find('/', end + 1)) {
        click(fmt::format("Menu/{}", menu.substr(0, end)));
        frames(2);
        if (end == std::string_view::npos) break;
      }
      const float bar = find("Menu/File")->y + find("Menu/File")->height;
      for (const Widget& widget : host_->widgets()) {
        const bool inside = widget.kind == "menu" && widget.path.starts_with(fmt::format("Menu/{}/", menu));
        if (!inside) continue;
        ++items;
        EXPECT_TRUE(widget.visible) << widget.path;
        EXPECT_GE(widget.y, bar - 0.5f) << widget.path;
        EXPECT_LE(widget.y + widget.height, 720) << widget.path;
        EXPECT_LE(widget.x + widget.width, 1280) << widget.path;
      }
      for (int i = 0; i < 3; ++i) key(platform::Key::escape);
      frames(2);
    }
    std::size_t in_menus = 0;
    for (const Action& action : actions()) in_menus += !action.menu.empty();
    EXPECT_GE(items, in_menus);
  }
}

TEST_F(ActionsTest, tab_gives_the_viewport_the_whole_window_and_back) {
  frames(2);
  ASSERT_LT(host_->view().viewport.width, 700);
  key(platform::Key::tab);
  frame();
  EXPECT_FALSE(session_.settings.panels->show_panels);
  EXPECT_TRUE(host_->widgets().empty());
  EXPECT_EQ(host_->view().viewport.width, 1280);
  EXPECT_EQ(host_->view().viewport.height, 720);
  key(platform::Key::tab);
  frame();
  EXPECT_NE(find("Track/Name"), nullptr);
}

TEST_F(ActionsTest, undo_and_both_redo_keys) {
  const auto before = world::hash(session_.document);
  select(world::EntityKind::knot, 2);
  key(platform::Key::del);
  const auto after = world::hash(session_.document);
  ASSERT_NE(after, before);
  key(platform::Key::z, {.ctrl = true});
  EXPECT_EQ(world::hash(session_.document), before);
  key(platform::Key::z, {.shift = true, .ctrl = true});
  EXPECT_EQ(world::hash(session_.document), after);
  key(platform::Key::z, {.ctrl = true});
  key(platform::Key::y, {.ctrl = true});
  EXPECT_EQ(world::hash(session_.document), after);
}

TEST_F(ActionsTest, a_key_that_cannot_work_says_what_it_needs) {
  for (const auto& [chord, needed] : {std::pair{platform::Key::g, "Select a knot first."},
                                      {platform::Key::j, "No ride has failed."},
                                      {platform::Key::i, "Point at the track or select a segment first."}}) {
    key(chord);
    EXPECT_EQ(host_->toast(), needed);
  }
  select(world::EntityKind::knot, 2);
  key(platform::Key::g);
  EXPECT_NE(host_->toast(), "Select a knot first.");
}

TEST_F(ActionsTest, nothing_is_appended_to_a_closed_track_and_each_way_to_do_it_says_so) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetClosed{true}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  frames(3);
  key(platform::Key::a);
  EXPECT_FALSE(session_.settings.aids->append_mode);
  EXPECT_EQ(host_->toast(), "The track is closed: open it first (Closed in the Track panel).");
  EXPECT_FALSE(find("Elements/Draw knots")->enabled);
  EXPECT_FALSE(find("Track/Append points")->enabled);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::append_mode>{true}));
  frames(2);
  EXPECT_TRUE(find("Elements/Draw knots")->enabled) << "to end it";
  EXPECT_TRUE(find("Track/Append points")->enabled);
  key(platform::Key::a);
  EXPECT_FALSE(session_.settings.aids->append_mode);
}

TEST_F(ActionsTest, escape_closes_a_list_then_leaves_append_mode_then_deselects) {
  select(world::EntityKind::knot, 2);
  key(platform::Key::a);
  click("Evaluation/Arc length");
  ASSERT_TRUE(host_->wants_keyboard());
  key(platform::Key::escape);
  frame();
  EXPECT_FALSE(host_->wants_keyboard());
  EXPECT_TRUE(session_.settings.aids->append_mode);
  key(platform::Key::escape);
  EXPECT_FALSE(session_.settings.aids->append_mode);
  EXPECT_TRUE(session_.settings.selected.valid());
  key(platform::Key::escape);
  EXPECT_FALSE(session_.settings.selected.valid());
}

TEST_F(ActionsTest, space_runs_and_holds_the_ride_and_period_steps_it) {
  key(platform::Key::space);
  EXPECT_EQ(session_.motion.state, world::RideState::running);
  key(platform::Key::period);
  EXPECT_EQ(session_.motion.state, world::RideState::paused);
  EXPECT_EQ(all<edit::RideStep>().size(), 1u);
  key(platform::Key::r, {.shift = true});
  EXPECT_EQ(session_.motion.state, world::RideState::stopped);
}

// The track of the stage is open and has two segments.
TEST_F(ActionsTest, the_probe_steps_along_the_track_and_stays_at_its_ends) {
  const auto at = [&] {
    return fmt::format("{} {}", world::label_of(session_.document, session_.settings.selected),
                       session_.settings.selected_t);
  };
  const std::vector<world::Entity>& segments = session_.document.track.segments;
  session_.settings.selected = segments[0], session_.settings.selected_t = 0.99;
  const std::string first = world::label_of(session_.document, segments[0]),
                    second = world::label_of(session_.document, segments[1]);
  key(platform::Key::right_bracket);
  EXPECT_EQ(at(), first + " 1");
  key(platform::Key::right_bracket);
  EXPECT_EQ(at(), second + " 0");
  key(platform::Key::right_bracket);
  EXPECT_EQ(at(), second + " 0.015625");
  key(platform::Key::left_bracket), key(platform::Key::left_bracket);
  EXPECT_EQ(at(), first + " 1");
  session_.settings.selected_t = 0;
  key(platform::Key::left_bracket);
  EXPECT_EQ(at(), first + " 0") << "there is no segment before it";
}

TEST_F(ActionsTest, f_frames_the_track_so_that_every_knot_is_in_the_viewport) {
  frames(2);
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {400, 2, 90}, .distance = 10})).ok());
  key(platform::Key::f);
  frame();
  for (std::uint32_t number : {1u, 2u, 3u}) EXPECT_TRUE(host_->view().viewport.contains(pixel_of(number))) << number;
}

TEST_F(ActionsTest, a_key_of_the_settings_takes_the_place_of_the_table_s) {
  const exchange::KeyBinding choices[] = {{"Panels", {"F7"}}};
  EXPECT_TRUE(host_->set_keys(choices).empty());
  frames(2);
  key(platform::Key::tab);
  EXPECT_TRUE(session_.settings.panels->show_panels);
  key(platform::Key::f7);
  EXPECT_FALSE(session_.settings.panels->show_panels);
  EXPECT_TRUE(host_->set_keys({}).empty());
  key(platform::Key::tab);
  EXPECT_TRUE(session_.settings.panels->show_panels);
}

TEST_F(ActionsTest, an_empty_list_of_recent_files_says_so) {
  for (const bool any : {false, true}) {
    user_.emplace();
    if (any) user_->settings.recent.push_back("/tmp/red.json");
    frames(2);
    click("Menu/File");
    frames(2);
    const Widget* const recent = find("Menu/File/Recent");
    ASSERT_NE(recent, nullptr);
    EXPECT_EQ(recent->enabled, any);
    hover(middle(*recent));
    frames(60);
    const ImGuiWindow* tooltip = nullptr;
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
      if ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active) tooltip = window;
    ASSERT_EQ(tooltip != nullptr, !any) << "the open list covers it";
    if (tooltip != nullptr) {
      EXPECT_NEAR(tooltip->ContentSize.x, text_size("No files have been used yet.").x, 1);
    }
    key(platform::Key::escape);
  }
}

TEST_F(ActionsTest, right_and_left_open_the_menu_beside_the_open_one) {
  using platform::Key;
  const auto expect_open = [&](const std::string& open) {
    frames(3);
    for (const std::string menu : {"File", "Edit", "View", "Ride", "Window"})
      EXPECT_EQ(find("Menu/" + menu)->value, menu == open ? "open" : "closed") << menu << ", not " << open;
  };
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));  // the first item of Edit that is not grey is a menu
  click("Menu/File");
  expect_open("File");
  for (const char* menu : {"Edit", "View", "Ride", "Window", "File"}) key(Key::right), expect_open(menu);
  for (const char* menu : {"Window", "Ride", "View"}) key(Key::left), expect_open(menu);
  const auto camera = [&] {
    const Widget* const inside = find("Menu/View/Camera");
    return inside != nullptr ? inside->value : "no menu";
  };
  for (int downs = 1; downs <= 20 && camera() != "open"; ++downs) {
    if (downs > 1) key(Key::left), expect_open("View");  // the last item was no menu
    for (int i = 0; i < downs; ++i) key(Key::down);
    key(Key::right), frames(3);
  }
  expect_open("View");
  ASSERT_EQ(camera(), "open") << "Right enters the menu inside";
  key(Key::left), expect_open("View");
  EXPECT_EQ(camera(), "closed") << "Left leaves it";
  key(Key::right), expect_open("View");
  EXPECT_EQ(camera(), "open");
  key(Key::right), expect_open("Ride");
  key(Key::escape);
  expect_open("none");
}

TEST_F(ActionsTest, the_laboratory_is_ticked_only_where_it_shows) {
  const std::pair<world::Workspace, const char*> rows[] = {{world::Workspace::laboratory, "on"},
                                                           {world::Workspace::build, "off"},
                                                           {world::Workspace::ride, "off"},
                                                           {world::Workspace::all, "on"}};
  for (const auto& [workspace, value] : rows) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{workspace}).ok());
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_laboratory>{true}).ok());
    frames(3);
    click("Menu/View");
    frames(2);
    const Widget* const row = find("Menu/View/Laboratory");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->value, value) << base::name_of(workspace);
    key(platform::Key::escape);
  }
}

TEST_F(ActionsTest, keys_do_nothing_behind_an_open_menu) {
  const std::size_t knots = session_.document.track.knots.size();
  click("Menu/Window");
  key(platform::Key::c);  // adds a knot where no list is open
  EXPECT_EQ(session_.document.track.knots.size(), knots);
  key(platform::Key::escape);
  key(platform::Key::c);
  EXPECT_EQ(session_.document.track.knots.size(), knots + 1);
}

TEST_F(ActionsTest, f12_asks_for_a_picture) {
  EXPECT_EQ(frame({platform::KeyPress{platform::Key::f12, true, false, {}}}).photo, PictureRequest::scene);
  EXPECT_EQ(frame({platform::KeyPress{platform::Key::f12, true, false, {.ctrl = true}}}).photo, PictureRequest::window);
  EXPECT_EQ(frame().photo, PictureRequest::none);
}

}  // namespace actions_test
}  // namespace coaster::ui
