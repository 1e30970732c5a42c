#include "exchange/own/force_limits_file.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "exchange/bad_file.h"

namespace coaster::exchange {
namespace force_limits_file_test {

std::string standard() { return print_envelope(sim::default_envelope(), "default"); }

// The standard one with one piece of text replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = standard();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}
void expect_error(const std::string& text, std::string_view expected) {
  test::expect_bad_file(parse_envelope(text, "e.json"), "e.json", expected);
}

TEST(envelope_file, printing_and_parsing_give_the_same_envelope_back) {
  sim::ForceLimitCurves odd = sim::default_envelope();
  odd.shortest = 0.1 + 0.2, odd.cutoff = 1.0 / 3.0;
  odd.curves[3] = {{0, 99.5}, {1e-3, 0}};
  odd.curves[4].clear();
  for (const sim::ForceLimitCurves& envelope : {sim::default_envelope(), odd}) {
    const auto loaded = parse_envelope(print_envelope(envelope, "a \"name\""), "e.json");
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    EXPECT_TRUE(loaded->envelope == envelope);
    EXPECT_EQ(loaded->name, "a \"name\"");
    EXPECT_TRUE(loaded->warnings.empty());
  }
  EXPECT_NE(standard().find("Not a compliance check"), std::string::npos);
}

TEST(envelope_file, the_one_that_comes_with_the_program_is_the_default) {
  std::ifstream in(std::string(COASTER_SOURCE_DIR) + "/envelopes/default.json");
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), standard());
}

TEST(envelope_file, errors_name_the_exact_place_and_the_reason) {
  expect_error("{\"format\": \"coaster-envelope\",\n  \"version\" 1}", "e.json:2:13: error");
  expect_error("[]", "expected an object, found an array");
  expect_error(with("coaster-envelope", "coaster-track"),
               "format: expected \"coaster-envelope\", found \"coaster-track\"");
  expect_error(with("\"version\": 1", "\"version\": 2"), "version 2 is newer");
  expect_error(with("\"name\": \"", "\"name\": \"" + std::string(1'000'000, 'n')),
               "name: longer than the limit of 200 bytes");
  expect_error(with("\"cutoff\": 5", "\"cutoff\": 0"), "cutoff: expected");
  expect_error(with("\"cutoff\": 5", "\"cutoff\": 5, \"cutoff\": 6"), "cutoff");
  expect_error(with("\"shortest\": 0.2", "\"shortest\": \"0.2\""), "shortest: expected a number");
  expect_error(with("\"shortest\": 0.2,", ""), "shortest: missing");
  expect_error(with("\"side\"", "\"sides\""), "side: missing");
  expect_error(with("\"side\": [", "\"side\": 3, \"was\": ["), "side: expected");
  expect_error(with("{\"seconds\": 2, \"g\": 4}", "{\"seconds\": 1, \"g\": 4}"),
               "down[2].seconds: expected more than 1");
  expect_error(with("{\"seconds\": 2, \"g\": 4}", "{\"seconds\": 2, \"g\": -4}"), "down[2].g: expected");
  expect_error(with("{\"seconds\": 2, \"g\": 4}", "{\"seconds\": 2}"), "down[2].g: missing");
  expect_error(with("{\"seconds\": 2, \"g\": 4}", "{\"seconds\": 2, \"g\": 1e999}"), "e.json");
  expect_error(with("{\"seconds\": 2, \"g\": 4}", "[2, 4]"), "down[2]: expected an object");
  std::string many = "\"down\": [";
  for (std::size_t i = 0; i <= kMaxEnvelopePoints; ++i)
    many += (i ? ", " : "") + ("{\"seconds\": " + std::to_string(i)) + ", \"g\": 1}";
  expect_error(with("\"down\": [", many + "], \"was\": ["), "down: more than the limit");
}

TEST(envelope_file, no_cut_of_a_file_is_read_and_nothing_crashes) {
  const std::string text = standard();
  for (std::size_t length = 0; length + 2 < text.size(); length += 3)
    EXPECT_FALSE(parse_envelope(text.substr(0, length), "e.json").ok()) << length;
}

TEST(envelope_file, unknown_members_are_warned_of) {
  const auto loaded = parse_envelope(with("\"cutoff\": 5", "\"cutoff\": 5, \"colour\": 3"), "e.json");
  ASSERT_TRUE(loaded.ok());
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("e.json: warning: "), std::string::npos);
  EXPECT_NE(loaded->warnings[0].find("colour"), std::string::npos);
  EXPECT_TRUE(loaded->envelope == sim::default_envelope());
}

TEST(envelope_file, only_json_files_are_read_and_missing_ones_say_so) {
  base::Files files;
  EXPECT_NE(load_envelope(files, "limits.txt").status().message.find(".json"), std::string::npos);
  EXPECT_FALSE(load_envelope(files, testing::TempDir() + "no_such_envelope.json").ok());
}

}  // namespace force_limits_file_test
}  // namespace coaster::exchange
