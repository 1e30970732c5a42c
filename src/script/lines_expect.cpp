// Parses expect and lesson: a condition, a file, or a statement that must fail.
#include "query/condition.h"
#include "script/grammar.h"
#include "script/lines.h"

#include <algorithm>

#include <fmt/format.h>

namespace coaster::script {
namespace {

bool parse_file(Words& words, bool negated, Action& action) {
  ExpectFile expect;
  expect.negated = negated;
  if (!take(words, "a file", expect.path)) return false;
  if (words.accept("not")) expect.negated = !expect.negated;
  if (words.at_end() || words.accept("exists")) {
    action = expect;
    return words.end();
  }
  if (!words.accept("same") && !words.accept("=="))
    return words.fail(words.peek()->column, "expected same or exists, found " + base::quoted_start(words.peek()->text));
  words.accept("as");
  if (!take(words, "the file to compare with", expect.same_as.emplace())) return false;
  action = expect;
  return words.end();
}

// Parses the optional end of the statement: ~ "text that the error contains".
bool parse_error(Words& words, Action& action) {
  ExpectError expect;
  std::span<const base::Token> rest = words.rest();
  if (rest.size() >= 2 && rest[rest.size() - 2].text == "~" && !rest[rest.size() - 2].quoted) {
    expect.contains = rest.back().text;
    rest = rest.first(rest.size() - 2);
  }
  if (rest.empty() && expect.contains) {  // expect error ~ "text": text of the newest notice
    Condition notice;
    notice.query = notice.text = "toast";
    notice.op = query::Op::contains;
    notice.values = {words.rest().back()};
    notice.column = words.rest().front().column;
    action = Expect{notice};
    return true;
  }
  if (rest.empty()) return words.fail(words.end_column(), "expected a statement that must fail");
  Statement inner;
  inner.column = rest.front().column;
  base::TextError error;
  if (!parse_line(rest, error, inner.action)) {
    if (!error.out_of_range) return words.fail(error);
    expect.out_of_range = error.message;
  }
  expect.statement.push_back(std::move(inner));
  action = std::move(expect);
  return true;
}

bool parse_expect(Words& words, Action& action) {
  const bool negated = words.accept("not");
  if (words.accept("file")) return parse_file(words, negated, action);
  if (!negated && words.accept("error")) return parse_error(words, action);
  Expect expect;
  if (!parse_condition(words, expect.condition)) return false;
  expect.condition.negated = expect.condition.negated != negated;
  action = std::move(expect);
  return words.end();
}

constexpr LineRow kExpectLines[]{{"expect", parse_expect}};

}  // namespace

std::span<const LineRow> expect_lines() { return kExpectLines; }

bool parse_lesson(Words& words, Action& action) {
  Lesson lesson;
  const base::Token* const text = words.take("a text");
  if (!text) return false;
  lesson.text = text->text;
  if (words.accept("at") && !take(words, "a widget's path", lesson.widget.emplace())) return false;
  if (!words.accept("until")) return words.fail(next_column(words), "expected at or until");
  if (!parse_condition(words, lesson.until)) return false;
  action = std::move(lesson);
  return words.end();
}

}  // namespace coaster::script
