#include "app/options.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coaster::app {
namespace options_test {

ParsedOptions parse(std::vector<const char*> words) {
  words.insert(words.begin(), "coaster");
  return parse_options(static_cast<int>(words.size()), words.data());
}

// A value that the option takes, not its default.
const char* value_for(const OptionRow& row) {
  if (row.name == "--size") return "640x360";
  if (row.name == "--fps") return "24";
  if (row.name == "--camera") return "fly";
  if (row.name == "--frames" || row.name == "--seed") return "17";
  return "some/where";
}

template <class Member>
bool is_set(const Options& options, Member member) {
  return !(options.*member == Options{}.*member);
}

TEST(Options, without_words_are_the_defaults) {
  const ParsedOptions parsed = parse({});
  EXPECT_FALSE(parsed.exit_code);
  for (const OptionRow& row : option_rows())
    EXPECT_FALSE(std::visit([&](auto member) { return is_set(parsed.options, member); }, row.member)) << row.name;
}

TEST(Options, each_row_sets_its_own_member_and_no_other_row_s) {
  for (const OptionRow& row : option_rows()) {
    std::vector<const char*> words;
    const std::string name(row.name);
    const bool is_switch = std::holds_alternative<bool Options::*>(row.member);
    EXPECT_EQ(row.value.empty(), is_switch || row.name == "FILE") << name;
    if (row.name != "FILE") words.push_back(name.c_str());
    if (!is_switch) words.push_back(value_for(row));
    if (row.name == "--movie") words.push_back("--headless");  // it asks for that
    const bool of_a_file = row.name == "--movie" || row.name == "--headless" || row.name == "--validate";
    if (of_a_file) words.push_back("some.json");
    const ParsedOptions parsed = parse(words);
    if (name.starts_with("--help")) EXPECT_EQ(parsed.exit_code, 0) << name;
    else EXPECT_FALSE(parsed.exit_code) << name << ": " << parsed.text;
    for (const OptionRow& other : option_rows()) {
      const bool expected = other.name == row.name || (row.name == "--movie" && other.name == "--headless") ||
                            (of_a_file && other.name == "FILE");
      EXPECT_EQ(std::visit([&](auto member) { return is_set(parsed.options, member); }, other.member), expected)
          << name << " and " << other.name;
    }
  }
}

TEST(Options, numbers_are_those_that_are_written) {
  const Options options = parse({"--size", "640x360", "--seed", "9223372036854775807", "--frames", "0"}).options;
  EXPECT_EQ(options.width, 640);
  EXPECT_EQ(options.height, 360);
  EXPECT_EQ(options.seed, 9223372036854775807);
  EXPECT_EQ(options.frames, 0);
}

TEST(Options, what_cannot_be_is_told_and_ends_with_2) {
  const struct {
    std::vector<const char*> words;
    std::string_view text;
  } cases[] = {
      {{"--sise", "1x1"}, "--sise"},
      {{"--script"}, "--script"},
      {{"--frames", "-1"}, "--frames: expected 0 to 10000000, found -1"},
      {{"--frames", "99999999999999999999"}, "--frames"},
      {{"--frames", "many"}, "--frames"},
      {{"--seed", "-1"}, "--seed: expected a whole number from 0, found -1"},
      {{"a.json", "b.json"}, "b.json"},
      {{"--size", "1280"}, "expected WIDTHxHEIGHT such as 1280x720, up to 7680x4320, found 1280"},
      {{"--size", "16384x16384"}, "found 16384x16384"},
      {{"--size", "0x720"}, "found 0x720"},
      {{"--fps", "25"}, "--fps: expected 10, 12, 15, 20, 24, 30, 40, 60 or 120, found 25"},
      {{"--camera", "side"}, "found side"},
      {{"--validate"}, "--validate needs a FILE or a --script"},
      {{"--headless"}, "--headless needs a FILE or a --script"},
      {{"--headless", "--movie", "m"}, "--headless needs a FILE or a --script"},
      {{"--movie", "m"}, "--movie needs --headless"},
  };
  for (const auto& one : cases) {
    const ParsedOptions parsed = parse(one.words);
    EXPECT_EQ(parsed.exit_code, 2) << one.text;
    EXPECT_TRUE(parsed.text.starts_with("coaster: ")) << parsed.text;
    EXPECT_NE(parsed.text.find(one.text), std::string::npos) << parsed.text;
  }
}

TEST(Options, help_names_every_row_and_every_exit_code) {
  const ParsedOptions help = parse({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const OptionRow& row : option_rows()) EXPECT_NE(help.text.find(row.name), std::string::npos) << row.name;
  for (const ExitCodeRow& row : exit_code_rows())
    EXPECT_NE(help.text.find(std::string(row.code) + " " + std::string(row.meaning)), std::string::npos) << row.code;
  EXPECT_EQ(parse({"--version"}).exit_code, 0);
  EXPECT_EQ(parse({"--version"}).text, version_text());
}

}  // namespace options_test
}  // namespace coaster::app
