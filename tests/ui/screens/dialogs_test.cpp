// Questions about unsaved changes, files and recovery, by mouse and keys.
#include "ui/screens/dialogs.h"

#include <imgui_internal.h>

#include "base/scratch_folder.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_park.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "ui/stage.h"

namespace coaster::ui {
namespace dialogs_test {

using platform::Key;

struct DialogsTest : Stage {
  test::ScratchFolder scratch;
  std::filesystem::path folder = scratch.path();
  void SetUp() override {
    Stage::SetUp();
    frames(2);
  }
};

TEST_F(DialogsTest, closing_asks_and_each_answer_does_what_it_says) {
  ASSERT_TRUE(edit::dirty(session_));
  EXPECT_FALSE(frame({platform::CloseRequest{}}).quit);
  frames(2);
  ASSERT_NE(find("Unsaved changes/Save"), nullptr);
  EXPECT_FALSE(frame({platform::CloseRequest{}}).quit) << "asking again is no answer";
  frames(2);
  click("Unsaved changes/Cancel");
  EXPECT_EQ(find("Unsaved changes/Save"), nullptr);
  EXPECT_TRUE(edit::dirty(session_));

  frame({platform::CloseRequest{}});
  frames(2);
  bool quit = false;
  for (const Key k : {Key::d}) quit = frame({platform::KeyPress{k, true, false, {}}}).quit;
  EXPECT_TRUE(quit);
}

TEST_F(DialogsTest, an_import_has_no_file_and_closing_asks) {
  const std::string own = (folder / "a.json").string(), rows = (folder / "a.csv").string();
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{own}));
  frames(2);
  EXPECT_EQ(find("Status/Unsaved")->value, "saved");
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{rows}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::LoadTrack{rows}));
  frames(2);
  EXPECT_EQ(find("Status/Unsaved")->value, "not saved yet");
  EXPECT_FALSE(frame({platform::CloseRequest{}}).quit);
  frames(2);
  ASSERT_NE(find("Unsaved changes/Question"), nullptr);
  EXPECT_NE(find("Unsaved changes/Question")->value.find("is not saved yet."), std::string::npos);
  click("Unsaved changes/Cancel");
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{own}));
  frames(2);
  EXPECT_EQ(find("Status/Unsaved")->value, "saved");
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  frames(2);
  EXPECT_EQ(find("Status/Unsaved")->value, "no file");
  EXPECT_TRUE(frame({platform::CloseRequest{}}).quit);
}

TEST_F(DialogsTest, an_answer_closes_the_dialog_in_the_same_frame) {
  frame({platform::CloseRequest{}});
  frames(2);
  ASSERT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1);
  hover(middle(*find("Unsaved changes/Cancel")));
  press();
  release();
  EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 0) << "the next frame would show an empty card";
  frame();
  EXPECT_EQ(find("Unsaved changes/Cancel"), nullptr);
}

TEST_F(DialogsTest, saving_first_quits_only_when_it_was_saved) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{(folder / "a.json").string()}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{{{world::EntityKind::knot, 1}}, {1, 2, 3}}));
  files_.inject(base::IoOperation::rename, 1);
  frame({platform::CloseRequest{}});
  frames(2);
  frame({platform::KeyPress{Key::enter, true, false, {}}});
  EXPECT_FALSE(frame().quit) << "the save failed";
  EXPECT_TRUE(edit::dirty(session_));
  EXPECT_NE(host_->toast().find("rename"), std::string::npos);
  frames(2);
  EXPECT_EQ(find("Unsaved changes/Save"), nullptr);

  frame({platform::CloseRequest{}});
  frames(2);
  frame({platform::KeyPress{Key::enter, true, false, {}}});
  EXPECT_TRUE(frame().quit);
  EXPECT_FALSE(edit::dirty(session_));
}

