#include "base/exit_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "base/crash_guard.h"
#include "base/status.h"

namespace coaster::base {
namespace exit_codes_test {

TEST(exit_codes, each_code_of_a_status_has_its_words) {
  for (const Code code : {Code::ok, Code::expectation, Code::usage, Code::bad_file, Code::graphics, Code::io,
                          Code::timeout, Code::refused, Code::skipped})
    EXPECT_EQ(std::count_if(std::begin(kExitCodes), std::end(kExitCodes),
                            [&](const ExitCode& row) { return row.code == std::to_string(exit_code(code)); }),
              1)
        << exit_code(code);
  EXPECT_EQ(std::string(kExitCodes[7].code), std::to_string(kMemoryExitCode));
  EXPECT_EQ(exit_codes_sentence(),
            "Exit codes: 0 success, 1 failed expectation, 2 usage or script error, 3 bad file, 4 no graphics, 5 input "
            "or output, 6 timeout, 70 out of memory, 77 skipped, 128+N ended by signal N.");
}

// The manual explains each code, in this order: its words first, then more.
TEST(exit_codes, the_manual_has_them_all) {
  std::ifstream page(std::string(COASTER_SOURCE_DIR) + "/docs/script.md");
  std::vector<std::string> rows;
  bool within = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| code |")) within = true;
    else if (within && line.starts_with("| ")) rows.push_back(line);
  }
  ASSERT_EQ(rows.size(), std::size(kExitCodes));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string start = "| " + std::string(kExitCodes[i].code) + " | " + std::string(kExitCodes[i].meaning);
    EXPECT_TRUE(rows[i].starts_with(start)) << rows[i] << "\nexpected " << start;
  }
}

}  // namespace exit_codes_test
}  // namespace coaster::base
