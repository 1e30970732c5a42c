// What messages and help tell the user to write can be written: hints for words of other languages, "such as ...", and
// every usage of --help-script are parsed.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "platform/events.h"
#include "query/query.h"
#include "script/grammar.h"
#include "script/statement_rows.h"
#include "world/entity.h"

namespace coaster::script {
namespace examples_test {

std::vector<std::string> errors_of(const std::string& lines) {
  base::Files files;
  return parse_script("coaster-script 1\n" + lines + "\n", "a.coaster", ".", files).errors;
}
bool parses(const std::string& lines) { return errors_of(lines).empty(); }
bool is_statement(const std::string& word) {
  const auto& known = statement_words();
  return std::find(known.begin(), known.end(), word) != known.end();
}
std::string read(const std::filesystem::path& path) {
  const auto text = base::Files().read(path);
  return text ? *text : "";
}

// Returns the string literals of a source, neighbours joined.
std::vector<std::string> literals(const std::string& source) {
  std::vector<std::string> all;
  bool open = false;  // only blanks since the last literal
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source.compare(i, 2, "//") == 0) {
      i = std::min(source.find('\n', i), source.size());
    } else if (source.compare(i, 3, "'\"'") == 0) {
      i += 2, open = false;
    } else if (source[i] == '"') {
      if (!open) all.emplace_back();
      for (++i; i < source.size() && source[i] != '"'; ++i)
        if (source[i] == '\\') all.back() += source[++i] == 'n' ? '\n' : source[i];
        else all.back() += source[i];
      open = true;
    } else if (source[i] != ' ' && source[i] != '\n') {
      open = false;
    }
  }
  return all;
}

TEST(examples, hints_for_words_of_other_languages_can_be_written) {
  std::vector<std::string> foreign;
  for (const ForeignWords& row : foreign_words()) {
    std::istringstream words{std::string(row.words)};
    for (std::string word; words >> word;) foreign.push_back(word);
  }
  int hints = 0, lines = 0;
  for (const std::string& word : foreign) {
    const std::vector<std::string> errors = errors_of(word + " 5");
    ASSERT_EQ(errors.size(), 1u) << word;
    const std::string& message = errors[0];
    if (const std::size_t meant = message.find("did you mean \""); meant != std::string::npos) {
      const std::size_t from = meant + 14;
      EXPECT_TRUE(is_statement(message.substr(from, message.find('"', from) - from))) << message;
      ++hints;
      continue;
    }
    const std::string first = message.substr(0, message.find('\n'));
    const std::size_t semicolon = first.find("; ");
    ASSERT_NE(semicolon, std::string::npos) << first;
    const std::string hint = first.substr(semicolon + 2);
    ++hints;
    for (const std::string mark : {": ", "such as "})
      if (const std::size_t example = hint.find(mark); example != std::string::npos) {
        const std::string line = hint.substr(example + mark.size());
        EXPECT_TRUE(is_statement(line.substr(0, line.find(' ')))) << hint;
        if (mark == ": " && !line.ends_with('"')) continue;
        EXPECT_TRUE(parses(line)) << hint;
        ++lines;
      }
    // A word with a dot is of a script.
    std::istringstream words(hint);
    for (std::string one; words >> one;)
      EXPECT_TRUE(one.find('.') >= one.size() - 1 || is_statement(one)) << hint << ": " << one;
  }
  EXPECT_GT(hints, 50);
  EXPECT_GE(lines, 4);
  EXPECT_NE(errors_of("set N 5")[0].find("such as resolution 64"), std::string::npos);
}

// True for what a script or a panel reads somewhere.
bool is_read(const std::string& text) {
  if (parses(text) || parses("expect " + text) || parses("seek " + text + " by height of @k3")) return true;
  if (query::find_query(text) != nullptr || platform::parse_chord(text)) return true;
  if (parses("expect length == 1 " + text) || parses("select " + text) || parses("roll " + text + " to 0")) return true;
  if (parses("section.title " + text + " to \"a\"") || parses("section.remove " + text)) return true;
  if (parses("handle " + text + " to 1 2 3") || parses("env size " + text) || parses("ui.click " + text)) return true;
  if (parses("fault " + text + " fail 1") || parses("needs " + text) || world::parse_name(text)) return true;
  return base::parse_double(text).has_value() || parses("expect section.value " + text + " == 1") ||
         parses("expect force.value " + text + " == 1") || help().find(text) != std::string::npos;
}

TEST(examples, what_messages_give_as_an_example_is_read_by_something) {
  int seen = 0;
  std::set<std::string> unread;
  for (const char* const room : {"script", "query", "edit", "base", "app", "world"})
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / "src" / room)) {
      if (file.path().extension() != ".cpp") continue;
      for (const std::string& literal : literals(read(file.path()))) {
        constexpr std::string_view kMark = "such as ";
        const std::size_t mark = literal.find(kMark);
        if (mark == std::string::npos || literal.find('{', mark) < mark + kMark.size() + 8) continue;
        std::string rest = literal.substr(mark + kMark.size());
        rest.resize(std::min({rest.size(), rest.find(", found"), rest.find(". "), rest.find(": "), rest.find(", or "),
                              rest.find(", up to"), rest.find(", within"), rest.find(" found")}));
        if (rest.ends_with('.')) rest.pop_back();
        rest = std::regex_replace(rest, std::regex(" or |, "), "\n");
        std::istringstream parts(rest);
        for (std::string part; std::getline(parts, part); ++seen)
          if (!is_read(part)) unread.insert(fmt::format("{}: {}", file.path().filename().string(), part));
      }
    }
  EXPECT_GT(seen, 20);
  EXPECT_TRUE(unread.empty()) << fmt::format("{}", fmt::join(unread, "\n"));
}

