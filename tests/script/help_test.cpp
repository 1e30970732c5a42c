// The text of --help-script, and the tables of docs/script.md, which come from the same rows.
#include "script/grammar.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/exit_codes.h"
#include "edit/commands/codec.h"
#include "query/query.h"
#include "script/statement_rows.h"

namespace coaster::script {
namespace help_test {

TEST(help, names_every_query_with_its_unit_and_its_line) {
  const std::string page = help();
  for (const query::Query& q : query::queries()) {
    const std::size_t at = page.find(std::string(q.name));
    ASSERT_NE(at, std::string::npos) << q.name;
    EXPECT_NE(page.find(std::string(q.unit), at), std::string::npos) << q.name;
    EXPECT_NE(page.find(std::string(q.text.substr(0, q.text.find(' ')))), std::string::npos) << q.name;
    const std::string line = "\n  " + std::string(q.name) + (q.argument.empty() ? "" : " " + usage_of(q.argument)) +
                             (q.unit.empty() ? "" : " (" + std::string(q.unit) + ")");
    EXPECT_NE(page.find(line + (q.values.may_be_none ? " or none\n" : "\n")), std::string::npos) << line;
  }
  for (const char* const word : {"coaster-script 1", "ui.click", "aim.click", "expect", "wait", "movie.start"})
    EXPECT_NE(page.find(word), std::string::npos) << word;
  EXPECT_TRUE(page.ends_with("\n\n" + base::exit_codes_sentence() + "\n"));
}

// Returns the cells of the first table below a heading of docs/script.md, without its head.
std::vector<std::string> table_below(const std::string& heading) {
  std::ifstream page(std::string(COASTER_SOURCE_DIR) + "/docs/script.md");
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(page, line) && line != "## " + heading) continue;
  while (std::getline(page, line) && !line.starts_with("|---|")) continue;
  while (std::getline(page, line) && line.starts_with("| ")) rows.push_back(line);
  return rows;
}

TEST(help, the_manual_has_the_rows_of_all_statements) {
  const auto escaped = [](std::string_view text) {
    return std::regex_replace(std::string(text), std::regex(R"(\|)"), R"(\|)");
  };
  for (const RowGroup& group : row_groups()) {
    std::vector<std::string> rows;
    for (const StatementRow& row : group.rows)
      rows.push_back("| `" + escaped(row.usage) + "` | " + escaped(row.help) + " |");
    EXPECT_EQ(table_below(std::string(group.title)), rows) << "docs/script.md lacks rows or has others";
  }
  const std::vector<std::string> commands = table_below("Commands");
  EXPECT_GT(commands.size(), 10u);
  for (const std::string& row : commands) {
    const std::string cell = row.substr(0, row.find(" | "));
    for (std::size_t from = cell.find('`'); from != std::string::npos;) {
      const std::size_t to = cell.find('`', from + 1);
      const std::string command = cell.substr(from + 1, to - from - 1);
      EXPECT_TRUE(edit::is_command(command.substr(0, command.find(' ')))) << command;
      from = cell.find('`', to + 1);
    }
  }
}

TEST(help, every_word_of_a_row_is_a_statement_of_its_own) {
  std::vector<std::string> words;
  for (const RowGroup& group : row_groups())
    for (const StatementRow& row : group.rows) {
      const std::string before = words.empty() ? "" : words.back();
      for (const std::string& word : words_of(row)) {
        const bool again = std::find(words.begin(), words.end(), word) != words.end();
        EXPECT_TRUE(!again || (word == before && row.read == nullptr)) << word << ": a form follows its first row";
        if (!again) words.push_back(word);
        EXPECT_EQ(std::count(statement_words().begin(), statement_words().end(), word), 1) << word;
      }
    }
  EXPECT_EQ(words_of({"ui.open|close \"PATH\"", ""}), (std::vector<std::string>{"ui.open", "ui.close"}));
  EXPECT_EQ(words_of({"text|raw.text \"TEXT\"", ""}), (std::vector<std::string>{"text", "raw.text"}));
}

}  // namespace help_test
}  // namespace coaster::script
