// Typed arithmetic against two other evaluators: the tree that a text was printed from, and the shunting yard
// (Dijkstra 1961) over random texts, most of which are wrong.
#include "base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "base/text.h"

namespace coaster::base {
namespace arithmetic_test {

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  unsigned below(unsigned n) { return bits_() % n; }
  std::string blanks() { return std::string(below(5) == 0 ? 1 + below(2) : 0, ' '); }

 private:
  std::mt19937 bits_;
};

// A text, its value, and how tightly its last operation binds: 0 sum, 1 product, 2 sign, number or bracket.
struct Term {
  std::string text;
  double value;
  int level;
};

Term bracketed(Random& random, const Term& term) {
  return {"(" + random.blanks() + term.text + random.blanks() + ")", term.value, 2};
}
Term at_least(Random& random, int level, const Term& term) {
  return term.level < level || random.below(6) == 0 ? bracketed(random, term) : term;
}

Term random_term(Random& random, int depth) {
  if (depth == 0 || random.below(5) == 0) {
    const double number = random.below(4000) / 16.0;
    return {to_text(number), number, 2};
  }
  if (random.below(6) == 0) {
    const Term inner = at_least(random, 2, random_term(random, depth - 1));
    return {"-" + inner.text, -inner.value, 2};
  }
  const char operation = "+-*/"[random.below(4)];
  const int level = operation == '+' || operation == '-' ? 0 : 1;
  const Term left = at_least(random, level, random_term(random, depth - 1)),
             right = at_least(random, level + 1, random_term(random, depth - 1));
  const double value = operation == '+'   ? left.value + right.value
                       : operation == '-' ? left.value - right.value
                       : operation == '*' ? left.value * right.value
                                          : left.value / right.value;
  return {left.text + random.blanks() + operation + random.blanks() + right.text, value, level};
}

TEST(arithmetic, a_printed_tree_has_the_value_of_the_tree) {
  Random random(7);
  int finite = 0;
  for (int i = 0; i < 20000; ++i) {
    const Term term = random_term(random, 1 + static_cast<int>(random.below(6)));
    const Result<double> found = evaluate(term.text);
    if (!std::isfinite(term.value)) {
      EXPECT_FALSE(found) << term.text;
      continue;
    }
    // A division by zero inside can cancel out in the tree (1/(1/0) = 0); evaluate() refuses it.
    if (!found && found.status().message.find("zero") != std::string::npos) continue;
    ASSERT_TRUE(found) << term.text << ": " << found.status().message;
    ASSERT_EQ(*found, term.value) << term.text;
    ++finite;
  }
  EXPECT_GT(finite, 18000);
}

// One stack of values and one of operations; '~' is the sign.
class ShuntingYard {
 public:
  std::optional<double> evaluate(const std::string& text) {
    bool operand = true;  // expected next
    for (const char* at = text.c_str(); *at != 0;) {
      const char c = *at;
      if (c == ' ') {
        ++at;
      } else if (operand && (c == '+' || c == '-')) {
        if (c == '-') operations_.push_back('~');
        ++at;
      } else if (operand && c == '(') {
        operations_.push_back('(');
        ++at;
      } else if (operand) {
        char* end = nullptr;
        const double number = std::strtod(at, &end);
        if (end == at || !std::isfinite(number)) return std::nullopt;
        const std::string word(at, static_cast<std::size_t>(end - at));
        const bool zero = word.substr(0, word.find_first_of("eE")).find_first_of("123456789") == std::string::npos;
        if (number == 0 && !zero) return std::nullopt;  // too small
        values_.push_back(number);
        at = end, operand = false;
      } else if (c == ')') {
        while (!operations_.empty() && operations_.back() != '(')
          if (!reduce()) return std::nullopt;
        if (operations_.empty()) return std::nullopt;
        operations_.pop_back();
        ++at;
      } else if (std::string("+-*/").find(c) != std::string::npos) {
        while (!operations_.empty() && level(operations_.back()) >= level(c))
          if (!reduce()) return std::nullopt;
        operations_.push_back(c);
        ++at, operand = true;
      } else {
        return std::nullopt;
      }
    }
    while (!operations_.empty())
      if (!reduce()) return std::nullopt;
    if (operand || values_.size() != 1) return std::nullopt;
    return values_.back();
  }

