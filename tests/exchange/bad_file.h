// Checks of readers' errors for invalid files.
#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "base/status.h"

namespace coaster::test {

// Expects one line that starts with the file's name and contains `expected`.
template <class Loaded>
void expect_bad_file(const Loaded& loaded, std::string_view name, std::string_view expected) {
  ASSERT_FALSE(loaded.ok()) << expected;
  EXPECT_EQ(loaded.status().code, base::Code::bad_file);
  const std::string& error = loaded.status().message;
  EXPECT_NE(error.find(expected), std::string::npos) << "expected: " << expected << "\nfound: " << error;
  EXPECT_EQ(error.rfind(name, 0), 0u) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

}  // namespace coaster::test
