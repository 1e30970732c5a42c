// The effects of statements on a program without GL.
#include "script/runner.h"

#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "script/fake_host.h"

namespace coaster::script {
namespace runner_test {

const char* const kTrack = "append at -3.25 1.5 2.75\nappend at 9.5 4.25 -1.125\nappend at 21.75 2.5 6.375\n";

TEST(runner, an_expectation_sees_a_frame_that_is_younger_than_the_last_change) {
  FakeHost fake;
  const base::Status status = run_lines(
      fake,
      std::string(kTrack) +
          "frames 1\nmove @k2 to 8 5 0.5\nexpect uploads == 1\nexpect uploads == 1\nticks 1\nexpect uploads == 0\n");
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST(runner, a_settling_frame_has_no_ticks_and_comes_once) {
  FakeHost fake;
  ASSERT_TRUE(run_lines(fake, "ticks 7\nexpect tick == 7\nexpect knots == 0\nexpect tick == 7\n").ok());
  ASSERT_EQ(fake.frames.size(), 1u);
  EXPECT_EQ(fake.frames[0].second, 0);
  ASSERT_TRUE(run_lines(fake, "frames 3\nexpect frame > 0\n").ok());
  ASSERT_EQ(fake.frames.size(), 4u);
  EXPECT_EQ(fake.frames[3].second, 2);
}

TEST(runner, repeat_runs_its_lines_that_many_times_and_gesture_is_one_step_of_undo) {
  FakeHost fake;
  const base::Status status =
      run_lines(fake, std::string(kTrack) +
                          "repeat 3\n  repeat 2\n    ticks 5\n  end\nend\nexpect tick == 30\n"
                          "gesture\nmove @k1 to 0 1 0\nmove @k1 to 0 2 0.5\nend\nexpect position @k1 == 0 2 0.5\nundo\n"
                          "expect position @k1 == -3.25 1.5 2.75\n");
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST(runner, a_gesture_that_a_command_inside_has_ended_fails_at_its_line) {
  for (const char* const line : {"undo", "new", "gesture.cancel"}) {
    FakeHost fake;
    const base::Status status = run_lines(fake, fmt::format("{}gesture\nmove @k1 to 0 1 0\n{}\nend\n", kTrack, line));
    EXPECT_EQ(status.code, base::Code::usage);
    EXPECT_EQ(status.message.rfind("test.coaster:5:1: error: a command up to end ended the gesture", 0), 0u)
        << status.message;
  }
}

TEST(runner, an_error_without_a_word_of_its_own_points_at_its_statement) {
  FakeHost fake;
  const base::Status status = run_lines(fake, "expect error aim.click @k9\n  split @s7 at 0.5\n");
  EXPECT_TRUE(status.message.starts_with("test.coaster:3:3: error: ")) << status.message;
}

TEST(runner, a_signal_ends_ticks_and_waits_early) {
  for (const char* const line : {"ticks 10000000\n", "wait knots == 7 max 10000000 ticks\n"}) {
    FakeHost fake;
    base::Files files;
    const ParsedScript parsed =
        parse_script(std::string("coaster-script 1\n") + line, "test.coaster", test_folder(), files);
    Host host = fake.host();
    int asked = 0;
    host.interrupted = [&asked] { return ++asked > 5; };
    const base::Status ended =
        run_script(parsed.script, host, {*base::FileRoot().open(test_folder() / "out"), false, {}});
    EXPECT_LE(fake.session.tick, 10 * world::kTicksPerSecond) << line;
    EXPECT_TRUE(ended.message.starts_with("test.coaster:2:1: error: stopped by a signal")) << ended.message;
  }
}

TEST(runner, wait_advances_until_it_is_so_or_times_out_with_its_own_code) {
  FakeHost fake;
  ASSERT_TRUE(
      run_lines(fake, "wait tick == 12 max 100 ticks\nexpect tick == 12\nwait tick == 12\nexpect tick == 12\n").ok());
  const base::Status late = run_lines(fake, "wait tick == 1000 max 5 ticks\n");
  EXPECT_EQ(late.code, base::Code::timeout);
  EXPECT_NE(late.message.find("waited 5 ticks for tick == 1000, found 17"), std::string::npos) << late.message;
  const std::size_t before = fake.frames.size();
  ASSERT_TRUE(run_lines(fake, "wait tick >= 23 max 9 frames\n").ok());
  EXPECT_EQ(fake.frames.size(), before + 3) << "waiting by frames draws them, 2 ticks each";
}

// What is to be seen later may not be there yet; a comparison that can never hold fails at once.
TEST(runner, wait_goes_on_while_the_widget_or_entity_of_its_condition_is_missing) {
  FakeHost fake;
  const base::Status never = run_lines(fake, "wait text \"Track/Lenght\" == \"7 m\" max 3 frames\n");
  EXPECT_EQ(never.code, base::Code::timeout);
  EXPECT_NE(never.message.find("waited 3 frames for text \"Track/Lenght\" == \"7 m\", no widget"), std::string::npos)
      << never.message;
  const base::Status entity = run_lines(fake, "wait roll @k99 == 0 max 2 ticks\n");
  EXPECT_EQ(entity.code, base::Code::timeout);
  EXPECT_NE(entity.message.find("k99"), std::string::npos) << entity.message;
  // A widget that comes in the third frame.
  Host host = fake.host();
  host.widgets = [&] {
    std::vector<query::Widget> shown;
    if (fake.frames.size() >= 3) shown.push_back({.path = "Track/Length", .kind = "label", .value = "7 m"});
    return shown;
  };
  base::Files files;
  const ParsedScript parsed = parse_script("coaster-script 1\nwait text \"Track/Length\" == \"7 m\" max 60 frames\n",
                                           "a.coaster", test_folder(), files);
  EXPECT_TRUE(run_script(parsed.script, host, {*base::FileRoot().open(test_folder() / "out"), false, {}}).ok());
  EXPECT_LT(fake.frames.size(), 10u);
  // A value that it never has, and a path of two widgets.
  EXPECT_EQ(run_lines(fake, "wait element.value radius == tall max 3 ticks\n").code, base::Code::usage);
  fake.widgets = {{.path = "A/twin", .kind = "text"}, {.path = "B/twin", .kind = "text"}};
  EXPECT_EQ(run_lines(fake, "wait text \"twin\" == \"7 m\" max 3 ticks\n").code, base::Code::usage);
}

TEST(runner, ends_as_skipped_where_the_driver_lacks_what_it_needs) {
  FakeHost fake;
  const std::string lines = "needs vertex_shader\nappend at 1 2 3\nneeds geometry_shader\nappend at 9 2 3\n";
  EXPECT_TRUE(run_lines(fake, lines).ok());
  EXPECT_EQ(fake.session.document.track.knots.size(), 2u);
  FakeHost lacks;
  lacks.stats.stage_refusals[static_cast<std::size_t>(curve::EvaluatedBy::geometry_shader)] = "it has none";
  const base::Status skipped = run_lines(lacks, lines);
  EXPECT_EQ(base::exit_code(skipped.code), 77);
  EXPECT_NE(skipped.message.find("needs geometry_shader. It has none."), std::string::npos) << skipped.message;
  EXPECT_EQ(lacks.session.document.track.knots.size(), 1u) << "what comes before it is run";
}

TEST(runner, a_failed_expectation_names_place_value_frame_and_evidence) {
  FakeHost fake;
  const base::Status status = run_lines(fake, "frames 2\n  expect knots == 4\n");
  EXPECT_EQ(status.code, base::Code::expectation);
  const std::string out = (test_folder() / "out").string();
  EXPECT_EQ(status.message,
            "test.coaster:3:10: error: expected knots == 4, found 0\n    expect knots == 4\n           ^ (frame 2; " +
                out + "/frame.png, widgets.txt, state.json)");
  for (const char* const name : {"frame.png", "widgets.txt", "state.json"})
    EXPECT_TRUE(std::filesystem::exists(test_folder() / "out" / name)) << name;
}

TEST(runner, a_failure_says_which_of_its_files_could_not_be_written_and_why) {
  FakeHost fake;
  const std::filesystem::path out = test_folder() / "out", picture = out / "frame.png", state = out / "state.json";
  const auto note = [&](const std::filesystem::path& taken) {
    std::filesystem::remove_all(out);
    std::filesystem::create_directories(taken / "x");  // a folder of that name
    const std::string message = run_lines(fake, "expect knots == 4\n").message;
    return message.substr(message.find("frame "));
  };
  EXPECT_EQ(note(picture).find(fmt::format("frame 1; {0}/widgets.txt, state.json; {0}/frame.png: ", out.string())), 0u)
      << note(picture);
  EXPECT_EQ(note(state).find(fmt::format("frame 2; {0}/frame.png; {0}/state.json: ", out.string())), 0u) << note(state);
  std::filesystem::remove_all(out);
}

TEST(runner, codes_tell_refused_commands_bad_files_and_forbidden_writes_apart) {
  FakeHost fake;
  EXPECT_EQ(base::exit_code(run_lines(fake, "move @k9 to 1 2 3\n").code), 2);
  EXPECT_EQ(run_lines(fake, "load \"not-there.json\"\n").code, base::Code::bad_file);
  for (const char* const line :
       {"save \"a.json\"\n", "save \"$OUT/../a.json\"\n", "save \"/tmp/a.json\"\n", "save \"$OUTSIDE/a.json\"\n"})
    EXPECT_EQ(run_lines(fake, line).code, base::Code::usage) << line;
  EXPECT_TRUE(
      run_lines(fake, "save \"$OUT/deep/a.json\"\nexpect file \"$OUT/deep/a.json\" exists\nload \"$OUT/deep/a.json\"\n")
          .ok());
}

TEST(runner, reports_the_notices_of_the_files_that_it_opens_and_of_nothing_else) {
  FakeHost fake;
  const std::string tracks = COASTER_SOURCE_DIR "/tests/tracks/";
  const std::string load = "load \"" + tracks;
  ASSERT_TRUE(run_lines(fake, load + "two_knots.json\"\nheartline 1e9\nexpect toast ~ \"limit\"\nnew\n").ok());
  EXPECT_TRUE(fake.reported.empty()) << fake.reported[0];
  ASSERT_TRUE(run_lines(fake, load + "jump.csv\"\n").ok());
  ASSERT_EQ(fake.reported.size(), 2u);
  EXPECT_NE(fake.reported[0].find("jump.csv:22: warning: the frame jumps by 30.00 degrees"), std::string::npos);
  EXPECT_EQ(fake.reported[1], "The train completes the ride with a start speed of 2 m/s.");
  ASSERT_TRUE(run_lines(fake, "expect error load \"" + tracks + "cut.csv\"\n").ok());
  EXPECT_EQ(fake.reported.size(), 2u) << "an expected error";
}

TEST(runner, expect_error_wants_a_failure_and_its_words) {
  FakeHost fake;
  EXPECT_TRUE(
      run_lines(
          fake,
          "expect error load \"not-there.json\"\nexpect error move @k9 to 1 2 3\nexpect error move @k9 to 1e39 0 0\n"
          "expect error ui.click \"Nothing\" ~ \"no widget\"\nexpect error expect knots == 4\n")
          .ok());
  EXPECT_EQ(run_lines(fake, "expect error new\n").code, base::Code::expectation);
  EXPECT_TRUE(run_lines(fake, "expect error pad left 2 0 ~ \"-1 to 1\"\n").ok());
  EXPECT_TRUE(run_lines(fake, "expect error resize 99999x99999 ~ \"up to 7680x4320\"\n").ok());
  EXPECT_EQ(run_lines(fake, "expect error pad left 2 0 ~ \"0 to 1\"\n").code, base::Code::expectation);
  EXPECT_EQ(run_lines(fake, "expect error load \"not-there.json\" ~ \"unlikely words\"\n").code,
            base::Code::expectation);
}

TEST(runner, injected_faults_fail_the_next_save_and_leave_the_old_file) {
  FakeHost fake;
  const base::Status status =
      run_lines(fake, std::string(kTrack) +
                          "save \"$OUT/a.json\"\nsave \"$OUT/b.json\"\nmove @k1 to 5 5 5\nfault io.fsync fail 1\n"
                          "expect error save \"$OUT/a.json\"\nexpect file \"$OUT/a.json\" same \"$OUT/b.json\"\n"
                          "save \"$OUT/a.json\"\nexpect not file \"$OUT/a.json\" same \"$OUT/b.json\"\n");
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST(runner, log_prints_values_and_texts) {
  FakeHost fake;
  ASSERT_TRUE(run_lines(fake, "log \"knots:\" knots\nlog hash document\n").ok());
  ASSERT_EQ(fake.printed.size(), 2u);
  EXPECT_EQ(fake.printed[0], "knots: 0");
  EXPECT_EQ(fake.printed[1].size(), 16u);
  EXPECT_EQ(fake.printed[1].find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(runner, env_changes_only_what_it_names) {
  FakeHost fake;
  ASSERT_TRUE(run_lines(fake, "env size 800x450 msaa 2\nenv seed 9\n").ok());
  EXPECT_EQ(fake.environment.width, 800);
  EXPECT_EQ(fake.environment.samples, 2);
  EXPECT_EQ(fake.environment.seed, 9u);
}

// A line that only sets the folder keeps the picture and the scale of the folder's settings; any other word sets all.
TEST(runner, env_home_alone_leaves_the_environment_as_it_is) {
  for (const char* const word : {"", " size 800x450", " msaa 2", " seed 9", " scale 1.5", " density 2"}) {
    FakeHost fake;
    int changes = 0, homes = 0;
    Host host = fake.host();
    host.set_environment = [&](const Environment& e) { return ++changes, fake.environment = e, base::Status{}; };
    host.set_home = [&](const std::filesystem::path&) { return ++homes, base::Status{}; };
    ASSERT_TRUE(run_lines(host, std::string("env home \"$OUT/here\"") + word + "\n").ok()) << word;
    EXPECT_EQ(homes, 1) << word;
    EXPECT_EQ(changes, *word != '\0' ? 2 : 1) << word << " after the one at the start";
  }
}

TEST(runner, aim_drag_presses_moves_at_least_four_times_and_releases) {
  FakeHost fake;
  ASSERT_TRUE(run_lines(fake, std::string(kTrack) + "aim.drag +shift @k2 by 1 2 0\n").ok());
  int moves = 0, presses = 0, releases = 0;
  platform::MouseMove last;
  for (const auto& [events, ticks] : fake.frames)
    for (const platform::Event& event : events) {
      if (const auto* const move = std::get_if<platform::MouseMove>(&event)) moves += presses > releases, last = *move;
      if (const auto* const button = std::get_if<platform::MouseButton>(&event)) {
        EXPECT_TRUE(button->modifiers.shift);
        ++(button->down ? presses : releases);
      }
    }
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(releases, 1);
  EXPECT_GE(moves, 4);
  EXPECT_FLOAT_EQ(last.x, 100 + 10 * 10.5f);
  EXPECT_FLOAT_EQ(last.y, 100 - 10 * 6.25f);
}

TEST(runner, a_drag_too_short_to_begin_fails_before_it_presses) {
  FakeHost fake;  // 10 pixels a metre
  const base::Status status = run_lines(fake, std::string(kTrack) + "aim.drag @k2 by 0.2 0.1 0\n");
  EXPECT_EQ(status.code, base::Code::expectation);
  EXPECT_NE(status.message.find("the drag is 2.2 pixels long, and shorter than 3 is a click: move the camera nearer"),
            std::string::npos)
      << status.message;
  for (const auto& [events, ticks] : fake.frames)
    for (const platform::Event& event : events) EXPECT_FALSE(std::holds_alternative<platform::MouseButton>(event));
}

TEST(runner, snap_looks_for_its_golden_beside_the_script) {
  FakeHost fake;
  ASSERT_TRUE(run_lines(fake, "snap \"apex\"\n").ok());
  EXPECT_EQ(fake.snapped["apex"], (test_folder() / "golden" / "apex.png").string());
}

TEST(runner, a_pad_line_moves_the_axes_that_it_names_and_lets_the_others_go) {
  FakeHost fake;
  ASSERT_TRUE(
      run_lines(fake, "pad left 0.25 -0.5 right 0.75 -1 triggers 0.1 0.2\npad right -0.3 0.4\npad rest\n").ok());
  std::vector<platform::GamepadAxes> seen;
  for (const auto& [events, ticks] : fake.frames)
    for (const platform::Event& event : events)
      if (const auto* const axes = std::get_if<platform::GamepadAxes>(&event)) seen.push_back(*axes);
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_EQ(seen[0], (platform::GamepadAxes{0.25f, -0.5f, 0.75f, -1, 0.1f, 0.2f}));
  EXPECT_EQ(seen[1], (platform::GamepadAxes{0, 0, -0.3f, 0.4f, 0, 0}));
  EXPECT_EQ(seen[2], platform::GamepadAxes{});
}

std::string read(const std::filesystem::path& path) {
  const auto text = base::Files().read(path);
  return text ? *text : "";
}

TEST(runner, a_failure_names_the_pass_of_each_repeat_and_each_including_line) {
  std::ofstream(test_folder() / "part.coaster") << "coaster-script 1\nrepeat 2\n  append at 1 2 3\n  expect knots < "
                                                   "6\nend\n";
  FakeHost fake;
  const std::string part = (test_folder() / "part.coaster").string();
  const base::Status status = run_lines(fake, "frames 1\nrepeat 5\n  include \"part.coaster\"\nend\n");
  EXPECT_EQ(status.message.find(part + ":4:10: error: expected knots < 6, found 6\n"), 0u) << status.message;
  EXPECT_TRUE(status.message.ends_with("\n  in pass 2 of 2 of the repeat at " + part +
                                       ":2\n  included at test.coaster:4\n"
                                       "  in pass 3 of 5 of the repeat at test.coaster:3"))
      << status.message;
  const std::string state = read(test_folder() / "out" / "state.json");
  for (const char* const text : {"\"error\"", "expected knots < 6, found 6", "\"pass\": 3", "\"of\": 5", "\"pass\": 2"})
    EXPECT_NE(state.find(text), std::string::npos) << text;
  // The first pass, the last one, and a statement after the repeat.
  for (const auto& [lines, end] : {std::pair{"repeat 4\nexpect knots == 7\nend\n", "in pass 1 of 4"},
                                   {"repeat 3\nappend at 1 2 3\nexpect knots < 9\nend\n", "in pass 3 of 3"},
                                   {"repeat 3\nappend at 1 2 3\nend\nexpect knots < 9\n", "state.json)"}})
    EXPECT_NE(run_lines(fake, lines).message.find(end), std::string::npos) << lines;
  EXPECT_EQ(run_lines(fake, "repeat 3\nframes 1\nend\nexpect knots < 9\n").message.find("pass"), std::string::npos);
}

// A ride that does not move cannot bring about what the script waits for.
TEST(runner, wait_says_at_once_that_the_ride_does_not_move) {
  const std::string track = kTrack;  // with its first train
  const struct {
    std::string lines;
    const char* reason;
    std::uint64_t most_ticks;
  } cases[] = {
      {"wait ride.lap == 1\n", "there is no train", 0},
      {track + "wait ride.lap == 1\n", "never started, or was stopped: write ride.start first", 0},
      {track + "wait ride.speed > 3 max 10 frames\n", "write ride.start", 0},
      {track + "wait not ride.state == stopped\n", "write ride.start", 0},
      {track + "ride.start\nticks 3\nride.pause\nwait ride.distance > 1000\n", "the ride is paused", 3},
      {track + "ride.start\nticks 3\nride.stop\nwait ride.distance > 1000\n", "or was stopped", 3},
      {track + "start_speed 30\nride.start\nwait ride.lap == 1 max 100000 ticks\n", "ran off the open end at ", 240},
      {track + "start_speed 30\nride.start\nwait ride.fail == stalled\n", "ran off the open end at ", 240},
      {track + "start_speed 30\nride.start\nwait ride.lap == 1 max 100000 frames\n", "ran off the open end at ", 240},
  };
  for (const auto& one : cases) {
    FakeHost fake;
    const base::Status status = run_lines(fake, one.lines);
    EXPECT_EQ(status.code, base::Code::timeout) << one.lines << status.message;
    EXPECT_NE(status.message.find(one.reason), std::string::npos) << one.lines << status.message;
    EXPECT_LE(fake.session.tick, one.most_ticks) << one.lines;
  }
}

TEST(runner, wait_goes_on_where_time_alone_can_bring_it_about) {
  FakeHost fake;
  const base::Status status =
      run_lines(fake, std::string(kTrack) +
                          "wait ride.state == stopped\nwait tick == 7\n"
                          "start_speed 30\nride.start\nwait ride.speed < 30\nwait ride.state == ended\n"
                          "wait ride.fail == \"ran off the open end\"\nwait ride.lap_time == none\nwait tick == 500\n");
  EXPECT_TRUE(status.ok()) << status.message;
  const base::Status other = run_lines(fake, "wait length > 1e6 max 9 ticks\n");
  EXPECT_NE(other.message.find("waited 9 ticks for length"), std::string::npos) << other.message;
}

TEST(runner, files_that_differ_say_where_in_their_own_terms) {
  FakeHost fake;
  const auto differ = [&](const std::string& a, const std::string& b) {
    std::ofstream(test_folder() / "a.bin", std::ios::binary) << a;
    std::ofstream(test_folder() / "b.bin", std::ios::binary) << b;
    return run_lines(fake, "expect file \"a.bin\" same \"b.bin\"\n").message;
  };
  using namespace std::string_literals;
  EXPECT_NE(differ("one\ntwo\nthree\n", "one\ntwo\nfour\n").find("a.bin differs from b.bin from line 3 on"),
            std::string::npos);
  EXPECT_NE(differ("one\ntwo\n", "one\n").find("from line 2 on"), std::string::npos);
  EXPECT_NE(differ("\0\n\n\n1"s, "\0\n\n\n2"s).find("from byte offset 4 on"), std::string::npos);
  EXPECT_NE(differ("abc", "abc\0"s).find("from byte offset 3 on"), std::string::npos);
}

TEST(runner, a_golden_picture_is_updated_once_a_run) {
  FakeHost fake;
  base::Files files;
  const ParsedScript parsed = parse_script("coaster-script 1\nsnap \"a\"\nsnap \"b\"\nrepeat 2\nsnap \"a\"\nend\n",
                                           "test.coaster", test_folder(), files);
  std::vector<std::pair<std::string, bool>> asked;
  const auto run = [&](bool update, base::Status third) {
    asked.clear();
    Host host = fake.host();
    host.snap = [&](const std::string& name, const std::filesystem::path&, const std::filesystem::path&, bool writes) {
      asked.emplace_back(name, writes);
      return asked.size() == 3 ? third : base::Status{};
    };
    return run_script(parsed.script, host, {*base::FileRoot().open(test_folder() / "out"), update, {}});
  };
  EXPECT_TRUE(run(true, {}).ok());
  EXPECT_EQ(asked, (std::vector<std::pair<std::string, bool>>{{"a", true}, {"b", true}, {"a", false}, {"a", false}}));
  const base::Status other{base::Code::expectation, "the picture differs"};
  EXPECT_NE(run(true, other).message.find("snap \"a\" was taken before in this run, of another picture"),
            std::string::npos);
  EXPECT_NE(run(false, other).message.find("error: the picture differs"), std::string::npos);
}

}  // namespace runner_test
}  // namespace coaster::script
