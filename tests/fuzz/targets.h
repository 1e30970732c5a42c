// What is fuzzed: one row a reader. Each takes any bytes, must not crash, and checks what a reader promises about what
// it accepts.
#pragma once

#include <span>
#include <string_view>

namespace coaster::fuzz {

struct Target {
  std::string_view name;  // of its folder in tests/fuzz/corpus
  void (*run)(std::string_view bytes);
};

std::span<const Target> targets();

}  // namespace coaster::fuzz
