// Part: src/ui/context/ui.
#include "ui/context/ui.h"

#include <gtest/gtest.h>

#include "ui/actions/actions.h"

namespace coaster::ui {
namespace key_map_test {

using platform::Key;

std::vector<std::string> problems_of(const std::vector<exchange::KeyBinding>& choices) {
  std::vector<std::string> problems;
  (void)KeyMap::make(key_rows(), choices, problems);
  return problems;
}

TEST(key_map, without_choices_the_keys_are_those_of_the_table) {
  std::vector<std::string> problems;
  const KeyMap keys = KeyMap::make(key_rows(), {}, problems);
  EXPECT_TRUE(problems.empty());
  for (const Action& a : actions())
    EXPECT_EQ(keys.shown(a.name), a.chord.key == Key::unknown ? "" : platform::to_text(a.chord)) << a.name;
  EXPECT_EQ(keys.shown("Save as"), "Ctrl+Shift+S");
  EXPECT_EQ(with_keys(keys, "Redo.", "Redo"), "Redo. Keys Ctrl+Y, Ctrl+Shift+Z.");
  EXPECT_EQ(with_keys(keys, "Clear.", "Select none"), "Clear.");
}

TEST(key_map, names_of_actions_are_unique) {
  for (const Action& a : actions())
    for (const Action& b : actions()) EXPECT_TRUE(&a == &b || a.name != b.name) << a.name;
}

TEST(key_map, a_choice_replaces_both_keys_of_its_action_and_an_empty_one_takes_them) {
  std::vector<std::string> problems;
  const std::vector<exchange::KeyBinding> choices{{"Redo", {"F4"}}, {"Delete", {}}};
  const KeyMap keys = KeyMap::make(key_rows(), choices, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(keys.shown("Redo"), "F4");
  EXPECT_EQ(keys.shown("Delete"), "");
  EXPECT_EQ(keys.shown("Undo"), "Ctrl+Z");
}

TEST(key_map, what_cannot_be_done_is_told_and_leaves_the_action_its_own_keys) {
  std::vector<std::string> problems;
  const std::vector<exchange::KeyBinding> choices{
      {"Undooo", {"F4"}}, {"Save", {"Ctrl+Splat"}}, {"Undo", {"F3"}}, {"Redo", {"F3"}}};
  const KeyMap keys = KeyMap::make(key_rows(), choices, problems);
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_NE(problems[0].find("did you mean \"Undo\"?"), std::string::npos);
  EXPECT_EQ(problems[1], "Save keeps its default keys because \"Ctrl+Splat\" is not a key.");
  EXPECT_EQ(problems[2], "F3 is assigned to both Undo and Redo. Redo keeps its default keys.");
  EXPECT_EQ(keys.shown("Save"), "Ctrl+S");
  EXPECT_EQ(keys.shown("Redo"), "Ctrl+Y");
  EXPECT_EQ(keys.shown("Undo"), "F3");
}

TEST(key_map, a_key_given_away_leaves_its_owner_and_two_can_change_places) {
  EXPECT_EQ(problems_of({{"Undo", {"Ctrl+S"}}}), std::vector<std::string>{"Ctrl+S now belongs to Undo, not to Save."});
  EXPECT_TRUE(problems_of({{"Undo", {"Ctrl+S"}}, {"Save", {"Ctrl+Z"}}}).empty());
}

}  // namespace key_map_test
}  // namespace coaster::ui
