// The words of a line.
#include "base/text.h"

#include <gtest/gtest.h>

namespace coaster::base {
namespace words_test {

struct Line {
  std::vector<Token> tokens;
  TextError error;
  WordReader words;
  explicit Line(const std::string& text) : tokens(read(text)), words(tokens, error) {}
  static std::vector<Token> read(const std::string& text) {
    std::vector<Token> tokens;
    TextError error;
    EXPECT_TRUE(tokenise(text, tokens, error)) << text;
    return tokens;
  }
};

TEST(words, a_line_is_taken_word_by_word) {
  Line line("go 2.5 +3 7 1 -2 3.25 off \"go\" end");
  EXPECT_FALSE(line.words.accept("stop"));
  EXPECT_TRUE(line.words.accept("go"));
  EXPECT_EQ(line.words.number("a length"), 2.5);
  EXPECT_EQ(line.words.number("a length"), 3);
  EXPECT_EQ(line.words.whole("a count", 0, 7), 7);
  EXPECT_EQ(line.words.vector("a place"), glm::vec3(1, -2, 3.25f));
  EXPECT_EQ(line.words.on_off(), false);
  EXPECT_FALSE(line.words.accept("go")) << "quoted words are no keywords";
  EXPECT_EQ(line.words.take("a text")->text, "go");
  EXPECT_FALSE(line.words.at_end());
  const std::vector<std::string> names{"begin", "end"};
  EXPECT_EQ(line.words.one_of("a name", names), 1u);
  EXPECT_TRUE(line.words.end());
  EXPECT_TRUE(line.error.message.empty());
}

TEST(words, the_first_failure_is_kept_with_its_column) {
  Line number("abc 1");
  EXPECT_FALSE(number.words.number("a length"));
  EXPECT_EQ(number.error.column, 1);
  EXPECT_NE(number.error.message.find("a length"), std::string::npos);
  EXPECT_EQ(number.words.take("another"), nullptr) << "nothing is taken after a failure";
  EXPECT_EQ(number.error.column, 1);

  Line whole("3 12");
  EXPECT_EQ(whole.words.whole("a count", 0, 9), 3);
  EXPECT_FALSE(whole.words.whole("a count", 0, 9));
  EXPECT_EQ(whole.error.column, 3);

  for (const char* const word : {"1e39", "-1e999", "inf", "nan", "-5", "2.5", "99999999999999999999"}) {
    Line far(word);
    EXPECT_FALSE(far.words.whole("a count", 0, 9));
    EXPECT_TRUE(far.error.out_of_range) << word;
  }
  for (const char* const word : {"1,5", "x", "3x", "-", "1 2"}) {
    const std::vector<Token> tokens{{word, 1, true}};
    TextError error;
    EXPECT_FALSE(WordReader(tokens, error).number("a length"));
    EXPECT_FALSE(error.out_of_range) << word;
  }

  Line left("on 1");
  EXPECT_EQ(left.words.on_off(), true);
  EXPECT_FALSE(left.words.end());
  EXPECT_EQ(left.error.column, 4);

  Line few("1 2");
  EXPECT_FALSE(few.words.vector("a place"));
  EXPECT_TRUE(few.words.failed());

  Line name("begn");
  const std::vector<std::string> names{"begin", "end"};
  EXPECT_FALSE(name.words.one_of("a name", names));
  EXPECT_NE(name.error.message.find("begin"), std::string::npos) << name.error.message;
  EXPECT_TRUE(name.error.suggests);
  Line far_off("xyzzy");
  EXPECT_FALSE(far_off.words.one_of("a name", names));
  EXPECT_FALSE(far_off.error.suggests) << far_off.error.message;
}

TEST(words, switches_and_sizes_read_as_people_write_them) {
  for (const char* const on : {"on", "TRUE", "yes"}) EXPECT_EQ(parse_switch(on), true) << on;
  for (const char* const off : {"off", "False", "no"}) EXPECT_EQ(parse_switch(off), false) << off;
  EXPECT_EQ(parse_switch("maybe"), std::nullopt);
  int width = 0, height = 0;
  EXPECT_TRUE(parse_size("640x360", width, height));
  EXPECT_EQ(width, 640);
  EXPECT_EQ(height, 360);
  EXPECT_TRUE(parse_size("16384X1", width, height));
  EXPECT_TRUE(parse_size("7680x4320", width, height));
  for (const char* const bad : {"640", "x360", "640x", "0x3", "16385x1", "1x16385", "-3x4", "3 x 4", "16384x16384"})
    EXPECT_FALSE(parse_size(bad, width, height)) << bad;
  EXPECT_EQ(lower("Red COMET 7"), "red comet 7");
}

}  // namespace words_test
}  // namespace coaster::base
