#include "edit/commands/codec.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "edit/commands/command.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "edit/random_commands.h"
#include "world/element_rows.h"

namespace coaster::edit {
namespace codec_test {

base::Result<Command> parsed(const std::string& line, base::TextError& error) {
  std::vector<base::Token> tokens;
  if (!base::tokenise(line, tokens, error)) return base::Status{base::Code::usage, error.message};
  return parse(tokens, error);
}

// Member by member, with ==. A place on what is no segment has no text and no meaning.
bool equal(const Command& a, const Command& b) {
  if (index_of(a) != index_of(b)) return false;
  static constexpr auto kEqual = Commands::table([]<class C>() -> bool (*)(const Command&, const Command&) {
    return [](const Command& one, const Command& other) {
      bool same = true;
      std::vector<const void*> values;
      C::fields(*other.as<C>(), [&](std::string_view, const auto& value) { values.push_back(&value); });
      std::size_t i = 0;
      C::fields(*one.as<C>(), [&](std::string_view name, const auto& value) {
        const auto& counterpart = *static_cast<const std::decay_t<decltype(value)>*>(values[i++]);
        if (name.find('?') == name.npos) same = same && value == counterpart;
      });
      return same;
    };
  });
  return kEqual[index_of(a)](a, b);
}

TEST(codec, what_print_writes_parse_reads_back) {
  test::RandomCommands random(4711);
  for (std::size_t kind = 0; kind < Commands::size; ++kind)
    for (int i = 0; i < 100; ++i) {
      const Command command = random.of_kind(kind);
      const std::string line = print(command);
      base::TextError error;
      const auto back = parsed(line, error);
      ASSERT_TRUE(back) << line << ": " << error.message;
      ASSERT_TRUE(equal(*back, command)) << line;
      ASSERT_EQ(print(*back), line);
      ASSERT_EQ(line.find('\n'), std::string::npos);
    }
}

TEST(codec, the_history_says_in_words_what_commands_did) {
  test::RandomCommands random(815);
  for (std::size_t kind = 0; kind < Commands::size; ++kind) {
    const Command command = random.of_kind(kind);
    const std::string name(info(command).name), full = done(command, {});
    const std::size_t quoted = full.find('"');  // text of the user's own
    const std::string text = quoted == std::string::npos ? full : full.substr(0, quoted) + "TEXT";
    if (info(command).effect != Effect::document) {
      EXPECT_EQ(text, "") << name;
      continue;
    }
    ASSERT_FALSE(text.empty()) << name;
    EXPECT_TRUE(text[0] >= 'A' && text[0] <= 'Z') << text;
    EXPECT_EQ(text.find_first_of("{}@"), std::string::npos) << text;
    EXPECT_EQ(text.find("  "), std::string::npos) << text;
    EXPECT_NE(text.back(), ' ') << text;
    EXPECT_FALSE(text.starts_with(name + " ")) << text;
  }
  const world::Document document;
  const world::EntityName k4{world::EntityKind::knot, 4}, k5{world::EntityKind::knot, 5};
  EXPECT_EQ(done(MoveKnot{{k4}, {1, 2, 3}}, document), "Moved k4");
  EXPECT_EQ(done(MoveHandle{{k4, HandleEnd::in}, {1, 2, 3}}, document), "Moved the incoming handle of k4");
  EXPECT_EQ(done(SetRoll{Knots({k4, k5}), -12.5}, document), "Set the roll of 2 knots to -12.5\u00B0");
  EXPECT_EQ(done(SetJoint{k4, world::JointKind::automatic}, document), "Set the joint of k4 to automatic");
  EXPECT_EQ(
      done(ChangeSection{{{world::EntityKind::section, 2}}, false, world::usual_element(world::ElementKind::climb)},
           document),
      "Changed q2");
  EXPECT_EQ(done(SetClosed{true}, document), "Closed the track");
  EXPECT_EQ(done(SetClosed{false}, document), "Opened the track");
  EXPECT_EQ(done(SetTrackName{"Comet"}, document), "Named the track \"Comet\"");
  EXPECT_EQ(done(Smooth{Knots(Knots::Which::all)}, document), "Smoothed all knots");
  EXPECT_EQ(done(SetRollbackFails{false}, document), "Rollbacks no longer end the ride");
}

TEST(codec, commands_read_as_documented) {
  EXPECT_EQ(print(Save{"a.json"}), "save \"a.json\"");
  EXPECT_EQ(print(Save{"a.json", {true}}), "save \"a.json\" overwrite");
  EXPECT_EQ(print(MoveKnot{{{world::EntityKind::knot, 4}}, {1, 2.5f, -3}}), "move @k4 to 1 2.5 -3");
  EXPECT_EQ(print(MoveHandle{{{world::EntityKind::knot, 4}, HandleEnd::in}, {1, 2, 3}}), "handle @k4.in to 1 2 3");
  EXPECT_EQ(print(SplitSegment{{{world::EntityKind::segment, 3}}, 0.5}), "split @s3:0.5");
  EXPECT_EQ(print(SetHandleLengths{{{world::EntityKind::knot, 1}}, 4, 6}), "lengths @k1 in 4 out 6");
  Knots two;
  two.names = {{world::EntityKind::knot, 1}, {world::EntityKind::knot, 12}};
  EXPECT_EQ(print(Translate{two, {1, 2, 3}, true}), "translate @k1,@k12 by 1 2 3 from_start on");
  base::TextError error;
  const auto former = parsed("translate @k1,@k12 by 1 2 3 anew on", error);
  ASSERT_TRUE(former.ok()) << error.message;
  EXPECT_EQ(print(*former), "translate @k1,@k12 by 1 2 3 from_start on") << "by its former name";
  for (const auto& [line, now] :
       {std::pair{"split @s3 at 0.4", "split @s3:0.4"}, {"select @s2 at 1", "select @s2:1"}}) {
    const auto place = parsed(line, error);
    ASSERT_TRUE(place.ok()) << error.message;
    EXPECT_EQ(print(*place), now) << "by its former form";
  }
  EXPECT_EQ(print(Smooth{Knots::Which::selected, world::SplineSteps::uniform}), "smooth selected by uniform");
  Knots range = two;
  range.which = Knots::Which::range;
  EXPECT_EQ(print(Smooth{range}), "smooth @k1..@k12 by chord");
  SeekGoal seek;
  seek.goal.text = "ride.lap_time == 40 +-0.1", seek.by.text = "height",
  seek.of.names = {{world::EntityKind::section, 2}};
  EXPECT_EQ(print(seek),
            "seek ride.lap_time == 40 +-0.1 by height of @q2 except none above -1e+05 below 1e+05 together off");
  EXPECT_EQ(print(SetSnapping{world::SnapTo::grid, 0.5, 30}), "snapping grid step 0.5 angle 30");
  EXPECT_EQ(print(SetTrain{{{world::EntityKind::cart, 1}}, 3, 2.5f}), "train @c1 cars 3 spacing 2.5 length 0 mass 0");
  EXPECT_EQ(print(SetClosed{false}), "closed off");
  EXPECT_EQ(print(SetTrackName{"a \"b\""}), R"(name "a \"b\"")");
  EXPECT_EQ(print(Select{}), "select none");
  EXPECT_EQ(print(Select{{{world::EntityKind::knot, 2}}, 0.3}), "select @k2");
  EXPECT_EQ(print(Select{{{world::EntityKind::segment, 2}}, 0.3}), "select @s2:0.3");
  EXPECT_EQ(print(RideStart{}), "ride.start");
}

TEST(codec, a_camera_line_has_one_value_or_more) {
  base::TextError error;
  const auto camera = parsed("camera distance 40 target 1 2 3", error);
  ASSERT_TRUE(camera) << error.message;
  EXPECT_EQ(print(*camera), "camera target 1 2 3 distance 40");
  for (const char* line : {"camera", "camera distance 40 roll 3"}) {
    EXPECT_FALSE(parsed(line, error)) << line;
    EXPECT_NE(error.message.find("expected target, yaw, pitch or distance"), std::string::npos) << error.message;
  }
}

TEST(codec, the_place_of_a_selection_may_be_left_out) {
  base::TextError error;
  const auto select = parsed("select @s2", error);
  ASSERT_TRUE(select);
  EXPECT_EQ(select->as<Select>()->at, 0.5);
}

TEST(codec, errors_have_the_column_of_the_word_and_say_what_was_expected) {
  const auto expect_error = [](const std::string& line, int column, std::string_view part) {
    base::TextError error;
    ASSERT_FALSE(parsed(line, error)) << line;
    EXPECT_EQ(error.column, column) << line;
    EXPECT_NE(error.message.find(part), std::string::npos) << line << ": " << error.message;
  };
  expect_error("", 1, "expected a command");
  expect_error("  mvoe @k1 to 1 2 3", 3, "did you mean \"move\"");
  expect_error("move", 5, "expected an entity");
  expect_error("move k1 to 1 2 3", 6, "expected an entity such as @k3");
  expect_error("move @k1 ot 1 2 3", 10, "expected \"to\"");
  expect_error("move @k1 to 1 2", 16, "z of three");
  expect_error("move @k1 to 1 2 x", 17, "found \"x\"");
  expect_error("move @k1 to 1e39 2 3", 13, "a number");
  expect_error("move @k1 to 1 nan 3", 15, "a number");
  expect_error("move @k1 to 1 2 3 4", 19, "unexpected \"4\"; usage: move @knot to X Y Z");
  expect_error("handle @k1 to 1 2 3", 8, "@k3.in or @k3.out");
  expect_error("handle @s1.in to 1 2 3", 8, "@k3.in or @k3.out");
  expect_error("joint @k1 to smoth", 14, "did you mean \"smooth\"");
  expect_error("closed yes", 8, "off|on");
  expect_error("resolution 1.5", 12, "a whole number");
  expect_error("resolution 99999999999", 12, "a whole number");
  expect_error("evaluator hroner", 11, "did you mean \"horner\"");
  expect_error("name", 5, "expected a text");
  expect_error("select @s2 at", 14, "a number");
  expect_error("undo now", 6, "unexpected");
}

TEST(codec, the_table_has_every_command_once_with_usage_and_help) {
  const auto& table = command_table();
  EXPECT_EQ(table.size(), Commands::size);
  std::set<std::string_view> names;
  for (const CommandHelp& row : table) {
    EXPECT_TRUE(names.insert(row.info.name).second) << row.info.name;
    EXPECT_TRUE(is_command(row.info.name));
    EXPECT_EQ(row.usage.rfind(row.info.name, 0), 0u);
    EXPECT_TRUE(row.info.help.ends_with('.')) << row.info.name;
  }
  EXPECT_FALSE(is_command("expect"));
  EXPECT_FALSE(is_command(""));
  test::RandomCommands random(1);
  for (std::size_t kind = 0; kind < table.size(); ++kind)
    EXPECT_EQ(info(random.of_kind(kind)).name, table[kind].info.name);
}

}  // namespace codec_test
}  // namespace coaster::edit
