// A recording, run as a script, ends in the same document and motion.
#include "script/recorder.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_session.h"
#include "script/fake_host.h"
#include "world/element_rows.h"
#include "world/laboratory_settings.h"
#include "world/layers.h"
#include "world/other_settings.h"

namespace coaster::script {
namespace recorder_test {

edit::Command command(const std::string& text) {
  std::vector<base::Token> tokens;
  base::TextError error;
  EXPECT_TRUE(base::tokenise(text, tokens, error));
  const auto parsed = edit::parse(tokens, error);
  EXPECT_TRUE(parsed.ok()) << text << ": " << error.message;
  return *parsed;
}

std::string hashes(const edit::Session& session) {
  return base::hex16(world::hash(session.document)) + " " + base::hex16(world::hash(session.document, session.motion));
}

TEST(recorder, a_replay_has_the_same_hashes) {
  base::Files files;
  FakeHost original;
  const std::string track = std::string(COASTER_SOURCE_DIR) + "/tracks/loop.json";
  ASSERT_TRUE(original.apply(edit::LoadTrack{track}).ok());
  const std::filesystem::path path = test_folder() / "recorded.coaster";
  {
    auto recorder = Recorder::start(files, path, original.session);
    ASSERT_TRUE(recorder.ok()) << recorder.status().message;
    const auto go = [&](const std::string& text, int ticks) {
      const edit::Command c = command(text);
      ASSERT_TRUE(original.apply(c).ok()) << text;
      ASSERT_TRUE((*recorder)->command(c, original.session).ok());
      edit::advance(original.session, ticks);
      ASSERT_TRUE((*recorder)->ticks(ticks).ok());
    };
    go("ride.start", 97);
    go("gesture.begin", 0);
    go("move @k3 to 41.25 4.5 1.125", 2);
    go("move @k3 to 41.5 4.75 1.25", 2);
    go("gesture.end", 133);
    go("split @s2 at 0.37", 250);
    go("evaluator horner", 1);
    go("undo", 11);
    go("select @k4", 0);
    go("start_speed 7.25", 61);
  }
  const auto parsed = parse_script_file(path, files);
  ASSERT_TRUE(parsed.ok());
  ASSERT_TRUE(parsed->errors.empty()) << parsed->errors.front();
  FakeHost replayed;
  Host host = replayed.host();
  const base::Status status =
      run_script(parsed->script, host, {*base::FileRoot().open(test_folder() / "out"), false, {}});
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(hashes(replayed.session), hashes(original.session));
  EXPECT_EQ(replayed.session.history.undo.size(), original.session.history.undo.size());
  EXPECT_NE(hashes(replayed.session), hashes(edit::make_session({})));
}

// What a session starts a recording with, changed in every member.
world::Settings other_settings(const edit::Session& session) {
  world::Settings s = session.settings;
  world::for_each_setting([&]<auto Setting>() { world::value_in<Setting>(s) = test::other_value<Setting>(); });
  for (std::size_t i = 0; i < std::size(world::kLayers); ++i) {
    const auto layer = static_cast<world::Layer>(i);
    s.lab->layers.set(layer, !s.lab->layers.has(layer));
  }
  s.camera = {{1.5f, 2.25f, -3.75f}, 12.5f, -7.25f, 33.5f, s.camera.field_of_view_deg};
  s.fly = {{-4.5f, 6.25f, 8.75f}, -21.5f, 3.25f};
  s.snapping = {world::SnapTo::knots, 0.375, 22.5};
  s.element = world::usual_element(world::ElementKind::loop);
  s.element.right = true, s.element.values[0] += 1.5;
  s.selected = session.document.track.segments.at(2);
  s.selected_t = 0.375;
  return s;
}

TEST(recorder, a_replay_has_the_same_settings) {
  base::Files files;
  FakeHost original;
  ASSERT_TRUE(original.apply(edit::LoadTrack{std::string(COASTER_SOURCE_DIR) + "/tracks/loop.json"}).ok());
  const world::Settings at_first = original.session.settings;
  const auto replay = [&](const std::string& name) {
    const std::filesystem::path path = test_folder() / (name + ".coaster");
    EXPECT_TRUE(Recorder::start(files, path, original.session).ok());
    const auto parsed = parse_script_file(path, files);
    EXPECT_TRUE(parsed.ok() && parsed->errors.empty());
    FakeHost replayed;
    Host host = replayed.host();
    EXPECT_TRUE(run_script(parsed->script, host, {*base::FileRoot().open(test_folder() / "out"), false, {}}).ok());
    return replayed.session.settings;
  };
  EXPECT_TRUE(replay("first") == at_first) << "what a command changes besides is set, too";

  original.session.settings = other_settings(original.session);
  {
    // A member that this test does not know would not compile here.
    const auto& [look, panels, feel, aids, evaluation, lab, frames, integrator, mode, camera, fly, selected, also,
                 place, snapping, element] = original.session.settings;
    EXPECT_FALSE(look == at_first.look || panels == at_first.panels);
    EXPECT_FALSE(feel == at_first.feel || aids == at_first.aids || lab == at_first.lab);
    EXPECT_FALSE(evaluation == at_first.evaluation || frames == at_first.frames || integrator == at_first.integrator);
    EXPECT_FALSE(mode == at_first.camera_mode || camera == at_first.camera || fly == at_first.fly);
    EXPECT_FALSE(selected == at_first.selected || place == at_first.selected_t);
    EXPECT_FALSE(snapping == at_first.snapping || element == at_first.element);
    EXPECT_TRUE(also.empty()) << "further knots are selected beside a knot alone";
  }
  const world::Settings replayed = replay("settings");
  world::for_each_setting([&]<auto Setting>() {
    EXPECT_EQ(world::value_in<Setting>(replayed), world::value_in<Setting>(original.session.settings))
        << world::setting_row<Setting>().word;
  });
  EXPECT_TRUE(replayed == original.session.settings);

  const auto& knots = original.session.document.track.knots;
  original.session.settings.selected = knots.at(3), original.session.settings.also = {knots.at(1), knots.at(4)};
  original.session.settings.selected_t = world::Settings{}.selected_t;  // a place on a segment alone
  EXPECT_TRUE(replay("selection") == original.session.settings);
}

TEST(recorder, a_folder_that_cannot_be_written_is_an_error) {
  base::Files files;
  EXPECT_EQ(Recorder::start(files, "/proc/nowhere/a.coaster", edit::make_session({})).status().code, base::Code::io);
}

}  // namespace recorder_test
}  // namespace coaster::script
