#include "base/text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace coaster::base {
namespace text_test {

std::vector<Token> tokens_of(std::string_view line) {
  std::vector<Token> tokens;
  TextError error;
  EXPECT_TRUE(tokenise(line, tokens, error)) << line << ": " << error.message;
  return tokens;
}

TEST(text, words_come_with_their_columns) {
  const auto tokens = tokens_of("  move @k4\tto 1.5 -2 # a comment");
  ASSERT_EQ(tokens.size(), 5u);
  EXPECT_EQ(tokens[0], (Token{"move", 3, false}));
  EXPECT_EQ(tokens[1], (Token{"@k4", 8, false}));
  EXPECT_EQ(tokens[4].text, "-2");
  EXPECT_TRUE(tokens_of("").empty());
  EXPECT_TRUE(tokens_of("# all comment").empty());
}

TEST(text, quotes_keep_blanks_hashes_and_escapes) {
  const auto tokens = tokens_of(R"(name "a # \"b\" \\ \n" end)");
  ASSERT_EQ(tokens.size(), 3u);
  EXPECT_EQ(tokens[1].text, "a # \"b\" \\ \n");
  EXPECT_TRUE(tokens[1].quoted);
}

TEST(text, broken_lines_say_where) {
  std::vector<Token> tokens;
  TextError error;
  EXPECT_FALSE(tokenise("load \"tracks", tokens, error));
  EXPECT_EQ(error.column, 6);
  EXPECT_FALSE(tokenise("load \"a\"b", tokens, error));
  EXPECT_FALSE(tokenise("a\"b\"", tokens, error));
  EXPECT_FALSE(tokenise("\"\\q\"", tokens, error));
  EXPECT_FALSE(tokenise(std::string_view("a\0b", 3), tokens, error));
}

RC_GTEST_PROP(text, a_quoted_text_reads_back, (const std::string& text)) {
  std::string clean;
  for (char c : text)
    if (c != '\0') clean += c;
  std::vector<Token> tokens;
  TextError error;
  RC_ASSERT(tokenise(base::quoted(clean), tokens, error));
  RC_ASSERT(tokens.size() == 1u);
  RC_ASSERT(tokens[0].text == clean);
}

TEST(text, the_nearest_word_is_suggested_and_far_ones_are_not) {
  const std::vector<std::string> words{"evaluator", "resolution", "move", "remove", "log", "joint"};
  EXPECT_EQ(nearest("evalutor", words), "evaluator");
  EXPECT_EQ(nearest("mvoe", words), "move");
  EXPECT_EQ(nearest("xylophone", words), std::nullopt);
  for (const char* const far : {"let", "for", "print", "u"}) EXPECT_EQ(nearest(far, words), std::nullopt);
  EXPECT_EQ(nearest("x", std::vector<std::string>{"y", "xy"}), "xy") << "a word with no letter in common is no slip";
  EXPECT_EQ(suggestion("resolutoin", words), "; did you mean \"resolution\"?");
}

TEST(text, an_error_becomes_a_sentence) {
  EXPECT_EQ(sentence("there is no knot @k7"), "There is no knot @k7.");
  EXPECT_EQ(sentence("@k7 is no segment."), "@k7 is no segment.");
  EXPECT_EQ(sentence("no query \"knotz\"; did you mean \"knots\"?"), "No query \"knotz\"; did you mean \"knots\"?");
  EXPECT_EQ(sentence(""), "");
}

// A table of all pairs of letters would have 3e10 entries.
TEST(text, a_long_word_is_not_compared_with_short_ones) {
  const std::string word(1'000'000, 'a');
  EXPECT_EQ(nearest(word, std::vector<std::string>(300, std::string(100, 'a'))), std::nullopt);
  EXPECT_EQ(nearest("aaaaaaaaaaaa", std::vector<std::string>{"aaaaaaaaa"}), "aaaaaaaaa");
  EXPECT_EQ(nearest("aaaaaaaaaaaa", std::vector<std::string>{"aaaaaaa"}), std::nullopt);
}

}  // namespace text_test
}  // namespace coaster::base
