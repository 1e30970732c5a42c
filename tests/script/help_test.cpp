#include "script/help.h"

#include <gtest/gtest.h>

#include "base/exit_codes.h"
#include "query/query.h"

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

}  // namespace help_test
}  // namespace coaster::script
