#include "app/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/ranges.h>

#include "base/exit_codes.h"

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

// The words that ask for a mode.
std::vector<const char*> words_of(char mode) {
  switch (mode) {
    case 'v': return {"--validate", "some.json"};
    case 'p': return {"--report"};
    case 's': return {"--script", "some.coaster"};
    case 'f': return {"--script", "some.coaster", "--headless", "--movie", "some/folder"};
    case 'r': return {"--headless", "some.json"};
    case 'm': return {"--headless", "some.json", "--movie", "some/folder"};
    default: return {};
  }
}
bool has(const std::vector<const char*>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}
// Adds an option that the words lack.
void add(std::vector<const char*>& words, const OptionRow& row) {
  if (has(words, row.name) || (row.name == "FILE" && has(words, "some.json"))) return;
  if (row.name != "FILE") words.push_back(row.name.data());
  if (!row.value.empty() || row.name == "FILE") words.push_back(row.name == "FILE" ? "some.json" : value_for(row));
}

TEST(Options, each_row_sets_its_own_member_and_no_other_row_s) {
  for (const OptionRow& row : option_rows()) {
    const bool is_switch = std::holds_alternative<bool Options::*>(row.member);
    EXPECT_EQ(row.value.empty(), is_switch || row.name == "FILE") << row.name;
    const std::vector<const char*> around = words_of(row.modes.back());
    std::vector<const char*> words = around;
    add(words, row);
    const ParsedOptions parsed = parse(words), without = parse(around);
    if (row.name.starts_with("--help")) EXPECT_EQ(parsed.exit_code, 0) << row.name;
    else EXPECT_FALSE(parsed.exit_code) << row.name << ": " << parsed.text;
    for (const OptionRow& other : option_rows()) {
      const bool set = std::visit([&](auto member) { return is_set(parsed.options, member); }, other.member);
      const bool before = std::visit([&](auto member) { return is_set(without.options, member); }, other.member);
      EXPECT_EQ(set, before || other.name == row.name) << row.name << " and " << other.name;
    }
  }
}

// Every pair of options in every mode: both have an effect there, or the one that has none is refused by name.
TEST(Options, every_pair_is_combined_or_refused) {
  int accepted = 0, refused = 0;
  for (const ModeRow& mode : mode_rows())
    for (const OptionRow& one : option_rows())
      for (const OptionRow& other : option_rows()) {
        std::vector<const char*> words = words_of(mode.letter);
        add(words, one), add(words, other);
        const ParsedOptions parsed = parse(words);
        if (one.name.starts_with("--help") || other.name.starts_with("--help")) continue;
        const char now = mode_of(parsed.options);
        std::vector<std::string_view> idle;
        for (const OptionRow& row : option_rows())
          if ((has(words, row.name) || (row.name == "FILE" && has(words, "some.json"))) &&
              row.modes.find(now) == std::string_view::npos)
            idle.push_back(row.name);
        const std::string text = fmt::format("{}: {}", fmt::join(words, " "), parsed.text);
        if (idle.empty() && !parsed.exit_code) {
          ++accepted;
          continue;
        }
        ++refused;
        EXPECT_EQ(parsed.exit_code, 2) << text;
        const bool named = std::any_of(idle.begin(), idle.end(), [&](std::string_view name) {
          return parsed.text.starts_with(fmt::format("coaster: {} has no effect with ", name));
        });
        // What needs something else is refused for that.
        EXPECT_TRUE(named || parsed.text.find(" needs ") != std::string::npos) << text;
      }
  EXPECT_GT(accepted, 300);
  EXPECT_GT(refused, 300);
}

TEST(Options, what_has_no_effect_together_is_refused_with_what_to_write) {
  const struct {
    std::vector<const char*> words;
    std::string_view text;
  } cases[] = {
      {{"--frames", "9", "--script", "a.coaster"},
       "--frames has no effect with --script F; it works with: --headless --movie, --headless FILE, a window"},
      {{"--report", "--size", "640x360"}, "--size has no effect with --report"},
      {{"--report", "--validate", "a.json"}, "--report has no effect with --validate"},
      {{"--report", "--script", "a.coaster"}, "--script has no effect with --report"},
      {{"--json", "a.json"}, "--json has no effect with a window"},
      {{"--out", "o", "a.json"}, "--out has no effect with a window"},
      {{"--fps", "30", "--headless", "a.json"}, "--fps has no effect with --headless FILE"},
      {{"--gif", "--script", "a.coaster"}, "--gif has no effect with --script F; it works with: --script F --movie"},
      {{"--update-goldens", "a.json"}, "--update-goldens has no effect with a window"},
      {{"--seed", "0"}, "--seed has no effect with a window"},
      {{"--reset-layout", "--script", "a.coaster"}, "--reset-layout of a script needs --config"},
  };
  for (const auto& one : cases) {
    const ParsedOptions parsed = parse(one.words);
    EXPECT_EQ(parsed.exit_code, 2) << one.text;
    EXPECT_NE(parsed.text.find(one.text), std::string_view::npos) << parsed.text;
  }
  EXPECT_FALSE(parse({"--report", "--json", "--envelope", "e.json", "a.json"}).exit_code);
  EXPECT_FALSE(parse({"--script", "a.coaster", "--json", "--seed", "3", "--out", "o"}).exit_code);
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
  const std::string manual = manual_page();
  for (const base::ExitCode& row : base::kExitCodes) {
    EXPECT_NE(help.text.find(std::string(row.code) + " " + std::string(row.meaning)), std::string::npos) << row.code;
    const std::string entry = "\n" + std::string(row.code) + "\n" + std::string(row.meaning) + ".\n";
    EXPECT_NE(manual.find(entry), std::string::npos) << row.code;
  }
  EXPECT_EQ(parse({"--version"}).exit_code, 0);
  EXPECT_EQ(parse({"--version"}).text, version_text());
}

}  // namespace options_test
}  // namespace coaster::app