TEST_F(DialogsTest, exports_hold_the_park_where_there_is_one_and_the_user_wants_it) {
  const auto save_as = [&](const char* name) {
    key(Key::s, {.shift = true, .ctrl = true});
    frames(2);
    type("Save as/Name", (folder / name).string(), false);
    commands_.clear();
  };
  session_.file.path = (folder / "own.json").string();
  key(Key::s, {.shift = true, .ctrl = true});
  frames(2);
  EXPECT_EQ(find("Save as/Park in glTF and OBJ"), nullptr) << "there is none";
  key(Key::escape);
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetLand{world::Land::meadow}).ok());
  save_as("a.svg");
  click("Save as/Park in glTF and OBJ");
  click("Save as/Save");
  ASSERT_EQ(all<edit::Save>().size(), 1u);
  EXPECT_FALSE(all<edit::Save>()[0].park.set) << "a drawing holds no land";
  save_as("a.obj");
  click("Save as/Save");
  ASSERT_EQ(all<edit::Save>().size(), 1u);
  EXPECT_TRUE(all<edit::Save>()[0].park.set) << "it is still ticked";
  EXPECT_NE(files_.read(folder / "a.mtl")->find("newmtl land"), std::string::npos);
  save_as("b.gltf");
  click("Save as/Park in glTF and OBJ");
  click("Save as/Save");
  ASSERT_EQ(all<edit::Save>().size(), 1u);
  EXPECT_FALSE(all<edit::Save>()[0].park.set);
}

TEST_F(DialogsTest, only_a_dialog_that_saves_makes_folders) {
  session_.file.path = (folder / "own.json").string();
  key(Key::s, {.shift = true, .ctrl = true});
  frames(2);
  EXPECT_NE(find("Save as/New folder"), nullptr);
  key(Key::escape);
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());
  key(Key::o, {.ctrl = true});
  frames(2);
  ASSERT_NE(find("Open/Cancel"), nullptr);
  EXPECT_EQ(find("Open/New folder"), nullptr);
}

TEST_F(DialogsTest, a_clean_track_is_left_without_a_question) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{(folder / "a.json").string()}));
  EXPECT_TRUE(frame({platform::CloseRequest{}}).quit);
}

TEST_F(DialogsTest, while_a_question_is_open_keys_and_mouse_are_its_own) {
  frame({platform::CloseRequest{}});
  frames(2);
  for (const Widget& w : host_->widgets()) EXPECT_TRUE(w.covered || w.path.starts_with("Unsaved changes/")) << w.path;
  const std::uint64_t before = world::hash(session_.document);
  const std::size_t commands = commands_.size();
  key(Key::z, {.ctrl = true});
  key(Key::space);
  click_at(empty_ground());
  EXPECT_EQ(world::hash(session_.document), before);
  EXPECT_EQ(commands_.size(), commands);
}

TEST_F(DialogsTest, recovery_is_offered_once_and_its_answer_goes_out) {
  user_.emplace();
  user_->recoveries.push_back({"/tmp/x.json", "Red", 1'000'000, 2'000'000});
  frames(3);
  ASSERT_NE(find("Recovery/Recover"), nullptr);
  EXPECT_NE(find("Recovery/File saved")->value, find("Recovery/Autosaved")->value);
  key(Key::escape);
  frames(2);
  ASSERT_NE(find("Recovery/Later"), nullptr) << "no key answers by accident";
  std::optional<RecoveryAnswer> answer;
  hover(middle(*find("Recovery/Later")));
  press();
  for (int i = 0; i < 3; ++i)
    if (const Output out = i == 0 ? frame({platform::MouseButton{platform::Button::left, false, {}}}) : frame();
        out.recovery)
      answer = out.recovery;
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(*answer, RecoveryAnswer::later);
  frames(3);
  EXPECT_EQ(find("Recovery/Later"), nullptr);
}

