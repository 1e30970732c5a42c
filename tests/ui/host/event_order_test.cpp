// What several events of one frame become in the frames that follow.
#include "ui/host/imgui_backend.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace coaster::ui {
namespace event_order_test {

using platform::Button;
using platform::Key;
using platform::KeyPress;
using platform::MouseButton;
using platform::TextInput;

const MouseButton kDown{Button::left, true, {}}, kUp{Button::left, false, {}};

// The events of a frame: "v" and "^" for the button, a key's name, "-A" for its release, text in quotes.
std::string text_of(const platform::Events& events) {
  std::string text;
  for (const platform::Event& event : events) {
    if (const auto* const button = std::get_if<MouseButton>(&event)) text += button->down ? "v" : "^";
    if (const auto* const key = std::get_if<KeyPress>(&event))
      text += (key->down ? "" : "-") + std::string(platform::name_of(key->key));
    if (const auto* const typed = std::get_if<TextInput>(&event)) text += "'" + typed->utf8 + "'";
  }
  return text;
}

struct EventOrderTest : testing::Test {
  std::string frame(platform::Events events, bool typing = false, bool clicks_wait = false, bool field_opens = false) {
    events.emplace_back(platform::Tick{0.3});
    const platform::Events taken = order.take(events, typing, clicks_wait, field_opens);
    EXPECT_TRUE(std::holds_alternative<platform::Tick>(taken.back())) << "time does not wait";
    return text_of(taken);
  }
  EventQueue order;
};

TEST_F(EventOrderTest, a_key_waits_for_the_click_before_it) {
  EXPECT_EQ(frame({kDown, kUp, KeyPress{Key::enter}, KeyPress{Key::enter, false}}), "v^");
  EXPECT_TRUE(order.waits());
  EXPECT_EQ(frame({}, false, true), "") << "the release is seen in this frame";
  EXPECT_EQ(frame({}), "Enter-Enter");
  EXPECT_FALSE(order.waits());
}

TEST_F(EventOrderTest, in_a_text_field_everything_waits_for_a_key_with_ctrl) {
  const KeyPress ctrl_a{Key::a, true, false, {.ctrl = true}};
  EXPECT_EQ(frame({ctrl_a, KeyPress{Key::a, false}, TextInput{"x"}}, true), "A");
  EXPECT_EQ(frame({}, true), "-A'x'");
}

TEST_F(EventOrderTest, a_click_waits_for_the_key_before_it) {
  EXPECT_EQ(frame({KeyPress{Key::n}, TextInput{"n"}, kDown, kUp}), "N'n'");
  EXPECT_EQ(frame({}), "v^");
}

TEST_F(EventOrderTest, keys_outside_a_text_field_come_one_a_frame) {
  EXPECT_EQ(frame({KeyPress{Key::g}, KeyPress{Key::g, false}, KeyPress{Key::y}, KeyPress{Key::d2}, TextInput{"2"}}),
            "G-G");
  EXPECT_EQ(frame({KeyPress{Key::enter}}), "Y") << "what comes later stays behind";
  EXPECT_EQ(frame({}), "2'2'");
  EXPECT_EQ(frame({}), "Enter");
  EXPECT_EQ(frame({}), "");
}

TEST_F(EventOrderTest, typed_text_does_not_wait_but_for_the_end_of_its_field) {
  EXPECT_EQ(frame({KeyPress{Key::d2}, TextInput{"2"}, KeyPress{Key::d7}, TextInput{"7"}, KeyPress{Key::enter},
                   KeyPress{Key::space}, TextInput{" "}},
                  true),
            "2'2'7'7'Enter");
  EXPECT_EQ(frame({}), "Space' '");
}

TEST_F(EventOrderTest, text_waits_for_the_click_that_opens_its_field) {
  EXPECT_EQ(frame({kDown, kUp, TextInput{"5"}}), "v^");
  EXPECT_EQ(frame({}, true), "'5'");
}

TEST_F(EventOrderTest, text_waits_three_frames_at_most_for_a_field_that_opens) {
  EXPECT_EQ(frame({TextInput{"c"}}, false, false, true), "");
  EXPECT_EQ(frame({}, false, false, true), "");
  EXPECT_EQ(frame({}, true, false, true), "'c'") << "the field has the keyboard";
  EXPECT_EQ(frame({TextInput{"d"}}, false, false, true), "");
  EXPECT_EQ(frame({}, false, false, true), "");
  EXPECT_EQ(frame({}, false, false, true), "");
  EXPECT_EQ(frame({}, false, false, true), "'d'") << "no field took the keyboard";
}

TEST_F(EventOrderTest, held_keys_and_modifiers_do_not_wait) {
  EXPECT_EQ(frame({KeyPress{Key::right, true, true}, KeyPress{Key::right, true, true}, KeyPress{Key::unknown}, kDown}),
            "RightRightv");
  EXPECT_EQ(frame({kUp, KeyPress{Key::unknown, false}, KeyPress{Key::right, false}}), "^--Right");
}

}  // namespace event_order_test
}  // namespace coaster::ui
