// Tests over every kind of coaster.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "world/coaster_kind.h"

namespace coaster::test {

inline std::vector<world::CoasterKind> kinds() {
  std::vector<world::CoasterKind> all;
  for (std::size_t i = 0; i < base::count_of<world::CoasterKind>(); ++i)
    all.push_back(static_cast<world::CoasterKind>(i));
  return all;
}
inline std::string kind_name(const testing::TestParamInfo<world::CoasterKind>& info) {
  return std::string(base::name_of(info.param));
}

}  // namespace coaster::test
