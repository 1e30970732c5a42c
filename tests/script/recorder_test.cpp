// A recording, run as a script, ends in the same document and motion.
#include "script/recorder.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "edit/commands/codec.h"
#include "script/fake_host.h"

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
  std::filesystem::create_directories(test_folder());
  base::Files files;
  FakeHost original;
  const std::string track = std::string(COASTER_SOURCE_DIR) + "/tracks/loop.json";
  ASSERT_TRUE(original.apply(edit::Load{track}).ok());
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
  const base::Status status = run_script(parsed->script, host, {test_folder() / "out", false, {}});
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(hashes(replayed.session), hashes(original.session));
  EXPECT_EQ(replayed.session.history.undo.size(), original.session.history.undo.size());
  EXPECT_NE(hashes(replayed.session), hashes(edit::make_session({})));
}

TEST(recorder, a_folder_that_cannot_be_written_is_an_error) {
  base::Files files;
  EXPECT_EQ(Recorder::start(files, "/proc/nowhere/a.coaster", edit::make_session({})).status().code, base::Code::io);
}

}  // namespace recorder_test
}  // namespace coaster::script
