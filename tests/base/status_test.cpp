#include "base/status.h"

#include <memory>

#include <gtest/gtest.h>

namespace coaster::base {
namespace status_test {

TEST(status, a_result_holds_a_value_or_the_reason_for_none) {
  Result<std::unique_ptr<int>> good(std::make_unique<int>(7));
  ASSERT_TRUE(good);
  EXPECT_EQ(**good, 7);
  EXPECT_TRUE(good.status().ok());
  const Result<std::string> bad(Status{Code::io, "disk full"});
  EXPECT_FALSE(bad);
  EXPECT_EQ(bad.status(), (Status{Code::io, "disk full"}));
  EXPECT_NE(bad.status(), (Status{Code::io, "disk empty"}));
}

TEST(status, exit_codes_are_those_of_the_manual) {
  EXPECT_EQ(exit_code(Code::ok), 0);
  EXPECT_EQ(exit_code(Code::expectation), 1);
  EXPECT_EQ(exit_code(Code::usage), 2);
  EXPECT_EQ(exit_code(Code::bad_file), 3);
  EXPECT_EQ(exit_code(Code::graphics), 4);
  EXPECT_EQ(exit_code(Code::io), 5);
  EXPECT_EQ(exit_code(Code::timeout), 6);
  EXPECT_EQ(exit_code(Code::refused), 2);
}

}  // namespace status_test
}  // namespace coaster::base