TEST_F(DialogsTest, recovering_leaves_the_start_screen_for_the_track) {
  user_.emplace();
  host_->show_start();
  user_->recoveries.push_back({"/tmp/x.json", "Red", 1'000'000, 2'000'000});
  frames(3);
  ASSERT_NE(find("Recovery/Recover"), nullptr);
  click_at(middle(*find("Recovery/Recover")));
  user_->recoveries.clear();  // as its keeper does
  frames(3);
  EXPECT_EQ(find("Start/New track"), nullptr);
}

TEST_F(DialogsTest, a_file_in_use_elsewhere_is_saved_under_another_name) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{(folder / "a.json").string()}));
  user_.emplace();
  user_->holder = "another coaster (process 7)";
  frames(2);
  commands_.clear();
  key(Key::s, {.ctrl = true});
  frames(2);
  EXPECT_TRUE(all<edit::Save>().empty());
  ASSERT_NE(find("Save as/Name"), nullptr);
  type("Save as/Name", (folder / "b").string());
  frame();
  ASSERT_EQ(all<edit::Save>().size(), 1u);
  EXPECT_EQ(all<edit::Save>()[0].path, (folder / "b.json").string());
}

TEST_F(DialogsTest, home_and_end_go_to_the_first_and_the_last_challenge) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());  // nothing to ask about
  for (const auto& [to, name] : {std::pair{Key::end, "08_tired_train.json"}, {Key::home, "01_first_hill.json"}}) {
    key(Key::h, {.ctrl = true});
    frames(2);
    key(Key::down);
    key(to);
    commands_.clear();
    key(Key::enter);
    frames(2);
    ASSERT_EQ(all<edit::StartChallenge>().size(), 1u) << name;
    EXPECT_EQ(std::filesystem::path(all<edit::StartChallenge>()[0].path).filename(), name);
  }
}

// Installed tracks are often not writable, and a page forgets what is saved beside them.
TEST_F(DialogsTest, a_track_of_the_program_is_saved_under_another_name) {
  const std::filesystem::path data = folder / "data", before = std::filesystem::current_path();
  ASSERT_TRUE(std::filesystem::create_directory(data));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{(data / "sample.json").string()}));
  std::filesystem::current_path(folder);
  ASSERT_EQ(setenv("COASTER_DATA", data.c_str(), 1), 0);
  commands_.clear();
  key(Key::s, {.ctrl = true});
  frames(2);
  EXPECT_TRUE(all<edit::Save>().empty());
  type("Save as/Name", "mine");
  frame();
  unsetenv("COASTER_DATA");
  std::filesystem::current_path(before);
  ASSERT_EQ(all<edit::Save>().size(), 1u);
  EXPECT_EQ(all<edit::Save>()[0].path, (std::filesystem::canonical(folder) / "mine.json").string());
}

// Save and Save as to the document's own file ask if another program changed it; each answer has its effect.
TEST_F(DialogsTest, a_file_that_another_program_changed_is_asked_about) {
  const std::string own = (folder / "a.json").string();
  const auto theirs = [&] {
    ASSERT_TRUE(base::Files().write_atomic(own, "theirs"));
    commands_.clear();
    key(Key::s, {.ctrl = true});
    frames(2);
    ASSERT_NE(find("Changed file/Question"), nullptr);
    EXPECT_TRUE(all<edit::Save>().empty());
  };
  ASSERT_TRUE(edit::apply(session_, files_, edit::Save{own}));
  theirs();
  key(Key::escape);
  frames(2);
  EXPECT_EQ(find("Changed file/Question"), nullptr);
  EXPECT_TRUE(all<edit::Save>().empty());

  theirs();
  key(Key::enter);
  frames(2);
  ASSERT_NE(find("Save as/Name"), nullptr);
  type("Save as/Name", own);
  frames(2);
  ASSERT_NE(find("Changed file/Question"), nullptr) << "the same name again";
  EXPECT_EQ(*files_.read(own), "theirs");
  click("Changed file/Overwrite");
  frames(2);
  ASSERT_EQ(all<edit::Save>().size(), 1u);
  EXPECT_NE(*files_.read(own), "theirs");
  EXPECT_EQ(find("Changed file/Question"), nullptr);
  key(Key::s, {.ctrl = true});
  frames(2);
  EXPECT_EQ(all<edit::Save>().size(), 2u) << "nobody changed it since";
}

