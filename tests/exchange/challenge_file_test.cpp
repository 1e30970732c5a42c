#include "exchange/challenge_file.h"

#include <gtest/gtest.h>

#include "exchange/bad_file.h"
#include "exchange/own/track_file.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace challenge_file_test {

// With the start track inside, so that a cut of the text is a cut of the track as well.
std::string standard() {
  std::string track = print_track(test::sample_document());
  track.pop_back();
  return "{\n  \"format\": \"coaster-challenge\",\n  \"version\": 1,\n  \"name\": \"A \\\"name\\\"\",\n  \"teaches\": "
         "\"Something.\",\n  \"judged\": \"time\",\n  \"seconds\": 12.5,\n"
         "  \"goals\": [\n    {\"expect\": \"knots <= 12\", \"text\": \"Twelve knots\"},\n    {\"expect\": \"ride.lap "
         "== 1\", \"text\": \"A lap\"}\n  ],\n"
         "  \"gold\": [{\"expect\": \"knots <= 4\", \"text\": \"Four\"}],\n  \"hints\": [\"One.\", \"Two.\"],\n  "
         "\"locks\": [\"smooth\"],\n  "
         "\"track\": " +
         track + "\n}\n";
}
std::string with(const std::string& from, const std::string& to) {
  std::string text = standard();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}
base::Result<LoadedChallenge> parse(const std::string& text, const std::filesystem::path& folder = ".") {
  base::Files files;
  return parse_challenge(text, "c.json", folder, files);
}
void expect_error(const std::string& text, std::string_view expected) {
  test::expect_bad_file(parse(text), "c.json", expected);
}

TEST(challenge_file, all_members_are_read) {
  const auto loaded = parse(standard());
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  const ChallengeFile& c = loaded->challenge;
  EXPECT_EQ(c.name, "A \"name\"");
  EXPECT_EQ(c.teaches, "Something.");
  EXPECT_EQ(c.judged, JudgedWhen::time);
  EXPECT_EQ(c.seconds, 12.5);
  ASSERT_EQ(c.list(RuleList::goals).size(), 2u);
  EXPECT_EQ(c.list(RuleList::goals)[1], (ChallengeRule{"ride.lap == 1", "A lap"}));
  EXPECT_TRUE(c.list(RuleList::silver).empty());
  ASSERT_EQ(c.list(RuleList::gold).size(), 1u);
  EXPECT_EQ(c.hints, (std::vector<std::string>{"One.", "Two."}));
  EXPECT_EQ(c.locks, std::vector<std::string>{"smooth"});
  EXPECT_EQ(world::hash(c.start), world::hash(test::sample_document()));
  EXPECT_TRUE(loaded->warnings.empty());
}

TEST(challenge_file, no_cut_of_a_file_at_any_byte_is_read) {
  const std::string text = standard();
  const std::size_t end = text.rfind('}');
  for (std::size_t length = 0; length <= end; ++length) ASSERT_FALSE(parse(text.substr(0, length)).ok()) << length;
}

TEST(challenge_file, errors_name_the_place_and_what_was_expected) {
  expect_error("{\"format\": \"coaster-challenge\",\n  \"version\" 1}", "c.json:2:13: error");
  expect_error("[]", "expected an object, found an array");
  expect_error(with("coaster-challenge", "coaster-envelope"), "format: expected \"coaster-challenge\"");
  expect_error(with("\"version\": 1", "\"version\": 2"), "version 2 is newer");
  expect_error(with("\"judged\": \"time\"", "\"judged\": \"day\""),
               "judged: expected \"lap\", \"time\" or \"build\", found \"day\"");
  expect_error(with("\"seconds\": 12.5,", ""), "seconds: missing");
  expect_error(with("\"seconds\": 12.5", "\"seconds\": 0"), "seconds: expected a number from 1 to 900");
  expect_error(with("\"name\": \"A \\\"name\\\"\"", "\"name\": 3"), "name: expected a text, found 3");
  expect_error(with("\"teaches\": \"Something.\"", "\"teaches\": \"\""), "teaches: expected a text");
  expect_error(with("\"goals\": [", "\"goals\": [], \"was\": ["), "goals: expected one goal at least");
  expect_error(with("\"goals\": [", "\"goals\": 3, \"was\": ["), "goals: expected an array, found 3");
  expect_error(with("\"goals\": [", "\"golas\": ["), "goals: missing");
  expect_error(with("\"expect\": \"ride.lap == 1\"", "\"expect\": 1"), "goals[1].expect: expected a text, found 1");
  expect_error(with(", \"text\": \"A lap\"", ""), "goals[1].text: missing");
  expect_error(with("{\"expect\": \"knots <= 4\", \"text\": \"Four\"}", "4"), "gold[0]: expected an object, found 4");
  expect_error(with("\"Two.\"", "2"), "hints[1]: expected a text, found 2");
  expect_error(with("\"smooth\"", "[]"), "locks[0]: expected a text, found an array");
  expect_error(with("\"track\": {", "\"track\": 5, \"was\": {"), "track: expected a text");
  expect_error(with("\"track\": {", "\"track\": \"no/such.json\", \"was\": {"), "no/such.json");
  expect_error(with("\"track\": {", "\"track\": \"readme.md\", \"was\": {"), "track: expected the start track");
  expect_error(with("\"datum\":", "\"datums\":"), "track: track: error: datum: missing");
}

TEST(challenge_file, unknown_members_are_told_and_ignored) {
  const auto loaded = parse(with("\"hints\":", "\"music\": true, \"hints\":"));
  ASSERT_TRUE(loaded.ok());
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_EQ(loaded->warnings[0], "c.json: warning: unknown member \"music\" is ignored");
}

TEST(challenge_file, those_that_come_with_the_program_are_read_without_a_warning) {
  base::Files files;
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / "challenges")) {
    if (entry.path().extension() != ".json") continue;
    ++count;
    const auto loaded = load_challenge(files, entry.path());
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
    EXPECT_FALSE(loaded->challenge.hints.empty()) << entry.path();
  }
  EXPECT_GE(count, 8);
}

TEST(challenge_file, a_challenge_is_told_from_other_files) {
  EXPECT_TRUE(looks_like_challenge(standard()));
  EXPECT_FALSE(looks_like_challenge(print_track(test::sample_document())));
  EXPECT_FALSE(looks_like_challenge("no JSON"));
  EXPECT_FALSE(looks_like_challenge("[\"format\"]"));
}

}  // namespace challenge_file_test
}  // namespace coaster::exchange