 private:
  static int level(char c) { return c == '(' ? 0 : c == '+' || c == '-' ? 1 : c == '~' ? 3 : 2; }
  bool reduce() {
    const char c = operations_.back();
    operations_.pop_back();
    if (c == '(' || values_.empty()) return false;
    const double b = values_.back();
    if (c == '~') return values_.back() = -b, true;
    values_.pop_back();
    if (values_.empty() || (c == '/' && b == 0)) return false;
    double& a = values_.back();
    a = c == '+' ? a + b : c == '-' ? a - b : c == '*' ? a * b : a / b;
    return std::isfinite(a);
  }
  std::vector<char> operations_;
  std::vector<double> values_;
};

TEST(arithmetic, any_text_has_the_value_and_the_verdict_of_the_shunting_yard) {
  Random random(11);
  int accepted = 0;
  for (int i = 0; i < 400000; ++i) {
    std::string text;
    constexpr std::string_view kLetters = "01259..+-*/()  e,";
    for (unsigned n = random.below(12); n > 0; --n) text += kLetters[random.below(kLetters.size())];
    const std::optional<double> wanted = ShuntingYard().evaluate(text);
    const Result<double> found = evaluate(text);
    ASSERT_EQ(found.ok(), wanted.has_value()) << quoted(text) << ": " << found.status().message;
    if (!wanted) {
      ASSERT_FALSE(found.status().message.empty());
      continue;
    }
    ASSERT_EQ(*found, *wanted) << quoted(text);
    ++accepted;
  }
  EXPECT_GT(accepted, 10000);
}

TEST(arithmetic, what_is_no_number_is_refused_with_the_reason) {
  const std::pair<const char*, const char*> cases[]{
      {"", "expected a number"}, {"7,25", "comma"},         {"1.000,5", "comma"},   {"12abc", "\"abc\""},
      {"inf", "\"inf\""},        {"-nan", "\"nan\""},       {"1e999", "too large"}, {"1e300*1e300", "too large"},
      {"5+", "at the end"},      {"(5", "closing bracket"}, {"5)", "\")\""},        {"5 5", "\"5\""},
      {"1.2.3", "\".3\""},       {"0x10", "\"x10\""},       {"1/(2-2)", "zero"}};
  for (const auto& [text, reason] : cases) {
    const Result<double> found = evaluate(text);
    EXPECT_EQ(found.status().code, Code::usage) << text;
    EXPECT_NE(found.status().message.find(reason), std::string::npos) << text << ": " << found.status().message;
  }
  EXPECT_FALSE(evaluate(std::string(100000, '(')));
  EXPECT_FALSE(evaluate(std::string(100000, '-')));
  EXPECT_EQ(*evaluate(std::string(1000, '-') + "5"), 5);
}

TEST(arithmetic, units_of_one_dimension_convert_and_others_are_refused) {
  for (const Unit& from : units())
    for (const Unit& to : units()) {
      const std::string text = "3" + std::string(from.name) + "*2";
      const Result<double> found = evaluate(text, to.name);
      ASSERT_EQ(found.ok(), from.dimension == to.dimension) << text << " in " << to.name;
      if (!found) continue;
      EXPECT_NEAR(*found, 6 * from.size / to.size, 1e-12 * 6 * from.size / to.size) << text;
      if (from.name == to.name) {
        EXPECT_EQ(*found, 6) << "exact";
      }
    }
  EXPECT_DOUBLE_EQ(*evaluate("5 + 50 cm", "m"), 5.5);
  EXPECT_DOUBLE_EQ(*evaluate("2 * (1 + 50cm)", "m"), 3);
  EXPECT_DOUBLE_EQ(*evaluate("90 km/h", "m/s"), 25);
  EXPECT_DOUBLE_EQ(*evaluate("10 m / 4", "m"), 2.5);
  EXPECT_DOUBLE_EQ(*evaluate("10 m / 2 m", "m"), 5);
  EXPECT_EQ(*evaluate("50 %", "%"), 50);
  EXPECT_EQ(*evaluate("-0.5\u00D7", "\u00D7"), -0.5);
  const std::pair<const char*, const char*> wrong[]{{"5 s", "s is a time; expected m, cm"},
                                                    {"(5 m) m", "second unit"},
                                                    {"5 m * 3 m", "product"},
                                                    {"5 / 3 m", "division line"},
                                                    {"5 mi", "no unit \"mi\""}};
  for (const auto& [text, reason] : wrong) {
    const Result<double> found = evaluate(text, "m");
    ASSERT_FALSE(found) << text;
    EXPECT_NE(found.status().message.find(reason), std::string::npos) << text << ": " << found.status().message;
  }
  EXPECT_FALSE(evaluate("5 m"));
  EXPECT_FALSE(evaluate("5 m", "%"));
}

}  // namespace arithmetic_test
}  // namespace coaster::base