TEST_F(DialogsTest, materials_beside_a_new_export_are_not_lost_unasked) {
  const std::string materials = (folder / "track.mtl").string();
  ASSERT_TRUE(files_.write_atomic(materials, "theirs"));
  key(Key::s, {.shift = true, .ctrl = true});
  frames(2);
  type("Save as/Name", (folder / "track.obj").string());
  frames(2);
  ASSERT_NE(find("Overwrite/Question"), nullptr);
  EXPECT_NE(find("Overwrite/Question")->value.find("track.mtl already exists"), std::string::npos)
      << find("Overwrite/Question")->value;
  EXPECT_EQ(*files_.read(materials), "theirs");
  click("Overwrite/Overwrite");
  frames(2);
  ASSERT_EQ(all<edit::Save>().size(), 1u);
}

TEST_F(DialogsTest, the_settings_say_what_to_keep) {
  user_.emplace();
  frames(2);
  key(Key::comma, {.ctrl = true});
  frames(2);
  ASSERT_NE(find("Settings/Keys/Save"), nullptr);
  const auto press = [&](const std::string& action, Key k, platform::Modifiers m) {
    click("Settings/Keys/" + action);
    EXPECT_EQ(find("Settings/Keys/" + action)->value, "Press a key");
    const Output out = frame({platform::KeyPress{k, true, false, m}});
    frame({platform::KeyPress{k, false, false, {}}});  // a wheel with Ctrl would not scroll
    if (out.settings) user_->settings = *out.settings, host_->set_keys(out.settings->keys);
    frames(2);
    return out.settings.has_value();
  };
  using Keys = std::vector<exchange::KeyBinding>;
  ASSERT_TRUE(press("Save", Key::u, {.ctrl = true}));
  EXPECT_EQ(user_->settings.keys, (Keys{{"Save", {"Ctrl+U"}}}));
  EXPECT_EQ(find("Settings/Keys/Save")->value, "Ctrl+U");
  ASSERT_TRUE(press("Open", Key::u, {.ctrl = true}));
  EXPECT_EQ(user_->settings.keys, (Keys{{"Save", {}}, {"Open", {"Ctrl+U"}}})) << "no key belongs to two";
  EXPECT_EQ(find("Settings/Keys note")->value, "Ctrl+U now belongs to Open, not to Save.");
  EXPECT_FALSE(press("Open", Key::escape, {})) << "keeps its keys";
  ASSERT_NE(find("Settings/Keys/Open"), nullptr) << "and the window is still open";
  EXPECT_EQ(find("Settings/Keys/Open")->value, "Ctrl+U");
  ASSERT_TRUE(press("Open", Key::backspace, {}));
  EXPECT_EQ(user_->settings.keys, (Keys{{"Save", {}}, {"Open", {}}}));
  ASSERT_TRUE(press("Save", Key::s, {.ctrl = true}));
  EXPECT_EQ(user_->settings.keys, (Keys{{"Open", {}}})) << "the default key is no choice";
  key(Key::escape);
  frames(2);
  EXPECT_EQ(find("Settings/Keys/Save"), nullptr);
}

// Of a track that is saved, so that nothing else is asked.
struct ImportTest : DialogsTest {
  std::string list = (folder / "list.xyz").string();
  void SetUp() override {
    DialogsTest::SetUp();
    ASSERT_TRUE(edit::apply(session_, files_, edit::Save{(folder / "own.json").string()}));
    ASSERT_TRUE(files_.write_atomic(list, "0 0 0\n40 0 0\n40 30 1\n0 30 1\n"));
    drop();
  }
  void drop() {
    commands_.clear();
    frame({platform::FileDrop{list}});
    frames(2);
  }
  const edit::LoadTrack* load() const {
    for (const edit::Command& command : commands_)
      if (const auto* const load = command.as<edit::LoadTrack>()) return load;
    return nullptr;
  }
};

