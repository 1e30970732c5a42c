// The first line of the rows that NoLimits 2 writes.
#pragma once

#include <string_view>

namespace coaster::test {

inline constexpr std::string_view kNl2Header =
    "\"No."
    "\"\t\"PosX\"\t\"PosY\"\t\"PosZ\"\t\"FrontX\"\t\"FrontY\"\t\"FrontZ\"\t\"LeftX\"\t\"LeftY\"\t\"LeftZ\"\t\"UpX\"\t\""
    "UpY\"\t\"UpZ\"\n";

}  // namespace coaster::test
