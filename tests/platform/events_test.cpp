#include "platform/events.h"

#include <gtest/gtest.h>

namespace coaster::platform {
namespace events_test {

TEST(events, chords_read_in_any_case_and_print_in_one) {
  EXPECT_EQ(parse_chord("ctrl+shift+z"), (KeyChord{Key::z, {true, true, false}}));
  EXPECT_EQ(parse_chord("F"), (KeyChord{Key::f, {}}));
  EXPECT_EQ(parse_chord("Esc"), parse_chord("Escape"));
  EXPECT_EQ(parse_chord("ArrowLeft"), parse_chord("Left"));
  EXPECT_EQ(parse_chord("Cmd+Option+S"), parse_chord("Ctrl+Alt+S"));
  EXPECT_EQ(to_text(*parse_chord("CTRL+z")), "Ctrl+Z");
  EXPECT_EQ(to_text(*parse_chord("f12")), "F12");
}

TEST(events, every_named_key_reads_back) {
  for (const char* text : {"A",         "Z",
                           "0",         "9",
                           "Space",     "Escape",
                           "Enter",     "Tab",
                           "Backspace", "Delete",
                           "Left",      "Right",
                           "Up",        "Down",
                           "PageUp",    "PageDown",
                           "Home",      "End",
                           "F1",        "F12",
                           ".",         ",",
                           "-",         "=",
                           "[",         "Ctrl+Shift+Alt+Delete"}) {
    const auto chord = parse_chord(text);
    ASSERT_TRUE(chord) << text;
    EXPECT_EQ(to_text(*chord), text);
  }
}

TEST(events, each_key_has_one_name_that_reads_back) {
  const std::vector<std::string> names = key_names();
  EXPECT_EQ(names.size(), 79u);
  for (const std::string& name : names) {
    const auto chord = parse_chord(name);
    ASSERT_TRUE(chord) << name;
    EXPECT_EQ(to_text(*chord), name);
  }
}

TEST(events, unknown_keys_are_refused) {
  for (const char* text : {"", "Hyper+Z", "Ctrl+", "Ctrl", "Nope", "F13", "AB"})
    EXPECT_FALSE(parse_chord(text)) << text;
}

}  // namespace events_test
}  // namespace coaster::platform