TEST_F(ImportTest, points_are_opened_as_proposed_by_enter_and_not_at_all_by_escape) {
  ASSERT_NE(find("Import points/Import"), nullptr);
  EXPECT_EQ(find("Import points/Up axis")->value, "Z");
  EXPECT_EQ(find("Import points/Size")->value, "4 points: 140 m long, 1 m high.");
  key(Key::escape);
  frames(2);
  EXPECT_EQ(find("Import points/Import"), nullptr);
  EXPECT_EQ(load(), nullptr);
  drop();
  click("Import points/Cancel");
  EXPECT_EQ(load(), nullptr);
  EXPECT_EQ(session_.document.track.knots.size(), 3u);
  drop();
  key(Key::enter);
  ASSERT_NE(load(), nullptr);
  EXPECT_EQ(load()->import, (exchange::ImportOptions{.up = world::Axis::z, .scale = 1}));
  EXPECT_TRUE(session_.document.track.closed);
  frames(2);
  EXPECT_EQ(find("Import points/Import"), nullptr);
}

TEST_F(ImportTest, keys_and_fields_give_the_words_of_load) {
  key(Key::y), key(Key::b), key(Key::o);
  frames(2);
  EXPECT_EQ(find("Import points/Size")->value, "4 points: 140 m long, 30 m high.");
  type("Import points/Metres a unit", "2.5");
  type("Import points/Smooth within", "0.001");
  click("Import points/Import");
  ASSERT_NE(load(), nullptr);
  EXPECT_EQ(edit::print(*load()), "load \"" + list + "\" up y scale 2.5 smooth 0.02 bank auto origin");
}

TEST_F(ImportTest, tab_leads_through_the_numbers) {
  key(Key::escape);
  drop();
  key(Key::tab);
  frames(4);
  frame({platform::TextInput{"0.5"}});
  key(Key::tab);
  frames(4);
  frame({platform::TextInput{"0.25"}});
  key(Key::enter);
  frames(2);
  ASSERT_EQ(load(), nullptr) << "that Enter was the field's";
  key(Key::enter);
  ASSERT_NE(load(), nullptr);
  EXPECT_EQ(load()->import, (exchange::ImportOptions{.up = world::Axis::z, .scale = 0.5, .smooth = 0.25}));
}

TEST_F(ImportTest, far_rows_are_offered_at_the_origin_alone) {
  key(Key::escape);
  list = (folder / "far.csv").string();
  std::string rows =
      "\"No.\"\t\"PosX\"\t\"PosY\"\t\"PosZ\"\t\"FrontX\"\t\"FrontY\"\t\"FrontZ\"\t\"LeftX\"\t\"LeftY\"\t"
      "\"LeftZ\"\t\"UpX\"\t\"UpY\"\t\"UpZ\"\n";
  for (int i = 1; i < 30; ++i)
    rows += std::to_string(i) + "\t" + std::to_string(50000 + i) + "\t3\t0\t1\t0\t0\t0\t0\t-1\t0\t1\t0\n";
  ASSERT_TRUE(files_.write_atomic(list, rows));
  drop();
  ASSERT_NE(find("Import rows/Move to the origin"), nullptr);
  EXPECT_EQ(find("Import rows/Up axis"), nullptr);
  click("Import rows/Import");
  ASSERT_NE(load(), nullptr);
  EXPECT_EQ(load()->import, exchange::ImportOptions{.origin = true});
}

TEST_F(ImportTest, unsaved_changes_are_asked_about_first) {
  key(Key::escape);
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{{{world::EntityKind::knot, 1}}, {1, 2, 3}}));
  drop();
  EXPECT_EQ(find("Import points/Import"), nullptr);
  click("Unsaved changes/Discard");
  frames(2);
  ASSERT_NE(find("Import points/Import"), nullptr);
}

}  // namespace dialogs_test
}  // namespace coaster::ui
