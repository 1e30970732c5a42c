// Scripts are parsed completely; each error has its position, the line, a caret and the nearest valid word.
#include "script/grammar.h"

#include <gtest/gtest.h>

#include <fstream>

namespace coaster::script {
namespace grammar_test {

ParsedScript parse(const std::string& text) {
  base::Files files;
  return parse_script(text, "a.coaster", testing::TempDir(), files);
}

ParsedScript parse_lines(const std::string& lines) { return parse("coaster-script 1\n" + lines); }

void write(const std::string& name, const std::string& text) { std::ofstream(testing::TempDir() + name) << text; }

TEST(grammar, every_statement_of_the_language_is_accepted) {
  const ParsedScript parsed = parse(
      "# a comment first\n\ncoaster-script 1\n"
      "env size 640x360 seed 7\nenv msaa 4 scale 1.5 size 800x600\n"
      "load \"tracks/hills.json\"\nsave \"$OUT/a.json\"\nnew\nframes 3\nticks 120\nframes\n"
      "expect knots == 12\nexpect geometric @k4 >= G1\nexpect length > 10.5 m\nexpect position @k3 == 1 2 3 +- 0.01\n"
      "expect ride.energy_drift < 1e-4\nexpect length == 3 +-0.1\nexpect length == 3 \u00b1 0.1\nexpect not "
      "closed\nexpect closed == off\n"
      "expect toast ~ \"limit\"\nexpect title ~ coaster\nexpect hash document == 5a1c09e27733d0b1\nexpect hash motion "
      "!= 0000000000000001\n"
      "expect visible \"Track/Add curve\"\nexpect not visible \"A/b\"\nexpect enabled \"A\"\nexpect not enabled \"A\"\n"
      "expect file \"$OUT/a.json\" same \"golden/a.json\"\nexpect file \"a\" exists\nexpect not file \"a\" exists\n"
      "expect error load \"x\"\nexpect error split @s1 at 0.5 ~ \"no\"\nexpect error move @k1 to 1e39 0 0\nexpect "
      "error ~ \"limit\"\n"
      "wait ride.lap == 1 max 7200 ticks\nwait uploads == 0 max 5 frames\nwait ride.speed > 3 max 10 seconds\nwait "
      "ride.lap == 1\n"
      "repeat 3\n  gesture\n    move @k4 to 1 2 3\n  end\nend\nselect @k4\nselect @s2 at 0.3\nselect none\nundo\nredo\n"
      "ui.click \"Evaluation/Forward differences\"\nui.check \"Track/Closed\" on\nui.type \"Inspector/Position/x\" "
      "\"1e39\"\n"
      "ui.drag \"A/b\" by 12 px\nui.drag \"A/b\" by -3.5\nui.drag \"A/b\" to 64\nui.open \"Track\"\nui.menu "
      "\"Edit/Undo\"\nui.scroll \"Track\" 3\n"
      "key Ctrl+Z\ntext \"hello\"\nwheel -2\nwheel 1 at 30 40\ndrop \"a.json\"\nfocus off\nresize 800x600\nresize 800 "
      "600\nminimise\nscale 1.5\n"
      "aim.click @k3\naim.click +shift @k3.in\naim.click @k3.out +ctrl\naim.hover @s2:0.4\naim.doubleclick "
      "@c1\naim.click ground 10 0 -4\n"
      "aim.drag @k4.out by 0 3.5 0\naim.drag @k4.spin by 0 1 0\naim.drag @k4 to 1 2 3\naim.drag +alt @k4 to "
      "@k5\naim.drag @k4 to ground 1 0 "
      "3\naim.click world 1 2 3\n"
      "camera target 1 2 3 yaw 10 pitch 20 distance 30\ncamera yaw 5\ncamera all\ncamera selection\ncamera fit\n"
      "ride.start\nride.pause\nride.stop\nride.seek 12\nride.seek to 3\n"
      "snap \"apex\"\nshot \"$OUT/x.png\"\ndump \"x\"\nlog hash document\nlog \"text\"\nlog ride.speed \"m/s\" "
      "position @k1\n"
      "fault io.fsync fail 3\nfault import slow 30\nraw.move 1 2\nraw.press left\nraw.release left\nraw.key F "
      "down\nraw.key F up\n");
  // "ride.seek to 3" is no command: the distance follows at once.
  ASSERT_EQ(parsed.errors.size(), 1u) << parsed.errors.front();
  EXPECT_NE(parsed.errors[0].find("ride.seek to 3"), std::string::npos) << parsed.errors[0];
}

TEST(grammar, all_errors_are_reported_with_place_line_caret_and_nearest_word) {
  const ParsedScript parsed = parse_lines("fraems 3\nframes 2\n  key Ctrl+Banana\nexpect knotz == 3\nend\n");
  ASSERT_EQ(parsed.errors.size(), 4u);
  EXPECT_EQ(parsed.errors[0],
            "a.coaster:2:1: error: no command \"fraems\"\n    fraems 3\n    ^ did you mean \"frames\"?");
  EXPECT_EQ(parsed.errors[1].find("a.coaster:4:7: error: expected a key"), 0u) << parsed.errors[1];
  EXPECT_NE(parsed.errors[1].find("\n    key Ctrl+Banana\n        ^"), std::string::npos) << parsed.errors[1];
  EXPECT_EQ(parsed.errors[2],
            "a.coaster:5:8: error: no query \"knotz\"\n    expect knotz == 3\n           ^ did you mean \"knots\"?");
  EXPECT_EQ(parsed.errors[3].find("a.coaster:6:1: error: \"end\" without"), 0u) << parsed.errors[3];
}

TEST(grammar, words_of_other_programs_lead_to_what_to_write) {
  const auto message = [](const std::string& line) {
    const ParsedScript parsed = parse_lines(line + "\n");
    return parsed.errors.size() == 1 ? parsed.errors[0] : "";
  };
  const auto ends = [&](const std::string& line, const std::string& end) {
    EXPECT_TRUE(message(line).ends_with(end)) << line << ": " << message(line);
  };
  ends("click \"Track/Add curve\"", "^ did you mean \"ui.click\"?");
  ends("paste", "^ did you mean \"section.paste\"?");
  ends("assert knots == 3", "^ did you mean \"expect\"?");
  ends("screenshot \"a.png\"", "^ did you mean \"shot\"?");
  ends("ride start", "^ did you mean \"ride.start\"?");
  ends("ui click \"Ride/Play\"", "^ did you mean \"ui.click\"?");
  ends("for i in 1..3", "^ did you mean \"repeat\"?");
  ends("check \"Track/Closed\" on", "^ did you mean \"ui.check\"?");
  EXPECT_NE(message("let n = 3").find("scripts have no variables"), std::string::npos);
  EXPECT_NE(message("while knots < 3").find("wait waits for one"), std::string::npos);
  ends("goto \"tracks/loop.json\"", "^ did you mean \"load\"?");
  ends("await page.fill('#length', '3');", "^ did you mean \"ui.type\"?");
  ends("await", "^ did you mean \"wait\"?");
  ends("page.getByRole('button').click()",
       "widgets are named by label: ui.click \"Track/Insert point\"\n"
       "    page.getByRole('button').click()\n    ^");
  ends("ctx->ItemClick(\"Track/Insert point\");", "^ did you mean \"ui.click\"?");
  ends("page.click(\"Track/Insert point\")", "^ did you mean \"ui.click\"?");
  ends("}", "^ did you mean \"end\"?");
  EXPECT_NE(message("ui.click Track/Insert point")
                .find(":2:23: error: unexpected \"point\": a text with blanks needs quotes"),
            std::string::npos);
  EXPECT_NE(message("text hello world").find("unexpected \"world\": a text"), std::string::npos);
  EXPECT_NE(message("wait 500ms").find("found \"500ms\"; ticks N or frames N"), std::string::npos);
  EXPECT_NE(message("log(\"a\")").find(":2:4: error: expected a blank instead of the bracket\n"), std::string::npos);
  EXPECT_NE(message("log a\"b\"").find(":2:6: error: expected a blank before the quote\n"), std::string::npos);
  ends("expect knots 29", "^ did you mean \"== 29\"?");
  ends("expect knots is 29", "^ did you mean \"==\"?");
  ends("expect toast contains \"saved\"", "^ did you mean \"~\"?");
  ends("expect knots at 29", "^");
  for (const std::string opener : {"repeat 3 {", "repeat 3:"}) {
    const ParsedScript parsed = parse_lines(opener + "\n  frames\nend\n");
    ASSERT_EQ(parsed.errors.size(), 1u) << opener;
    EXPECT_NE(parsed.errors[0].find("a block has no { or :, only an \"end\"\n"), std::string::npos) << parsed.errors[0];
  }
  EXPECT_NE(message("hold W 30").find("; raw.key W down presses a key until raw.key W up"), std::string::npos);
  ends("expect(page).toBeVisible()", "^ did you mean \"expect\"?");
  EXPECT_NE(message("waitForSelector \"Track/Length\"").find("; wait visible \"Track/Insert point\" waits"),
            std::string::npos);
  EXPECT_NE(message("qqqqqq 1").find("no command \"qqqqqq\"; coaster --help-script lists all"), std::string::npos);
  EXPECT_NE(
      message("wait 100").find(":2:6: error: expected a query such as ride.lap, found \"100\"; ticks N or frames N"),
      std::string::npos);
}

TEST(grammar, keys_and_targets_of_other_programs_lead_to_what_to_write) {
  const auto ends = [](const std::string& line, const std::string& end) {
    const ParsedScript parsed = parse_lines(line + "\n");
    ASSERT_EQ(parsed.errors.size(), 1u) << line;
    EXPECT_NE(parsed.errors[0].find(end), std::string::npos) << line << ": " << parsed.errors[0];
  };
  ends("key Ctrl-Z", "^ did you mean \"Ctrl+Z\"?");
  ends("key ctrl z", "^ did you mean \"Ctrl+Z\"?");
  ends("key Ctrl Shift Z", "^ did you mean \"Ctrl+Shift+Z\"?");
  ends("key Super+Z", "found \"Super+Z\"; only Ctrl, Shift and Alt can come before a key");
  ends("key Ctrl+Escpe", "^ did you mean \"Escape\"?");
  EXPECT_TRUE(parse_lines("key Strg+Z\n").errors.empty());
  ends("aim.click k1", "^ did you mean \"@k1\"?");
  ends("aim.drag k1.out by 0 1 0", "^ did you mean \"@k1.out\"?");
  ends("aim.click knob", "or world X Y Z, found \"knob\"\n");
  ends("env scale 0", "expected a scale from 0.75 to 3, found \"0\"");
  ends("fault io.read fail 0", "expected the number of the call that fails (1..1000000), found \"0\"");
}

TEST(grammar, the_goal_of_a_search_is_parsed_before_the_script_runs) {
  const auto place = [](const std::string& line) {
    const ParsedScript parsed = parse_lines(line + "\n");
    return parsed.errors.empty() ? "" : parsed.errors[0].substr(0, parsed.errors[0].find('\n'));
  };
  EXPECT_EQ(place("seek ride.lap_time == 40 by height of @k3..@k9"), "");
  EXPECT_EQ(place("seek ride.lap_tim == 40 by height of @k3"), "a.coaster:2:6: error: no query \"ride.lap_tim\"");
  EXPECT_EQ(place("expect error seek ride.lap_time == x by height of @k3"),
            "a.coaster:2:36: error: expected a number (s), found \"x\"");
  EXPECT_EQ(place("seek name == 3 by height of @k3"),
            "a.coaster:2:6: error: \"name\" cannot be sought: expected a query of track or ride with a number");
  EXPECT_EQ(place("seek ride.lap_time != 40 by height of @k3").substr(0, 37), "a.coaster:2:6: error: expected a goal");
}

TEST(grammar, a_lesson_with_an_error_still_owns_its_end) {
  const ParsedScript parsed = parse_lines("lesson \"Close it.\" until closed == onn\nclosed on\nend\n");
  ASSERT_EQ(parsed.errors.size(), 1u) << parsed.errors[1];
  EXPECT_EQ(parsed.errors[0].find("a.coaster:2:36: error: expected off or on"), 0u) << parsed.errors[0];
}

TEST(grammar, a_search_changes_numbers_that_exist) {
  const auto error = [](const std::string& line) {
    const ParsedScript parsed = parse_lines("seek ride.lap_time == 40 by " + line + "\n");
    return parsed.errors.empty() ? "" : parsed.errors[0];
  };
  const std::string height = error("heigth of @k3..@k9");
  EXPECT_EQ(height.find("a.coaster:2:29: error: expected height, x, z, place or roll of knots, found \"heigth\""), 0u)
      << height;
  EXPECT_NE(height.find("did you mean \"height\"?"), std::string::npos) << height;
  EXPECT_NE(error("radius of @k3"), "");
  EXPECT_NE(error("place of @q2").find("of sections, found \"place\""), std::string::npos) << error("place of @q2");
  EXPECT_NE(error("vertcal at 40 of @q2"), "");
  EXPECT_NE(error("heigth of all").find("of knots or sections"), std::string::npos);
  for (const char* const fine : {"roll of @k3", "radius of @q2", "vertical at 40 of @q2", "length of all",
                                 "height of selected", "place of all except @k1"})
    EXPECT_EQ(error(fine), "") << fine;
}

TEST(grammar, the_header_is_required_and_newer_versions_are_refused) {
  EXPECT_EQ(parse("frames 1\n").errors.size(), 1u);
  EXPECT_EQ(parse("").errors.size(), 1u);
  ASSERT_EQ(parse("coaster-script 2\nframes 1\n").errors.size(), 1u);
  EXPECT_NE(parse("coaster-script 2\n").errors[0].find("version 2"), std::string::npos);
  EXPECT_EQ(parse("coaster-script\n").errors.size(), 1u);
  EXPECT_TRUE(parse("\xEF\xBB\xBF# mark\r\ncoaster-script 1\r\n\tframes 1\r\n").errors.empty());
}

TEST(grammar, lines_end_as_on_any_system_and_text_is_utf8) {
  const ParsedScript old = parse("coaster-script 1\rframes 1\r\rfrmaes 2\r");
  ASSERT_EQ(old.errors.size(), 1u);
  EXPECT_EQ(old.errors[0].find("a.coaster:4:1: error: no command \"frmaes\""), 0u) << old.errors[0];
  for (const std::string& wide :
       {std::string("\xff\xfe"
                    "c\0\n\0",
                    6),
        std::string("\xfe\xff\0c\0\n", 6), std::string("c\0\n\0", 4), std::string("\0c\0\n", 4)}) {
    const ParsedScript parsed = parse(wide);
    ASSERT_EQ(parsed.errors.size(), 1u);
    EXPECT_EQ(parsed.errors[0], "a.coaster:1:1: error: UTF-16 text: save it as UTF-8");
  }
}

TEST(grammar, a_nul_is_refused_in_quotes_and_outside) {
  for (const std::string& line : {std::string("log \"a\0b\"", 9), std::string("log  a\0b", 8)}) {
    const ParsedScript parsed = parse_lines(line);
    ASSERT_EQ(parsed.errors.size(), 1u);
    EXPECT_EQ(parsed.errors[0].find("a.coaster:2:7: error: unexpected control character \\u0000"), 0u)
        << parsed.errors[0];
  }
}

TEST(grammar, nesting_beyond_the_limit_is_one_error_with_the_limit) {
  std::string lines;
  for (int i = 0; i < kMaxBlockDepth + 3; ++i) lines += "repeat 1\n";
  for (int i = 0; i < kMaxBlockDepth + 3; ++i) lines += "end\n";
  const ParsedScript parsed = parse_lines(lines);
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_EQ(parsed.errors[0].find("a.coaster:66:1: error: blocks are nested more than 64 deep"), 0u)
      << parsed.errors[0];
  const std::string header = "coaster-script 1\n";
  write("deep0.coaster", header + "frames 1\n");
  for (int i = 1; i <= kMaxIncludeDepth + 1; ++i)
    write("deep" + std::to_string(i) + ".coaster", header + "include \"deep" + std::to_string(i - 1) + ".coaster\"\n");
  EXPECT_TRUE(parse_lines("include \"deep" + std::to_string(kMaxIncludeDepth - 1) + ".coaster\"\n").errors.empty());
  const ParsedScript deep = parse_lines("include \"deep" + std::to_string(kMaxIncludeDepth) + ".coaster\"\n");
  ASSERT_EQ(deep.errors.size(), 1u);
  EXPECT_NE(deep.errors[0].find("includes are nested more than 16 deep"), std::string::npos) << deep.errors[0];
}

TEST(grammar, blocks_nest_and_must_be_closed) {
  const ParsedScript parsed = parse_lines("repeat 2\nrepeat 3\nframes 1\nend\nticks 1\nend\n");
  ASSERT_TRUE(parsed.errors.empty());
  ASSERT_EQ(parsed.script.statements.size(), 1u);
  const Statement& outer = parsed.script.statements[0];
  EXPECT_EQ(std::get<Repeat>(outer.action).count, 2);
  ASSERT_EQ(outer.body.size(), 2u);
  EXPECT_EQ(std::get<Repeat>(outer.body[0].action).count, 3);
  const ParsedScript open = parse_lines("repeat 2\nframes 1\n");
  ASSERT_EQ(open.errors.size(), 1u);
  EXPECT_EQ(open.errors[0].find("a.coaster:2:1: error: no \"end\""), 0u);
}

TEST(grammar, of_a_long_line_the_part_around_the_error_is_shown) {
  Source source{"a.coaster", ".", {}};
  source.lines = {"  " + std::string(5'000'000, '\x1b') + "wrong" + std::string(5'000'000, 'z')};
  const std::string shown = describe_error(source, {source.name, 1, 5'000'003, "no", {}});
  EXPECT_LT(shown.size(), 2'000u);
  EXPECT_NE(shown.find("...\\u001b"), std::string::npos);
  EXPECT_NE(shown.find("wrongzz"), std::string::npos);
  const std::size_t caret = shown.rfind('^') - shown.rfind('\n'), text = shown.find("wrong");
  EXPECT_EQ(text - shown.rfind('\n', text), caret);
}

TEST(grammar, errors_stop_at_twenty_with_a_count) {
  std::string lines;
  for (int i = 0; i < 33; ++i) lines += "splat\n";
  const ParsedScript parsed = parse_lines(lines);
  ASSERT_EQ(parsed.errors.size(), kMaxErrors + 1);
  EXPECT_EQ(parsed.errors.back(), "and 13 more");
  write("prose.txt", "many words\n");
  EXPECT_EQ(parse_lines(lines + "include \"prose.txt\"\n").errors.size(), kMaxErrors + 1) << "none of them empty";
  EXPECT_EQ(parse_lines(lines + "include \"prose.txt\"\n").errors.back(), "and 14 more");
}

// Eight includes of eight includes, and so on: an exponential script of small files.
TEST(grammar, the_lines_of_all_includes_are_limited) {
  write("leaf.coaster", std::string(5000, '\n'));
  std::string below = "leaf.coaster";
  for (int level = 0; level < 8; ++level) {
    const std::string name = "level" + std::to_string(level) + ".coaster";
    std::string text;
    for (int i = 0; i < 8; ++i) text += "include \"" + below + "\"\n";
    write(name, text);
    below = name;
  }
  const ParsedScript parsed = parse_lines("include \"" + below + "\"\n");
  ASSERT_FALSE(parsed.errors.empty());
  EXPECT_NE(parsed.errors[0].find("limit of 500000 lines"), std::string::npos) << parsed.errors[0];
  EXPECT_LT(parsed.lines, 2 * kMaxLines);
  EXPECT_EQ(parse_lines(std::string(kMaxLines, '\n')).errors.size(), 1u);
}

TEST(grammar, terminal_escapes_of_a_line_are_shown_as_text_above_the_caret) {
  const ParsedScript parsed = parse_lines("log \"\u009b\" splat\n");
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_NE(parsed.errors[0].find("\n    log \"\\u009b\" splat\n                 ^"), std::string::npos)
      << parsed.errors[0];
}

TEST(grammar, errors_name_what_was_expected_and_what_was_found) {
  const ParsedScript parsed = parse_lines(
      "env density 5\nresize 80 now\nresize 8x6 now\nshot \"a.jpg\"\nwait knots == 3 max 1 ms\n"
      "wait knots == 3 max 0.5 seconds\n");
  const std::vector<std::string> wanted{"expected a density from 0.5 to 4, found \"5\"",
                                        "expected WIDTHxHEIGHT such as 1280x720, up to 7680x4320, found \"80xnow\"",
                                        "unexpected \"now\" after the end of the statement",
                                        "expected a file below $OUT ending in .png, found \"a.jpg\"",
                                        "expected ticks, frames or seconds, found \"ms\"",
                                        "expected a number of ticks, frames or seconds (0..10000000), found \"0.5\""};
  ASSERT_EQ(parsed.errors.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_NE(parsed.errors[i].find("error: " + wanted[i]), std::string::npos) << parsed.errors[i];
}

TEST(grammar, words_left_over_and_missing_ones_are_errors) {
  for (const char* const line : {"frames 1 2",
                                 "frames -1",
                                 "ticks x",
                                 "env",
                                 "env density 5",
                                 "resize 800x600 now",
                                 "shot \"$OUT/a.jpg\"",
                                 "sheet \"$OUT/a.gif\" \"a.png\"",
                                 "sheet \"$OUT/a.png\" \"a\"",
                                 "env size 640",
                                 "env size 0x3",
                                 "ui.click",
                                 "ui.click \"a\" \"b\"",
                                 "ui.drag \"a\"",
                                 "aim.click",
                                 "aim.click @z3",
                                 "aim.click @s2:1.5",
                                 "aim.drag @k1",
                                 "aim.drag @k1 by 1 2",
                                 "aim.click @c1.in",
                                 "expect",
                                 "expect knots",
                                 "expect knots ==",
                                 "expect knots 3",
                                 "expect position == 1 2 3",
                                 "wait ride.lap == 1 max",
                                 "wait ride.lap == 1 max 3 days",
                                 "fault io.sync fail 1",
                                 "fault io.read",
                                 "fault import",
                                 "fault import slow",
                                 "fault import slow 0",
                                 "snap",
                                 "snap \"../x\"",
                                 "dump \"../x\"",
                                 "log",
                                 "log nothing",
                                 "key",
                                 "raw.key F sideways",
                                 "repeat x\nend",
                                 "focus maybe",
                                 "expect error",
                                 "expect error laod \"x\"",
                                 "expect error move @k4",
                                 "expect error move @k4 1 2 3",
                                 "expect error move @k4 to 1 2",
                                 "expect error move @k4 to 1 2 x",
                                 "expect error move @k4 to 1 2 3 4",
                                 "expect error frames_by bishop",
                                 "expect error resize 800xnow",
                                 "expect error element.choose loop wide 3",
                                 "expect error camera yaw west ~ \"number\"",
                                 "expect error expect knotz == 3",
                                 "expect error expect error new now",
                                 "expect error end",
                                 "expect error include \"a\"",
                                 "expect error repeat 3",
                                 "expect length == 3 +-",
                                 "expect length == 3 +- -1",
                                 "camera",
                                 "camera roll 3",
                                 "text \"open",
                                 "movie.start",
                                 "movie.start \"$OUT/m\" fps 25",
                                 "movie.start \"$OUT/m\" fps",
                                 "movie.start \"$OUT/m\" gif gif",
                                 "movie.stop now",
                                 "pad",
                                 "pad left 1",
                                 "pad left 0 1.5",
                                 "pad triggers -1 0",
                                 "pad a b",
                                 "pad z",
                                 "expect visible",
                                 "expect file \"a\" like \"b\""}) {
    const std::string text = line;
    if (text == "expect knots") continue;  // a value alone: that it is true
    EXPECT_EQ(parse_lines(text).errors.size(), 1u) << line;
  }
}

TEST(grammar, of_a_line_that_must_fail_only_numbers_may_be_wrong) {
  const ParsedScript wrong = parse_lines("expect error move @k4\nexpect error mvoe @k4 to 1 2 3 ~ \"command\"\n");
  ASSERT_EQ(wrong.errors.size(), 2u);
  EXPECT_EQ(wrong.errors[0],
            "a.coaster:2:22: error: expected \"to\" at the end of the line; usage: move @knot to X Y Z\n"
            "    expect error move @k4\n"
            "                         ^");
  EXPECT_EQ(wrong.errors[1],
            "a.coaster:3:14: error: no command \"mvoe\"\n    expect error mvoe @k4 to 1 2 3 ~ \"command\"\n"
            "                 ^ did you mean \"move\"?");
  for (const char* const line :
       {"move @k1 to 1e39 0 0", "move @k1 to 1e999 0 0", "move @k1 to nan -inf 0", "resolution 99999999999",
        "resolution 2.5", "frames -1", "env density 5", "pad left 0 1.5", "aim.click @s2:1.5", "camera yaw 1e99",
        "movie.start \"$OUT/m\" fps 25", "select @k99", "load \"no\"", "expect knots == 4", "ui.click \"no\""}) {
    const ParsedScript parsed = parse_lines("expect error " + std::string(line));
    EXPECT_TRUE(parsed.errors.empty()) << line << ": " << parsed.errors.front();
  }
}

TEST(grammar, includes_are_read_beside_the_script_and_cycles_are_refused) {
  write("inner.coaster", "frames 2\nfrmaes 3\n");
  const ParsedScript parsed = parse_lines("include \"inner.coaster\"\n");
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_NE(parsed.errors[0].find("inner.coaster:2:1: error: no command"), std::string::npos) << parsed.errors[0];
  write("self.coaster", "coaster-script 1\ninclude \"self.coaster\"\n");
  const ParsedScript cycle = parse_lines("include \"self.coaster\"\n");
  ASSERT_EQ(cycle.errors.size(), 1u);
  EXPECT_NE(cycle.errors[0].find("includes itself"), std::string::npos);
  EXPECT_EQ(parse_lines("include \"not-there.coaster\"\n").errors.size(), 1u);
  // A file that is no script is not printed, not even word by word.
  write("secret.txt", "\n# users\nroot:x:0\nhunter2\n");
  const ParsedScript secret = parse_lines("splat\ninclude \"secret.txt\"\n");
  ASSERT_EQ(secret.errors.size(), 2u);
  EXPECT_NE(secret.errors[1].find("\"secret.txt\" is not a script: its line 3 is no"), std::string::npos)
      << secret.errors[1];
  EXPECT_NE(secret.errors[1].find("begin it with \"coaster-script 1\""), std::string::npos) << secret.errors[1];
  for (const char* const word : {"root", "hunter2"})
    EXPECT_EQ(secret.errors[1].find(word), std::string::npos) << secret.errors[1];
  write("part.coaster", "coaster-script 1\nfrmaes 1\nhunter2\n");
  EXPECT_EQ(parse_lines("include \"part.coaster\"\n").errors.size(), 2u);
}

TEST(grammar, errors_in_included_files_name_every_including_line_in_text_and_json) {
  write("chain_b.coaster", "coaster-script 1\nframes 1\nexpect knotz == 1\n");
  write("chain_a.coaster", "coaster-script 1\n\ninclude \"chain_b.coaster\"\n");
  const ParsedScript parsed = parse_lines("repeat 2\n  include \"chain_a.coaster\"\nend\nfraems 1\n");
  ASSERT_EQ(parsed.errors.size(), 2u);
  const std::string a = testing::TempDir() + "chain_a.coaster", b = testing::TempDir() + "chain_b.coaster";
  EXPECT_EQ(parsed.errors[0], b +
                                  ":3:8: error: no query \"knotz\"\n    expect knotz == 1\n           ^ did you mean "
                                  "\"knots\"?\n  included at " +
                                  a + ":3\n  included at a.coaster:3");
  EXPECT_TRUE(parsed.errors[1].ends_with("did you mean \"frames\"?")) << parsed.errors[1];
  ASSERT_EQ(parsed.problems.size(), 2u);
  const std::string json = exchange::json_members(to_json(parsed.problems[0]));
  for (const std::string part :
       {"\"line\": 3", "\"column\": 8", "no query", "did you mean", "chain_a.coaster\"", "\"file\": \"a.coaster\""})
    EXPECT_NE(json.find(part), std::string::npos) << part << ": " << json;
  EXPECT_EQ(json.find("\"pass\""), std::string::npos) << "nothing runs yet";
  EXPECT_EQ(parsed.problems[0].from.size(), 2u);
  EXPECT_TRUE(parsed.problems[1].from.empty());
}

TEST(grammar, a_place_on_a_curve_is_a_parameter_from_0_to_1) {
  for (const char* const good : {"@s1:0", "@s1:1", "@s1:0.5", "@s1"})
    EXPECT_TRUE(parse_lines(std::string("aim.click ") + good + "\n").errors.empty()) << good;
  for (const char* const bad : {"@s1:1.5", "@s1:-0.1", "@s1:", "@s1:nan", "@s1:1e9", "@k1:", "@k1:0.5", "@s1:0.5x"})
    EXPECT_EQ(parse_lines(std::string("aim.hover ") + bad + "\n").errors.size(), 1u) << bad;
}

// Recordings have the command.
TEST(grammar, drop_takes_a_file_or_knots) {
  const auto action = [](const std::string& line) { return parse_lines(line + "\n").script.statements.at(0).action; };
  for (const char* const knots : {"@k1", "@k1,@k2 to 3", "@k1..@k4", "all to 2", "selected"})
    EXPECT_TRUE(std::holds_alternative<RunCommand>(action(std::string("drop ") + knots))) << knots;
  for (const char* const file : {"a.json", "\"@k1\"", "\"all\"", "\"a b.json\""})
    EXPECT_TRUE(std::holds_alternative<Input>(action(std::string("drop ") + file))) << file;
  EXPECT_EQ(parse_lines("drop @k1 too 3\n").errors.size(), 1u);
}

}  // namespace grammar_test
}  // namespace coaster::script
