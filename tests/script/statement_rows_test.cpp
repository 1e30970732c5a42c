// What single statements become: the verb of each word of a row, the events of input, the usage in errors.
#include "script/statement_rows.h"

#include <gtest/gtest.h>

#include <map>

#include <fmt/format.h>

namespace coaster::script {
namespace statement_rows_test {

Action action_of(const std::string& line, std::string* message = nullptr) {
  std::vector<base::Token> tokens;
  base::TextError error;
  Action action;
  EXPECT_TRUE(base::tokenise(line, tokens, error)) << line;
  const bool read = parse_line(tokens, error, action);
  EXPECT_EQ(read, message == nullptr) << line << ": " << error.message;
  if (message) *message = error.message;
  return action;
}

TEST(rows, each_word_of_a_row_has_its_own_verb) {
  using Ui = UiAction::Verb;
  for (const auto& [line, verb] : std::map<std::string, Ui>{{"ui.click \"A\"", Ui::click},
                                                            {"ui.doubleclick \"A\"", Ui::doubleclick},
                                                            {"ui.hover \"A\"", Ui::hover},
                                                            {"ui.check \"A\" off", Ui::check},
                                                            {"ui.type \"A\" \"1\"", Ui::type},
                                                            {"ui.drag \"A\" by 3 px", Ui::drag_by},
                                                            {"ui.drag \"A\" to 3", Ui::drag_to},
                                                            {"ui.open \"A\"", Ui::open},
                                                            {"ui.close \"A\"", Ui::close},
                                                            {"ui.menu \"A\"", Ui::menu},
                                                            {"ui.scroll \"A\" -2", Ui::scroll}})
    EXPECT_EQ(std::get<UiAction>(action_of(line)).verb, verb) << line;
  EXPECT_FALSE(std::get<UiAction>(action_of("ui.check \"A\" off")).on);
  EXPECT_TRUE(std::get<UiAction>(action_of("ui.check \"A\"")).on);
  using Aim = AimAction::Verb;
  for (const auto& [line, verb] : std::map<std::string, Aim>{{"aim.click @k1", Aim::click},
                                                             {"aim.doubleclick @k1", Aim::doubleclick},
                                                             {"aim.hover @k1", Aim::hover},
                                                             {"aim.drag @k1 by 1 2 3", Aim::drag}})
    EXPECT_EQ(std::get<AimAction>(action_of(line)).verb, verb) << line;
}

TEST(rows, a_dump_is_named_with_or_without_the_folder) {
  for (const char* const line : {"dump \"a/b\"", "dump \"$OUT/a/b\""})
    EXPECT_EQ(std::get<Dump>(action_of(line)).name, "a/b") << line;
}

// Returns an event in words, for comparison.
std::string text_of(const platform::Event& event) {
  const auto with = [](const platform::Modifiers& m) {
    return fmt::format("{}{}{}", m.shift ? "+shift" : "", m.ctrl ? "+ctrl" : "", m.alt ? "+alt" : "");
  };
  if (const auto* move = std::get_if<platform::MouseMove>(&event)) return fmt::format("move {} {}", move->x, move->y);
  if (const auto* wheel = std::get_if<platform::Wheel>(&event)) return fmt::format("wheel {} {}", wheel->dx, wheel->dy);
  if (const auto* button = std::get_if<platform::MouseButton>(&event))
    return fmt::format("button {} {}{}", int(button->button), button->down, with(button->modifiers));
  if (const auto* key = std::get_if<platform::KeyPress>(&event))
    return fmt::format("key {} {}{}", int(key->key), key->down, with(key->modifiers));
  if (const auto* size = std::get_if<platform::Resize>(&event)) return fmt::format("{}x{}", size->width, size->height);
  if (const auto* focus = std::get_if<platform::Focus>(&event)) return fmt::format("focus {}", focus->focused);
  if (const auto* pad = std::get_if<platform::GamepadAxes>(&event))
    return fmt::format("pad {} {} {} {} {} {}", pad->left_x, pad->left_y, pad->right_x, pad->right_y, pad->left_trigger,
                       pad->right_trigger);
  if (const auto* pad = std::get_if<platform::GamepadButton>(&event))
    return fmt::format("pad {} {}", int(pad->button), pad->down);
  return "other";
}

// Returns the events of a line; commas separate frames.
std::string events_of(const std::string& line) {
  const Action action = action_of(line);
  std::string text;
  for (const platform::Events& step : std::get<Input>(action).steps) {
    if (!text.empty()) text += ", ";
    for (const platform::Event& event : step) text += text_of(event);
  }
  return text;
}

TEST(rows, input_becomes_these_events) {
  const std::string f = fmt::format("key {} ", int(platform::parse_chord("F")->key));
  EXPECT_EQ(events_of("raw.move 3.5 -2"), "move 3.5 -2");
  EXPECT_EQ(events_of("wheel -2"), "wheel 0 -2");
  EXPECT_EQ(events_of("raw.wheel 1.5 at 30 40"), "move 30 40, wheel 0 1.5");
  EXPECT_EQ(events_of("raw.press"), "button 0 true");
  EXPECT_EQ(events_of("raw.press right +ctrl +shift"), "button 1 true+shift+ctrl");
  EXPECT_EQ(events_of("raw.release middle"), "button 2 false");
  EXPECT_EQ(events_of("key Ctrl+F"), f + "true+ctrl, " + f + "false");
  EXPECT_EQ(events_of("raw.key Alt+F down"), f + "true+alt");
  EXPECT_EQ(events_of("raw.key Alt+F up"), f + "false");
  EXPECT_EQ(events_of("resize 81x62"), "81x62");
  EXPECT_EQ(events_of("resize 81 62"), "81x62");
  EXPECT_EQ(events_of("minimise"), "0x0");
  EXPECT_EQ(events_of("minimize"), "0x0");
  EXPECT_EQ(events_of("focus off"), "focus false");
  EXPECT_EQ(events_of("focus"), "focus true");
  EXPECT_EQ(events_of("pad triggers 0.25 0.5 left 0.125 -1 right -0.5 0.75"), "pad 0.125 -1 -0.5 0.75 0.25 0.5");
  EXPECT_EQ(events_of("pad rest"), "pad 0 0 0 0 0 0");
  EXPECT_EQ(events_of("pad x"), "pad 2 true, pad 2 false");
  EXPECT_TRUE(std::get<Input>(action_of("key F")).last_step_can_wait);
  EXPECT_FALSE(std::get<Input>(action_of("raw.key F up")).last_step_can_wait);
}

TEST(rows, errors_show_the_usage_of_the_form_that_was_begun_unless_they_suggest_a_word) {
  const auto message = [](const std::string& line) {
    std::string text;
    action_of(line, &text);
    return text;
  };
  EXPECT_EQ(message("snap"), "expected a name at the end of the line; usage: snap \"NAME\"");
  EXPECT_EQ(message("expect error snap"), "expected a name at the end of the line; usage: snap \"NAME\"");
  EXPECT_EQ(message("expect error"), "expected a statement that must fail; usage: expect error STATEMENT [~ \"TEXT\"]");
  EXPECT_TRUE(message("expect file").ends_with("; usage: expect file \"FILE\" exists | same \"FILE\""));
  EXPECT_TRUE(message("fault import").ends_with("; usage: fault import slow N"));
  EXPECT_TRUE(message("aim.drag @k1 to").ends_with(" TARGET to X Y Z|TARGET"));
  EXPECT_TRUE(message("fault").ends_with("; usage: fault io.open|read|write|fsync|rename|close fail [N]"))
      << "of forms that fit alike, the first";
  EXPECT_TRUE(message("repeat 2 3").ends_with("; usage: repeat N ... end"));
  EXPECT_EQ(message("env scal 2"),
            "expected size, seed, scale, density, msaa or home, found \"scal\"; did you mean "
            "\"scale\"?");
  EXPECT_EQ(message("env scale 9"), "expected a scale from 0.75 to 3, found \"9\"");
  EXPECT_NE(message("fault crash 3").find("; usage: fault crash input|job|"), std::string::npos);
  EXPECT_EQ(message("repeat 3 {").find("usage"), std::string::npos);
}

}  // namespace statement_rows_test
}  // namespace coaster::script