// Returns lines that follow a usage, with the parts in brackets and without them, for each of its alternatives.
std::vector<std::string> lines_of(std::string usage) {
  const auto replace = [](std::string& text, const char* what, const char* by) {
    text = std::regex_replace(text, std::regex(what), by);
  };
  // The arguments of one kind.
  for (const auto& [what, by] :
       {std::pair{R"(seek WORDS by WORDS)", "seek ride.lap_time == 40 by height"},
        {R"(X Y Z\|TARGET)", "@k2"},
        {R"(fps N)", "fps 30"},
        {R"x("(FILE|PICTURE\.png|\$OUT/[A-Z.a-z]+|PATH|MENU/ITEM|PANEL|TEXT|NAME|WIDGET)")x", "\"$OUT/a.png\""},
        {R"(@knot,\.\.\.\|@knot\.\.@knot(\|@section,\.\.\.)?\|all\|selected)", "@k1|@k1..@k2|all|selected"},
        {R"(@section,\.\.\.\|@section\.\.@section\|all\|selected)", "@q1|@q1,@q2|all"},
        {R"(@knot)", "@k1"},
        {R"(@segment)", "@s1"},
        {R"(@cart)", "@c1"},
        {R"(@section)", "@q1"},
        {R"(QUERY \[ARGUMENT\] OP VALUE)", "knots == 3"},
        {R"(\+-TOLERANCE)", "+-0.1"},
        {R"(QUERY\|)", "knots|"},
        {R"(CONDITION)", "knots == 3"},
        {R"(STATEMENT)", "undo"},
        {R"(TARGET)", "@k1"},
        {R"(CHORD)", "Ctrl+Z"},
        {R"(WxH)", "640x360"},
        {R"( \.\.\.$)", ""},
        {R"(\b(X|Y|Z|L|R|A|B|D|V|N|NUMBER|VALUE)\b)", "1"}})
    replace(usage, what, by);
  std::vector<std::string> lines;
  for (std::size_t choice = 0; choice < 40; ++choice)
    for (const bool optional : {false, true}) {
      if (optional && usage.find("] | ") != std::string::npos) continue;  // an element with all that it may have
      std::string line;
      if (optional) {
        line = usage;
        std::erase_if(line, [](char c) { return c == '[' || c == ']'; });
      } else {
        int depth = 0;
        for (const char c : usage) {
          depth += c == '[';
          if (depth == 0) line += c;
          depth -= c == ']';
        }
      }
      line = std::regex_replace(line, std::regex(" +"), " ");
      // "a|b|c" is one of them; "ui.open|close" is ui.open or ui.close. "pad rest | a" is two forms.
      std::string chosen, prefix;
      if (const std::size_t bar = line.find(" | "); bar != std::string::npos) {
        const std::string head = line.substr(0, line.rfind(' ', bar - 1));
        std::vector<std::string> forms{line.substr(head.size() + 1, bar - head.size() - 1)};
        for (std::size_t at = bar; at != std::string::npos;) {
          const std::size_t next = line.find(" | ", at + 3);
          forms.push_back(line.substr(at + 3, next == std::string::npos ? next : next - at - 3));
          at = next;
        }
        line = head + " " + forms[choice % forms.size()];
      }
      std::istringstream words(line);
      for (std::string word; words >> word;) {
        std::vector<std::string> either;
        std::istringstream parts(word);
        for (std::string part; std::getline(parts, part, '|');) either.push_back(part);
        std::string one = either[choice % either.size()];
        if (const std::size_t dot = either[0].find('.'); choice % either.size() > 0 && dot != std::string::npos &&
                                                         one.find('.') == std::string::npos && one[0] != '@' &&
                                                         one != "all" && one != "selected" && one[0] != '"')
          one = either[0].substr(0, dot + 1) + one;
        chosen += (chosen.empty() ? "" : " ") + one;
      }
      if (const std::size_t block = chosen.find(" ... end"); block != std::string::npos)
        chosen = chosen.substr(0, block) + "\nend";
      const bool bare = !optional && chosen.find(' ') == std::string::npos && usage.find(" [") != std::string::npos;
      if (bare && (chosen == "env" || chosen == "pad" || chosen == "camera")) continue;  // at least one of the parts
      if (std::find(lines.begin(), lines.end(), chosen) == lines.end()) lines.push_back(chosen);
    }
  return lines;
}

TEST(examples, every_usage_of_the_help_can_be_written) {
  std::istringstream page(help());
  int usages = 0;
  for (std::string line; std::getline(page, line) && line != "Queries";) {
    if (!line.starts_with("  ") || line.starts_with("      ")) continue;
    const std::string usage = line.substr(2);
    if (usage.starts_with("coaster-script") || usage.starts_with("include")) continue;  // "a.png" is no script
    ++usages;
    int good = 0, bad = 0;
    std::string first;
    for (const std::string& one : lines_of(usage)) {
      const auto errors = errors_of(one);
      ++(errors.empty() ? good : bad);
      if (!errors.empty() && first.empty()) first = errors[0];
    }
    EXPECT_TRUE(good > 0 && bad == 0) << usage << "\n" << first;
  }
  EXPECT_GT(usages, 150);
}

}  // namespace examples_test
}  // namespace coaster::script
